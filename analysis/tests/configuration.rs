//! Configuration files: each rule's own example, files of a project, and texts nobody meant.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Arc, Mutex};

use proptest::prelude::*;
use technol_analysis::configuration::{self, ConfigKind};
use technol_analysis::database::Database;
use technol_analysis::diagnostics::RULES;
use technol_analysis::project::{Encoding, FileReader, encode, load};
use technol_analysis::{AnalysisHost, Change, Diagnostic};

#[derive(Clone, Default)]
struct Memory(BTreeMap<String, Vec<u8>>);

impl FileReader for Memory {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        self.0.get(path).cloned().ok_or_else(|| "no such file".to_string())
    }

    fn list(&self, folder: &str) -> Vec<String> {
        let inside = |path: &String| {
            let (at, name) = path.rsplit_once('/').unwrap_or(("", path));
            (at == folder).then(|| name.to_string())
        };
        self.0.keys().filter_map(inside).collect()
    }
}

impl Memory {
    fn with(mut self, path: &str, text: impl AsRef<[u8]>) -> Memory {
        self.0.insert(path.to_string(), text.as_ref().to_vec());
        self
    }

    fn host(&self) -> AnalysisHost {
        let mut host = AnalysisHost::new();
        host.apply(Change { project: Some(load("", self)), texts: Vec::new() });
        host
    }

    /// What is found about configuration; hints and remarks on style belong to tests of their own.
    fn diagnostics(&self) -> Vec<(String, Vec<Diagnostic>)> {
        about_configuration(self.host().analysis().all_diagnostics().expect("nothing cancels it"))
    }

    /// `file:line:column code` of everything found, with lines and columns from 1.
    fn found(&self) -> Vec<String> {
        let all = self.diagnostics();
        all.iter()
            .flat_map(|(file, list)| {
                list.iter().map(move |d| {
                    format!("{file}:{}:{} {}", d.span.start.line + 1, d.span.start.column + 1, d.code)
                })
            })
            .collect()
    }
}

/// Without the lints, which judge the style of any program.
fn about_configuration(mut all: Vec<(String, Vec<Diagnostic>)>) -> Vec<(String, Vec<Diagnostic>)> {
    for (_, list) in &mut all {
        list.retain(|d| !d.code.starts_with("T11"));
    }
    all.retain(|(_, list)| !list.is_empty());
    all
}

const DATA: &str = "\
INPUTS:  DFM START,HALT_KEY,DOOR,LIMIT,,,READY,FAULT
OUTPUTS: DFM MOTOR,PUMP,LAMP,VALVE
         DFM M0,M1,M2,M3,M4,M5,M6,M7
SMALL:   DS 1
MIDDLE:  DS 2
LARGE:   DS 4
RATIO:   DS 8
";

/// A complete program with these lines in MODULE_INIT and MODULE_MAIN.
fn program(init: &str, main: &str) -> String {
    let module = |name: &str, body: &str| format!("MODULE_{name}\n{body}MODULE_{name}_END\n");
    [
        format!("DATA\n{DATA}DATA_END\n"),
        module("INPUT", ""),
        module("BLOCK_INIT", ""),
        module("BLOCK_DONE", ""),
        module("MAIN", main),
        module("INIT", init),
        module("CLEAR", ""),
        module("HALT", ""),
        "STOP\n".to_string(),
    ]
    .concat()
}

/// The project an example of a rule stands for: its sections, or lines of MODULE_MAIN, and further files.
fn example(text: &str) -> Memory {
    let mut parts = text.split(";=== ");
    let source = parts.next().unwrap_or_default();
    let section = |name: &str| {
        let begin = format!("MODULE_{name}\n");
        let body = source.split(&begin).nth(1)?;
        Some(body.split(&format!("MODULE_{name}_END\n")).next()?.to_string())
    };
    let (init, main) = (section("INIT"), section("MAIN"));
    let lines = if init.is_none() && main.is_none() { source.to_string() } else { String::new() };
    let main = main.unwrap_or(lines);
    let mut files = Memory::default().with("main.plc", program(&init.unwrap_or_default(), &main));
    for part in parts {
        let (name, text) = part.split_once('\n').expect("a name and a text");
        files = files.with(name, text);
    }
    files
}

