//! Conditions: what they mean, and what is said about wrong ones.

use technol_target::Simulation;

use super::super::condition::{Condition, Look};
use super::super::messages::Messages;
use super::Fixture;

/// Whether conditions hold after these names were set.
fn check(set: &[(&str, &str)], conditions: &[(&str, bool)]) {
    let fixture = Fixture::new();
    let mut simulation = Simulation::new(fixture.program.clone(), None).expect("it can be loaded");
    let mut messages = Messages::default();
    messages.show(77);
    for (name, value) in set {
        let target = technol_analysis::expression::resolve(&fixture.debug, None, name).expect("a name");
        let assignment = target.in_memory(&fixture.program).assign(value).expect("a value");
        crate::run::changes::assign(&assignment, &mut simulation).expect("in memory");
    }
    for (text, expected) in conditions {
        let condition = Condition::parse(text, &fixture.names()).unwrap_or_else(|e| panic!("{text}: {e:?}"));
        let runtime = simulation.runtime();
        let look = Look { runtime, messages: &messages, mechanisms: &fixture.mechanisms };
        assert_eq!(condition.holds(&look), *expected, "{text}: {}", condition.explain(&look));
    }
}

#[test]
fn numbers_are_compared_as_the_language_shows_them() {
    let set = [("GO", "1"), ("SMALL", "255"), ("COUNT", "1000"), ("REAL.ROOM", "2.5")];
    check(
        &set,
        &[
            ("GO", true),
            ("GO == 1", true),
            ("GO == true", true),
            ("GO != TRUE", false),
            ("!GO", false),
            ("! LAMP", true),
            ("LAMP == GO", false),
            ("COUNT", true),
            ("ZERO", false),
            ("COUNT == 3E8h", false),
            ("COUNT == 03E8h", true),
            ("COUNT < 1000", false),
            ("COUNT <= 1000", true),
            ("COUNT > 999", true),
            ("COUNT>=1001", false),
            ("COUNT != 5", true),
            // Unsigned, unless the other side is negative.
            ("SMALL == 255", true),
            ("SMALL == -1", true),
            ("SMALL > -2", true),
            ("SMALL < 0", false),
            ("SMALL > 200", true),
            ("BYTE.COUNT == 0E8h", true),
            ("HIGH.COUNT == 3", true),
            ("REAL.ROOM == 2.5", true),
            ("REAL.ROOM > 2", true),
            ("REAL.ROOM < 2.499", false),
            ("COUNT == REAL.ROOM", false),
            ("COUNT > REAL.ROOM", true),
            ("CTL.GO && CTL == 1", true),
        ],
    );
}

#[test]
fn and_is_stronger_than_or() {
    check(
        &[("GO", "1")],
        &[
            ("LAMP && LAMP || GO", true),
            ("GO || LAMP && LAMP", true),
            ("LAMP || GO && LAMP", false),
            ("!LAMP && !DONE && GO", true),
            ("!GO == 1", false),
        ],
    );
}

#[test]
fn texts_mechanisms_and_messages_have_comparisons_of_their_own() {
    check(
        &[("WORK", "1"), ("TEXT", "a && b")],
        &[
            ("TEXT == 'a && b'", true),
            ("TEXT != 'a || b'", true),
            ("TEXT == TEXT", true),
            ("SMALL == 'a'", false),
            ("MECH(WORK)", true),
            ("mech( work ) == active", true),
            ("MECH(WORK) == idle", false),
            ("MECH(WORK) != 'TIM'", true),
            ("MECH(MODULE_BLOCK_INIT) == IDLE", true),
            ("MESSAGE(77)", true),
            ("!MESSAGE(78) && MESSAGE( 77 )", true),
        ],
    );
}

#[test]
fn a_wrong_condition_says_where_and_what_is_right() {
    let fixture = Fixture::new();
    let mut said = String::new();
    for text in [
        "",
        "GO &&",
        "GO & LAMP",
        "GO = 1",
        "GO == ",
        "GO == 2",
        "CONT > 5",
        "SMALL == 256",
        "COUNT == -40000",
        "5",
        "TEXT",
        "TEXT == 5",
        "TEXT < 'b'",
        "COUNT == 'lathe'",
        "(GO || LAMP) && DONE",
        "ROOM == 1",
        "2.5.1 == COUNT",
        "MECH(WROK) == idle",
        "MECH(WORK) > idle",
        "GO && MECH(WORK) == EX",
        "GO == MECH(WORK)",
        "MESSAGE(x)",
        "MESSAGE(1) == 1",
        "GO ! LAMP",
    ] {
        let mistake = Condition::parse(text, &fixture.names()).expect_err(text);
        said.push_str(&format!("{text:<24}{:>2} {}\n", mistake.at, mistake.message));
    }
    insta::assert_snapshot!(said, @r"");
}
