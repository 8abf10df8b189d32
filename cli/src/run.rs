//! `technol run`: a project on the simulated machine, in virtual time.

pub(crate) mod changes;
mod explain;
mod report;

use std::time::{Duration, Instant};

use technol_image::{DebugInfo, Image};
use technol_runtime::{RuntimeEvent, TickOutcome};
use technol_target::Simulation;

use crate::arguments::RunArguments;
use crate::exit::{self, Failure, Outcome};
use crate::files::Project;
use changes::Changes;
use report::Wanted;

/// Length of a cycle.
const CYCLE: Duration = Duration::from_millis(20);

/// Runs the project. Exit 0; 1 when it has errors; 2 for a wrong name or value; 3 on a PLC fault.
pub(crate) fn run(arguments: &RunArguments) -> Outcome {
    let project = Project::open(&arguments.path)?;
    crate::build::configuration_errors(&project)?;
    let built = crate::build::image(&project)?;
    let Image { program, debug } = built.image;
    let debug = debug.ok_or_else(|| Failure::usage("the build has no debug information"))?;
    let machine = project.machine_for(&program, &debug)?;
    if arguments.explain_machine {
        let machine = machine.ok_or_else(|| {
            Failure::usage("no machine is described: name a file by `file` in `[machine]` of technol.toml")
        })?;
        let channel = crate::control_data::channel(&project.loaded);
        explain::explain(&machine, &channel, &program, &debug, arguments.format);
        return Ok(exit::OK);
    }
    // Everything that was asked for is checked before anything moves.
    let wanted = Wanted::parse(&arguments.print, &debug, &program)?;
    let mut changes = Changes::parse(arguments, &debug, &program)?;
    let mut simulation =
        Simulation::new(program, machine.as_ref()).map_err(|e| Failure::usage(e.to_string()))?;
    changes.check(&simulation)?;
    let machine_path = project.machine();
    let (data, mut keep) = crate::control_data::control_data(
        Some(&*project.loaded),
        machine.as_ref().zip(machine_path.as_deref()),
        arguments.backup.clone(),
    )
    .map_err(Failure::usage)?;
    simulation.set_data(data);
    let mut log = crate::control_data::event_log(arguments.log.as_deref(), false)?;
    let mut logged = 0;

    let mut events = Vec::new();
    simulation.start(true);
    // MODULE_INIT; no PLC time goes by.
    simulation.tick(&mut events);
    let start = Instant::now();
    let mut done = 0;
    while done < arguments.cycles && simulation.runtime().fault().is_none() {
        changes.apply(done, &mut simulation)?;
        if arguments.realtime {
            let due = CYCLE.saturating_mul(u32::try_from(done).unwrap_or(u32::MAX));
            std::thread::sleep(due.saturating_sub(start.elapsed()));
        }
        let outcome = simulation.cycle(&mut events);
        if let Some(log) = &mut log {
            log.write(&simulation, &events[logged..]).map_err(Failure::usage)?;
            logged = events.len();
        }
        if outcome == TickOutcome::Stopped || !simulation.runtime().state().is_cycling() {
            break;
        }
        done += 1;
        keep.follow(simulation.control()).map_err(Failure::usage)?;
    }
    if let Some(log) = &mut log {
        log.write(&simulation, events.get(logged..).unwrap_or_default()).map_err(Failure::usage)?;
    }
    simulation.power_off();
    keep.follow(simulation.control()).map_err(Failure::usage)?;
    let outcome = report::Run { cycles: done, simulation: &simulation, debug: &debug, events: &events };
    outcome.print(&wanted, arguments.format);
    Ok(if simulation.runtime().fault().is_some() { exit::FAULT } else { exit::OK })
}

/// Messages of the run.
fn messages<'a>(
    events: &'a [RuntimeEvent],
    debug: &'a DebugInfo,
) -> impl Iterator<Item = report::Message<'a>> {
    events.iter().filter_map(|event| report::Message::of(event, debug))
}
