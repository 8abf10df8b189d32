//! The lines of a section with its calls expanded.

use std::sync::Arc;

use rustc_hash::FxHashMap;

use super::definition::{BodyLine, Flags, MacroDefinition};
use super::substitute::{self, Bindings, Segment, Spot, Traced};
use super::table::{self, MacroMeaning, MacroUse};
use super::{MARK, MAX_DEPTH, MAX_LINES};
use crate::catalogue;
use crate::database::{self, Db, NameRef, Project, Section};
use crate::syntax::ast::{Columns, ExprKind, Line, Name, SyntaxError, key};
use crate::syntax::section::SectionKind;
use crate::syntax::{ParsedLines, parse_lines};

/// Own lines of a section, each call followed by the lines it expands to.
#[derive(Clone, Debug, PartialEq, salsa::SalsaValue)]
pub struct Expansion<'db> {
    /// The lines, with the mistakes of the parser in them.
    pub parsed: ParsedLines,
    /// Where each comes from.
    pub origins: Vec<Origin>,
    /// Calls in order of their lines.
    pub calls: Vec<Call<'db>>,
    /// Definitions that were used.
    pub definitions: Vec<Section<'db>>,
}

/// Where a line comes from.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Origin {
    /// 0-based own line of the section: its own, or that of the call.
    pub own: u32,
    /// It belongs to an expansion.
    pub body: Option<Body>,
}

/// A line of an expansion.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Body {
    /// Index into [`Expansion::definitions`].
    pub definition: u16,
    /// 0-based own line there.
    pub line: u32,
    /// Index into [`Expansion::calls`] of the call it belongs to.
    pub call: u32,
    /// It stands in DATA_LOCAL of the body.
    pub local: bool,
    /// Its text.
    pub text: String,
    /// Where its pieces were written.
    pub segments: Vec<Segment>,
}

/// A call.
#[derive(Clone, Debug, PartialEq, Eq, salsa::SalsaValue)]
pub struct Call<'db> {
    /// Index of its line in the list.
    pub line: u32,
    /// Index behind its last line.
    pub end: u32,
    /// Columns of the word in its line.
    pub columns: Columns,
    /// Key of the word.
    pub word: Arc<str>,
    /// What it calls.
    pub definition: Option<Section<'db>>,
    /// Its flags.
    pub flags: Flags,
    /// Why it could not be expanded.
    pub problem: Option<Problem>,
}

/// Why a call could not be expanded.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Problem {
    /// The macro is defined behind the call.
    Later,
    /// The macro calls itself; its definition is reported.
    Circle,
    /// Nested or long beyond the bounds.
    TooLarge,
    /// Another number of operands than parameters.
    Arguments {
        /// Parameters of the macro.
        expected: u32,
        /// Operands of the call.
        given: u32,
    },
    /// The operand with this 1-based number is empty.
    Empty(u32),
    /// The operand at these columns has brackets, and the macro was not declared with C_1.
    Brackets(Columns),
}

impl Problem {
    /// The call has no lines because of it.
    #[must_use]
    pub fn stops(&self) -> bool {
        !matches!(self, Problem::Brackets(_))
    }
}

impl<'db> Expansion<'db> {
    /// Where columns of a line were written: in one piece, else nowhere.
    #[must_use]
    pub fn written(&self, line: u32, columns: &Columns) -> Option<(Spot, Columns)> {
        let origin = self.origins.get(line as usize)?;
        let Some(body) = &origin.body else {
            return Some((
                Spot { definition: None, line: origin.own, column: columns.start },
                columns.clone(),
            ));
        };
        let mut spots = body
            .segments
            .iter()
            .filter(|segment| segment.columns.start < columns.end && columns.start < segment.columns.end);
        let first = spots.next()?;
        let last = spots.next_back().unwrap_or(first);
        if (first.spot.definition, first.spot.line) != (last.spot.definition, last.spot.line) {
            return None;
        }
        let into = |segment: &Segment, column: u32, end: bool| {
            let exact = segment.columns.end - segment.columns.start == segment.len;
            match (exact, end) {
                (true, _) => segment.spot.column + (column - segment.columns.start),
                (false, false) => segment.spot.column,
                (false, true) => segment.spot.column + segment.len,
            }
        };
        let start = into(first, columns.start.max(first.columns.start), false);
        let end = into(last, columns.end.min(last.columns.end), true);
        (start <= end).then_some((Spot { column: start, ..first.spot }, start..end))
    }

