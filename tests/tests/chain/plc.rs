//! A source text as a running PLC, and rows of tables about it.

use std::path::Path;

use technol_analysis::expression::{self, Assignment, RegisterValues, Target};
use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Built, Change};
use technol_image::container::Image;
use technol_image::{DebugInfo, Program};
use technol_machine::{MachineConfig, SimulatedControl};
use technol_runtime::{Command, InputImage, Runtime};
use technol_target::{Simulation, parse_machine};

use crate::coverage::{loaded, mutated, recorded, wrong_rows};
use crate::frame;

/// The cells of the tables; they lie one behind the other in this order.
const DATA: &str = "\
IB: DFM I0,I1,I2,I3,I4,I5,I6,I7
OB: DFM O0,O1,O2,O3,O4,O5,O6,O7
B1: DS 1
B2: DS 1
W1: DS 2
W2: DS 2
D1: DS 4
D2: DS 4
Q1: DS 8
Q2: DS 8
R1: DS 8
R2: DS 8
AREA: DS 16
LONG: STR 8,'abcdefgh'
MIDDLE: STR 8,'abcde'
SHORT: STR 3,'cde'
BEHIND: STR 1,'w'
PACKET: STR 12
BIG: DS 256
EQUI FIVE,5";

/// Line of the first of the lines given to [`Plc::of`].
pub(crate) fn first_line() -> usize {
    DATA.lines().count() + 4
}

/// What is in memory before, the lines separated by `/`, what is true after one cycle: `NAME=VALUE …` with names
/// and values as a debugger takes them.
pub(crate) type Row = (&'static str, &'static str, &'static str);

/// One file as a project.
struct OneFile(String);

impl FileReader for OneFile {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        if path == "plc.plc" { Ok(self.0.clone().into_bytes()) } else { Err("no such file".to_owned()) }
    }
}

/// Builds what was loaded; panics with the findings when it cannot be built.
pub(crate) fn build(reader: &dyn FileReader, path: &str) -> Built {
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load(path, reader)), texts: Vec::new() });
    let built = host.analysis().build().expect("nothing cancels it");
    built.unwrap_or_else(|findings| {
        let lines: Vec<String> =
            findings.iter().map(|(f, d)| format!("{f} {:?} {}", d.span, d.message)).collect();
        panic!("{}", lines.join("\n"))
    })
}

/// A running program.
pub(crate) struct Plc {
    simulation: Simulation,
    debug: DebugInfo,
}

impl Plc {
    /// A program of these lines of MODULE_MAIN, past MODULE_INIT.
    pub(crate) fn of(lines: &str) -> Plc {
        Plc::with_init("", lines)
    }

    /// A program of these lines of MODULE_INIT and MODULE_MAIN, past MODULE_INIT.
    pub(crate) fn with_init(init: &str, main: &str) -> Plc {
        Plc::with_modules(init, main, "")
    }

    /// The same in front of the machine that a `machine.toml` describes.
    pub(crate) fn on(machine: Option<&str>, init: &str, main: &str) -> Plc {
        let machine = machine.map(|text| toml::from_str::<MachineConfig>(text).expect("a description"));
        Plc::on_machine(machine.as_ref(), init, main, "")
    }

    /// The same with other modules, written in full.
    pub(crate) fn with_modules(init: &str, main: &str, modules: &str) -> Plc {
        Plc::on_machine(None, init, main, modules)
    }

    /// The same in front of a machine.
    pub(crate) fn on_machine(machine: Option<&MachineConfig>, init: &str, main: &str, modules: &str) -> Plc {
        Plc::load(&source(init, main, modules), machine)
    }

    /// A program of these lines of MODULE_MAIN in front of a machine, past MODULE_INIT.
    pub(crate) fn before(machine: &str, lines: &str) -> Plc {
        let main: Vec<String> = lines.split(" / ").map(str::trim).map(indented).collect();
        let machine = parse_machine(Path::new("machine.toml"), machine).expect("a machine");
        Plc::load(&frame::program(DATA, &main.join("\n"), ""), Some(&machine))
    }

