//! The requests about programs, one file per feature: the protocol's question in, the protocol's answer out.

mod code_actions;
mod completion;
mod definition;
mod document_symbols;
mod highlights;
mod hover;
mod references;
mod signature_help;
mod symbol_kind;
#[cfg(test)]
mod test_requests;
mod workspace_symbols;

use serde_json::Value;
use technol_analysis::Cancellable;
use tower_lsp::jsonrpc::{Error, ErrorCode};
use tower_lsp::ls_types::Uri;
use tower_lsp::ls_types::request::Request;

use crate::requests::error;
use crate::view::View;

/// Work that gives a request's answer. It owns a snapshot; it must be run or dropped soon, a writer waits for it.
pub(crate) type Work = Box<dyn FnOnce() -> Cancellable<Value> + Send>;

/// Gives out snapshots.
pub(crate) trait Views {
    /// The project that answers for a document.
    fn of_document(&self, uri: &Uri) -> Option<View>;
    /// Every project.
    fn of_projects(&self) -> Vec<View>;
}

/// A request the server answers.
trait Feature {
    /// The protocol's request.
    type Request: Request;
    /// The snapshots it wants.
    fn views(params: &<Self::Request as Request>::Params, views: &dyn Views) -> Vec<View>;
    /// The answer.
    fn answer(
        views: &[View],
        params: &<Self::Request as Request>::Params,
    ) -> Cancellable<<Self::Request as Request>::Result>;
}

/// A method and how its work is made.
pub(crate) struct Route {
    /// The protocol's name.
    pub(crate) method: &'static str,
    /// Reads the parameters and takes the snapshots.
    pub(crate) prepare: fn(Value, &dyn Views) -> Result<Work, Error>,
}

/// Every feature there is.
pub(crate) const ROUTES: &[Route] = &[
    route::<code_actions::CodeActions>(),
    route::<completion::Completions>(),
    route::<definition::Definition>(),
    route::<document_symbols::DocumentSymbols>(),
    route::<highlights::Highlights>(),
    route::<hover::HoverHelp>(),
    route::<references::FindReferences>(),
    route::<signature_help::Signatures>(),
    route::<workspace_symbols::WorkspaceSymbols>(),
    #[cfg(test)]
    route::<test_requests::Stumble>(),
    #[cfg(test)]
    route::<test_requests::KeepChecking>(),
];

const fn route<F: Feature>() -> Route
where
    <F::Request as Request>::Params: Send + 'static,
{
    Route { method: F::Request::METHOD, prepare: prepare::<F> }
}

fn prepare<F: Feature>(params: Value, views: &dyn Views) -> Result<Work, Error>
where
    <F::Request as Request>::Params: Send + 'static,
{
    let params: <F::Request as Request>::Params = serde_json::from_value(params)
        .map_err(|cause| error(ErrorCode::InvalidParams, format!("{}: {cause}", F::Request::METHOD)))?;
    let views = F::views(&params, views);
    Ok(Box::new(move || {
        let answer = F::answer(&views, &params)?;
        // The protocol's own types always have a JSON form.
        Ok(serde_json::to_value(answer).unwrap_or_default())
    }))
}

/// The snapshot of a request about one document; empty when no project knows it.
fn of_document(uri: &Uri, views: &dyn Views) -> Vec<View> {
    views.of_document(uri).into_iter().collect()
}