    /// Columns of the own line that stand for columns of a line: those of an operand that the call wrote, else
    /// those of the word that calls.
    #[must_use]
    pub fn shown(&self, line: u32, columns: &Columns) -> Columns {
        if let Some((Spot { definition: None, .. }, columns)) = self.written(line, columns) {
            return columns;
        }
        let outer = self.outermost(line).and_then(|call| self.calls.get(call as usize));
        outer.map_or_else(|| columns.clone(), |call| call.columns.clone())
    }

    /// The call in the section's own line that a line belongs to.
    #[must_use]
    pub fn outermost(&self, line: u32) -> Option<u32> {
        let mut call = self.origins.get(line as usize)?.body.as_ref()?.call;
        // A call stands before its lines, so this ends.
        while let Some(body) =
            self.calls.get(call as usize).and_then(|call| self.origins.get(call.line as usize)?.body.as_ref())
        {
            call = body.call;
        }
        Some(call)
    }

    /// The definition's section, own line and columns of a place in an expansion.
    #[must_use]
    pub fn defined(&self, db: &dyn Db, line: u32, columns: &Columns) -> Option<(Section<'db>, u32, Columns)> {
        let body = self.origins.get(line as usize)?.body.as_ref()?;
        if let Some((Spot { definition: Some(definition), line, .. }, columns)) = self.written(line, columns)
        {
            return Some((*self.definitions.get(usize::from(definition))?, line, columns));
        }
        // The call wrote it: the whole line of the body stands for what it does with it.
        let section = *self.definitions.get(usize::from(body.definition))?;
        let lines = &database::macro_definition(db, section).body;
        let text = &lines.get(lines.binary_search_by_key(&body.line, |line| line.line).ok()?)?.text;
        let start = text.len() - text.trim_start().len();
        Some((section, body.line, start as u32..text.len() as u32))
    }

    /// Own lines with calls, each with whether it takes break-points.
    #[must_use]
    pub fn call_lines(&self) -> Vec<(u32, bool)> {
        let own = self.calls.iter().filter_map(|call| {
            let origin = self.origins.get(call.line as usize)?;
            origin.body.is_none().then_some((origin.own, call.flags.break_points))
        });
        own.collect()
    }
}

/// Expands a section; `None` when it has no calls.
pub(crate) fn expand<'db>(
    db: &'db dyn Db,
    project: Project,
    section: Section<'db>,
) -> Option<Expansion<'db>> {
    if section.kind(db) == SectionKind::Macro {
        return None;
    }
    let mut builder = Builder {
        db,
        project,
        section,
        pre: database::macros_before(db, project),
        meanings: FxHashMap::default(),
        tag: tag(db, section),
        chain: Vec::new(),
        used: FxHashMap::default(),
        added: 0,
        out: Expansion {
            parsed: ParsedLines::default(),
            origins: Vec::new(),
            calls: Vec::new(),
            definitions: Vec::new(),
        },
    };
    let parsed = database::section_lines(db, section);
    let calls = |builder: &mut Builder<'db>, number: usize, line: &Line| {
        let word = line.operation.as_ref();
        word.is_some_and(|word| builder.called(&word.text, number as u32).is_some())
    };
    let first =
        parsed.lines.iter().enumerate().position(|(number, line)| calls(&mut builder, number, line))?;
    let mut errors = parsed.errors.iter().peekable();
    let mut texts = crate::syntax::lines(section.text(db));
    for (number, line) in parsed.lines.iter().enumerate() {
        let own = number as u32;
        let text = texts.next().map_or("", |line| line.text);
        let at = builder.out.parsed.lines.len() as u32;
        if let Some(error) = errors.next_if(|error| error.line == own) {
            builder.out.parsed.errors.push(SyntaxError { line: at, ..error.clone() });
        }
        builder.out.parsed.lines.push(line.clone());
        builder.out.origins.push(Origin { own, body: None });
        if number >= first {
            let traced = |()| Traced::plain(text, Spot { definition: None, line: own, column: 0 });
            builder.line(line, own, traced);
        }
    }
    Some(builder.out)
}

