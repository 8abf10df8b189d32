//! What the editor asks about a program.

use serde_json::{Value, json};

use super::client::Client;

const DOCUMENT: &str = "untitled:Untitled-1";

/// A whole program; `{data}` and `{main}` are what a test is about.
pub(super) fn program(data: &str, main: &str) -> String {
    let empty = |name: &str| format!("MODULE_{name}\nMODULE_{name}_END\n");
    format!(
        "DATA\n{data}DATA_END\nMODULE_MAIN\n{main}MODULE_MAIN_END\n{}{}{}{}{}{}STOP\n",
        empty("INPUT"),
        empty("BLOCK_INIT"),
        empty("BLOCK_DONE"),
        empty("INIT"),
        empty("CLEAR"),
        empty("HALT"),
    )
}

fn capabilities() -> Value {
    json!({
        "textDocument": {
            "documentSymbol": { "hierarchicalDocumentSymbolSupport": true },
            "codeAction": { "codeActionLiteralSupport": { "codeActionKind": { "valueSet": ["quickfix"] } } },
            "publishDiagnostics": { "relatedInformation": true },
        },
        "workspace": { "workspaceEdit": { "documentChanges": true } },
    })
}

fn with(text: &str, options: &Value) -> Client {
    let mut client = Client::start(None, &capabilities(), options);
    client.open(DOCUMENT, 1, text);
    client
}

fn at(line: u32, character: u32) -> Value {
    json!({ "textDocument": { "uri": DOCUMENT }, "position": { "line": line, "character": character } })
}

/// `line:from-to` of a range.
fn range(value: &Value) -> String {
    let (start, end) = (&value["start"], &value["end"]);
    format!("{}:{}-{}", start["line"], start["character"], end["character"])
}

#[test]
fn a_sound_program_has_no_diagnostics_and_mistakes_come_and_go_with_the_text() {
    let mut client = with(
        &program(
            "        DFM ON_LAMP,,,,,,,\n",
            "        LDR ON_LAMP\n        WR ON_LAMP\n        LDR ON_LAMP\n        FL1 0,ON_LAMP\n",
        ),
        &json!(null),
    );
    assert_eq!(client.diagnostics(DOCUMENT, Some(1)), Vec::<String>::new());
    client.edit(DOCUMENT, 2, (4, 12, 4, 19), "NOBODY");
    assert_eq!(client.diagnostics(DOCUMENT, Some(2)), ["T0301 4:12-18"]);
    client.edit(DOCUMENT, 3, (4, 12, 4, 18), "ON_LAMP");
    assert_eq!(client.diagnostics(DOCUMENT, Some(3)), Vec::<String>::new());
    client.close(DOCUMENT);
}

#[test]
fn columns_after_astral_characters_are_utf16_unless_utf8_was_agreed() {
    let text = program("", "        LDR '𝄞ř' NOBODY\n        LDR NOBODY ; 𝄞\n");
    let mut client = with(&text, &json!(null));
    let found = client.diagnostics(DOCUMENT, Some(1));
    assert!(found.contains(&"T0301 4:12-18".to_owned()), "{found:?}");
    // Inserting behind the clef: two units in UTF-16.
    client.edit(DOCUMENT, 2, (4, 25, 4, 27), "");
    client.edit(DOCUMENT, 3, (4, 0, 4, 12), "WR ");
    assert!(client.diagnostics(DOCUMENT, Some(3)).contains(&"T0301 4:3-9".to_owned()));

    let mut client = Client::start(
        None,
        &json!({ "general": { "positionEncodings": ["utf-8", "utf-16"] } }),
        &json!(null),
    );
    client.open(DOCUMENT, 1, &program("", "        STR 𝄞 NOBODY\n"));
    let utf8 = client.diagnostics(DOCUMENT, Some(1));
    assert!(utf8.iter().any(|it| it.ends_with("3:12-16")), "the clef is four bytes: {utf8:?}");
}

