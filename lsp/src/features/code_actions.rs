//! The remedies that diagnostics bring along.

use std::collections::HashMap;

use technol_analysis::{Cancellable, Diagnostic, Fix};
use tower_lsp::ls_types::request::CodeActionRequest;
use tower_lsp::ls_types::{
    CodeAction, CodeActionContext, CodeActionKind, CodeActionOrCommand, CodeActionParams, DocumentChanges,
    OneOf, OptionalVersionedTextDocumentIdentifier, Range, TextDocumentEdit, TextEdit, Uri, WorkspaceEdit,
};

use super::{Feature, Views, of_document};
use crate::diagnostics;
use crate::view::View;

pub(super) struct CodeActions;

impl Feature for CodeActions {
    type Request = CodeActionRequest;

    fn views(params: &CodeActionParams, views: &dyn Views) -> Vec<View> {
        of_document(&params.text_document.uri, views)
    }

    fn answer(views: &[View], params: &CodeActionParams) -> Cancellable<Option<Vec<CodeActionOrCommand>>> {
        let [view] = views else { return Ok(None) };
        if !view.client.literal_actions || !wants_quick_fixes(&params.context) {
            return Ok(Some(Vec::new()));
        }
        let mut actions = Vec::new();
        for diagnostic in view.analysis.diagnostics(&view.file)? {
            let range = view.range_here(diagnostic.span);
            if range.start > params.range.end || params.range.start > range.end {
                continue;
            }
            if let Some(fix) = &diagnostic.fix {
                actions.push(action(view, &params.text_document.uri, &diagnostic, fix, true));
            }
            if let Some(fix) = view.analysis.allow(&view.file, &diagnostic)? {
                actions.push(action(view, &params.text_document.uri, &diagnostic, &fix, false));
            }
        }
        Ok(Some(actions))
    }
}

fn wants_quick_fixes(context: &CodeActionContext) -> bool {
    context.only.as_ref().is_none_or(|only| {
        only.iter().any(|kind| *kind == CodeActionKind::QUICKFIX || *kind == CodeActionKind::EMPTY)
    })
}

/// `remedy`: it corrects the mistake, so that an editor may apply it unasked.
fn action(view: &View, uri: &Uri, diagnostic: &Diagnostic, fix: &Fix, remedy: bool) -> CodeActionOrCommand {
    CodeActionOrCommand::CodeAction(CodeAction {
        title: fix.title.clone(),
        kind: Some(CodeActionKind::QUICKFIX),
        diagnostics: Some(vec![diagnostics::to_client(view, &view.file, diagnostic)]),
        edit: Some(workspace_edit(view, uri, fix)),
        is_preferred: Some(remedy),
        ..CodeAction::default()
    })
}

fn workspace_edit(view: &View, uri: &Uri, fix: &Fix) -> WorkspaceEdit {
    let edit = |(span, new_text): &(technol_analysis::Span, String)| {
        let range: Range = view.range_here(*span);
        TextEdit { range, new_text: new_text.clone() }
    };
    let edits: Vec<TextEdit> = fix.edits.iter().map(edit).collect();
    if !view.client.versioned_edits {
        let changes = HashMap::from([(uri.clone(), edits)]);
        return WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() };
    }
    let version = view.state(&view.file).and_then(|it| it.version);
    let document = OptionalVersionedTextDocumentIdentifier { uri: uri.clone(), version };
    let change =
        TextDocumentEdit { text_document: document, edits: edits.into_iter().map(OneOf::Left).collect() };
    WorkspaceEdit { document_changes: Some(DocumentChanges::Edits(vec![change])), ..WorkspaceEdit::default() }
}
