//! Mnemonics, keywords and the names that fit an operand.

use technol_analysis::{Cancellable, Completion, CompletionKind};
use tower_lsp::ls_types::request::Completion as CompletionRequest;
use tower_lsp::ls_types::{
    CompletionItem, CompletionItemKind, CompletionList, CompletionParams, CompletionResponse,
    CompletionTextEdit, Documentation, MarkupContent, MarkupKind, TextEdit,
};

use super::{Feature, Views, of_document};
use crate::view::View;

pub(super) struct Completions;

impl Feature for Completions {
    type Request = CompletionRequest;

    fn views(params: &CompletionParams, views: &dyn Views) -> Vec<View> {
        of_document(&params.text_document_position.text_document.uri, views)
    }

    fn answer(views: &[View], params: &CompletionParams) -> Cancellable<Option<CompletionResponse>> {
        let [view] = views else { return Ok(None) };
        let position = view.position(params.text_document_position.position);
        let found = view.analysis.completion(&view.file, position, view.language)?;
        // A full list was cut: the editor asks again when more letters are typed.
        let is_incomplete = found.len() >= technol_analysis::ide::MOST_COMPLETIONS;
        let items = found.into_iter().enumerate().map(|(rank, it)| item(view, rank, it)).collect();
        Ok(Some(CompletionResponse::List(CompletionList { is_incomplete, items })))
    }
}

/// The analysis gives the best first; the rank keeps that order in the editor.
fn item(view: &View, rank: usize, found: Completion) -> CompletionItem {
    let markdown = |value| Documentation::MarkupContent(MarkupContent { kind: MarkupKind::Markdown, value });
    CompletionItem {
        sort_text: Some(format!("{rank:05}")),
        filter_text: (found.label != found.insert).then(|| found.insert.clone()),
        label: found.label,
        kind: Some(kind(found.kind)),
        detail: (!found.detail.is_empty()).then_some(found.detail),
        documentation: found.documentation.map(markdown),
        text_edit: Some(CompletionTextEdit::Edit(TextEdit {
            range: view.range_here(found.replace),
            new_text: found.insert,
        })),
        ..CompletionItem::default()
    }
}

/// The protocol's nearest icon; the same as in the outline where there is one.
fn kind(kind: CompletionKind) -> CompletionItemKind {
    match kind {
        CompletionKind::Instruction => CompletionItemKind::METHOD,
        CompletionKind::Structure => CompletionItemKind::MODULE,
        CompletionKind::Keyword | CompletionKind::Prefix => CompletionItemKind::KEYWORD,
        CompletionKind::Bit => CompletionItemKind::FIELD,
        CompletionKind::Cell | CompletionKind::Area => CompletionItemKind::VARIABLE,
        CompletionKind::Text => CompletionItemKind::TEXT,
        CompletionKind::Constant => CompletionItemKind::CONSTANT,
        CompletionKind::Mechanism => CompletionItemKind::CLASS,
        CompletionKind::Procedure => CompletionItemKind::FUNCTION,
        CompletionKind::Macro => CompletionItemKind::SNIPPET,
        CompletionKind::Label => CompletionItemKind::REFERENCE,
        CompletionKind::Parameter => CompletionItemKind::VARIABLE,
    }
}
