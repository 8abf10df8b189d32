//! Conditions: what they mean, and what is said about wrong ones.

use std::fmt::Write as _;

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
            ("COUNT == 3E8h", true),
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
        writeln!(said, "{text:<24}{:>2} {}", mistake.at, mistake.message).expect("a text grows");
    }
    insta::assert_snapshot!(said, @r"
                             0 a condition is missing here, for instance COUNT >= 5
    GO &&                    5 a condition is missing here, for instance COUNT >= 5
    GO & LAMP                3 `&` is not known here; write &&
    GO = 1                   3 `=` compares nothing; write ==
    GO ==                    5 a value is missing here
    GO == 2                  6 GO is a bit, 0 or 1
    CONT > 5                 0 CONT is not declared in this program; did you mean COUNT?
    SMALL == 256             9 SMALL has 8 bits and is never 256: -128 to 255
    COUNT == -40000          9 COUNT has 16 bits and is never -40000: -32768 to 65535
    5                        0 `5` never changes; compare it with something, for instance COUNT >= 5
    TEXT                     0 compare the text: TEXT == 'like this'
    TEXT == 5                8 TEXT is a text: compare it with one between apostrophes, 'like this'
    TEXT < 'b'               7 texts are compared by == and != only
    COUNT == 'lathe'         9 a text is compared with a text buffer (STR) only
    (GO || LAMP) && DONE     0 parentheses do not match; they do not group conditions either: `&&` is stronger than `||`
    ROOM == 1                0 ROOM has no type; say BYTE.ROOM, WORD.ROOM, DWRD.ROOM, QWRD.ROOM or REAL.ROOM
    2.5.1 == COUNT           0 `2.5.1` is not a number
    MECH(WROK) == idle       5 WROK is not a mechanism; there is: WORK, MODULE_BLOCK_INIT, MODULE_BLOCK_DONE
    MECH(WORK) > idle       13 a mechanism is or is not in a state: use == or !=
    GO && MECH(WORK) == EX  20 `EX` is no state of WORK; say idle, active, or a line, a label or words of one of:
        WORK: 14 EX0 (LDR GO)
        WORK: 15 TIM -,3
        LAST: 21 TEX0 -,5,FAILED,77 (LOD COUNT / INR / STO COUNT / LDR DONE)
    GO == MECH(WORK)         6 MECH(…) stands on the left of == and !=, MESSAGE(…) stands alone
    MESSAGE(x)               8 `x` is not the number of a message
    MESSAGE(1) == 1         14 MECH(…) stands on the left of == and !=, MESSAGE(…) stands alone
    GO ! LAMP                3 `!` stands before a name, or in !=
    ");
}
