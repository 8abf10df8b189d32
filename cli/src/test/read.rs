//! Reading scenario files. Everything that is wrong is reported, not only the first mistake.

mod block;
mod step;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use technol_analysis::expression::Target;
use technol_target::MachineFileError;
use toml::de::{DeTable, DeValue};

use super::condition::{Condition, Names};
use super::fields::{Node, Source, entries, get};
use super::machines::{Choice, Machines, Unusable};
use super::scenario::{Action, Check, Guard, Place, ScenarioError, Test, Time};

/// Keys of a file.
const FILE: &[&str] = &["machine", "part-program", "never", "always", "test"];
/// Keys of a test.
const TEST: &[&str] = &["name", "machine", "part-program", "never", "always", "step"];

/// All keys of scenario files.
#[cfg(test)]
pub(super) fn keys() -> Vec<&'static str> {
    [FILE, TEST, step::STEP, block::BLOCK].concat()
}

/// What tests may name.
pub(super) struct Reader<'a> {
    pub(super) names: Names<'a>,
    pub(super) machines: &'a mut Machines,
    /// The machine of the project.
    pub(super) machine: Option<PathBuf>,
}

/// A scenario file as it is on disk.
pub(super) struct ScenarioFile<'a> {
    /// As the user of the shell would write it.
    pub(super) shown: &'a str,
    /// Folder that names of machine files are relative to.
    pub(super) folder: &'a Path,
    pub(super) text: &'a str,
}

/// A mistake in a machine file keeps its own place.
fn of_machine(error: MachineFileError) -> ScenarioError {
    let place = Place { line: error.line, column: error.col };
    ScenarioError { file: error.file.display().to_string(), place, message: error.message }
}

impl Reader<'_> {
    /// The tests of a file.
    ///
    /// # Errors
    /// Everything that is wrong in it.
    pub(super) fn read(&mut self, file: &ScenarioFile<'_>) -> Result<Vec<Test>, Vec<ScenarioError>> {
        let mut source = Source { file: file.shown, text: file.text, errors: Vec::new() };
        let document = match DeTable::parse(file.text) {
            Ok(document) => document,
            Err(error) => {
                source.error(error.span().map_or(0, |span| span.start), error.message());
                return Err(source.errors);
            }
        };
        let tests = self.file(document.get_ref(), file.folder, &mut source);
        let mut errors = source.errors;
        if errors.is_empty() {
            return Ok(tests);
        }
        errors.sort_by(|a, b| (&a.file, a.place).cmp(&(&b.file, b.place)));
        errors.dedup();
        Err(errors)
    }

    fn file(&mut self, table: &DeTable<'_>, folder: &Path, source: &mut Source<'_>) -> Vec<Test> {
        source.known(table, "a scenario file", FILE);
        let project = Choice { file: self.machine.clone(), part_program: true };
        let choice = choice(table, &(project, None), folder, source);
        let guards = self.guards(table, source);
        let Some(node) = get(table, "test") else {
            source.error(0, "there is no [[test]] in this file");
            return Vec::new();
        };
        let mut tests = Vec::new();
        let mut names = BTreeSet::new();
        for (at, table) in source.tables(node, "a test") {
            let test = self.test(at, table, &choice, &guards, folder, source);
            if !names.insert(test.name.clone()) {
                source.error(at, format!("there is another test `{}` in this file", test.name));
            }
            tests.push(test);
        }
        tests
    }

    fn test(
        &mut self,
        at: usize,
        table: &DeTable<'_>,
        of_file: &(Choice, Option<usize>),
        guards_of_file: &[Guard],
        folder: &Path,
        source: &mut Source<'_>,
    ) -> Test {
        source.known(table, "a test", TEST);
        let name = get(table, "name").and_then(|node| source.text(node, "the name of a test"));
        let name = name.map(str::trim).filter(|name| !name.is_empty());
        if name.is_none() {
            source.error(at, "a test needs a `name`");
        }
        let (choice, said) = choice(table, of_file, folder, source);
        let machine = self.machines.number(&choice).unwrap_or_else(|error| {
            match error {
                Unusable::Missing(message) if said.is_none() => {
                    source.error(at, format!("{message}; `[machine] file` in technol.toml names it"));
                }
                Unusable::Missing(message) => source.error(said.unwrap_or(at), message),
                Unusable::Wrong(errors) => source.errors.extend(errors.into_iter().map(of_machine)),
            }
            // It is known from now on as one of which nothing is known.
            self.machines.number(&choice).unwrap_or_default()
        });
        let mut guards = guards_of_file.to_vec();
        guards.extend(self.guards(table, source));
        let mut test = Test {
            name: name.unwrap_or_default().to_owned(),
            file: source.file.to_owned(),
            place: source.place(at),
            machine,
            guards,
            steps: Vec::new(),
            values: Vec::new(),
        };
        match get(table, "step") {
            Some(node) => {
                for (at, table) in source.tables(node, "a step") {
                    let step = self.step(at, table, &test, source);
                    test.steps.push(step);
                }
            }
            None => source.error(at, "a test needs steps: `[[test.step]]`, or `step = [ { … }, … ]`"),
        }
        test.values = values(&test);
        test
    }

    /// `never` and `always`: a condition, several, or a table of names and conditions.
    fn guards(&self, table: &DeTable<'_>, source: &mut Source<'_>) -> Vec<Guard> {
        let mut guards = Vec::new();
        for entry in entries(table) {
            let always = match entry.key {
                "never" => false,
                "always" => true,
                _ => continue,
            };
            match entry.node.get_ref() {
                DeValue::Table(named) => {
                    for named in entries(named) {
                        let condition = self.condition(named.node, entry.key, source);
                        let name = Some(named.key.to_owned());
                        guards.extend(condition.map(|condition| Guard { name, always, condition }));
                    }
                }
                DeValue::Array(nodes) => {
                    for node in nodes {
                        let condition = self.condition(node, entry.key, source);
                        guards.extend(condition.map(|condition| Guard { name: None, always, condition }));
                    }
                }
                _ => {
                    let condition = self.condition(entry.node, entry.key, source);
                    guards.extend(condition.map(|condition| Guard { name: None, always, condition }));
                }
            }
        }
        guards
    }

    fn condition(&self, node: &Node<'_>, key: &str, source: &mut Source<'_>) -> Option<Condition> {
        let what = format!("`{key}` is a condition: it");
        let text = source.text(node, &what)?;
        match Condition::parse(text, &self.names) {
            Ok(condition) => Some(condition),
            Err(mistake) => {
                source.error(inside(node, text, mistake.at, source.text), mistake.message);
                None
            }
        }
    }
}

