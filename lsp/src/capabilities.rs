//! What the server tells the client about itself.

use tower_lsp::ls_types::{
    CodeActionKind, CodeActionOptions, CodeActionProviderCapability, CompletionOptions,
    HoverProviderCapability, InitializeResult, OneOf, SaveOptions, ServerCapabilities, ServerInfo,
    SignatureHelpOptions, TextDocumentSyncCapability, TextDocumentSyncKind, TextDocumentSyncOptions,
    TextDocumentSyncSaveOptions, WorkspaceFoldersServerCapabilities, WorkspaceServerCapabilities,
};

use crate::client::Client;

/// The answer to `initialize`.
pub(crate) fn initialize_result(client: Client) -> InitializeResult {
    let info = ServerInfo { name: "technol".into(), version: Some(env!("CARGO_PKG_VERSION").into()) };
    InitializeResult { capabilities: capabilities(client), server_info: Some(info), offset_encoding: None }
}

fn capabilities(client: Client) -> ServerCapabilities {
    let sync = TextDocumentSyncOptions {
        open_close: Some(true),
        change: Some(TextDocumentSyncKind::INCREMENTAL),
        save: Some(TextDocumentSyncSaveOptions::SaveOptions(SaveOptions { include_text: Some(false) })),
        ..TextDocumentSyncOptions::default()
    };
    let folders = WorkspaceFoldersServerCapabilities {
        supported: Some(true),
        change_notifications: Some(OneOf::Left(true)),
    };
    ServerCapabilities {
        position_encoding: Some(client.encoding.kind()),
        text_document_sync: Some(TextDocumentSyncCapability::Options(sync)),
        hover_provider: Some(HoverProviderCapability::Simple(true)),
        completion_provider: Some(CompletionOptions {
            // The dot of a prefix or of `adr.bit`, the apostrophe of an identifier; letters ask by themselves.
            trigger_characters: Some(vec![".".into(), "'".into()]),
            resolve_provider: Some(false),
            ..CompletionOptions::default()
        }),
        signature_help_provider: Some(SignatureHelpOptions {
            trigger_characters: Some(vec![" ".into(), ",".into()]),
            ..SignatureHelpOptions::default()
        }),
        definition_provider: Some(OneOf::Left(true)),
        references_provider: Some(OneOf::Left(true)),
        document_highlight_provider: Some(OneOf::Left(true)),
        document_symbol_provider: Some(OneOf::Left(true)),
        workspace_symbol_provider: Some(OneOf::Left(true)),
        code_action_provider: client.literal_actions.then(|| {
            CodeActionProviderCapability::Options(CodeActionOptions {
                code_action_kinds: Some(vec![CodeActionKind::QUICKFIX]),
                ..CodeActionOptions::default()
            })
        }),
        workspace: Some(WorkspaceServerCapabilities {
            workspace_folders: Some(folders),
            ..WorkspaceServerCapabilities::default()
        }),
        ..ServerCapabilities::default()
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use serde_json::json;

    use super::*;
    use crate::features::ROUTES;

    /// `hoverProvider` → `textDocument/hover`, and so on.
    fn method(provider: &str) -> String {
        match provider {
            "workspaceSymbolProvider" => "workspace/symbol".into(),
            other => format!("textDocument/{}", other.strip_suffix("Provider").unwrap()),
        }
    }

    #[test]
    fn what_is_offered_is_what_is_answered() {
        let all = json!({"textDocument": {"codeAction": {"codeActionLiteralSupport": {"codeActionKind": {"valueSet": []}}}}});
        let client = Client::new(&serde_json::from_value(all).unwrap());
        let offered = serde_json::to_value(capabilities(client)).unwrap();
        let offered: BTreeSet<String> = offered
            .as_object()
            .unwrap()
            .keys()
            .filter(|it| it.ends_with("Provider"))
            .map(|it| method(it))
            .collect();
        let own = |it: &&crate::features::Route| !it.method.starts_with("test/");
        let answered: BTreeSet<String> = ROUTES.iter().filter(own).map(|it| it.method.to_owned()).collect();
        assert_eq!(offered, answered);
    }

    #[test]
    fn code_actions_are_offered_only_to_clients_that_understand_them() {
        let client = Client::new(&serde_json::from_value(json!({})).unwrap());
        assert_eq!(capabilities(client).code_action_provider, None);
    }
}
