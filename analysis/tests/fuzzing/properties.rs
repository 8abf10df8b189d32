//! What holds for every input.

use std::sync::Arc;

use technol_analysis::project::{Encoding, LoadedProject, decode, encode, load};
use technol_analysis::syntax::{lines, parse};
use technol_analysis::{Analysis, AnalysisHost, Change, Diagnostic, Language, Position, Span};

use super::input::{Edit, Input};

type Found = Vec<(String, Vec<Diagnostic>)>;

/// Panics when something does not hold.
pub(crate) fn check(bytes: &[u8]) {
    let input = Input::of(bytes);
    for bytes in input.files.values() {
        nothing_is_lost(bytes);
    }
    let loaded = load(input.root(), &input);
    let mut host = host(&loaded);
    let before = diagnostics(&host.analysis());
    spans_are_inside(&host.analysis(), &before);
    let built = host.analysis().build().expect("nothing cancels it");
    if let Err(problems) = built {
        assert!(!problems.is_empty(), "a refusal says why");
    }
    let Some((path, text)) = edited(&loaded, input.edit) else { return };
    ask(&host.analysis(), &path, input.edit);
    let old = host.analysis().text(&path).expect("nothing cancels it").expect("it was loaded");

    let change = |text: &Arc<str>| Change { project: None, texts: vec![(path.clone(), text.clone())] };
    host.apply(change(&text));
    let after = diagnostics(&host.analysis());
    // Undecodable bytes are places of the file as it was read: an edit does not move them.
    let moved: Found = after
        .iter()
        .map(|(path, list)| (path.clone(), list.iter().filter(|d| d.code != "T0013").cloned().collect()))
        .collect();
    spans_are_inside(&host.analysis(), &moved);
    ask(&host.analysis(), &path, input.edit);
    let scratch = self::host(&with(&loaded, &path, &text));
    assert_eq!(after, diagnostics(&scratch.analysis()), "an edit finds what a fresh start finds");
    let _ = host.needs_reload();

    host.apply(change(&old));
    assert_eq!(diagnostics(&host.analysis()), before, "taking an edit back takes its findings back");
}

/// Decoding keeps every byte, and the tree every character.
fn nothing_is_lost(bytes: &[u8]) {
    let guesses = [None, Some(Encoding::Utf8), Some(Encoding::Windows1250), Some(Encoding::Cp852)];
    for (number, declared) in guesses.into_iter().enumerate() {
        let decoded = decode(bytes, declared);
        if let Some((at, _)) = decoded.problem {
            assert!(at < bytes.len(), "{declared:?}: the undecodable byte {at} is one of the file");
        } else {
            let again = encode(&decoded.text, decoded.encoding);
            assert_eq!(again.as_deref(), Ok(bytes), "{declared:?}: the bytes come back");
        }
        if number == 0 {
            assert_eq!(parse(&decoded.text).root().to_string(), decoded.text, "the tree is lossless");
        }
    }
}

fn host(project: &LoadedProject) -> AnalysisHost {
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(project.clone()), texts: Vec::new() });
    host
}

fn diagnostics(analysis: &Analysis) -> Found {
    analysis.all_diagnostics().expect("nothing cancels it")
}

/// The path of the edited file and its text without the part that goes.
fn edited(loaded: &LoadedProject, edit: Edit) -> Option<(String, Arc<str>)> {
    let all: Vec<_> = loaded.files.iter().chain(&loaded.included).chain(&loaded.configuration).collect();
    let file = all.get(edit.file % all.len().max(1))?;
    let from = offset(&file.text, edit.from.min(edit.to));
    let to = offset(&file.text, edit.from.max(edit.to));
    let text = [&file.text[..from], &file.text[to..]].concat();
    Some((file.path.clone(), Arc::from(text)))
}

/// A place in thousandths of a text, between two characters.
fn offset(text: &str, place: usize) -> usize {
    let mut at = text.len() * place / 1000;
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

fn with(loaded: &LoadedProject, path: &str, text: &Arc<str>) -> LoadedProject {
    let mut loaded = loaded.clone();
    let all = loaded.files.iter_mut().chain(&mut loaded.included).chain(&mut loaded.configuration);
    for file in all.filter(|file| file.path == path) {
        file.text = text.clone();
    }
    loaded
}

/// Everything a finding points at is there.
fn spans_are_inside(analysis: &Analysis, found: &Found) {
    for (path, list) in found {
        for diagnostic in list {
            let inside = |path: &str, span: Span| {
                let Some(text) = analysis.text(path).expect("nothing cancels it") else { return };
                assert!(is_inside(&text, span), "{path} {span:?} is outside: {diagnostic:?}");
            };
            inside(path, diagnostic.span);
            for (location, _) in &diagnostic.related {
                inside(&location.file, location.span);
            }
            for (span, _) in diagnostic.fix.iter().flat_map(|fix| &fix.edits) {
                inside(path, *span);
            }
        }
    }
}

fn is_inside(text: &str, span: Span) -> bool {
    let lines: Vec<&str> = lines(text).map(|line| line.text).collect();
    let there = |at: Position| match lines.get(at.line as usize) {
        Some(line) => line.is_char_boundary(at.column as usize),
        // The end of the text, behind the last end of a line.
        None => at.line as usize == lines.len() && at.column == 0,
    };
    span.start <= span.end && there(span.start) && there(span.end)
}

/// The editor's questions, at the ends of the edit, at the end of the text and outside of it.
fn ask(analysis: &Analysis, path: &str, edit: Edit) {
    let text = analysis.text(path).expect("nothing cancels it").unwrap_or_default();
    let place = |thousandths: usize| {
        let at = offset(&text, thousandths);
        let line = lines(&text[..at]).count().saturating_sub(1);
        let column = text[..at].len() - text[..at].rfind(['\n', '\r']).map_or(0, |end| end + 1);
        Position { line: line as u32, column: column as u32 }
    };
    let outside = Position { line: place(edit.to).line, column: 1_000_000 };
    for (number, at) in [place(edit.from), place(edit.to), place(1000), outside].into_iter().enumerate() {
        let language = if number % 2 == 0 { Language::En } else { Language::Cs };
        analysis.hover(path, at, language).expect("nothing cancels it");
        analysis.completion(path, at, language).expect("nothing cancels it");
        analysis.signature_help(path, at, language).expect("nothing cancels it");
        analysis.references(path, at, true).expect("nothing cancels it");
        analysis.definition(path, at).expect("nothing cancels it");
    }
    analysis.document_symbols(path).expect("nothing cancels it");
    analysis.workspace_symbols("A").expect("nothing cancels it");
}