#[test]
fn each_rule_fires_on_its_wrong_example_and_not_on_the_right_one() {
    let mut report = Vec::new();
    for rule in RULES.iter().filter(|rule| ("T0901".."T1000").contains(&rule.code)) {
        let wrong = example(rule.wrong).diagnostics();
        let codes: Vec<_> = wrong.iter().flat_map(|(_, list)| list.iter().map(|d| d.code)).collect();
        if codes.is_empty() || codes.iter().any(|code| *code != rule.code) {
            report.push(format!("{} wrong: {wrong:#?}", rule.code));
        }
        let right = example(rule.right).diagnostics();
        if !right.is_empty() {
            report.push(format!("{} right: {right:#?}", rule.code));
        }
        fixes(rule.code, rule.wrong, &wrong, &mut report);
    }
    assert!(report.is_empty(), "{}", report.join("\n"));
}

/// Each offered fix removes its finding.
fn fixes(code: &str, text: &str, found: &[(String, Vec<Diagnostic>)], report: &mut Vec<String>) {
    for (file, list) in found {
        for diagnostic in list {
            let Some(fix) = &diagnostic.fix else { continue };
            let mut files = example(text);
            let source = String::from_utf8(files.0[file].clone()).expect("UTF-8");
            let mut lines: Vec<String> = source.split('\n').map(str::to_string).collect();
            for (span, new) in &fix.edits {
                let line = &mut lines[span.start.line as usize];
                line.replace_range(span.start.column as usize..span.end.column as usize, new);
            }
            files = files.with(file, lines.join("\n"));
            if files.diagnostics().iter().any(|(_, list)| list.iter().any(|d| d.code == code)) {
                report.push(format!("{code}: the fix {} does not help", fix.title));
            }
        }
    }
}

const CHANNEL: &str = "<Plc>\n <Input ID=\"inDoor\" Port=\"1\" Bit=\"2\" Connected=\"1\"/>\n</Plc>\n";

#[test]
fn files_beside_the_program_are_found_unless_the_manifest_says_which() {
    let init = "        MAP_IN inDoor,'inDor'\n";
    let beside = Memory::default().with("main.plc", program(init, "")).with("a.ChannelConfig", CHANNEL);
    assert_eq!(beside.found(), ["main.plc:19:23 T0911"]);
    let none = beside.clone().with("technol.toml", "[project]\nname = \"t\"\nconfiguration = []\n");
    assert_eq!(none.found(), Vec::<String>::new());
    let folder = Memory::default()
        .with("main.plc", program(init, ""))
        .with("config/a.ChannelConfig", CHANNEL)
        .with("technol.toml", "[project]\nname = \"t\"\nconfiguration = [\"config\"]\n");
    assert_eq!(folder.found(), ["main.plc:19:23 T0911"]);
    let missing =
        none.with("technol.toml", "[project]\nname = \"t\"\nconfiguration = [\"b.PlcErrors\", \"c\"]\n");
    assert_eq!(missing.found(), ["technol.toml:3:18 T0004", "technol.toml:3:33 T0004"]);
}

#[test]
fn a_declared_encoding_is_obeyed() {
    let text = "<?xml version=\"1.0\" encoding=\"windows-1250\"?>\n<PlcErrors>\n <PlcError No=\"7\" Type=\"Err\" Validity=\"Transient\"><Text>Příliš nízký tlak</Text></PlcError>\n</PlcErrors>\n";
    let bytes = encode(text, Encoding::Windows1250).expect("Czech fits");
    let files =
        Memory::default().with("main.plc", program("", "        ESET 7\n")).with("Plc0.PlcErrors", bytes);
    assert_eq!(files.found(), Vec::<String>::new());
    let loaded = load("", &files);
    assert_eq!(
        (&*loaded.configuration[0].text, loaded.configuration[0].encoding),
        (text, Encoding::Windows1250)
    );
}

