//! Reading scenario files.

use proptest::prelude::*;
use technol_machine::{BlockFlag, BlockMode};

use super::super::scenario::{Action, Check, Time};
use super::Fixture;

#[test]
fn a_step_is_done_waited_for_and_checked() {
    let mut fixture = Fixture::new();
    let tests = fixture.tests(
        "never = 'LAMP && !GO'\n[[test]]\nname = 'both'\nalways = { quiet = '!MESSAGE(77)' }\n\
         step = [\n { press = 'start', set = { GO = 1, P2IN.3 = true }, until = 'COUNT == 1', at-most = '5 cycles' },\n \
         { end = 'quiet', wait = '2 s', expect = { COUNT = '>= 1', TEXT = 'lathe' }, state = { WORK = 'LAST' }, message = [77] },\n]\n",
    );
    let test = &tests[0];
    assert_eq!((test.name.as_str(), test.guards.len(), test.place.line), ("both", 2, 2));
    let first = &test.steps[0];
    assert!(matches!(
        first.actions.as_slice(),
        [Action::Key { down: true, .. }, Action::Set { .. }, Action::Set { name, .. }] if name == "P2IN.3"
    ));
    assert!(matches!(&first.time, Time::Until { at_most: 100, at_least: 0, .. }));
    let second = &test.steps[1];
    assert_eq!(
        (second.time.clone(), second.ends.as_slice()),
        (Time::Wait { ms: 2000 }, &["quiet".to_owned()][..])
    );
    assert!(matches!(
        second.checks.as_slice(),
        [Check::Holds(_), Check::Holds(_), Check::Holds(_), Check::Message(77)]
    ));
    let names: Vec<&str> = test.values.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["LAMP", "GO", "COUNT", "TEXT", "P2IN.3"], "each name once, for the report");
}

#[test]
fn every_mistake_is_reported_with_its_place() {
    let mut fixture = Fixture::new();
    let said = fixture.mistakes(
        "mashine = 'none'\nalways = 'GO &'\n\n[[test]]\nname = 'wrong'\nsteps = []\n\n  [[test.step]]\n  press = 'strat'\n  \
         fault = ['stuck', 'broken']\n  set = { COUNT = 70000, CUONT = 1, P1IN.0 = 1, TEXT = 'far too long' }\n  \
         block = { m = [3, 100], s = -1, motion = 5 }\n\n  [[test.step]]\n  until = 'COUNT >= CONT'\n  \
         expect = { GO = 2, SMALL = '> ', NOBODY = 1 }\n  state = { WORK = 'EX', WROK = 'idle' }\n  end = 'nothing'\n\n  \
         [[test.step]]\n  wait = '3 minutes'\n  at-most = 5\n  start = 'hot'\n  no-message = -1\n\n[[test]]\nname = 'wrong'\n",
    );
    insta::assert_snapshot!(said, @r#"
    a.test.toml:1:1: `mashine` is no key of a scenario file; there is: machine, part-program, never, always, test
    a.test.toml:2:14: `&` is not known here; write &&
    a.test.toml:6:1: `steps` is no key of a test; there is: name, machine, part-program, never, always, step
    a.test.toml:9:11: the machine has no key `strat`; it has: start
    a.test.toml:10:21: the machine has no fault `broken`; it has: stuck
    a.test.toml:11:19: COUNT: 70000 does not fit: -32768 to 65535
    a.test.toml:11:26: CUONT is not declared in this program; did you mean COUNT?
    a.test.toml:11:37: the machine decides on P1IN.0 and would overwrite it; press a key, switch a fault, or say machine = "none"
    a.test.toml:11:56: TEXT: the text has 12 characters, the buffer holds 8
    a.test.toml:12:21: an M function is a whole number from 0 to 99
    a.test.toml:12:31: `s` is a whole number from 0 to 32767
    a.test.toml:12:35: `motion` is no key of a block; there is: m, s, t, h, motion-ms, rapid, mode, speed, cutting-speed, speed-limit, feed, feed-max, length-mm, dwell, scale, integers, reals, axes, flags
    a.test.toml:15:11: `until` needs `at-most`, the longest time it may take
    a.test.toml:15:21: CONT is not declared in this program; did you mean COUNT?
    a.test.toml:16:19: GO is a bit, 0 or 1
    a.test.toml:16:32: a value is missing here
    a.test.toml:16:36: NOBODY is not declared in this program
    a.test.toml:17:21: `EX` is no state of WORK; say idle, active, or a line, a label or words of one of:
        WORK: 14 EX0 (LDR GO)
        WORK: 15 TIM -,3
        LAST: 21 TEX0 -,5,FAILED,77 (LOD COUNT / INR / STO COUNT / LDR DONE)
    a.test.toml:17:26: WROK is not a mechanism; there is: WORK, MODULE_BLOCK_INIT, MODULE_BLOCK_DONE
    a.test.toml:18:9: no `never` or `always` called nothing has begun; there is: none
    a.test.toml:21:10: a time is a number of milliseconds, or a text such as "2 s" or "5 cycles"; at most an hour
    a.test.toml:22:13: `at-most` belongs to `until`
    a.test.toml:23:11: `start` is "cold" or "warm"
    a.test.toml:24:16: `no-message` is true, or a number: it is a whole number from 0 to 4294967295
    a.test.toml:26:1: a test needs steps: `[[test.step]]`, or `step = [ { … }, … ]`
    a.test.toml:26:1: there is another test `wrong` in this file
    "#);
}

#[test]
fn a_block_has_the_keys_of_the_machine_file() {
    let mut fixture = Fixture::new();
    let tests = fixture.tests(
        "[[test]]\nname = 'a'\nstep = [{ block = { m = [3], t = 5, mode = 'other', feed = 100, dwell = 0.5, \
         integers = [-1, 2], reals = [1.5], axes = [[0, 12.5], [15, -3]], flags = ['thread', 'rev-feed'] } }]\n",
    );
    let [Action::Block(block)] = tests[0].steps[0].actions.as_slice() else { panic!("one block") };
    assert_eq!((block.m.as_slice(), block.t, block.mode), (&[3][..], Some(5), BlockMode::Other));
    let extra = &block.extra;
    assert_eq!((extra.feed, extra.dwell, extra.scale), (Some(100.0), Some(0.5), None));
    assert_eq!((extra.integers.as_slice(), extra.reals.as_slice()), (&[-1, 2][..], &[1.5][..]));
    assert_eq!(extra.axes, [(0, 12.5), (15, -3.0)]);
    assert_eq!(extra.flags, [BlockFlag::Thread, BlockFlag::RevFeed]);
    for (wrong, said) in [
        ("feed = 'fast'", "`feed` is a number"),
        ("dwell = inf", "`dwell` is a number"),
        ("integers = [1, 2, 3, 4, 5, 6]", "`integers` is an array of at most 5 whole numbers"),
        ("integers = [2147483648]", "`integers` is an array"),
        ("axes = [[16, 1.0]]", "`axes` is an array of pairs"),
        ("axes = [1, 2]", "`axes` is an array of pairs"),
        ("flags = ['thred']", "`flags` is \"backward\" or"),
        ("at-cycle = 5", "`at-cycle` is no key of a block"),
    ] {
        let mistakes =
            fixture.mistakes(&format!("[[test]]\nname = 'a'\nstep = [{{ block = {{ {wrong} }} }}]\n"));
        assert!(mistakes.starts_with("a.test.toml:3:") && mistakes.contains(said), "{wrong}: {mistakes}");
    }
}

#[test]
fn what_is_no_toml_or_holds_no_test_says_so() {
    let mut fixture = Fixture::new();
    insta::assert_snapshot!(fixture.mistakes("[[test]]\nname = \n"), @r"a.test.toml:2:8: string values must be quoted, expected literal string");
    insta::assert_snapshot!(fixture.mistakes("machine = 'none'\n"), @r"a.test.toml:1:1: there is no [[test]] in this file");
    insta::assert_snapshot!(fixture.mistakes("test = 5\n"), @r"a.test.toml:1:8: a test is a table, { name = value }");
    insta::assert_snapshot!(fixture.mistakes("machine = 'nowhere.toml'\n[[test]]\nname='a'\nstep = [{wait = 5}]"), @r"a.test.toml:1:11: there is no machine file nowhere.toml");
}

#[test]
fn a_wrong_machine_is_told_once_at_its_own_place() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let machine = folder.path().join("machine.toml");
    std::fs::write(
        &machine,
        "[[limit]]\noutput-forward = 'P0OUT.0'\ntravel-ms = 0\ninput-at-end = 'P1IN.0'\n",
    )
    .expect("it is written");
    let mut fixture = Fixture::new();
    let file = machine.display().to_string().replace('\\', "/");
    // Keys and faults are unknown then, which is no mistake of the tests.
    let said = fixture.mistakes(&format!(
        "machine = '{file}'\n[[test]]\nname='a'\nstep = [{{press = 'go'}}]\n[[test]]\nname='b'\nstep = [{{fault = 'x'}}]"
    ));
    let said = said.replace(&machine.display().to_string(), "machine.toml");
    insta::assert_snapshot!(said, @"machine.toml:3:13: limit[0].travel-ms: must be at least 1");
}

