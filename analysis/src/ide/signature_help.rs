//! The operands of the instruction being written, with the one at the cursor marked.

use super::cursor::macro_parameters;
use crate::catalogue::{self, Entry, EntryKind, Language, OperandSpec, page};
use crate::database::{Db, Project, SourceFile};
use crate::location::Position;
use crate::syntax::ast::{Expr, ExprKind, SyntaxErrorKind};
use crate::syntax::{self, parse_lines};

/// How an instruction is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SignatureHelp {
    /// Mnemonic and operands, for instance `TEX0 counter, time, label`.
    pub label: String,
    /// What the instruction does, and its forms: Markdown.
    pub documentation: String,
    /// Its operands in order.
    pub parameters: Vec<Parameter>,
    /// The operand at the cursor; `None` behind the last one.
    pub active: Option<u32>,
}

/// An operand of a signature.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Where it stands in the label: bytes.
    pub label: (u32, u32),
    /// What it may be and what it means: Markdown.
    pub documentation: String,
}

/// The signature of the instruction before the position; `None` outside of its operands, in comments and for
/// instructions without operands.
pub fn signature_help(
    db: &dyn Db,
    project: Project,
    file: SourceFile,
    at: Position,
    language: Language,
) -> Option<SignatureHelp> {
    let line = syntax::lines(file.text(db)).nth(at.line as usize)?;
    let head = line.text.get(..at.column as usize)?;
    let parsed = parse_lines(head);
    let line = parsed.lines.first()?;
    let operation = line.operation.as_ref()?;
    let behind = head.get(operation.columns.end as usize..)?;
    if line.comment.is_some() || !behind.starts_with([' ', '\t']) {
        return None;
    }
    // A literal that is still being written holds no separating comma.
    let unclosed = parsed.errors.iter().find(|error| error.kind == SyntaxErrorKind::UnclosedText);
    let index = match unclosed {
        Some(error) => line.operands.iter().filter(|o| o.columns.end <= error.columns.start).count(),
        None => line.operands.len().saturating_sub(1),
    };
    if let Some(entry) = catalogue::entry(&operation.text).filter(|entry| is_written_first(entry)) {
        return of_entry(entry, index, language);
    }
    if let [Expr { kind: ExprKind::Name(word), columns }] = line.operands.as_slice()
        && head.len() > columns.end as usize
        && let Some(entry) = catalogue::entry(&word.text).filter(|entry| is_written_second(entry))
    {
        return of_entry(entry, 0, language);
    }
    let parameters = macro_parameters(db, project, file, &operation.text)?;
    of_macro(&operation.text, &parameters, index)
}

fn is_written_first(entry: &Entry) -> bool {
    !matches!(entry.kind, EntryKind::TypePrefix | EntryKind::Keyword | EntryKind::EventProcedure)
}

/// `MEMBER DB ?`: without its value the line does not read as one of a structure yet.
fn is_written_second(entry: &Entry) -> bool {
    matches!(entry.name, "DB" | "DW" | "DD" | "DQ")
}

fn of_entry(entry: &'static Entry, index: usize, language: Language) -> Option<SignatureHelp> {
    let last = entry.operands.last()?;
    let mut label = Label::new(entry.name);
    for (number, operand) in entry.operands.iter().enumerate() {
        label.parameter(number, operand, operand_page(operand, language));
    }
    let mut documentation = entry.summary.in_language(language).to_owned();
    if entry.forms.len() > 1 {
        documentation.push_str("\n\n```technol\n");
        for form in entry.forms {
            documentation.push_str(form.syntax);
            documentation.push('\n');
        }
        documentation.push_str("```");
    }
    let active = match index {
        index if index < entry.operands.len() => Some(index as u32),
        _ if last.repeatable => Some(entry.operands.len() as u32 - 1),
        _ => None,
    };
    Some(SignatureHelp { label: label.text, documentation, parameters: label.parameters, active })
}

fn operand_page(operand: &OperandSpec, language: Language) -> String {
    let kind = page::operand_kind(operand, language);
    format!("{}\n\n*{kind}*", operand.help.in_language(language))
}

fn of_macro(name: &str, parameters: &[String], index: usize) -> Option<SignatureHelp> {
    if parameters.is_empty() {
        return None;
    }
    let mut label = Label::new(name);
    for (number, parameter) in parameters.iter().enumerate() {
        label.separate(number, false);
        label.word(parameter, String::new());
    }
    let active = (index < parameters.len()).then_some(index as u32);
    let documentation = String::new();
    Some(SignatureHelp { label: label.text, documentation, parameters: label.parameters, active })
}

