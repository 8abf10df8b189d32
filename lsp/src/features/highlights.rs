//! The uses of a name in the same file, read and written ones told apart.

use technol_analysis::{Cancellable, ReferenceAccess};
use tower_lsp::ls_types::request::DocumentHighlightRequest;
use tower_lsp::ls_types::{DocumentHighlight, DocumentHighlightKind, DocumentHighlightParams};

use super::{Feature, Views, of_document};
use crate::view::View;

pub(super) struct Highlights;

impl Feature for Highlights {
    type Request = DocumentHighlightRequest;

    fn views(params: &DocumentHighlightParams, views: &dyn Views) -> Vec<View> {
        of_document(&params.text_document_position_params.text_document.uri, views)
    }

    fn answer(
        views: &[View],
        params: &DocumentHighlightParams,
    ) -> Cancellable<Option<Vec<DocumentHighlight>>> {
        let [view] = views else { return Ok(None) };
        let position = view.position(params.text_document_position_params.position);
        let found = view.analysis.references(&view.file, position, true)?;
        let here = found.iter().filter(|it| it.location.file == view.file);
        let mark = |it: &technol_analysis::Reference| DocumentHighlight {
            range: view.range_here(it.location.span),
            kind: Some(kind(it.access)),
        };
        Ok(Some(here.map(mark).collect()))
    }
}

/// What writes in any way is shown as a write.
fn kind(access: ReferenceAccess) -> DocumentHighlightKind {
    match access {
        ReferenceAccess::Read => DocumentHighlightKind::READ,
        ReferenceAccess::Write | ReferenceAccess::ReadWrite => DocumentHighlightKind::WRITE,
        ReferenceAccess::Declare | ReferenceAccess::Jump | ReferenceAccess::Call => {
            DocumentHighlightKind::TEXT
        }
    }
}