/// Pieces that scenario files are made of, and some that they are not.
const PIECES: &[&str] = &[
    "[[test]]\n",
    "[[test.step]]\n",
    "name = 'a'\n",
    "name = ''\n",
    "set = { GO = 1 }\n",
    "set = { P1IN.3.4 = 1 }\n",
    "set = { WORD.COUNT = 5 }\n",
    "expect = { COUNT = '>= 5' }\n",
    "expect = { TEXT = '''a''' }\n",
    "expect = {}\n",
    "until = 'GO'\n",
    "until = \"G\\u004F == 'ž\"\n",
    "at-most = '5 cycles'\n",
    "at-most = 99999999999999999999\n",
    "wait = '18446744073709551615 s'\n",
    "state = { WORK = 'LAST' }\n",
    "state = { WORK = 15 }\n",
    "step = [{}]\n",
    "never = ['(', '||', '!!', 'MECH(']\n",
    "always = { a = 'MESSAGE(99999999999)' }\n",
    "end = 'a'\n",
    "machine = 'none'\n",
    "block = [{ m = [3] }, { t = 5, mode = 'other' }]\n",
    "press = 'start'\n",
    "fault = [[['x']]]\n",
    "message = [1, 2]\n",
    "expect = { \"'\" = \"'\" }\n",
    "until = '(COUNT+70000) == 1'\n",
    "set = { DR = -0x10, BX = 1979-05-27 }\n",
    "ž = 'ž'\n",
];

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_text_makes_the_reader_panic(picks in prop::collection::vec(0..PIECES.len(), 0..14), cut in 0_usize..400) {
        let mut text: String = picks.iter().map(|pick| PIECES[*pick]).collect();
        let cut = (0..=cut.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
        thread_local!(static FIXTURE: std::cell::RefCell<Fixture> = std::cell::RefCell::new(Fixture::new()));
        FIXTURE.with_borrow_mut(|fixture| {
            let _ = fixture.read(&text);
            text.truncate(cut);
            let _ = fixture.read(&text);
        });
    }
}