#[test]
fn a_broken_file_silences_what_it_may_have_defined() {
    let files = Memory::default()
        .with("main.plc", program("        MAP_IN inDoor,'inDoor'\n", "        ESET 9\n"))
        .with("a.ChannelConfig", "<Plc><Input ID=\"inDoor\"</Plc>")
        .with("b.PlcErrors", "<PlcErrors/>");
    assert_eq!(files.found(), ["main.plc:17:14 T0921", "a.ChannelConfig:1:24 T0901"]);
}

#[test]
fn one_identifier_in_two_files_is_reported_in_the_later_one() {
    let files = Memory::default()
        .with("main.plc", program("        MAP_IN inDoor,'inDoor'\n", ""))
        .with("a.ChannelConfig", CHANNEL)
        .with("b.ChannelConfig", CHANNEL);
    assert_eq!(files.found(), ["b.ChannelConfig:2:13 T0907"]);
}

#[test]
fn severities_of_the_project_hold_for_configuration_files() {
    let files = Memory::default().with("main.plc", program("", "")).with("a.ChannelConfig", CHANNEL);
    assert_eq!(files.found(), ["a.ChannelConfig:2:13 T0914"]);
    let off = files.with("technol.toml", "[project]\nname = \"t\"\n[lints]\nT0914 = \"off\"\n");
    assert_eq!(off.found(), Vec::<String>::new());
}

#[test]
fn m_functions_have_groups_and_the_fixed_ones_stay_in_theirs() {
    let functions = "<Channel>\n<MFunctions>\n<MFunc No=\"91\" GroupNo=\"10\"/>\n<MFuncs No=\"92\"/>\n\
                     <MFunc No=\"6\" ChangePos=\"1\"/>\n<MFunc No=\"3\" GroupNo=\"4\"/>\n<MFunc No=\"91\" GroupNo=\"11\"/>\n\
                     </MFunctions>\n</Channel>\n";
    let read = configuration::read(ConfigKind::of_path("a.ChannelConfig").expect("a kind"), functions);
    let configuration::Contents::Channel(channel) = read.contents else { panic!("a channel") };
    let groups: Vec<_> = channel.m_functions.iter().map(|it| (it.number, it.group)).collect();
    assert_eq!(groups, [(91, 10), (92, 14), (6, 9), (91, 11)]);
    let problems: Vec<_> =
        read.problems.iter().map(|it| format!("{} {}", it.span.start.line + 1, it.message)).collect();
    assert_eq!(
        problems,
        ["6 M03 belongs to group 2 and cannot be moved to group 4", "7 the number 91 stands here twice"]
    );
}

#[test]
fn an_edit_gives_what_a_fresh_start_gives() {
    let files = Memory::default()
        .with("main.plc", program("        MAP_IN inDoor,'inDoor'\n", ""))
        .with("a.ChannelConfig", CHANNEL);
    let mut host = files.host();
    let edited = CHANNEL.replace("inDoor", "inGate");
    host.apply(Change {
        project: None,
        texts: vec![("a.ChannelConfig".to_string(), edited.as_str().into())],
    });
    let found = about_configuration(host.analysis().all_diagnostics().expect("nothing cancels it"));
    assert_eq!(found, files.with("a.ChannelConfig", edited).diagnostics());
    assert!(!found.is_empty());
}

/// Queries that run when one file changes.
fn executed_by(files: &Memory, path: &str, text: &str) -> BTreeSet<String> {
    let log = Arc::new(Mutex::new(BTreeSet::new()));
    let sink = log.clone();
    let db = Database::with_events(Box::new(move |event| {
        if let salsa::EventKind::WillExecute { database_key } = event.kind {
            let name = format!("{database_key:?}");
            sink.lock().expect("one thread").insert(name.split('(').next().unwrap_or_default().to_string());
        }
    }));
    let mut host = AnalysisHost::with_database(db);
    let opened = String::from_utf8(files.read(path).expect("it is there")).expect("it is UTF-8");
    host.apply(Change { project: Some(load("", files)), texts: vec![(path.to_string(), opened.into())] });
    host.analysis().all_diagnostics().expect("nothing cancels it");
    log.lock().expect("one thread").clear();
    host.apply(Change { project: None, texts: vec![(path.to_string(), text.into())] });
    host.analysis().all_diagnostics().expect("nothing cancels it");
    log.lock().expect("one thread").clone()
}

