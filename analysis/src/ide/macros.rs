//! The features on macros: calls, parameters, bodies.

use super::fixture::fixture;
use crate::catalogue::Language;

const DEFINITIONS: &str = "\
;--- copies a bit ---
;for lamps
DEF_T_MACRO Copy FROM, TO
 T_LOCAL NEXT
 LDR TMAC.FROM
 JL0 NEXT
 LDR DOOR
 WR TMAC.TO
NEXT:
END_T_MACRO T_END, C_0, D_ON
 APPEND_T_MACRO SHOW, COPY, T_END
";

fn text(definitions: &str, main: &str) -> String {
    format!(
        "//- main.plc\n T_INCLUDE copy.inc\nDATA\nKEYS: DFM START,DOOR\nLAMPS: DFM RED\nDATA_END\nMODULE_MAIN\n{main}\
         MODULE_MAIN_END\n//- copy.inc\n{definitions}"
    )
}

fn with_main(main: &str) -> String {
    text(DEFINITIONS, main)
}

fn in_body(from: &str, to: &str) -> String {
    text(&DEFINITIONS.replacen(from, to, 1), " COPY START,RED\n")
}

fn definition(text: &str) -> String {
    let it = fixture(text);
    let found = it.analysis.definition(&it.file, it.at).expect("not cancelled");
    found.iter().map(|location| it.show(location)).collect()
}

fn references(text: &str) -> String {
    let it = fixture(text);
    let found = it.analysis.references(&it.file, it.at, true).expect("not cancelled");
    let show = |r: &crate::ide::Reference| format!("{:?} {}", r.access, it.show(&r.location));
    found.iter().map(show).collect()
}

fn hover(text: &str, language: Language) -> String {
    let it = fixture(text);
    let found = it.analysis.hover(&it.file, it.at, language).expect("not cancelled");
    found.map_or_else(|| "nothing".to_owned(), |hover| hover.markdown)
}

fn completions(text: &str) -> Vec<String> {
    let it = fixture(text);
    let found = it.analysis.completion(&it.file, it.at, Language::En).expect("not cancelled");
    found.into_iter().map(|completion| format!("{:?} {}", completion.kind, completion.insert)).collect()
}

#[test]
fn a_call_leads_to_the_definition() {
    insta::assert_snapshot!(definition(&with_main(" CO<CURSOR>PY START,RED\n")), @"copy.inc:3 DEF_T_MACRO «Copy» FROM, TO");
    insta::assert_snapshot!(definition(&with_main(" SH<CURSOR>OW START,RED\n")), @"
    copy.inc:3 DEF_T_MACRO «Copy» FROM, TO
    copy.inc:11 APPEND_T_MACRO «SHOW», COPY, T_END
    ");
    insta::assert_snapshot!(definition(&with_main(" COPY STA<CURSOR>RT,RED\n")), @"main.plc:3 KEYS: DFM «START»,DOOR");
}

#[test]
fn parameters_and_local_symbols_lead_to_where_they_are_named() {
    insta::assert_snapshot!(definition(&in_body("TMAC.FROM", "TMAC.FR<CURSOR>OM")), @"copy.inc:3 DEF_T_MACRO Copy «FROM», TO");
    insta::assert_snapshot!(definition(&in_body("JL0 NEXT", "JL0 NE<CURSOR>XT")), @"copy.inc:4 T_LOCAL «NEXT»");
    insta::assert_snapshot!(definition(&in_body("LDR DOOR", "LDR DO<CURSOR>OR")), @"main.plc:3 KEYS: DFM START,«DOOR»");
    insta::assert_snapshot!(references(&in_body("TMAC.TO", "TMAC.T<CURSOR>O")), @"
    Declare copy.inc:3 DEF_T_MACRO Copy FROM, «TO»
    Write copy.inc:8 WR TMAC.«TO»
    ");
}

#[test]
fn uses_are_found_in_calls_and_in_bodies() {
    insta::assert_snapshot!(references(&with_main(" COPY START,RED\n LDR DO<CURSOR>OR\n SHOW DOOR,RED\n")), @"
    Declare main.plc:3 KEYS: DFM START,«DOOR»
    Read main.plc:8 LDR «DOOR»
    Read main.plc:9 SHOW «DOOR»,RED
    Read copy.inc:7 LDR «DOOR»
    ");
    insta::assert_snapshot!(references(&with_main(" COPY START,R<CURSOR>ED\n")), @"
    Declare main.plc:4 LAMPS: DFM «RED»
    Write main.plc:7 COPY START,«RED»
    ");
    insta::assert_snapshot!(references(&with_main(" CO<CURSOR>PY START,RED\n SHOW START,RED\n")), @"
    Call main.plc:7 «COPY» START,RED
    Declare copy.inc:3 DEF_T_MACRO «Copy» FROM, TO
    Call copy.inc:11 APPEND_T_MACRO SHOW, «COPY», T_END
    ");
}

#[test]
fn a_call_shows_the_header_and_the_comment_before_it() {
    insta::assert_snapshot!(hover(&with_main(" CO<CURSOR>PY START,RED\n"), Language::En), @"
    ```technol
    DEF_T_MACRO Copy FROM, TO
    ```
    user instruction · T_END · takes break-points · `copy.inc`:3

    copies a bit
    for lamps
    ");
    insta::assert_snapshot!(hover(&in_body("TMAC.FROM", "TMAC.FR<CURSOR>OM"), Language::Cs), @"
    ```technol
    DEF_T_MACRO Copy FROM, TO
    ```
    parametr makra
    ");
}

#[test]
fn completion_offers_macros_where_they_are_defined_and_parameters_in_bodies() {
    assert_eq!(completions(&with_main(" COP<CURSOR>\n")), ["Macro Copy"]);
    assert!(completions(&with_main(" SHO<CURSOR>\n")).contains(&"Macro SHOW".to_owned()));
    let before =
        with_main("").replacen(" T_INCLUDE copy.inc\nDATA\n", " COP<CURSOR>\n T_INCLUDE copy.inc\nDATA\n", 1);
    assert!(!completions(&before).iter().any(|found| found.starts_with("Macro")), "not defined yet");
    assert_eq!(completions(&in_body("TMAC.FROM", "TMAC.<CURSOR>")), ["Parameter FROM", "Parameter TO"]);
    let operands = completions(&in_body("LDR TMAC.FROM", "LDR <CURSOR>"));
    assert!(operands.contains(&"Parameter TMAC.FROM".to_owned()), "{operands:?}");
    assert!(operands.contains(&"Parameter NEXT".to_owned()), "{operands:?}");
    let own = completions(&in_body("LDR TMAC.FROM", "COP<CURSOR>"));
    assert!(!own.contains(&"Macro Copy".to_owned()), "a macro cannot call itself: {own:?}");
}
