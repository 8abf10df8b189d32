//! The cut of a file into sections, by the first words of its lines.
//!
//! It never fails: an opening line closes what cannot hold it, a closing line closes its section together with
//! what is still open inside, and a closing line without a section is a plain line.

use std::collections::HashMap;

use technol_image::program::ModuleKind;

use super::ast::key;
use super::lexer::{blank_len, word_len};
use super::lines::lines;
use super::section::{RawSection, SectionKind};

/// Cuts a file into sections in order of their opening lines. The first is always the file itself.
#[must_use]
pub fn split(text: &str) -> Vec<RawSection> {
    let mut cutter = Cutter::new();
    let mut rest = text;
    for (number, line) in lines(text).enumerate() {
        rest = &rest[line.text.len() + line.end.len()..];
        let own = match boundary(line.text) {
            None => cutter.innermost(),
            // DATA instead of DATA_LOCAL in the body of a macro: one mistake, not the end of the macro.
            Some(Boundary::Open(SectionKind::Data, _)) if cutter.in_macro() && macro_goes_on(rest) => {
                cutter.innermost()
            }
            Some(Boundary::Open(kind, name)) => cutter.open(kind, name),
            Some(Boundary::Close(closing)) => cutter.close(closing),
        };
        let section = &mut cutter.sections[own];
        section.text.push_str(line.text);
        section.text.push_str(line.end);
        section.lines.push(number as u32);
    }
    cutter.sections
}

/// Whether the next line that opens or closes a macro or opens a module is END_T_MACRO. An answer of true is asked
/// for again before that line at most once per DATA, and DATA in macros is rare.
fn macro_goes_on(rest: &str) -> bool {
    let next = lines(rest).find_map(|line| match boundary(line.text)? {
        Boundary::Close(Closing::Macro) => Some(true),
        Boundary::Open(SectionKind::Macro | SectionKind::Module(_), _) => Some(false),
        _ => None,
    });
    next.unwrap_or(false)
}

/// What a line does to the sections.
enum Boundary<'a> {
    /// Opens one; the word behind the keyword is its name.
    Open(SectionKind, &'a str),
    /// Closes one.
    Close(Closing),
}

/// What a closing keyword closes. Modules close with the end of any module: a wrong one is a slip of the pen, and
/// better one section with a wrong end than two that run into each other.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Closing {
    Data,
    DataLocal,
    Module,
    Mechanism,
    Procedure,
    Macro,
}

impl Closing {
    fn fits(self, kind: SectionKind) -> bool {
        match self {
            Closing::Data => kind == SectionKind::Data,
            Closing::DataLocal => kind == SectionKind::DataLocal,
            Closing::Module => matches!(kind, SectionKind::Module(_)),
            Closing::Mechanism => kind == SectionKind::Mechanism,
            Closing::Procedure => kind == SectionKind::Procedure,
            Closing::Macro => kind == SectionKind::Macro,
        }
    }
}

struct Cutter {
    sections: Vec<RawSection>,
    /// Indexes of the open sections, outermost (the file) first.
    open: Vec<usize>,
    ordinals: HashMap<(SectionKind, String), u32>,
}

impl Cutter {
    fn new() -> Self {
        Cutter {
            sections: vec![empty(SectionKind::File, String::new(), 0, None)],
            open: vec![0],
            ordinals: HashMap::new(),
        }
    }

    fn innermost(&self) -> usize {
        self.open.last().copied().unwrap_or(0)
    }

    fn kind(&self, depth: usize) -> SectionKind {
        self.sections[self.open[depth]].kind
    }

    fn in_macro(&self) -> bool {
        self.sections[self.innermost()].kind == SectionKind::Macro
    }

    /// Opens a section and returns the owner of its opening line.
    fn open(&mut self, kind: SectionKind, name: &str) -> usize {
        let stays = |inner: SectionKind| match kind {
            SectionKind::File | SectionKind::Data | SectionKind::Module(_) => false,
            SectionKind::Mechanism | SectionKind::Procedure => {
                !matches!(inner, SectionKind::Mechanism | SectionKind::Procedure | SectionKind::DataLocal)
            }
            SectionKind::DataLocal => inner != SectionKind::DataLocal,
            SectionKind::Macro => inner != SectionKind::Macro,
        };
        // The body of a macro is text until it is expanded.
        if self.in_macro()
            && matches!(kind, SectionKind::Mechanism | SectionKind::Procedure | SectionKind::DataLocal)
        {
            return self.innermost();
        }
        while self.open.len() > 1 && !stays(self.kind(self.open.len() - 1)) {
            self.open.pop();
        }
        let parent = self.innermost();
        let index = self.sections.len();
        let name = key(name);
        let count = self.ordinals.entry((kind, name.clone())).or_default();
        let section = empty(kind, name, *count, Some(parent));
        *count += 1;
        let before = self.sections[parent].lines.len() as u32;
        self.sections[parent].children.push((index, before));
        self.sections.push(section);
        self.open.push(index);
        index
    }

