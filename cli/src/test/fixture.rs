//! A small program with its machine, to try scenarios on.

use std::path::Path;

use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change};
use technol_image::{DebugInfo, Program};
use technol_machine::MachineConfig;

use super::condition::Names;
use super::execute::{Bench, Verdict, execute};
use super::machines::Machines;
use super::read::{Reader, ScenarioFile};
use super::scenario::{ScenarioError, Test};
use super::state::Mechanisms;

/// LAMP follows GO; WORK waits for GO, then three cycles, counts, and reports when DONE does not come in time.
const SOURCE: &str = "\
DATA
CTL:   DFM GO,LAMP,DONE,,,,,
SMALL: DS 1
COUNT: DS 2
ZERO:  DS 2
TEXT:  STR 8,'lathe'
ROOM:  DS 8
DATA_END
MODULE_MAIN
 LDR GO
 WR LAMP
MECH_BEGIN WORK
 LDR GO
 EX0
 TIM -,3
 LOD COUNT
 INR
 STO COUNT
LAST:
 LDR DONE
 TEX0 -,5,FAILED,77
 JUM READY
FAILED:
 ESET
READY:
MECH_END WORK
MODULE_MAIN_END
MODULE_INPUT
MODULE_INPUT_END
MODULE_BLOCK_INIT
MODULE_BLOCK_INIT_END
MODULE_BLOCK_DONE
 LOD SMALL
 DIVB ZERO
MODULE_BLOCK_DONE_END
MODULE_INIT
 FL 1,WORK
MODULE_INIT_END
MODULE_CLEAR
MODULE_CLEAR_END
MODULE_HALT
MODULE_HALT_END
STOP
";

/// A machine with a key, a fault and a contact.
const MACHINE: &str = "\
[[contact]]
output = \"P0OUT.0\"
input = \"P1IN.0\"
[[key]]
name = \"start\"
input = \"P1IN.1\"
[[fault]]
name = \"stuck\"
input = \"P1IN.0\"
stuck = true
";

struct Files;

impl FileReader for Files {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        if path == "plc.plc" { Ok(SOURCE.into()) } else { Err("no such file".to_owned()) }
    }
}

/// The program, built.
pub(super) struct Fixture {
    pub(super) program: Program,
    pub(super) debug: DebugInfo,
    pub(super) mechanisms: Mechanisms,
    machines: Machines,
}

impl Fixture {
    pub(super) fn new() -> Fixture {
        let loaded = load("plc.plc", &Files);
        let mut host = AnalysisHost::new();
        host.apply(Change { project: Some(loaded), texts: Vec::new() });
        let built = host.analysis().build().expect("nothing cancels it").expect("the program has no errors");
        let program = built.image.program;
        let debug = built.image.debug.expect("a build has debug information");
        let mechanisms = Mechanisms::new(&program, &debug, &|_| Some(SOURCE));
        let config: MachineConfig = toml::from_str(MACHINE).expect("the machine is right");
        let mut machines = Machines::default();
        machines.add(Path::new("machine.toml"), &config);
        Fixture { program, debug, mechanisms, machines }
    }

    #[cfg(test)]
    pub(super) fn names(&self) -> Names<'_> {
        Names { program: &self.program, debug: &self.debug, mechanisms: &self.mechanisms }
    }

    pub(super) fn read(&mut self, text: &str) -> Result<Vec<Test>, Vec<ScenarioError>> {
        let names = Names { program: &self.program, debug: &self.debug, mechanisms: &self.mechanisms };
        let mut reader = Reader { names, machines: &mut self.machines, machine: Some("machine.toml".into()) };
        reader.read(&ScenarioFile { shown: "a.test.toml", folder: Path::new(""), text })
    }

    /// The tests of a scenario that is right.
    #[cfg(test)]
    pub(super) fn tests(&mut self, text: &str) -> Vec<Test> {
        self.read(text).unwrap_or_else(|errors| panic!("{errors:#?}"))
    }

    /// The mistakes of a scenario that is wrong, one a line.
    #[cfg(test)]
    pub(super) fn mistakes(&mut self, text: &str) -> String {
        let errors = self.read(text).expect_err("it is wrong");
        errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
    }

    pub(super) fn run(&self, test: &Test) -> Verdict {
        let Fixture { program, debug, mechanisms, machines } = self;
        let data = &technol_machine::ControlData::default();
        execute(test, &Bench { program, data, debug, mechanisms, machines, coverage: false })
    }
}
