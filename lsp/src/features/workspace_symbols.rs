//! Names in all projects.

use technol_analysis::Cancellable;
use tower_lsp::ls_types::request::WorkspaceSymbolRequest;
use tower_lsp::ls_types::{SymbolInformation, WorkspaceSymbolParams, WorkspaceSymbolResponse};

use super::symbol_kind::symbol_kind;
use super::{Feature, Views};
use crate::view::View;

pub(super) struct WorkspaceSymbols;

impl Feature for WorkspaceSymbols {
    type Request = WorkspaceSymbolRequest;

    fn views(_: &WorkspaceSymbolParams, views: &dyn Views) -> Vec<View> {
        views.of_projects()
    }

    #[expect(deprecated, reason = "the protocol's type has a field of old that must be given")]
    fn answer(
        views: &[View],
        params: &WorkspaceSymbolParams,
    ) -> Cancellable<Option<WorkspaceSymbolResponse>> {
        let mut symbols: Vec<SymbolInformation> = Vec::new();
        for view in views {
            for it in view.analysis.workspace_symbols(&params.query)? {
                let Some(location) = view.location(&it.location) else { continue };
                let symbol = SymbolInformation {
                    name: it.name,
                    kind: symbol_kind(it.kind),
                    tags: None,
                    deprecated: None,
                    location,
                    container_name: (!it.container.is_empty()).then_some(it.container),
                };
                // A file that several projects include shows its names once.
                if !symbols.contains(&symbol) || views.len() == 1 {
                    symbols.push(symbol);
                }
            }
        }
        Ok(Some(WorkspaceSymbolResponse::Flat(symbols)))
    }
}