    /// Closes a section and returns the owner of the closing line.
    fn close(&mut self, closing: Closing) -> usize {
        if self.in_macro() && !matches!(closing, Closing::Macro | Closing::Module | Closing::Data) {
            return self.innermost();
        }
        let fitting = (1..self.open.len()).rev().find(|depth| closing.fits(self.kind(*depth)));
        if let Some(depth) = fitting.or_else(|| self.mistaken(closing)) {
            let closed = self.open[depth];
            self.open.truncate(depth);
            self.sections[closed].closed = true;
            return closed;
        }
        if closing == Closing::Module {
            self.open.truncate(1);
        }
        self.innermost()
    }

    /// DATA_END on DATA_LOCAL and the other way round.
    fn mistaken(&self, closing: Closing) -> Option<usize> {
        let depth = self.open.len() - 1;
        let swapped = matches!(
            (closing, self.kind(depth)),
            (Closing::Data, SectionKind::DataLocal) | (Closing::DataLocal, SectionKind::Data)
        );
        swapped.then_some(depth)
    }
}

fn empty(kind: SectionKind, name: String, ordinal: u32, parent: Option<usize>) -> RawSection {
    RawSection {
        kind,
        name,
        ordinal,
        parent,
        text: String::new(),
        lines: Vec::new(),
        children: Vec::new(),
        closed: kind == SectionKind::File,
    }
}

/// Looks at the first words of a line.
fn boundary(line: &str) -> Option<Boundary<'_>> {
    let (mut word, mut rest) = next_word(line);
    let behind = &rest[blank_len(rest)..];
    if !word.is_empty() && behind.starts_with(':') {
        (word, rest) = next_word(&behind[1..]);
    }
    // All keywords start with one of these letters; most lines end here.
    if !matches!(word.as_bytes().first().map(u8::to_ascii_uppercase), Some(b'D' | b'M' | b'P' | b'E')) {
        return None;
    }
    let named = |kind| Some(Boundary::Open(kind, next_word(rest).0));
    let is = |keyword: &str| word.eq_ignore_ascii_case(keyword);
    match word.len() {
        4 if is("DATA") => Some(Boundary::Open(SectionKind::Data, "")),
        8 if is("DATA_END") => Some(Boundary::Close(Closing::Data)),
        8 if is("MECH_END") => Some(Boundary::Close(Closing::Mechanism)),
        8 if is("PROC_END") => Some(Boundary::Close(Closing::Procedure)),
        10 if is("MECH_BEGIN") => named(SectionKind::Mechanism),
        10 if is("PROC_BEGIN") => named(SectionKind::Procedure),
        10 if is("DATA_LOCAL") => Some(Boundary::Open(SectionKind::DataLocal, "")),
        14 if is("DATA_LOCAL_END") => Some(Boundary::Close(Closing::DataLocal)),
        11 if is("DEF_T_MACRO") => named(SectionKind::Macro),
        11 if is("END_T_MACRO") => Some(Boundary::Close(Closing::Macro)),
        _ => module(word),
    }
}

fn module(word: &str) -> Option<Boundary<'static>> {
    let ends = word.len() > 4
        && word.is_char_boundary(word.len() - 4)
        && word[word.len() - 4..].eq_ignore_ascii_case("_END");
    let keyword = if ends { &word[..word.len() - 4] } else { word };
    let kind = ModuleKind::ALL.iter().copied().find(|kind| kind.keyword().eq_ignore_ascii_case(keyword))?;
    Some(if ends { Boundary::Close(Closing::Module) } else { Boundary::Open(SectionKind::Module(kind), "") })
}

/// The first word of a text and what stands behind it.
fn next_word(text: &str) -> (&str, &str) {
    let text = &text[blank_len(text)..];
    let len = if text.starts_with(|c: char| c.is_ascii_digit()) { 0 } else { word_len(text) };
    text.split_at(len)
}
