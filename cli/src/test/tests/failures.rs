//! Running tests, and what is said when they fail.

use super::super::{junit, report};
use super::Fixture;
use crate::paint::Paint;

/// The report of a test that fails.
fn report_of(scenario: &str) -> String {
    let mut fixture = Fixture::new();
    let tests = fixture.tests(scenario);
    let verdict = fixture.run(&tests[0]);
    report::failure(&tests[0], &verdict.failure.expect("it fails"), Paint::none())
}

#[track_caller]
fn passes(steps: &str) {
    let mut fixture = Fixture::new();
    let tests = fixture.tests(&format!("[[test]]\nname = 'a'\n{steps}\n"));
    assert_eq!(fixture.run(&tests[0]).failure, None);
}

#[test]
fn a_test_passes_in_virtual_time() {
    passes(
        "step = [
         { wait = '1 cycle', state = { WORK = 'EX0' }, expect = { LAMP = 0 } },
         { set = { GO = 1 }, until = 'LAMP', at-most = 20, state = { WORK = 'TIM' } },
         { until = 'COUNT == 1', at-least = '3 cycles', at-most = '3 cycles', state = { WORK = 'LAST' } },
         { set = { DONE = 1 }, until = 'MECH(WORK) == idle', at-most = 20, no-message = true },
         ]",
    );
}

#[test]
fn a_failed_wait_tells_what_led_to_it() {
    let text = report_of(
        "[[test]]\nname = 'DONE is forgotten'\nstep = [\n { wait = 40 },\n { name = 'go', set = { GO = 1 }, wait = 30 },\n \
         { until = 'MECH(WORK) == idle && COUNT == 2', at-most = '10 cycles' },\n]\n",
    );
    insta::assert_snapshot!(text, @r"");
}

#[test]
fn all_wrong_values_of_a_step_are_told() {
    let text = report_of(
        "[[test]]\nname = 'values'\n[[test.step]]\nset = { GO = 1 }\nwait = '2 cycles'\n\
         expect = { LAMP = 0, COUNT = '> 5', TEXT = 'mill', SMALL = 'COUNT' }\nstate = { WORK = 'LAST' }\nmessage = 77\n",
    );
    insta::assert_snapshot!(text, @r"");
}

#[test]
fn a_guard_fails_in_the_millisecond_it_is_broken() {
    let text = report_of(
        "[[test]]\nname = 'guard'\nstep = [{ never = 'LAMP', wait = 100 }, { set = { GO = 1 }, wait = 100 }]\n",
    );
    insta::assert_snapshot!(text, @r"");
    passes("step = [{ never = { dark = 'LAMP' }, wait = 100 }, { end = 'dark', set = { GO = 1 }, wait = 100 }]");
}

#[test]
fn a_fault_of_the_program_fails_unless_it_is_expected() {
    let text = report_of("[[test]]\nname = 'fault'\nstep = [{ block = { m = [3] }, wait = '1 s' }]\n");
    insta::assert_snapshot!(text, @r"");
    passes("step = [{ block = {}, wait = '1 s', plc-fault = 'division by zero at plc.plc' }, { start = 'cold', wait = 100 }]");
}

#[test]
fn messages_are_ticked_off() {
    passes(
        "step = [
         { set = { GO = 1 }, until = 'MESSAGE(77)', at-most = '10 cycles', no-message = 78 },
         { message = 77 },
         { no-message = true },
         ]",
    );
    let text = report_of("[[test]]\nname = 'left'\nstep = [{ set = { GO = 1 }, wait = '1 s', no-message = true }]\n");
    assert!(text.contains("expected  no message\n    actual    shown: 77\n"), "{text}");
}

#[test]
fn junit_holds_every_test_and_the_whole_failure() {
    let mut fixture = Fixture::new();
    let tests = fixture.tests(
        "[[test]]\nname = 'a < b'\nstep = [{ wait = 20 }]\n[[test]]\nname = 'c'\nstep = [{ expect = { GO = '> 0' } }]\n",
    );
    let verdicts: Vec<_> = tests.iter().map(|test| fixture.run(test)).collect();
    let results: Vec<_> = tests.iter().zip(&verdicts).collect();
    let document = junit::document("p & q", &results);
    // What it took is another time on each machine.
    let times: Vec<&str> = document.split(" time=\"").collect();
    let rest = times[1..].iter().map(|part| part.split_once('"').expect("a time").1);
    let without: String = std::iter::once(times[0]).chain(rest).collect();
    insta::assert_snapshot!(without, @r"");
}
