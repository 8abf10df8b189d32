//! How a mechanism is told about: which state it is in and for how long.

use technol_image::debug_info::{Mechanism, State};
use technol_image::program::ModuleKind;
use technol_wire::message::SequenceState;

/// The state a mechanism is in: the EX-type instruction it waits at, or passed last.
pub(crate) fn state<'a>(mechanism: &'a Mechanism, now: &SequenceState) -> Option<&'a State> {
    // `mech_LINE` is a WORD: compare what fits.
    mechanism.states.iter().find(|s| now.line != 0 && s.line as u16 == now.line)
}

/// The 1-based source line a mechanism stands at; its first line when it is at rest.
pub(crate) fn line(mechanism: &Mechanism, now: &SequenceState) -> u32 {
    if let Some(state) = state(mechanism, now) {
        return state.line;
    }
    let low = u32::from(now.line);
    let whole = (mechanism.lines.0 & !0xFFFF) | low;
    if low != 0 && (mechanism.lines.0..=mechanism.lines.1).contains(&whole) {
        whole
    } else {
        mechanism.lines.0
    }
}

/// Characters of a condition in one line of a list.
const CONDITION: usize = 32;

/// `EX0 LDR KSMP`: the instruction and what it depends on, shortened.
fn state_text(state: &State) -> String {
    let mut condition: String = state.condition.chars().take(CONDITION).collect();
    if condition.len() < state.condition.len() {
        condition.truncate(condition.trim_end_matches([' ', '/']).len());
        condition.push('…');
    }
    format!("{} {condition}", state.mnemonic).trim_end().to_owned()
}

/// Time in the present state, in milliseconds.
pub(crate) fn millis(mechanism: &Mechanism, now: &SequenceState) -> u64 {
    u64::from(now.since) * if mechanism.module == ModuleKind::Fast { 1 } else { 20 }
}

/// A duration as people say it.
pub(crate) fn duration(millis: u64) -> String {
    match millis {
        0..1000 => format!("{millis} ms"),
        1000..60_000 => format!("{}.{} s", millis / 1000, millis % 1000 / 100),
        _ => format!("{} min {:02} s", millis / 60_000, millis / 1000 % 60),
    }
}

/// `line 42 EX0 LDR KSMP (1.2 s)`, or `at rest`.
pub(crate) fn summary(mechanism: &Mechanism, now: &SequenceState) -> String {
    if !now.active {
        return if now.resume == 0 {
            "at rest".into()
        } else {
            format!("paused at line {}", line(mechanism, now))
        };
    }
    let state = state(mechanism, now).map(|s| format!(" {}", state_text(s))).unwrap_or_default();
    format!("line {}{state} ({})", line(mechanism, now), duration(millis(mechanism, now)))
}

/// Name of the mechanism's thread.
pub(crate) fn thread_name(mechanism: &Mechanism, now: Option<&SequenceState>) -> String {
    match now.filter(|s| s.active) {
        Some(now) => format!("{} · {}", mechanism.name, summary(mechanism, now)),
        None => mechanism.name.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spindle() -> Mechanism {
        Mechanism {
            name: "SPINDLE".into(),
            sequence: 0,
            file: 0,
            module: ModuleKind::Main,
            lines: (40, 60),
            states: vec![State { point: 1, line: 42, mnemonic: "EX0".into(), condition: "LDR KSMP".into() }],
        }
    }

    fn at(line: u16, since: u32, active: bool) -> SequenceState {
        SequenceState { sequence: 0, active, resume: u16::from(line != 0), line, since }
    }

    #[test]
    fn a_thread_tells_its_state_and_time() {
        for (now, name) in [
            (at(42, 60, true), "SPINDLE · line 42 EX0 LDR KSMP (1.2 s)"),
            (at(42, 4, true), "SPINDLE · line 42 EX0 LDR KSMP (80 ms)"),
            (at(42, 3250, true), "SPINDLE · line 42 EX0 LDR KSMP (1 min 05 s)"),
            (at(40, 0, true), "SPINDLE · line 40 (0 ms)"),
            (at(0, 0, true), "SPINDLE · line 40 (0 ms)"),
            (at(0, 0, false), "SPINDLE"),
        ] {
            assert_eq!(thread_name(&spindle(), Some(&now)), name);
        }
        assert_eq!(summary(&spindle(), &at(0, 0, false)), "at rest");
        assert_eq!(summary(&spindle(), &at(42, 7, false)), "paused at line 42");
    }

    #[test]
    fn long_conditions_are_shortened() {
        let mut long = spindle();
        long.states[0].condition = "LDR  K_CW / LO   K_CCW / LA   -SP_WANT_CW / LA  SP_STAND".into();
        assert_eq!(summary(&long, &at(42, 0, true)), "line 42 EX0 LDR  K_CW / LO   K_CCW / LA   -S… (0 ms)");
    }

    #[test]
    fn the_fast_raster_counts_milliseconds() {
        let fast = Mechanism { module: ModuleKind::Fast, ..spindle() };
        assert_eq!(millis(&fast, &at(42, 60, true)), 60);
    }

    #[test]
    fn lines_past_65535_are_found() {
        let mut long = spindle();
        long.lines = (65_600, 65_700);
        long.states[0].line = 65_610;
        assert_eq!(line(&long, &at(65_610_u32 as u16, 0, true)), 65_610);
        assert_eq!(line(&long, &at(65_605_u32 as u16, 0, true)), 65_605);
    }
}
