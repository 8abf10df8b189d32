//! Help on what is under the cursor.

use technol_analysis::Cancellable;
use tower_lsp::ls_types::request::HoverRequest;
use tower_lsp::ls_types::{Hover, HoverContents, HoverParams, MarkupContent, MarkupKind};

use super::{Feature, Views, of_document};
use crate::view::View;

pub(super) struct HoverHelp;

impl Feature for HoverHelp {
    type Request = HoverRequest;

    fn views(params: &HoverParams, views: &dyn Views) -> Vec<View> {
        of_document(&params.text_document_position_params.text_document.uri, views)
    }

    fn answer(views: &[View], params: &HoverParams) -> Cancellable<Option<Hover>> {
        let [view] = views else { return Ok(None) };
        let position = view.position(params.text_document_position_params.position);
        let hover = view.analysis.hover(&view.file, position, view.language)?;
        Ok(hover.map(|it| Hover {
            contents: HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value: it.markdown }),
            range: Some(view.range_here(it.span)),
        }))
    }
}
