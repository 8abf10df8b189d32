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
    insta::assert_snapshot!(text, @r"
    FAILED DONE is forgotten
      a.test.toml:6:2: step 3, at 270 ms, cycle 13
        expected  MECH(WORK) == idle && COUNT == 2 within 200 ms
        actual    WORK is idle, COUNT is 6
      What led to it:
            ms   cycle
             0       0  PLC Starting
             0       0  PLC Running
             0       0  step 1 (line 4)
             0       0  WORK waits at plc.plc:14 EX0 (LDR GO)
            40       2  step 2 (line 5): go
            40       2  GO 0 → 1
            40       2  WORK waits at plc.plc:15 TIM -,3
            70       3  step 3 (line 6)
           100       5  WORK waits at plc.plc:21 TEX0 -,5,FAILED,77 (LOD COUNT / INR / STO COUNT / LDR DONE)
           140       7  COUNT 2 → 3
           160       8  COUNT 3 → 4
           180       9  COUNT 4 → 5
           200      10  message 77 at plc.plc:24
           200      10  COUNT 5 → 6
           200      10  WORK is idle
    ");
}

#[test]
fn all_wrong_values_of_a_step_are_told() {
    let text = report_of(
        "[[test]]\nname = 'values'\n[[test.step]]\nset = { GO = 1 }\nwait = '2 cycles'\n\
         expect = { LAMP = 0, COUNT = '> 5', TEXT = 'mill', SMALL = 'COUNT' }\nstate = { WORK = 'LAST' }\nmessage = 77\n",
    );
    insta::assert_snapshot!(text, @r"
    FAILED values
      a.test.toml:3:1: step 1, at 40 ms, cycle 2
        expected  LAMP == 0
        actual    LAMP is 1
        expected  COUNT > 5
        actual    COUNT is 0
        expected  TEXT == 'mill'
        actual    TEXT is 'lathe'
        expected  MECH(WORK) == LAST
        actual    WORK waits at plc.plc:15 TIM -,3
        expected  message 77
        actual    shown and not ticked off yet: none
      What led to it:
            ms   cycle
             0       0  PLC Starting
             0       0  PLC Running
             0       0  step 1 (line 3)
             0       0  GO 0 → 1
             0       0  LAMP 0 → 1
             0       0  WORK waits at plc.plc:15 TIM -,3
    ");
}

#[test]
fn a_guard_fails_in_the_millisecond_it_is_broken() {
    let text = report_of(
        "[[test]]\nname = 'guard'\nstep = [{ never = 'LAMP', wait = 100 }, { set = { GO = 1 }, wait = 100 }]\n",
    );
    insta::assert_snapshot!(text, @r"
    FAILED guard
      a.test.toml:3:41: step 2, at 101 ms, cycle 5
        expected  never LAMP
        actual    LAMP is 1
      What led to it:
            ms   cycle
             0       0  PLC Starting
             0       0  PLC Running
             0       0  step 1 (line 3)
             0       0  WORK waits at plc.plc:14 EX0 (LDR GO)
           100       5  step 2 (line 3)
           100       5  GO 0 → 1
           100       5  LAMP 0 → 1
           100       5  WORK waits at plc.plc:15 TIM -,3
    ");
    passes(
        "step = [{ never = { dark = 'LAMP' }, wait = 100 }, { end = 'dark', set = { GO = 1 }, wait = 100 }]",
    );
}

#[test]
fn a_fault_of_the_program_fails_unless_it_is_expected() {
    let text = report_of("[[test]]\nname = 'fault'\nstep = [{ block = { m = [3] }, wait = '1 s' }]\n");
    insta::assert_snapshot!(text, @r"
    FAILED fault
      a.test.toml:3:9: step 1, at 1 ms, cycle 0
        expected  no fault of the PLC
        actual    division by zero at plc.plc:34 in MODULE_BLOCK_DONE, cycle 0
      What led to it:
            ms   cycle
             0       0  PLC Starting
             0       0  PLC Running
             0       0  step 1 (line 3)
             0       0  block M3
             0       0  block begun
             0       0  PLC fault: division by zero at plc.plc:34 in MODULE_BLOCK_DONE, cycle 0
             0       0  PLC Faulted
             0       0  MODULE_BLOCK_DONE is active
    ");
    passes(
        "step = [{ block = {}, wait = '1 s', plc-fault = 'division by zero at plc.plc' }, { start = 'cold', wait = 100 }]",
    );
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
    let text = report_of(
        "[[test]]\nname = 'left'\nstep = [{ set = { GO = 1 }, wait = '1 s', no-message = true }]\n",
    );
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
    insta::assert_snapshot!(without, @r#"
    <?xml version="1.0" encoding="UTF-8"?>
    <testsuites name="p &amp; q" tests="2" failures="1" errors="0" skipped="0">
      <testsuite name="a.test.toml" tests="2" failures="1" errors="0" skipped="0">
        <testcase classname="a" name="a &lt; b" file="a.test.toml" line="1"/>
        <testcase classname="a" name="c" file="a.test.toml" line="4">
          <failure type="failure" message="expected GO &gt; 0, GO is 0">FAILED c&#10;  a.test.toml:6:9: step 1, at 0 ms, cycle 0&#10;    expected  GO &gt; 0&#10;    actual    GO is 0&#10;  What led to it:&#10;        ms   cycle&#10;         0       0  PLC Starting&#10;         0       0  PLC Running&#10;         0       0  step 1 (line 6)&#10;</failure>
        </testcase>
      </testsuite>
    </testsuites>
    "#);
}