/// Place of a byte of a text in the file; the text itself when it is written with escapes.
fn inside(node: &Node<'_>, text: &str, at: usize, file: &str) -> usize {
    let start = node.span().start;
    let first = start + 1;
    let plain = file.get(first..).is_some_and(|rest| rest.starts_with(text)) && !text.starts_with('"');
    if plain { first + at } else { start }
}

/// The machine that a file or a test says and where it says so, or else the one before.
fn choice(
    table: &DeTable<'_>,
    before: &(Choice, Option<usize>),
    folder: &Path,
    source: &mut Source<'_>,
) -> (Choice, Option<usize>) {
    let (mut choice, mut at) = before.clone();
    if let Some(node) = get(table, "machine")
        && let Some(name) = source.text(node, "`machine`")
    {
        choice.file = (name != "none").then(|| folder.join(name));
        at = Some(node.span().start);
    }
    if let Some(on) = get(table, "part-program").and_then(|node| source.boolean(node, "`part-program`")) {
        choice.part_program = on;
    }
    (choice, at)
}

/// Every name with a value that a test mentions, once.
fn values(test: &Test) -> Vec<(String, Target)> {
    let mut conditions: Vec<&Condition> = test.guards.iter().map(|guard| &guard.condition).collect();
    for step in &test.steps {
        conditions.extend(step.guards.iter().map(|guard| &guard.condition));
        if let Time::Until { condition, .. } = &step.time {
            conditions.push(condition);
        }
        conditions.extend(step.checks.iter().filter_map(|check| match check {
            Check::Holds(condition) => Some(condition),
            _ => None,
        }));
    }
    let mentioned = conditions.into_iter().flat_map(Condition::values);
    let set = test.steps.iter().flat_map(|step| &step.actions).filter_map(|action| match action {
        Action::Set { name, target, .. } => Some((name.as_str(), *target)),
        _ => None,
    });
    let mut values: Vec<(String, Target)> = Vec::new();
    for (name, target) in mentioned.chain(set) {
        if !values.iter().any(|(_, known)| *known == target) {
            values.push((name.to_owned(), target));
        }
    }
    values
}
