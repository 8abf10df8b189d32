//! What stands at a position and has a part in configuration files: identifiers in apostrophes, numbers of messages,
//! and, seen from the other side, attributes of the files.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::cursor;
use super::describe::hexadecimal;
use super::references::{self, Reference};
use crate::catalogue::{ConfigElement, Language};
use crate::configuration::channel::{Point, element_name};
use crate::configuration::constants::ConstantValue;
use crate::configuration::cross::{Configured, Defined, Definition, logical};
use crate::configuration::mentions::{Subject, mentions};
use crate::configuration::uses::UsePlace;
use crate::database::{self, ConfigFile, Db, Project, Section};
use crate::location::{Location, Position};
use crate::semantics::reference::ReferenceAccess;
use crate::syntax::ast::Columns;

/// What an own line of a section names at a column.
pub(super) fn in_section(
    db: &dyn Db,
    project: Project,
    section: Section<'_>,
    own: u32,
    column: u32,
) -> Option<(Subject, Columns)> {
    if project.configuration(db).is_empty() {
        return None;
    }
    let touches =
        |place: &UsePlace| place.line == own && place.columns.start <= column && column <= place.columns.end;
    let uses = database::section_identifiers(db, project, section);
    let named = uses.identifiers.iter().find(|it| touches(&it.place));
    if let Some(it) = named {
        return Some((subject(it.element, &it.text), it.place.columns.clone()));
    }
    let message = uses.messages.iter().find(|it| it.number.is_some() && touches(&it.place))?;
    Some((Subject::Message(message.number?), message.place.columns.clone()))
}

fn subject(element: ConfigElement, text: &str) -> Subject {
    match element {
        ConfigElement::LogicalInput | ConfigElement::LogicalOutput => {
            Subject::Named(element, logical::normal(text))
        }
        _ => Subject::Named(element, text.to_string()),
    }
}

/// What a configuration file names at a position.
fn in_file(db: &dyn Db, file: ConfigFile, at: Position) -> Vec<Subject> {
    let all = mentions(&database::configuration_file(db, file).contents);
    all.into_iter().find(|it| it.span.touches(at)).map(|it| it.subjects).unwrap_or_default()
}

/// All places that name one of the subjects, with what they do.
pub(super) fn places(
    db: &dyn Db,
    project: Project,
    subjects: &[Subject],
) -> BTreeMap<Location, ReferenceAccess> {
    let mut found = BTreeMap::new();
    for file in project.configuration(db) {
        for mention in mentions(&database::configuration_file(db, *file).contents) {
            if mention.subjects.iter().any(|it| subjects.contains(it)) {
                let access = if mention.defines { ReferenceAccess::Declare } else { ReferenceAccess::Read };
                found.insert(Location { file: file.path(db).clone(), span: mention.span }, access);
            }
        }
    }
    for file in references::files(db, project) {
        for section in database::sections(db, file) {
            let uses = database::section_identifiers(db, project, *section);
            let named = uses.identifiers.iter().map(|it| (subject(it.element, &it.text), &it.place));
            let messages =
                uses.messages.iter().filter_map(|it| Some((Subject::Message(it.number?), &it.place)));
            for (subject, place) in named.chain(messages).filter(|(subject, _)| subjects.contains(subject)) {
                let access = match subject {
                    // The program defines these, and connections use them.
                    Subject::Named(ConfigElement::LogicalInput | ConfigElement::LogicalOutput, _) => {
                        ReferenceAccess::Declare
                    }
                    _ => ReferenceAccess::Read,
                };
                if let Some(location) = cursor::location(db, *section, place.line, &place.columns) {
                    found.insert(location, access);
                }
            }
        }
    }
    found
}