#[test]
fn an_edit_of_a_configuration_file_analyses_no_section_and_the_other_way_round() {
    let source = program("        MAP_IN inDoor,'inDoor'\n", "        LDR START\n        WR LAMP\n");
    let files = Memory::default()
        .with("main.plc", &source)
        .with("a.ChannelConfig", CHANNEL)
        .with("b.PlcErrors", "<PlcErrors/>");
    let ran = executed_by(&files, "a.ChannelConfig", &CHANNEL.replace("\"2\"", "\"3\""));
    assert!(ran.contains("configuration_file"), "{ran:?}");
    assert!(!ran.iter().any(|query| query.starts_with("section")), "{ran:?}");
    let ran = executed_by(&files, "main.plc", &source.replace("LDR START", "LDR DOOR"));
    assert!(ran.contains("section_identifiers"), "{ran:?}");
    assert!(!ran.iter().any(|query| query.starts_with("config")), "{ran:?}");
}

const SAMPLES: &[(ConfigKind, &str)] = &[
    (
        ConfigKind::Channel,
        "<C><Plc><Input ID=\"a\" Port=\"1\"/><PlcParam ID=\"p\" Type=\"Int\">4</PlcParam></Plc><Connections><Connection Source=\"PLC.Output.a[01].Bit[2]\" Destination=\"CAN[1].INOUT08.OP0\"/></Connections></C>",
    ),
    (
        ConfigKind::Errors,
        "<E><PlcError No=\"1\" Type=\"Err\" Validity=\"Persistent\"><Text>a %d b %X 100 %</Text></PlcError></E>",
    ),
    (ConfigKind::Constants, "<PlcConstants><Constant ID=\"A\" Value=\"SA0INT\"/> <!-- a --></PlcConstants>"),
    (
        ConfigKind::TableDefinition,
        "<PLCTableDef><Definition><DefinitionID>M</DefinitionID><ColsCount>1</ColsCount><Col No=\"0\"><ColID>F</ColID><ColType>REAL</ColType></Col></Definition></PLCTableDef>",
    ),
    (
        ConfigKind::Table,
        "<PLCTable><Definition><DefinitionID>M</DefinitionID><LinesCount>1</LinesCount></Definition><Line No=\"0\"><Col ColID=\"F\">1.5</Col></Line></PLCTable>",
    ),
    (
        ConfigKind::Keyboard,
        "<KeyboardConfig><KeyConfig ScanCode=\"0x6A\"><Function No=\"0\" PlcCommand=\"A\"/></KeyConfig></KeyboardConfig>",
    ),
];

/// Whether the places of all mistakes lie in the text.
fn places_are_inside(text: &str, kind: ConfigKind) -> bool {
    let lines: Vec<&str> = technol_analysis::syntax::lines(text).map(|line| line.text).collect();
    let inside = |at: technol_analysis::Position| match lines.get(at.line as usize) {
        Some(line) => line.is_char_boundary(at.column as usize),
        None => at.line as usize == lines.len() && at.column == 0,
    };
    configuration::read(kind, text).problems.iter().all(|it| inside(it.span.start) && inside(it.span.end))
}

