//! Projects of several files, on the disk and in the editor.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};
use tempfile::TempDir;

use super::client::Client;
use super::language::program;

/// The address of a file in the project.
fn uri(folder: &TempDir, name: &str) -> String {
    format!("file://{}/{name}", folder.path().display())
}

fn write(folder: &Path, files: &[(&str, &str)]) {
    for (name, text) in files {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
}

const MANIFEST: &str = "[project]\nname = \"two\"\nmain = \"main.plc\"\nfiles = [\"second.plc\"]\n";
const SECOND: &str = "DATA\nDATA_END\nMODULE_MAIN\n        LDR LAMP\n        WR LAMP\nMODULE_MAIN_END\n";

/// Two program files and an include, all sound.
fn project() -> TempDir {
    let folder = TempDir::new().unwrap();
    let main = format!(
        "T_INCLUDE inc/limits.inc\n{}",
        program("        DFM LAMP,,,,,,,\n", "        LOD CNST.LIMIT\n")
    );
    let files = [
        ("technol.toml", MANIFEST),
        ("main.plc", main.as_str()),
        ("second.plc", SECOND),
        ("inc/limits.inc", "EQUI LIMIT,5\n"),
    ];
    write(folder.path(), &files);
    folder
}

fn start(folder: &TempDir, capabilities: &Value) -> Client {
    Client::start(Some(&format!("file://{}", folder.path().display())), capabilities, &json!(null))
}

fn at(uri: &str, line: u32, character: u32) -> Value {
    json!({ "textDocument": { "uri": uri }, "position": { "line": line, "character": character } })
}

fn changed(client: &mut Client, uri: &str) {
    client.notify("workspace/didChangeWatchedFiles", &json!({ "changes": [{ "uri": uri, "type": 2 }] }));
}

#[test]
fn a_definition_leads_into_another_file_and_references_back() {
    let folder = project();
    let mut client = start(&folder, &json!({}));
    let second = uri(&folder, "second.plc");
    client.open(&second, 1, SECOND);
    assert_eq!(client.diagnostics(&second, Some(1)), Vec::<String>::new());
    let found = client.request("textDocument/definition", &at(&second, 3, 13));
    assert_eq!(found[0]["uri"], uri(&folder, "main.plc"));
    assert_eq!(found[0]["range"]["start"], json!({ "line": 2, "character": 12 }));
    let mut asked = at(&second, 3, 13);
    asked["context"] = json!({ "includeDeclaration": true });
    let found = client.request("textDocument/references", &asked);
    let files: Vec<&str> = found
        .as_array()
        .unwrap()
        .iter()
        .map(|it| it["uri"].as_str().unwrap().rsplit('/').next().unwrap())
        .collect();
    assert_eq!(files, ["main.plc", "second.plc", "second.plc"]);
}

#[test]
fn an_edit_in_one_file_shows_in_another_that_is_not_open() {
    let folder = project();
    let mut client = start(&folder, &json!({}));
    let main = uri(&folder, "main.plc");
    let text = fs::read_to_string(folder.path().join("main.plc")).unwrap();
    client.open(&main, 7, &text);
    assert_eq!(client.diagnostics(&main, Some(7)), Vec::<String>::new());
    client.edit(&main, 8, (2, 12, 2, 16), "BULB");
    let second = uri(&folder, "second.plc");
    assert_eq!(client.diagnostics(&second, None), ["T0301 3:12-16", "T0301 4:11-15"]);
    client.edit(&main, 9, (2, 12, 2, 16), "LAMP");
    assert_eq!(client.diagnostics(&second, None), Vec::<String>::new());
}

#[test]
fn closing_a_file_brings_back_what_is_on_the_disk() {
    let folder = project();
    let mut client = start(&folder, &json!({}));
    let second = uri(&folder, "second.plc");
    client.open(&second, 1, &SECOND.replace("LDR LAMP", "LDR NOBODY"));
    assert_eq!(client.diagnostics(&second, Some(1)), ["T0301 3:12-18"]);
    client.close(&second);
    assert_eq!(client.diagnostics(&second, None), Vec::<String>::new());
}

#[test]
fn files_changed_behind_the_editor_are_read_again() {
    let folder = project();
    let mut client = start(&folder, &json!({}));
    write(folder.path(), &[("second.plc", &SECOND.replace("WR LAMP", "WR NOBODY"))]);
    let second = uri(&folder, "second.plc");
    changed(&mut client, &second);
    assert_eq!(client.diagnostics(&second, None), ["T0301 4:11-17"]);
    write(folder.path(), &[("second.plc", SECOND)]);
    changed(&mut client, &second);
    assert_eq!(client.diagnostics(&second, None), Vec::<String>::new());
}

#[test]
fn a_file_that_was_missed_is_read_once_it_is_there() {
    let folder = project();
    let elsewhere = TempDir::new().unwrap();
    let manifest = format!("{MANIFEST}include-dirs = [\"{}\"]\n", elsewhere.path().display());
    write(folder.path(), &[("technol.toml", &manifest)]);
    let text =
        fs::read_to_string(folder.path().join("main.plc")).unwrap().replace("inc/limits.inc", "more.inc");
    write(folder.path(), &[("main.plc", &text)]);
    let mut client = start(&folder, &json!({}));
    let main = uri(&folder, "main.plc");
    assert_eq!(client.diagnostics(&main, None), ["T0009 0:10-18", "T0301 5:17-22"]);
    write(elsewhere.path(), &[("more.inc", "EQUI LIMIT,5\n")]);
    changed(&mut client, &uri(&elsewhere, "more.inc"));
    assert_eq!(client.diagnostics(&main, None), Vec::<String>::new());
}

#[test]
fn an_include_is_read_when_its_line_is_typed_and_missed_when_it_goes() {
    let folder = project();
    let mut client = start(&folder, &json!({}));
    let main = uri(&folder, "main.plc");
    let text = fs::read_to_string(folder.path().join("main.plc")).unwrap();
    client.open(&main, 1, text.split_once('\n').unwrap().1);
    assert_eq!(client.diagnostics(&main, Some(1)), ["T0301 4:17-22"]);
    client.edit(&main, 2, (0, 0, 0, 0), "T_INCLUDE inc/limits.inc\n");
    assert_eq!(client.diagnostics(&main, Some(2)), Vec::<String>::new());
    // What the open include says counts before it is saved.
    let limits = uri(&folder, "inc/limits.inc");
    client.open(&limits, 1, "EQUI LIMIT,5\n");
    client.edit(&limits, 2, (0, 5, 0, 10), "OTHER");
    client.wait_until(|it| it["params"]["uri"] == main && it["params"]["diagnostics"][0]["code"] == "T0301");
}

#[test]
fn a_manifest_is_checked_while_it_is_typed() {
    let folder = project();
    let mut client = start(&folder, &json!({}));
    let manifest = uri(&folder, "technol.toml");
    client.open(&manifest, 1, MANIFEST);
    assert_eq!(client.diagnostics(&manifest, Some(1)), Vec::<String>::new());
    client.edit(&manifest, 2, (2, 8, 2, 12), "mine");
    let found = client.diagnostics(&manifest, Some(2));
    assert_eq!(found, ["T0004 2:7-17"]);
    assert_eq!(client.request("textDocument/hover", &at(&manifest, 1, 1)), Value::Null);
}

#[test]
fn a_file_outside_every_project_is_one_by_itself_until_a_manifest_takes_it_in() {
    let folder = TempDir::new().unwrap();
    let mut client = Client::start(None, &json!({}), &json!(null));
    let second = uri(&folder, "second.plc");
    client.open(&second, 1, SECOND);
    let alone = client.diagnostics(&second, Some(1));
    assert!(alone.iter().any(|it| it.starts_with("T0301")), "{alone:?}");
    let main = program("        DFM LAMP,,,,,,,\n", "");
    write(folder.path(), &[("technol.toml", MANIFEST), ("main.plc", &main), ("second.plc", SECOND)]);
    let manifest = uri(&folder, "technol.toml");
    changed(&mut client, &manifest);
    client.wait_until(|it| it["params"]["uri"] == second && it["params"]["diagnostics"] == json!([]));
    let found = client.request("textDocument/definition", &at(&second, 3, 13));
    assert_eq!(found[0]["uri"], uri(&folder, "main.plc"));
}

#[test]
fn a_fragment_nobody_includes_is_only_checked_line_by_line() {
    let folder = TempDir::new().unwrap();
    let mut client = Client::start(None, &json!({}), &json!(null));
    let fragment = uri(&folder, "part.inc");
    client.open(&fragment, 1, "EQUI LIMIT,5\nEQUI BAD,1x2\nEQUI LIMIT,6\n");
    assert_eq!(client.diagnostics(&fragment, Some(1)), ["T0104 1:9-12"]);
}

#[test]
fn what_was_found_is_withdrawn_with_the_last_file_of_a_project_that_is_no_folder_of_the_editor() {
    let folder = project();
    write(folder.path(), &[("second.plc", &SECOND.replace("WR LAMP", "WR NOBODY"))]);
    let mut client = Client::start(None, &json!({}), &json!(null));
    let (main, second) = (uri(&folder, "main.plc"), uri(&folder, "second.plc"));
    client.open(&main, 1, &fs::read_to_string(folder.path().join("main.plc")).unwrap());
    assert_eq!(client.diagnostics(&second, None), ["T0301 4:11-17"]);
    client.close(&main);
    assert_eq!(client.diagnostics(&second, None), Vec::<String>::new());
}

#[test]
fn the_client_s_spelling_of_an_address_is_kept() {
    let folder = project();
    let mut client = start(&folder, &json!({}));
    let odd = format!("file://{}/./second%2Eplc", folder.path().display());
    client.open(&odd, 1, &SECOND.replace("LDR LAMP", "LDR NOBODY"));
    assert_eq!(client.diagnostics(&odd, Some(1)), ["T0301 3:12-18"]);
}

#[test]
fn folders_come_and_go() {
    let folder = project();
    write(folder.path(), &[("second.plc", &SECOND.replace("WR LAMP", "WR NOBODY"))]);
    let mut client = Client::start(None, &json!({}), &json!(null));
    let second = uri(&folder, "second.plc");
    let this = json!([{ "uri": format!("file://{}", folder.path().display()), "name": "two" }]);
    let event = |added: &Value, removed: &Value| json!({ "event": { "added": added, "removed": removed } });
    client.notify("workspace/didChangeWorkspaceFolders", &event(&this, &json!([])));
    assert_eq!(client.diagnostics(&second, None), ["T0301 4:11-17"]);
    client.notify("workspace/didChangeWorkspaceFolders", &event(&json!([]), &this));
    assert_eq!(client.diagnostics(&second, None), Vec::<String>::new());
}

const ERRORS: &str = "<PlcErrors>\n <PlcError No=\"5\" Type=\"Err\" Validity=\"Transient\">\n  <Text>Door</Text>\n </PlcError>\n</PlcErrors>\n";

#[test]
fn configuration_files_are_checked_as_they_are_typed() {
    let folder = project();
    let second = SECOND.replace("WR LAMP", "ESET1 5");
    write(folder.path(), &[("second.plc", &second), ("Plc0.PlcErrors", ERRORS)]);
    let mut client = start(&folder, &json!({}));
    let (program, errors) = (uri(&folder, "second.plc"), uri(&folder, "Plc0.PlcErrors"));
    client.open(&program, 1, &second);
    assert_eq!(client.diagnostics(&program, Some(1)), Vec::<String>::new());
    let found = client.request("textDocument/definition", &at(&program, 4, 15));
    assert_eq!(found[0]["uri"], errors);
    client.open(&errors, 1, ERRORS);
    assert_eq!(client.diagnostics(&errors, Some(1)), Vec::<String>::new());
    client.edit(&errors, 2, (1, 15, 1, 16), "6");
    assert_eq!(client.diagnostics(&program, Some(1)), ["T0921 4:14-15"]);
    assert_eq!(client.diagnostics(&errors, Some(2)), ["T0914 1:15-16"]);
    client.edit(&errors, 3, (1, 15, 1, 17), "5");
    assert_eq!(client.diagnostics(&program, Some(1)), Vec::<String>::new());
    assert_eq!(client.diagnostics(&errors, Some(3)), ["T0901 1:23-24"]);
}

#[test]
fn a_configuration_file_of_no_project_is_no_program() {
    let folder = TempDir::new().unwrap();
    write(folder.path(), &[("Plc0.PlcErrors", ERRORS)]);
    let mut client = start(&folder, &json!({}));
    let errors = uri(&folder, "Plc0.PlcErrors");
    client.open(&errors, 1, ERRORS);
    assert_eq!(client.request("textDocument/hover", &at(&errors, 1, 3)), json!(null));
}
