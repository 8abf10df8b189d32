//! What the client can do, as far as it matters here.

use tower_lsp::ls_types::ClientCapabilities;

use crate::positions::Encoding;

/// The client's abilities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Client {
    /// Negotiated columns.
    pub(crate) encoding: Encoding,
    /// Files to watch can be registered.
    pub(crate) watches_files: bool,
    /// It answers `workspace/configuration`.
    pub(crate) has_configuration: bool,
    /// Changes of its configuration can be registered for.
    pub(crate) tells_configuration: bool,
    /// Document symbols may nest.
    pub(crate) nested_symbols: bool,
    /// Edits may name the version they are for.
    pub(crate) versioned_edits: bool,
    /// Diagnostics may point at related places.
    pub(crate) related_places: bool,
    /// Diagnostics may say that what they mark is superfluous.
    pub(crate) diagnostic_tags: bool,
    /// Code actions may be literals; otherwise there are none.
    pub(crate) literal_actions: bool,
}

impl Client {
    /// Reads what matters from the capabilities.
    pub(crate) fn new(capabilities: &ClientCapabilities) -> Client {
        let general = capabilities.general.as_ref();
        let workspace = capabilities.workspace.as_ref();
        let text = capabilities.text_document.as_ref();
        let yes = |flag: Option<bool>| flag.unwrap_or(false);
        Client {
            encoding: Encoding::negotiate(general.and_then(|it| it.position_encodings.as_deref())),
            watches_files: yes(workspace
                .and_then(|it| it.did_change_watched_files.as_ref())
                .and_then(|it| it.dynamic_registration)),
            has_configuration: yes(workspace.and_then(|it| it.configuration)),
            tells_configuration: yes(workspace
                .and_then(|it| it.did_change_configuration.as_ref())
                .and_then(|it| it.dynamic_registration)),
            nested_symbols: yes(text
                .and_then(|it| it.document_symbol.as_ref())
                .and_then(|it| it.hierarchical_document_symbol_support)),
            versioned_edits: yes(workspace
                .and_then(|it| it.workspace_edit.as_ref())
                .and_then(|it| it.document_changes)),
            related_places: yes(text
                .and_then(|it| it.publish_diagnostics.as_ref())
                .and_then(|it| it.related_information)),
            diagnostic_tags: text
                .and_then(|it| it.publish_diagnostics.as_ref())
                .is_some_and(|it| it.tag_support.is_some()),
            literal_actions: text
                .and_then(|it| it.code_action.as_ref())
                .is_some_and(|it| it.code_action_literal_support.is_some()),
        }
    }
}