proptest! {
    #[test]
    fn any_bytes_are_read_without_a_panic(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        let text = configuration::decode(&bytes, None).text;
        for kind in ConfigKind::ALL {
            prop_assert!(places_are_inside(&text, kind));
        }
    }

    #[test]
    fn damaged_files_are_read_without_a_panic(
        sample in 0..SAMPLES.len(),
        cuts in proptest::collection::vec((any::<prop::sample::Index>(), 0usize..6, "[<>/&;=\"' a-zA-Z0-9%\\[\\].ř\n!-]{0,5}"), 1..6),
    ) {
        let (kind, text) = SAMPLES[sample];
        let mut chars: Vec<char> = text.chars().collect();
        for (at, remove, insert) in cuts {
            let at = at.index(chars.len() + 1).min(chars.len());
            let end = (at + remove).min(chars.len());
            chars.splice(at..end, insert.chars());
        }
        let text: String = chars.into_iter().collect();
        prop_assert!(places_are_inside(&text, kind), "{}", text);
        let name = format!("x.{}", kind.extensions()[0]);
        let files = Memory::default()
            .with("main.plc", program("        DEF_OUT x,'a',TYPE_BIT\n", "        ESET 1\n"))
            .with(&name, &text)
            .with("t.PlcTDef", SAMPLES[3].1);
        let _ = files.diagnostics();
    }
}

/// `line:column message` of what is wrong in a channel of these elements, one a line.
fn wrong_channel(elements: &str) -> Vec<String> {
    let files = Memory::default()
        .with("main.plc", program("", ""))
        .with("a.ChannelConfig", format!("<C><Plc>\n{elements}\n</Plc></C>"));
    let wrong = |d: &&Diagnostic| d.code == "T0905" || d.code == "T0907";
    let line = |d: &Diagnostic| format!("{}:{} {}", d.span.start.line, d.span.start.column + 1, d.message);
    let all = files.diagnostics();
    all.iter().flat_map(|(_, list)| list.iter().filter(wrong).map(line).collect::<Vec<_>>()).collect()
}

#[test]
fn physical_ends_that_there_are_not_or_that_have_two_sources_are_reported() {
    for (elements, expected) in [
        ("<Input ID='a' Port='127' Bit='7' Connected='1'/><Output ID='b' Port='95' Connected='1'/>", &[][..]),
        (
            "<Input ID='a' Port='128' Connected='1'/>",
            &["1:21 Port=\"128\" of an input would be P129IN; the last one is Port=\"127\", P128IN"],
        ),
        (
            "<Output ID='b' Port='96' Connected='1'/>",
            &["1:22 Port=\"96\" of an output would be P96OUT; the last one is P95OUT"],
        ),
        (
            "<Input ID='a' Port='1' Bit='8'/>",
            &["1:29 Bit cannot be \"8\"; it needs a whole number from 0 to 7"],
        ),
        // Outputs that share a bit are joined; two inputs of one bit are no mistake either.
        ("<Output ID='a' Bit='1' Connected='1'/>\n<Output ID='b' Bit='1' Connected='1'/>", &[]),
        ("<Input ID='a' Bit='1' Connected='1'/>\n<Input ID='b' Bit='1' Invert='1' Connected='1'/>", &[]),
        (
            "<Output ID='a' Port='2' Bit='1' Connected='1'/>\n<Output ID='b' Port='2' Bit='1' Invert='1'/>",
            &[],
        ),
        (
            "<Output ID='a' Port='2' Bit='1' Connected='1'/>\n<Output ID='b' Port='2' Bit='1' Invert='1' Connected='1'/>",
            &[
                "2:22 b and a both drive P2OUT.1, and only one of them is inverted; outputs that share a bit need the \
               same Invert",
            ],
        ),
        (
            "<AnalogOutput ID='a' PhysNo='3' Connected='1'/>\n<AnalogOutput ID='b' PhysNo='3' Connected='1'/>",
            &["2:30 b and a both drive the analogue output 3; it can have one source"],
        ),
        (
            "</Plc><Connections>\n<Connection Source='PLC.Output.a' Destination='PLC.Input.b' Connected='1'/>\n\
             <Connection Source='PLC.Output.c' Destination='plc.input.B[0]' Connected='1'/>\n</Connections><Plc>",
            &["3:48 the destination plc.input.B[0] stands here twice"],
        ),
    ] {
        assert_eq!(wrong_channel(elements), expected, "{elements}");
    }
}
