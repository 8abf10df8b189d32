//! Where a name is declared.

use technol_analysis::Cancellable;
use tower_lsp::ls_types::request::GotoDefinition;
use tower_lsp::ls_types::{GotoDefinitionParams, GotoDefinitionResponse};

use super::{Feature, Views, of_document};
use crate::view::View;

pub(super) struct Definition;

impl Feature for Definition {
    type Request = GotoDefinition;

    fn views(params: &GotoDefinitionParams, views: &dyn Views) -> Vec<View> {
        of_document(&params.text_document_position_params.text_document.uri, views)
    }

    fn answer(views: &[View], params: &GotoDefinitionParams) -> Cancellable<Option<GotoDefinitionResponse>> {
        let [view] = views else { return Ok(None) };
        let position = view.position(params.text_document_position_params.position);
        let places = view.analysis.definition(&view.file, position)?;
        Ok(Some(GotoDefinitionResponse::Array(places.iter().filter_map(|it| view.location(it)).collect())))
    }
}