/// Where a subject is defined; asked at its definition, where it is used.
pub(super) fn definition(
    db: &dyn Db,
    project: Project,
    subjects: &[Subject],
    at: &Location,
) -> Vec<Location> {
    let places = places(db, project, subjects);
    let is_here = |location: &Location| location.file == at.file && location.span.touches(at.span.start);
    let declared = places.iter().filter(|(_, access)| **access == ReferenceAccess::Declare).map(|(it, _)| it);
    let declared: Vec<Location> = declared.cloned().collect();
    if declared.iter().any(is_here) {
        return places.into_keys().filter(|it| !is_here(it)).collect();
    }
    declared
}

/// The definition of what stands at a position of a configuration file.
pub(super) fn definition_in_file(
    db: &dyn Db,
    project: Project,
    file: ConfigFile,
    at: Position,
) -> Vec<Location> {
    let here = Location { file: file.path(db).clone(), span: crate::Span { start: at, end: at } };
    let subjects = in_file(db, file, at);
    if subjects.is_empty() { Vec::new() } else { definition(db, project, &subjects, &here) }
}

/// All places that name what stands at a position of a configuration file.
pub(super) fn references_in_file(
    db: &dyn Db,
    project: Project,
    file: ConfigFile,
    at: Position,
    include_declaration: bool,
) -> Vec<Reference> {
    let subjects = in_file(db, file, at);
    if subjects.is_empty() {
        return Vec::new();
    }
    references::in_order(db, project, places(db, project, &subjects), include_declaration)
}

/// Help on what a position of a configuration file names.
pub(super) fn hover_in_file(
    db: &dyn Db,
    project: Project,
    file: ConfigFile,
    at: Position,
    language: Language,
) -> Option<super::Hover> {
    let all = mentions(&database::configuration_file(db, file).contents);
    let Some(mention) = all.into_iter().find(|it| it.span.touches(at)) else {
        return super::configured_word::hover(file.path(db), file.text(db), at, language);
    };
    let markdown = mention.subjects.iter().find_map(|it| page(db, project, it, language))?;
    Some(super::Hover { markdown, span: mention.span })
}

/// Help on a subject (Markdown); `None` when no file defines it.
pub(super) fn page(db: &dyn Db, project: Project, subject: &Subject, language: Language) -> Option<String> {
    let configured = database::configured(db, project);
    let cs = language == Language::Cs;
    match subject {
        Subject::Message(number) => {
            let found = configured.message(*number)?;
            let message = &found.it;
            let word = if cs { "Hlášení" } else { "Message" };
            let validity = match (message.persistent, cs) {
                (Some(true), false) => ", persistent",
                (Some(true), true) => ", trvalé",
                (Some(false), true) => ", přechodné",
                (Some(false), false) => ", transient",
                (None, _) => "",
            };
            let head = format!("**{word} {number}** · {}{validity}", message.kind);
            Some(finished(
                head,
                found,
                &format!("> {}", message.text.text.replace('\n', "\n> ")),
                &message.note,
            ))
        }
        Subject::Named(element @ (ConfigElement::LogicalInput | ConfigElement::LogicalOutput), _) => {
            connections(configured, *element, subject, cs)
        }
        Subject::Named(ConfigElement::Column, id) => {
            let tables = configured.tables.iter();
            let (table, column) = tables
                .flat_map(|it| it.it.columns.iter().map(move |column| (it, column)))
                .find(|(_, c)| c.id.text == *id)?;
            let kind = column.kind.map_or("?", |kind| kind.name());
            let (word, of) = if cs { ("Sloupec", "tabulka") } else { ("Column", "table") };
            let head = format!("**{word} {}** `{id}` · {kind} · {of} {}", column.number, table.it.id.text);
            let place = Location { file: table.place.file.clone(), span: column.id.span };
            Some(finished(head, &Definition { place, it: () }, "", ""))
        }
        Subject::Named(element, id) => {
            let found = configured.find(*element, id)?;
            let (details, note) = match &found.it {
                Defined::Point(point) => (point_text(point, cs), &point.note),
                Defined::Parameter(it) => {
                    let kind = it.kind.map_or("?", |kind| kind.name());
                    (format!("{kind} · `{}`", it.value.text), &it.note)
                }
                Defined::Constant(it) => (constant_text(it.value), &it.note),
            };
            let head = format!("**{}** `{id}` · {details}", element_name(*element));
            Some(finished(head, found, "", note))
        }
    }
}

