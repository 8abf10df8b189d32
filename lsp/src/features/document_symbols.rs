//! The outline of a file.

use technol_analysis::{Cancellable, DocumentSymbol as Found};
use tower_lsp::ls_types::request::DocumentSymbolRequest;
use tower_lsp::ls_types::{
    DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, Location, SymbolInformation, Uri,
};

use super::symbol_kind::symbol_kind;
use super::{Feature, Views, of_document};
use crate::view::View;

pub(super) struct DocumentSymbols;

impl Feature for DocumentSymbols {
    type Request = DocumentSymbolRequest;

    fn views(params: &DocumentSymbolParams, views: &dyn Views) -> Vec<View> {
        of_document(&params.text_document.uri, views)
    }

    fn answer(views: &[View], params: &DocumentSymbolParams) -> Cancellable<Option<DocumentSymbolResponse>> {
        let [view] = views else { return Ok(None) };
        let found = view.analysis.document_symbols(&view.file)?;
        if view.client.nested_symbols {
            return Ok(Some(DocumentSymbolResponse::Nested(
                found.into_iter().map(|it| nested(view, it)).collect(),
            )));
        }
        let mut flat = Vec::new();
        flatten(view, &params.text_document.uri, &found, None, &mut flat);
        Ok(Some(DocumentSymbolResponse::Flat(flat)))
    }
}

#[expect(deprecated, reason = "the protocol's type has a field of old that must be given")]
fn nested(view: &View, found: Found) -> DocumentSymbol {
    let children: Vec<_> = found.children.into_iter().map(|it| nested(view, it)).collect();
    DocumentSymbol {
        name: found.name,
        detail: (!found.detail.is_empty()).then_some(found.detail),
        kind: symbol_kind(found.kind),
        tags: None,
        deprecated: None,
        range: view.range_here(found.span),
        selection_range: view.range_here(found.selection),
        children: (!children.is_empty()).then_some(children),
    }
}

#[expect(deprecated, reason = "the protocol's type has a field of old that must be given")]
fn flatten(
    view: &View,
    uri: &Uri,
    found: &[Found],
    container: Option<&str>,
    flat: &mut Vec<SymbolInformation>,
) {
    for it in found {
        flat.push(SymbolInformation {
            name: it.name.clone(),
            kind: symbol_kind(it.kind),
            tags: None,
            deprecated: None,
            location: Location { uri: uri.clone(), range: view.range_here(it.selection) },
            container_name: container.map(str::to_owned),
        });
        flatten(view, uri, &it.children, Some(&it.name), flat);
    }
}