/// What makes the T_LOCAL names of a section differ from those of others.
fn tag(db: &dyn Db, section: Section<'_>) -> String {
    let kind = match section.kind(db) {
        SectionKind::File => "FILE",
        SectionKind::Data => "DATA",
        SectionKind::DataLocal => "LOCAL",
        SectionKind::Module(module) => module.keyword().trim_start_matches("MODULE_"),
        SectionKind::Mechanism | SectionKind::Procedure | SectionKind::Macro => "",
    };
    let file = section.file(db);
    let included = if file.order(db).is_none() { file.path(db).as_str() } else { "" };
    let words = [included, kind, section.name(db)];
    let mut tag: String = words.concat().chars().filter(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
    if section.ordinal(db) > 0 {
        tag.push('_');
        tag.push_str(&section.ordinal(db).to_string());
    }
    tag
}

struct Builder<'db> {
    db: &'db dyn Db,
    project: Project,
    section: Section<'db>,
    /// CONTROL_T_MACRO PRE stands somewhere: instructions may be macros too.
    pre: bool,
    meanings: FxHashMap<String, Option<&'db MacroMeaning<'db>>>,
    tag: String,
    /// Definitions being expanded, outermost first.
    chain: Vec<Section<'db>>,
    used: FxHashMap<Section<'db>, u16>,
    /// Number of lines that do not belong to the section itself.
    added: usize,
    out: Expansion<'db>,
}

/// What an operation calls.
enum Called<'db> {
    Macro(MacroUse<'db>),
    /// Defined behind the call.
    Later,
}