fn finished<T>(head: String, found: &Definition<T>, body: &str, note: &str) -> String {
    let mut text = head;
    // Writing to a String never fails.
    let _ = write!(text, " · `{}`:{}", found.place.file, found.place.span.start.line + 1);
    for part in [body, note].into_iter().filter(|part| !part.is_empty()) {
        let _ = write!(text, "\n\n{part}");
    }
    text.push('\n');
    text
}

/// Port and bit as the program would name them: an input's port n is P(n+1)IN, an output's is PnOUT.
fn point_text(point: &Point, cs: bool) -> String {
    let say = |en: &'static str, czech: &'static str| if cs { czech } else { en };
    let mut text = match point.element {
        ConfigElement::Input => format!("P{}IN.{}", point.port + 1, point.bit),
        ConfigElement::Output => format!("P{}OUT.{}", point.port, point.bit),
        _ => format!("{} {}", say("channel", "kanál"), point.port),
    };
    if point.invert {
        text.push_str(say(", inverted", ", invertován"));
    }
    if point.connected != Some(true) {
        text.push_str(say(", not connected", ", nepropojen"));
        if !point.default.is_empty() {
            let _ = write!(text, " ({} {})", say("default", "předvolba"), point.default);
        }
    }
    text
}

fn constant_text(value: ConstantValue) -> String {
    match value {
        ConstantValue::Number(number @ 0..=9) => number.to_string(),
        ConstantValue::Number(number) => match u64::try_from(number) {
            Ok(positive) => format!("{number} ({})", hexadecimal(positive)),
            Err(_) => number.to_string(),
        },
        ConstantValue::Automatic(word) => word.to_string(),
        ConstantValue::Wrong => "?".to_string(),
    }
}

/// The links of a logical element.
fn connections(
    configured: &Configured,
    element: ConfigElement,
    subject: &Subject,
    cs: bool,
) -> Option<String> {
    let mut text = String::new();
    for found in &configured.connections {
        let (own, other) = match element {
            ConfigElement::LogicalInput => (&found.it.destination, &found.it.source),
            _ => (&found.it.source, &found.it.destination),
        };
        let end = logical::end(&own.text);
        let names = logical::candidates(end.name).into_iter();
        if end.group.element() != Some(element)
            || !names.map(|name| Subject::Named(element, name)).any(|it| it == *subject)
        {
            continue;
        }
        let arrow = if element == ConfigElement::LogicalInput { "←" } else { "→" };
        let off = match (found.it.connected, cs) {
            (Some(true), _) => "",
            (_, false) => " (not connected)",
            (_, true) => " (nepropojeno)",
        };
        let line = found.place.span.start.line + 1;
        let _ =
            writeln!(text, "- `{}` {arrow} `{}`{off} · `{}`:{line}", own.text, other.text, found.place.file);
    }
    (!text.is_empty()).then_some(text)
}

