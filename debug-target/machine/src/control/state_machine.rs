//! The state machine of a drive (CiA 402): control word in, status word out.

/// Bits of the control word.
const SWITCH_ON: u16 = 1;
const VOLTAGE: u16 = 2;
const NO_QUICK_STOP: u16 = 4;
const ENABLE: u16 = 8;
const RESET: u16 = 0x80;

/// Bit 4 of the status word: the main voltage is there.
const VOLTAGE_ENABLED: u16 = 0x10;

/// A state, by its bits of the status word.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum State {
    Fault = 0x08,
    #[default]
    SwitchOnDisabled = 0x40,
    Ready = 0x21,
    SwitchedOn = 0x23,
    Enabled = 0x27,
    QuickStop = 0x07,
}

/// A drive.
#[derive(Clone, Debug, Default)]
pub(super) struct StateMachine {
    state: State,
    /// Cause of an error that is still there.
    cause: Option<u16>,
    /// Code of the error the drive is in.
    code: u16,
    reset: bool,
}

impl StateMachine {
    pub(super) fn state(&self) -> State {
        self.state
    }

    /// The status word; bit 4 tells that the voltage is there.
    pub(super) fn status(&self) -> u16 {
        self.state as u16 | VOLTAGE_ENABLED
    }

    /// Code of the error; 0 without.
    pub(super) fn code(&self) -> u16 {
        self.code
    }

    /// Something is wrong with it, or no longer. The error itself stays until it is reset.
    pub(super) fn set_cause(&mut self, cause: Option<u16>) {
        self.cause = cause;
    }

    /// It was switched off and on.
    pub(super) fn power_on(&mut self) {
        *self = StateMachine { cause: self.cause, ..StateMachine::default() };
    }

    /// A step under a control word: at most one transition.
    pub(super) fn step(&mut self, control: u16) {
        let reset = control & RESET != 0;
        let was = core::mem::replace(&mut self.reset, reset);
        if let Some(code) = self.cause {
            (self.state, self.code) = (State::Fault, code);
            return;
        }
        if self.state == State::Fault {
            if reset && !was {
                (self.state, self.code) = (State::SwitchOnDisabled, 0);
            }
            return;
        }
        self.state = self.next(control);
    }

    /// An error whose cause is gone ends.
    pub(super) fn reset(&mut self) {
        if self.cause.is_none() && self.state == State::Fault {
            (self.state, self.code) = (State::SwitchOnDisabled, 0);
        }
    }

    fn next(&self, control: u16) -> State {
        use State::{Enabled, QuickStop, Ready, SwitchOnDisabled, SwitchedOn};
        if control & VOLTAGE == 0 {
            return SwitchOnDisabled;
        }
        if control & NO_QUICK_STOP == 0 {
            return if self.state == Enabled { QuickStop } else { SwitchOnDisabled };
        }
        match (self.state, control & SWITCH_ON != 0, control & ENABLE != 0) {
            (SwitchOnDisabled | Ready | SwitchedOn | Enabled, false, _) => Ready,
            (Ready, true, _) | (Enabled, true, false) => SwitchedOn,
            (SwitchedOn | QuickStop, true, true) => Enabled,
            (state, ..) => state,
        }
    }

    /// The control word that leads it towards a state, one transition after the other.
    pub(super) fn word_towards(status: u16, goal: State) -> u16 {
        let down = VOLTAGE | NO_QUICK_STOP;
        let is_disabled = status & 0x4F == State::SwitchOnDisabled as u16;
        match goal {
            State::SwitchOnDisabled | State::Fault | State::QuickStop => 0,
            State::Ready => down,
            _ if is_disabled => down,
            State::SwitchedOn => down | SWITCH_ON,
            State::Enabled if status & 0x6F == State::Ready as u16 => down | SWITCH_ON,
            State::Enabled => down | SWITCH_ON | ENABLE,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_words_lead_from_state_to_state() {
        // The control words one after the other, and the status after each, without the voltage.
        let table: [&[(u16, u16)]; 5] = [
            &[(0, 0x40), (0x0F, 0x40), (6, 0x21), (7, 0x23), (0xF, 0x27), (7, 0x23), (6, 0x21), (0, 0x40)],
            &[(6, 0x21), (0xF, 0x23), (0xF, 0x27), (0xB, 0x07), (0xB, 0x40)],
            &[(6, 0x21), (7, 0x23), (0xF, 0x27), (0xB, 0x07), (0xF, 0x27), (6, 0x21)],
            &[(6, 0x21), (7, 0x23), (0xF, 0x27), (0, 0x40)],
            &[(0x80, 0x40), (0x86, 0x21)],
        ];
        for words in table {
            let mut drive = StateMachine::default();
            for (control, status) in words {
                drive.step(*control);
                assert_eq!(drive.status() & !VOLTAGE_ENABLED, *status, "{control:X} of {words:X?}");
            }
        }
    }

    #[test]
    fn an_error_stays_until_its_cause_is_gone_and_it_is_reset() {
        let mut drive = StateMachine::default();
        drive.step(6);
        drive.set_cause(Some(0x7305));
        for control in [6, 0x80, 0, 0x80] {
            drive.step(control);
            assert_eq!((drive.state(), drive.code()), (State::Fault, 0x7305), "{control:X}");
        }
        drive.set_cause(None);
        drive.step(0x80);
        assert_eq!(drive.state(), State::Fault, "only a rising bit resets");
        drive.step(0);
        drive.step(0x80);
        assert_eq!((drive.state(), drive.code()), (State::SwitchOnDisabled, 0));
    }

    #[test]
    fn words_towards_a_state_reach_it_from_every_other() {
        for goal in [State::SwitchOnDisabled, State::Ready, State::SwitchedOn, State::Enabled] {
            for first in [0, 6, 7, 0xF] {
                let mut drive = StateMachine::default();
                for control in [6, 7, first] {
                    drive.step(control);
                }
                for _ in 0..4 {
                    let word = StateMachine::word_towards(drive.status(), goal);
                    drive.step(word);
                }
                assert_eq!(drive.state(), goal, "{first:X}");
            }
        }
    }
}