impl<'db> Builder<'db> {
    fn called(&mut self, word: &str, own: u32) -> Option<Called<'db>> {
        let is_instruction = table::is_instruction(word);
        if is_instruction && !self.pre {
            return None;
        }
        let key = key(word);
        let known = self.meanings.get(&key).copied();
        let meaning = known.unwrap_or_else(|| {
            let name = NameRef::new(self.db, Arc::from(key.as_str()), None);
            let found = database::macro_meaning(self.db, self.project, self.section, name);
            let found = found.somewhere.then_some(found);
            self.meanings.insert(key, found);
            found
        })?;
        match meaning.at(own) {
            Some(found) => Some(Called::Macro(found)),
            None => (!is_instruction).then_some(Called::Later),
        }
    }

    /// Expands what the last line calls, if it calls something.
    fn line(&mut self, line: &Line, own: u32, text: impl FnOnce(()) -> Traced) {
        let Some(operation) = &line.operation else { return };
        let Some(called) = self.called(&operation.text, own) else { return };
        let at = self.out.parsed.lines.len() as u32 - 1;
        let mut call = Call {
            line: at,
            end: at + 1,
            columns: operation.columns.clone(),
            word: Arc::from(key(&operation.text)),
            definition: None,
            flags: Flags::default(),
            problem: None,
        };
        let Called::Macro(found) = called else {
            call.problem = Some(Problem::Later);
            self.out.calls.push(call);
            return;
        };
        if self.chain.contains(&found.definition) {
            if catalogue::entry(&operation.text).is_some() {
                // The body of a macro that overloads an instruction means the instruction.
                return;
            }
            call.problem = Some(Problem::Circle);
            self.out.calls.push(call);
            return;
        }
        let definition = database::macro_definition(self.db, found.definition);
        call.definition = Some(found.definition);
        call.flags = found.flags.unwrap_or(definition.flags);
        call.problem = self.refuses(line, definition.parameters.len(), call.flags);
        let stops = call.problem.as_ref().is_some_and(Problem::stops);
        self.out.calls.push(call);
        if !stops {
            self.body(found.definition, definition, own, line, &text(()));
        }
    }

    /// Adds the lines of the last call, which stands in `line` of the text `call`.
    fn body(
        &mut self,
        section: Section<'db>,
        definition: &MacroDefinition,
        own: u32,
        line: &Line,
        call: &Traced,
    ) {
        let number = self.out.calls.len() - 1;
        let actual = line.operands.iter().map(|operand| call.slice(&operand.columns));
        let unique = |name: &str| format!("{name}{MARK}{}@{}", self.tag, number + 1);
        let with = Bindings {
            parameters: definition.parameters.iter().map(Name::key).zip(actual).collect(),
            locals: definition.locals.iter().map(|(_, name)| (name.key(), unique(&name.text))).collect(),
        };
        let next = self.out.definitions.len() as u16;
        let index = *self.used.entry(section).or_insert(next);
        if index == next {
            self.out.definitions.push(section);
        }
        self.chain.push(section);
        let mut local = false;
        for line in &definition.body {
            if !self.body_line(line, own, (index, number as u32), &with, &mut local) {
                break;
            }
        }
        self.chain.pop();
        self.out.calls[number].end = self.out.parsed.lines.len() as u32;
    }

    fn refuses(&self, line: &Line, expected: usize, flags: Flags) -> Option<Problem> {
        let given = line.operands.len();
        if given != expected {
            return Some(Problem::Arguments { expected: expected as u32, given: given as u32 });
        }
        if let Some(empty) = line.operands.iter().position(|o| o.kind == ExprKind::Missing) {
            return Some(Problem::Empty(empty as u32 + 1));
        }
        if self.chain.len() >= MAX_DEPTH || self.added >= MAX_LINES {
            return Some(Problem::TooLarge);
        }
        let brackets = line.operands.iter().find(|operand| !flags.brackets && has_brackets(&operand.kind));
        brackets.map(|operand| Problem::Brackets(operand.columns.clone()))
    }

    /// Adds a line of a body and what it calls; `false` when there is no room.
    fn body_line(
        &mut self,
        line: &BodyLine,
        own: u32,
        (definition, call): (u16, u32),
        with: &Bindings,
        local: &mut bool,
    ) -> bool {
        if self.added >= MAX_LINES {
            self.out.calls[call as usize].problem = Some(Problem::TooLarge);
            return false;
        }
        self.added += 1;
        let word = line
            .operation
            .as_ref()
            .and_then(|columns| line.text.get(columns.start as usize..columns.end as usize))
            .unwrap_or_default();
        let assembler = catalogue::entry(word).is_none_or(catalogue::Entry::is_assembler);
        let bare = assembler || self.called(word, own).is_some();
        let origin = Spot { definition: Some(definition), line: line.line, column: 0 };
        let traced = substitute::line(&line.text, line.operation.as_ref(), bare, origin, with);
        let mut parsed = parse_lines(&traced.text);
        let at = self.out.parsed.lines.len() as u32;
        let Some(first) = parsed.lines.pop() else { return true };
        let ends = word.eq_ignore_ascii_case("DATA_LOCAL_END");
        if ends {
            *local = false;
        }
        if let Some(error) = parsed.errors.pop() {
            self.out.parsed.errors.push(SyntaxError { line: at, ..error });
        }
        self.out.parsed.lines.push(first.clone());
        let body = Body {
            definition,
            line: line.line,
            call,
            local: *local,
            text: traced.text.clone(),
            segments: traced.segments.clone(),
        };
        self.out.origins.push(Origin { own, body: Some(body) });
        if word.eq_ignore_ascii_case("DATA_LOCAL") {
            *local = true;
        }
        self.line(&first, own, |()| traced);
        true
    }
}

/// `( )` somewhere in an operand.
fn has_brackets(kind: &ExprKind) -> bool {
    match kind {
        ExprKind::Parens(_) => true,
        ExprKind::Index { base, index } => has_brackets(&base.kind) || has_brackets(&index.kind),
        ExprKind::Sign { operand, .. } => has_brackets(&operand.kind),
        ExprKind::Sum { left, right, .. } | ExprKind::Dot { left, right } => {
            has_brackets(&left.kind) || has_brackets(&right.kind)
        }
        _ => false,
    }
}