/// Identifiers that may stand between apostrophes for an element, with a few words about each.
pub(super) fn identifiers(
    db: &dyn Db,
    project: Project,
    element: ConfigElement,
    language: Language,
) -> Vec<(String, String)> {
    let configured = database::configured(db, project);
    let cs = language == Language::Cs;
    let mut all: BTreeMap<String, String> = BTreeMap::new();
    match element {
        ConfigElement::LogicalInput | ConfigElement::LogicalOutput => {
            for it in &configured.connections {
                for text in [&it.it.source, &it.it.destination] {
                    let end = logical::end(&text.text);
                    if end.group.element() == Some(element) {
                        let detail = format!("{} → {}", it.it.source.text, it.it.destination.text);
                        all.entry(end.name.to_string()).or_insert(detail);
                    }
                }
            }
        }
        ConfigElement::Column => {
            for table in &configured.tables {
                for column in &table.it.columns {
                    let kind = column.kind.map_or("", |kind| kind.name());
                    all.entry(column.id.text.clone()).or_insert(format!("{} {kind}", table.it.id.text));
                }
            }
        }
        ConfigElement::Table => {
            all.extend(configured.tables.iter().map(|it| (it.it.id.text.clone(), it.place.file.clone())));
        }
        _ => {
            for id in configured.identifiers(element) {
                let detail = configured.find(element, id).map_or_else(String::new, |found| match &found.it {
                    Defined::Point(point) => point_text(point, cs),
                    Defined::Parameter(it) => {
                        it.kind.map_or_else(String::new, |kind| kind.name().to_string())
                    }
                    Defined::Constant(it) => constant_text(it.value),
                });
                all.insert(id.to_string(), detail);
            }
        }
    }
    all.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::super::fixture::fixture;
    use crate::Language;

    const FILES: &str = "\
//- Channel0.ChannelConfig
<Channel>
<Plc>
<Input ID=\"inDoor\" Port=\"1\" Bit=\"2\" Connected=\"1\"/> <!-- front door -->
<Input ID=\"inGate\" Port=\"1\" Bit=\"3\" Invert=\"1\" Default=\"1\" Connected=\"0\"/>
<PlcParam ID=\"LIMIT\" Type=\"Int\">40</PlcParam>
</Plc>
<Connections>
<Connection Source=\"PLC.Output.Speed[2]\" Destination=\"ECAT.Drive.Outputs.Speed\" Connected=\"1\"/>
</Connections>
</Channel>
//- Plc0.PlcErrors
<PlcErrors>
<PlcError No=\"40\" Type=\"Err\" Validity=\"Transient\"><Text>Dveře jsou otevřené</Text></PlcError>
</PlcErrors>
";

    fn text(init: &str, main: &str) -> String {
        format!(
            "//- main.plc\nEQUI ERR_DOOR,40\nMODULE_MAIN\n {main}\nMODULE_MAIN_END\nMODULE_INIT\n {init}\nMODULE_INIT_END\n{FILES}"
        )
    }

    fn hover(text: &str, language: Language) -> String {
        let it = fixture(text);
        let found = it.analysis.hover(&it.file, it.at, language).expect("not cancelled");
        found.map_or_else(|| "nothing".to_owned(), |hover| hover.markdown)
    }

    fn definition(text: &str) -> String {
        let it = fixture(text);
        let found = it.analysis.definition(&it.file, it.at).expect("not cancelled");
        found.iter().map(|location| it.show(location)).collect()
    }

    fn references(text: &str) -> String {
        let it = fixture(text);
        let found = it.analysis.references(&it.file, it.at, true).expect("not cancelled");
        let show = |r: &super::Reference| format!("{:?} {}", r.access, it.show(&r.location));
        found.iter().map(show).collect()
    }

    fn completion(text: &str) -> Vec<String> {
        let it = fixture(text);
        let found = it.analysis.completion(&it.file, it.at, Language::En).expect("not cancelled");
        found.into_iter().map(|c| format!("{} -> {} | {}", c.label, c.insert, c.detail)).collect()
    }

    #[test]
    fn an_identifier_shows_its_element() {
        let at = |init: &str| text(init, "");
        insta::assert_snapshot!(hover(&at("MAP_IN inDoor,'inD<CURSOR>oor'"), Language::En), @"
        **Input** `inDoor` · P2IN.2 · `Channel0.ChannelConfig`:3

        front door
        ");
        insta::assert_snapshot!(hover(&at("MAP_IN inGate,'<CURSOR>inGate'"), Language::Cs), @"**Input** `inGate` · P2IN.3, invertován, nepropojen (předvolba 1) · `Channel0.ChannelConfig`:4");
        insta::assert_snapshot!(hover(&at("CNF_GET_INT SMALL,'LIMIT<CURSOR>'"), Language::En), @"**PlcParam** `LIMIT` · Int · `40` · `Channel0.ChannelConfig`:5");
        insta::assert_snapshot!(hover(&at("DEF_OUT rSpeed[4],'Spe<CURSOR>ed',TYPE_REAL"), Language::En), @"- `PLC.Output.Speed[2]` → `ECAT.Drive.Outputs.Speed` · `Channel0.ChannelConfig`:8");
    }

    #[test]
    fn the_number_of_a_message_shows_its_text_and_the_constant() {
        insta::assert_snapshot!(hover(&text("", "ESET 4<CURSOR>0"), Language::Cs), @"
        **Hlášení 40** · Err, přechodné · `Plc0.PlcErrors`:2

        > Dveře jsou otevřené
        ");
        insta::assert_snapshot!(hover(&text("", "ESET ERR_<CURSOR>DOOR"), Language::En), @"
        **Message 40** · Err, transient · `Plc0.PlcErrors`:2

        > Dveře jsou otevřené

        ---

        ```technol
        EQUI ERR_DOOR,40
        ```
        constant 40 (28h) · `main.plc`:1
        ");
    }

    #[test]
    fn definitions_lead_into_the_configuration() {
        insta::assert_snapshot!(definition(&text("MAP_IN inDoor,'inD<CURSOR>oor'", "")), @r#"Channel0.ChannelConfig:3 <Input ID="«inDoor»" Port="1" Bit="2" Connected="1"/> <!-- front door -->"#);
        insta::assert_snapshot!(definition(&text("", "ESET ERR_<CURSOR>DOOR")), @r#"
        main.plc:1 EQUI «ERR_DOOR»,40
        Plc0.PlcErrors:2 <PlcError No="«40»" Type="Err" Validity="Transient"><Text>Dveře jsou otevřené</Text></PlcError>
        "#);
        insta::assert_snapshot!(definition(&text("DEF_OUT rSpeed[4],'Spe<CURSOR>ed',TYPE_REAL", "")), @r#"Channel0.ChannelConfig:8 <Connection Source="«PLC.Output.Speed[2]»" Destination="ECAT.Drive.Outputs.Speed" Connected="1"/>"#);
    }

    #[test]
    fn references_are_found_from_both_sides() {
        let source = text("MAP_IN inDoor,'<CURSOR>inDoor'", "");
        let found = references(&source);
        insta::assert_snapshot!(found, @r#"
        Read main.plc:6 MAP_IN inDoor,«'inDoor'»
        Declare Channel0.ChannelConfig:3 <Input ID="«inDoor»" Port="1" Bit="2" Connected="1"/> <!-- front door -->
        "#);
        let file = source.replace("<CURSOR>", "").replace("ID=\"inDoor", "ID=\"in<CURSOR>Door");
        assert_eq!(references(&file), found);
        let connection =
            text("DEF_OUT rSpeed[4],'Speed',TYPE_REAL", "").replace("Speed[2]", "Spe<CURSOR>ed[2]");
        insta::assert_snapshot!(definition(&connection), @"main.plc:6 DEF_OUT rSpeed[4],«'Speed'»,TYPE_REAL");
    }

    #[test]
    fn between_apostrophes_the_identifiers_that_fit_are_offered() {
        let at = |init: &str| completion(&text(init, ""));
        assert_eq!(
            at("MAP_IN x,'in<CURSOR>"),
            ["inDoor -> inDoor' | P2IN.2", "inGate -> inGate' | P2IN.3, inverted, not connected (default 1)"]
        );
        assert_eq!(at("CNF_GET_INT x,'<CURSOR>'"), ["LIMIT -> LIMIT | Int"]);
        assert_eq!(
            at("DEF_OUT x,'<CURSOR>',TYPE_REAL"),
            ["Speed[2] -> Speed[2] | PLC.Output.Speed[2] → ECAT.Drive.Outputs.Speed"]
        );
        assert_eq!(at("MAP_OUT x,'<CURSOR>'"), Vec::<String>::new());
    }
}