    /// A program of this text, past MODULE_INIT.
    pub(crate) fn from_source(source: &str) -> Plc {
        Plc::load(source, None)
    }

    fn load(source: &str, machine: Option<&MachineConfig>) -> Plc {
        let mut image = recorded(source, || build(&OneFile(source.to_owned()), "plc.plc").image);
        mutated(source, &mut image);
        Plc::of_image(image, machine)
    }

    /// A program that was built, past MODULE_INIT.
    pub(crate) fn from_image(image: Image) -> Plc {
        Plc::of_image(image, None)
    }

    fn of_image(image: Image, machine: Option<&MachineConfig>) -> Plc {
        let debug = image.debug.expect("a build has debug information");
        let mut simulation = loaded(Simulation::new(image.program, machine));
        simulation.start(true);
        simulation.tick(&mut Vec::new());
        Plc { simulation, debug }
    }

    /// Whether a line with code lies in a DEBUG region.
    pub(crate) fn in_debug_region(&self, line: u32) -> Option<bool> {
        self.debug.lines.iter().find(|it| it.line == line).map(|it| it.in_debug_region)
    }

    /// The first operation of a line.
    pub(crate) fn pc_of(&self, line: usize) -> Option<u32> {
        self.debug.lines.iter().find(|it| it.line as usize == line).map(|it| it.pc)
    }

    /// The line of an operation.
    pub(crate) fn line_of(&self, pc: u32) -> Option<usize> {
        self.debug.line_at(pc).map(|line| line.line as usize)
    }

    /// What happens in so many cycles.
    pub(crate) fn events(&mut self, cycles: u32) -> Vec<technol_runtime::RuntimeEvent> {
        let mut events = Vec::new();
        for _ in 0..cycles {
            self.simulation.cycle(&mut events);
        }
        events
    }

    /// The control around the program.
    pub(crate) fn control(&mut self) -> &mut SimulatedControl {
        self.simulation.control_mut()
    }

    /// Output ports as the machine sees them.
    pub(crate) fn ports(&self) -> &[u8] {
        self.simulation.runtime().outputs()
    }

    /// Input ports as the machine drives them.
    pub(crate) fn input_ports(&mut self) -> &mut [u8] {
        self.simulation.inputs_mut()
    }

    /// So many milliseconds.
    pub(crate) fn tick(&mut self, millis: u32) {
        for _ in 0..millis {
            self.simulation.tick(&mut Vec::new());
        }
    }

    /// Starts the PLC again, past MODULE_INIT.
    pub(crate) fn restart(&mut self) {
        self.simulation.start(false);
        self.simulation.tick(&mut Vec::new());
    }

    /// The same after the power was off.
    pub(crate) fn restart_cold(&mut self) {
        self.simulation.start(true);
        self.simulation.tick(&mut Vec::new());
    }

    /// Stops the PLC through MODULE_DONE.
    pub(crate) fn stop(&mut self) {
        self.simulation.runtime_mut().command(technol_runtime::Command::StopPlc { power_off: true });
        self.simulation.cycle(&mut Vec::new());
    }

    pub(crate) fn memory(&self) -> &[u8] {
        self.simulation.runtime().memory()
    }

    pub(crate) fn run(&mut self, cycles: u32) {
        for _ in 0..cycles {
            self.simulation.cycle(&mut Vec::new());
        }
    }

    /// Why the program was stopped.
    pub(crate) fn fault(&self) -> Option<String> {
        self.simulation.runtime().fault().map(|fault| fault.kind.to_string())
    }

    /// Something the control does.
    pub(crate) fn command(&mut self, command: Command) {
        self.simulation.runtime_mut().command(command);
    }

    /// Switches a fault of the machine.
    pub(crate) fn fault_of_machine(&mut self, name: &str, on: bool) {
        self.simulation.plant_mut().set_fault(name, on).expect("a fault of the machine");
    }

    /// Presses or releases a key of the machine.
    pub(crate) fn press(&mut self, name: &str, down: bool) {
        self.simulation.plant_mut().press(name, down).expect("a key of the machine");
    }