/// A label in the making.
struct Label {
    text: String,
    parameters: Vec<Parameter>,
}

impl Label {
    fn new(name: &str) -> Label {
        Label { text: name.to_owned(), parameters: Vec::new() }
    }

    /// `a, b [, c] [, …]`: optional ones in brackets, as the forms of the help have them.
    fn parameter(&mut self, number: usize, operand: &OperandSpec, documentation: String) {
        self.separate(number, operand.optional);
        self.word(operand.name, documentation);
        if operand.optional {
            self.text.push(']');
        }
        if operand.repeatable {
            self.text.push_str(" [, …]");
        }
    }

    fn separate(&mut self, number: usize, optional: bool) {
        self.text.push_str(match (number, optional) {
            (0, false) => " ",
            (0, true) => " [",
            (_, false) => ", ",
            (_, true) => " [, ",
        });
    }

    fn word(&mut self, word: &str, documentation: String) {
        let start = self.text.len() as u32;
        self.text.push_str(word);
        self.parameters.push(Parameter { label: (start, self.text.len() as u32), documentation });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::entries;
    use crate::ide::fixture::fixture;

    fn ask(line: &str) -> Option<SignatureHelp> {
        let it = fixture(&format!("MODULE_MAIN\n{line}\nMODULE_MAIN_END\n"));
        it.analysis.signature_help(&it.file, it.at, Language::En).expect("nothing cancels it")
    }

    /// The label with the active operand between `«` and `»`.
    fn show(line: &str) -> String {
        let Some(help) = ask(line) else { return String::from("none") };
        let Some(active) = help.active else { return help.label };
        let (start, end) = help.parameters[active as usize].label;
        let (start, end) = (start as usize, end as usize);
        format!("{}«{}»{}", &help.label[..start], &help.label[start..end], &help.label[end..])
    }

    #[test]
    fn the_operand_at_the_cursor_is_marked() {
        let expected = [
            ("        TEX0 <CURSOR>", "TEX0 «count», time, error [, code]"),
            ("X:      TEX0 -,<CURSOR>", "TEX0 count, «time», error [, code]"),
            ("        TEX0 -, 50<CURSOR>, ERR", "TEX0 count, «time», error [, code]"),
            ("        TEX0 -, 50, ERR<CURSOR>", "TEX0 count, time, «error» [, code]"),
            ("        TEX0 -, 50, ERR, 7, <CURSOR>", "TEX0 count, time, error [, code]"),
            ("        WR A, B, C<CURSOR>", "WR «bit» [, …]"),
            ("        ESET 5,<CURSOR>", "ESET [error] [, «subid»] [, set] [, par1] [, par2] [, par3]"),
            ("        STRCPY A,'x,y<CURSOR>", "STRCPY text1, «text2» [, num]"),
        ];
        for (line, shown) in expected {
            assert_eq!(show(line), shown, "{line}");
        }
    }

    #[test]
    fn there_is_none_where_no_operand_is_written() {
        for line in [
            "        TE<CURSOR>X0",
            "        LOD X ;a <CURSOR>",
            "<CURSOR>",
            "        CA <CURSOR>",
            "        FOO <CURSOR>",
        ] {
            assert_eq!(show(line), "none", "{line}");
        }
    }

    #[test]
    fn every_entry_with_operands_has_a_signature_that_names_them_all() {
        for entry in entries().filter(|entry| is_written_first(entry)) {
            for language in [Language::En, Language::Cs] {
                let help = of_entry(entry, 0, language);
                assert_eq!(help.is_some(), !entry.operands.is_empty(), "{}", entry.name);
                let Some(help) = help else { continue };
                let named: Vec<&str> = help
                    .parameters
                    .iter()
                    .map(|p| &help.label[p.label.0 as usize..p.label.1 as usize])
                    .collect();
                let operands: Vec<&str> = entry.operands.iter().map(|operand| operand.name).collect();
                assert_eq!(named, operands, "{}", entry.name);
                assert!(help.documentation.starts_with(entry.summary.in_language(language)));
                assert!(help.parameters.iter().all(|p| p.documentation.len() > 4), "{}", entry.name);
            }
        }
    }
}
