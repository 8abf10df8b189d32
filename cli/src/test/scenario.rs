//! Tests as data: what a scenario file says, with every name looked up.

use technol_analysis::expression::{Assignment, Target};
use technol_machine::BlockStart;

use super::condition::Condition;

/// Line and column in a scenario file, 1-based, in characters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Place {
    pub(super) line: u32,
    pub(super) column: u32,
}

/// Something wrong in a scenario file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct ScenarioError {
    /// As the user of the shell would write it.
    pub(super) file: String,
    pub(super) place: Place,
    /// What is wrong, and what would be right.
    pub(super) message: String,
}

impl std::fmt::Display for ScenarioError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}:{}:{}: {}", self.file, self.place.line, self.place.column, self.message)
    }
}

/// One `[[test]]`.
#[derive(Debug)]
pub(super) struct Test {
    pub(super) name: String,
    /// Scenario file, as the user of the shell would write it.
    pub(super) file: String,
    pub(super) place: Place,
    /// Index into [`Machines`](super::machines::Machines).
    pub(super) machine: usize,
    /// Held during the whole test.
    pub(super) guards: Vec<Guard>,
    pub(super) steps: Vec<Step>,
    /// Every name with a value that the test mentions.
    pub(super) values: Vec<(String, Target)>,
}

/// One `[[test.step]]`: what is done, then what time goes by, then what is checked.
#[derive(Debug, Default)]
pub(super) struct Step {
    pub(super) place: Place,
    pub(super) name: Option<String>,
    pub(super) actions: Vec<Action>,
    /// Names of guards that end here.
    pub(super) ends: Vec<String>,
    /// Guards from here on.
    pub(super) guards: Vec<Guard>,
    pub(super) time: Time,
    pub(super) checks: Vec<Check>,
}

/// What a step does.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Action {
    Start {
        cold: bool,
    },
    Stop {
        power_off: bool,
    },
    CentralAnnulment,
    /// The operator confirms the message on the screen.
    Acknowledge,
    /// MODULE_CLEAR.
    Clear,
    /// A fatal error of the control: MODULE_HALT.
    Halt,
    Fault {
        name: String,
        on: bool,
    },
    Key {
        name: String,
        down: bool,
    },
    /// The text says it as written.
    Set {
        name: String,
        target: Target,
        text: String,
        assignment: Assignment,
    },
    Block(Box<BlockStart>),
}

impl Action {
    /// As it is told in a report; a value that is set is told as a change of that value.
    pub(super) fn text(&self) -> Option<String> {
        let text = match self {
            Action::Start { cold: true } => "start, cold".to_owned(),
            Action::Start { cold: false } => "start, warm".to_owned(),
            Action::Stop { .. } => "stop".to_owned(),
            Action::CentralAnnulment => "central annulment".to_owned(),
            Action::Acknowledge => "acknowledge".to_owned(),
            Action::Clear => "clear".to_owned(),
            Action::Halt => "halt".to_owned(),
            Action::Fault { name, on: true } => format!("fault {name}"),
            Action::Fault { name, on: false } => format!("repair {name}"),
            Action::Key { name, down: true } => format!("press {name}"),
            Action::Key { name, down: false } => format!("release {name}"),
            Action::Set { .. } => return None,
            Action::Block(block) => {
                let m = block.m.iter().map(|m| format!("M{m}"));
                let other = |letter: char, value: Option<u32>| value.map(|value| format!("{letter}{value}"));
                let s = other('S', block.s.map(u32::from));
                let h = other('H', block.h.map(u32::from));
                let functions: Vec<String> = m.chain(s).chain(other('T', block.t)).chain(h).collect();
                format!("block {}", functions.join(" ")).trim_end().to_owned()
            }
        };
        Some(text)
    }
}

/// What a step waits for.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) enum Time {
    /// Nothing.
    #[default]
    None,
    Wait {
        ms: u64,
    },
    Until {
        condition: Condition,
        at_least: u64,
        at_most: u64,
    },
}

/// What must be so at the end of a step.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Check {
    Holds(Condition),
    Message(u32),
    NoMessage(u32),
    NoMessages,
    /// The transient message that the operator has to confirm.
    Screen(Option<u32>),
    /// In the list of persistent messages, or not.
    Listed {
        number: u32,
        listed: bool,
    },
    /// That list is empty.
    NothingListed,
    /// The program faulted, and the text of the fault holds this.
    PlcFault(String),
}

/// What must be so all the time.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Guard {
    /// To end it by.
    pub(super) name: Option<String>,
    /// `false`: the condition must never hold.
    pub(super) always: bool,
    pub(super) condition: Condition,
}

impl Guard {
    /// `never SP_CW && SP_CCW`
    pub(super) fn text(&self) -> String {
        format!("{} {}", if self.always { "always" } else { "never" }, self.condition.text)
    }
}