    /// The PLC itself.
    pub(crate) fn runtime(&mut self) -> &mut Runtime {
        self.simulation.runtime_mut()
    }

    /// Input ports.
    pub(crate) fn inputs(&mut self) -> &mut InputImage {
        self.simulation.inputs_mut()
    }

    /// Values of the analogue outputs, the first in front.
    pub(crate) fn analog(&self) -> &[i16] {
        self.simulation.control().motion().outputs()
    }

    fn registers(&self) -> RegisterValues {
        let r = self.simulation.runtime().registers();
        RegisterValues { rlo: r.rlo, dr: r.dr, dr_real: r.dr_real, bx: r.bx }
    }

    /// `NAME=VALUE …`
    pub(crate) fn set(&mut self, values: &str) {
        for text in values.split_whitespace() {
            let runtime = self.simulation.runtime_mut();
            let result = match assignment(&self.debug, runtime.program(), text).1 {
                Assignment::Bit { addr, bit, value } => runtime.write_bit(addr, bit, value),
                Assignment::Memory { addr, bytes } => runtime.write_memory(addr, &bytes),
                Assignment::Registers(_) => panic!("{text}: load registers by the program"),
            };
            result.unwrap_or_else(|e| panic!("{text}: {e}"));
        }
    }

    /// The conditions among `NAME=VALUE …` that do not hold, with what is there instead.
    pub(crate) fn differences(&self, values: &str) -> Vec<String> {
        let runtime = self.simulation.runtime();
        let (memory, registers) = (runtime.memory(), self.registers());
        let holds = |assignment: &Assignment| match assignment {
            Assignment::Bit { addr, bit, value } => (memory[*addr as usize] >> bit & 1 != 0) == *value,
            Assignment::Memory { addr, bytes } => memory[*addr as usize..].starts_with(bytes),
            Assignment::Registers(change) => change.apply(registers) == registers,
        };
        let wrong = values.split_whitespace().filter_map(|text| {
            let (target, assignment) = assignment(&self.debug, runtime.program(), text);
            let found = target.read(memory, &registers);
            (!holds(&assignment)).then(|| format!("{text} is {found:X?}"))
        });
        wrong.collect()
    }
}

/// What the name in `NAME=VALUE` stands for, and what gives it the value.
fn assignment(debug: &DebugInfo, program: &Program, text: &str) -> (Target, Assignment) {
    let (name, value) = text.split_once('=').unwrap_or_else(|| panic!("NAME=VALUE: {text}"));
    let target = expression::resolve(debug, Some(0), name).unwrap_or_else(|e| panic!("{text}: {e}"));
    let target = target.in_memory(program);
    (target, target.assign(value).unwrap_or_else(|e| panic!("{text}: {e}")))
}

/// The text of a program of these lines of MODULE_INIT and MODULE_MAIN, and other modules.
fn source(init: &str, main: &str, modules: &str) -> String {
    let lines = |text: &str| -> Vec<String> {
        text.split(" / ").map(str::trim).filter(|line| !line.is_empty()).map(indented).collect()
    };
    let source = frame::program(DATA, &lines(main).join("\n"), &lines(init).join("\n"));
    let modules: String = modules.split(" / ").flat_map(|line| [indented(line), "\n".to_owned()]).collect();
    source.replacen("MODULE_INPUT\n", &format!("{modules}MODULE_INPUT\n"), 1)
}

/// A label stands at the start of its line, an instruction does not.
fn indented(line: &str) -> String {
    if line.ends_with(':') { line.to_owned() } else { format!("  {line}") }
}

/// Runs every row for one cycle; all that went wrong is reported at once.
#[track_caller]
pub(crate) fn check(rows: &[Row]) {
    let wrong = wrong_rows(rows, |(given, lines, then)| {
        let mut plc = Plc::of(lines);
        plc.set(given);
        plc.run(1);
        let mut found = plc.differences(then);
        found.extend(plc.fault());
        found
    });
    assert!(wrong.is_empty(), "{} of {} rows:\n{}", wrong.len(), rows.len(), wrong.join("\n"));
}
