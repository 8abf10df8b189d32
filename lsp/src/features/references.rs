//! Where a name is used.

use technol_analysis::Cancellable;
use tower_lsp::ls_types::request::References;
use tower_lsp::ls_types::{Location, ReferenceParams};

use super::{Feature, Views, of_document};
use crate::view::View;

pub(super) struct FindReferences;

impl Feature for FindReferences {
    type Request = References;

    fn views(params: &ReferenceParams, views: &dyn Views) -> Vec<View> {
        of_document(&params.text_document_position.text_document.uri, views)
    }

    fn answer(views: &[View], params: &ReferenceParams) -> Cancellable<Option<Vec<Location>>> {
        let [view] = views else { return Ok(None) };
        let position = view.position(params.text_document_position.position);
        let found = view.analysis.references(&view.file, position, params.context.include_declaration)?;
        Ok(Some(found.iter().filter_map(|it| view.location(&it.location)).collect()))
    }
}