#[test]
fn hovers_speak_the_language_that_is_set() {
    let mut client = with(&program("", "        LDR 1\n"), &json!({ "language": "cs" }));
    let hover = |client: &mut Client| client.request("textDocument/hover", &at(3, 9));
    let czech = hover(&mut client);
    assert_eq!(czech["contents"]["kind"], "markdown");
    assert_eq!(range(&czech["range"]), "3:8-11");
    client.notify(
        "workspace/didChangeConfiguration",
        &json!({ "settings": { "technol": { "language": "en" } } }),
    );
    let english = hover(&mut client);
    let text = |hover: &Value| hover["contents"]["value"].as_str().unwrap().to_owned();
    assert!(text(&czech).contains("rovnic"), "{}", text(&czech));
    assert!(text(&english).contains("equation"), "{}", text(&english));
    assert_eq!(client.request("textDocument/hover", &at(99, 0)), Value::Null);
}

#[test]
fn definition_references_and_highlights_agree() {
    let mut client =
        with(&program("        DFM LAMP,,,,,,,\n", "        LDR LAMP\n        WR LAMP\n"), &json!(null));
    let definition = client.request("textDocument/definition", &at(4, 13));
    assert_eq!(definition[0]["uri"], DOCUMENT);
    assert_eq!(range(&definition[0]["range"]), "1:12-16");
    let mut asked = at(1, 12);
    asked["context"] = json!({ "includeDeclaration": true });
    let ranges = |found: &Value| -> Vec<String> {
        found.as_array().unwrap().iter().map(|it| range(&it["range"])).collect()
    };
    assert_eq!(ranges(&client.request("textDocument/references", &asked)), ["1:12-16", "4:12-16", "5:11-15"]);
    asked["context"] = json!({ "includeDeclaration": false });
    assert_eq!(ranges(&client.request("textDocument/references", &asked)), ["4:12-16", "5:11-15"]);
    let marks = client.request("textDocument/documentHighlight", &at(1, 13));
    let kinds: Vec<i64> = marks.as_array().unwrap().iter().map(|it| it["kind"].as_i64().unwrap()).collect();
    assert_eq!(
        (ranges(&marks), kinds),
        (vec!["1:12-16".into(), "4:12-16".into(), "5:11-15".into()], vec![1, 2, 3])
    );
}

#[test]
fn the_outline_nests_where_the_client_can_show_it() {
    let main = "MECH_BEGIN DOOR\n        EX\nMECH_END DOOR\n";
    let text = program("SPEED:  DS 2\n", main);
    let mut client = with(&text, &json!(null));
    let asked = json!({ "textDocument": { "uri": DOCUMENT } });
    let outline = client.request("textDocument/documentSymbol", &asked);
    let names = |list: &Value| -> Vec<String> {
        list.as_array().map_or_else(Vec::new, |list| {
            list.iter().map(|it| it["name"].as_str().unwrap().to_owned()).collect()
        })
    };
    assert_eq!(names(&outline)[..2], ["DATA", "MODULE_MAIN"]);
    assert_eq!(names(&outline[0]["children"]), ["SPEED"]);
    assert_eq!(names(&outline[1]["children"]), ["DOOR"]);
    assert_eq!(outline[1]["range"]["start"]["line"], 3);

    let mut client = Client::start(None, &json!({}), &json!(null));
    client.open(DOCUMENT, 1, &text);
    let flat = client.request("textDocument/documentSymbol", &asked);
    let door = flat.as_array().unwrap().iter().find(|it| it["name"] == "DOOR").unwrap();
    assert_eq!(
        (&door["containerName"], range(&door["location"]["range"])),
        (&json!("MODULE_MAIN"), "4:11-15".to_owned())
    );
}

#[test]
fn workspace_symbols_find_a_part_of_a_name() {
    let mut client = with(&program("SPEED:  DS 2\nSPEED_LIMIT: DS 2\nOTHER: DS 1\n", ""), &json!(null));
    let found = client.request("workspace/symbol", &json!({ "query": "spee" }));
    let names: Vec<&str> = found.as_array().unwrap().iter().map(|it| it["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["SPEED", "SPEED_LIMIT"]);
    assert_eq!(found[0]["location"]["uri"], DOCUMENT);
}

#[test]
fn completion_offers_what_fits_and_replaces_the_word() {
    let mut client = with(
        &program("LEVEL:  DS 2\n        DFM LEVEL_LOW,,,,,,,\n", "        LDR LEV\n        LO\n"),
        &json!(null),
    );
    let labels = |list: &Value| -> Vec<String> {
        assert_eq!(list["isIncomplete"], false);
        list["items"].as_array().unwrap().iter().map(|it| it["label"].as_str().unwrap().to_owned()).collect()
    };
    let operand = client.request("textDocument/completion", &at(5, 15));
    assert!(labels(&operand).contains(&"LEVEL_LOW".to_owned()), "{operand}");
    let bit = operand["items"].as_array().unwrap().iter().find(|it| it["label"] == "LEVEL_LOW").unwrap();
    assert_eq!(
        (bit["textEdit"]["newText"].as_str(), range(&bit["textEdit"]["range"])),
        (Some("LEVEL_LOW"), "5:12-15".into())
    );
    let operation = client.request("textDocument/completion", &at(6, 10));
    assert!(labels(&operation).contains(&"LOD".to_owned()), "{operation}");
}

#[test]
fn what_nobody_uses_is_faded_where_the_client_can() {
    let text = program("OLD:    DS 2\n", "");
    for (abilities, tags) in
        [(json!({ "tagSupport": { "valueSet": [1, 2] } }), json!([1])), (json!({}), Value::Null)]
    {
        let capabilities = json!({ "textDocument": { "publishDiagnostics": abilities } });
        let mut client = Client::start(None, &capabilities, &json!(null));
        client.open(DOCUMENT, 1, &text);
        let message = client.wait_until(|it| {
            it["method"] == "textDocument/publishDiagnostics" && it["params"]["version"] == json!(1)
        });
        let found = &message["params"]["diagnostics"][0];
        assert_eq!((&found["code"], &found["severity"], &found["tags"]), (&json!("T1133"), &json!(4), &tags));
    }
}

#[test]
fn a_fix_comes_as_an_edit_of_the_version_it_is_for() {
    let mut client = with(
        &program("CELL:   DS 2\n", "        LOD CNTS.5\n        STO CELL\n        LOD CELL\n"),
        &json!(null),
    );
    assert_eq!(client.diagnostics(DOCUMENT, Some(1)), ["T0112 4:12-16"]);
    let here = json!({ "start": { "line": 4, "character": 13 }, "end": { "line": 4, "character": 13 } });
    let asked = |range: &Value, context: Value| json!({ "textDocument": { "uri": DOCUMENT }, "range": range, "context": context });
    let actions = client.request("textDocument/codeAction", &asked(&here, json!({ "diagnostics": [] })));
    let action = &actions[0];
    assert_eq!((&action["kind"], &action["diagnostics"][0]["code"]), (&json!("quickfix"), &json!("T0112")));
    let change = &action["edit"]["documentChanges"][0];
    assert_eq!(change["textDocument"], json!({ "uri": DOCUMENT, "version": 1 }));
    assert_eq!(change["edits"][0]["newText"], "CNST");
    // The other way: to let it stand.
    assert_eq!(actions[1]["title"], "allow T0112 misspelled-prefix here");
    assert_eq!(actions[1]["edit"]["documentChanges"][0]["edits"][0]["newText"], " ;technol: allow(T0112)");
    assert_eq!(actions.as_array().map(Vec::len), Some(2), "{actions}");
    let elsewhere = json!({ "start": { "line": 5, "character": 0 }, "end": { "line": 6, "character": 0 } });
    assert_eq!(
        client.request("textDocument/codeAction", &asked(&elsewhere, json!({ "diagnostics": [] }))),
        json!([])
    );
    let refactorings = json!({ "diagnostics": [], "only": ["refactor"] });
    assert_eq!(client.request("textDocument/codeAction", &asked(&here, refactorings)), json!([]));
}
