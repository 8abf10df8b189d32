//! What each message does to the session.

use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use tower_lsp::jsonrpc::{ErrorCode, Id};
use tower_lsp::ls_types::request::{RegisterCapability, Request, WorkspaceConfiguration};
use tower_lsp::ls_types::{
    ConfigurationItem, ConfigurationParams, DidChangeConfigurationParams, DidChangeTextDocumentParams,
    DidChangeWatchedFilesParams, DidChangeWatchedFilesRegistrationOptions, DidChangeWorkspaceFoldersParams,
    DidCloseTextDocumentParams, DidOpenTextDocumentParams, DidSaveTextDocumentParams, FileSystemWatcher,
    GlobPattern, InitializeParams, MessageType, Registration, RegistrationParams,
};

use crate::Outcome;
use crate::capabilities::initialize_result;
use crate::client::Client;
use crate::documents::Document;
use crate::file_key::FileKey;
use crate::frames;
use crate::main_loop::{Event, MainLoop, Phase};
use crate::parent;
use crate::requests::error;
use crate::transport::Reply;

/// JSON-RPC's code for a request before `initialize`.
const NOT_INITIALIZED: ErrorCode = ErrorCode::ServerError(-32002);

/// Files whose change on the disk matters.
const WATCHED: [&str; 3] = [
    "**/technol.toml",
    "**/*.{plc,inc,PLC,INC}",
    "**/*.{ChannelConfig,PlcErrors,PlcConstants,PlcConstans,PlcTDef,PlcT,KbdConfig}",
];

impl MainLoop {
    pub(crate) fn request(&mut self, method: &str, params: Value, reply: Reply) {
        match (method, self.phase) {
            (frames::UNREADABLE, _) => {
                let code = params["code"].as_i64().unwrap_or_default();
                reply.send(Err(error(code.into(), params["message"].as_str().unwrap_or_default())));
            }
            ("initialize", Phase::Fresh) => self.initialize(params, reply),
            (_, Phase::Fresh) => reply.send(Err(error(NOT_INITIALIZED, "`initialize` must come first"))),
            (_, Phase::ShutDown) => {
                reply.send(Err(error(ErrorCode::InvalidRequest, "after `shutdown` only `exit` is left")));
            }
            ("initialize", Phase::Running(_)) => {
                reply.send(Err(error(ErrorCode::InvalidRequest, "`initialize` comes only once")));
            }
            ("shutdown", Phase::Running(_)) => {
                self.phase = Phase::ShutDown;
                reply.send(Ok(Value::Null));
            }
            (method, Phase::Running(client)) => self.feature(method, params, client, reply),
        }
    }

    /// Takes a notification; the session's end when it is one.
    pub(crate) fn notification(&mut self, method: &str, params: Value) -> Option<Outcome> {
        match (method, self.phase) {
            ("exit", phase) => {
                return Some(if phase == Phase::ShutDown {
                    Outcome::Exit
                } else {
                    Outcome::ExitWithoutShutdown
                });
            }
            (frames::INPUT_CLOSED, phase) => {
                return Some(if phase == Phase::ShutDown { Outcome::Exit } else { Outcome::InputClosed });
            }
            ("$/cancelRequest", _) => {
                if let Ok(id) = serde_json::from_value::<Id>(params["id"].clone()) {
                    self.requests.cancel(&id);
                }
            }
            (method, Phase::Running(client)) => {
                if let Err(complaint) = self.running_notification(method, params, client) {
                    self.outbox.log(MessageType::WARNING, complaint);
                }
            }
            (_, Phase::Fresh | Phase::ShutDown) => {}
        }
        None
    }

    fn running_notification(&mut self, method: &str, params: Value, client: Client) -> Result<(), String> {
        match method {
            "initialized" => self.initialized(client),
            "textDocument/didOpen" => {
                let document = read::<DidOpenTextDocumentParams>(method, params)?.text_document;
                let effects =
                    self.workspace.open(Document::new(document.uri, document.version, &document.text));
                self.follow(effects);
            }
            "textDocument/didChange" => {
                let params: DidChangeTextDocumentParams = read(method, params)?;
                let document = params.text_document;
                let changes = &params.content_changes;
                let effects =
                    self.workspace.change(&document.uri, document.version, changes, client.encoding)?;
                self.follow(effects);
            }
            "textDocument/didClose" => {
                let params: DidCloseTextDocumentParams = read(method, params)?;
                let effects = self.workspace.close(&params.text_document.uri);
                self.follow(effects);
            }
            "textDocument/didSave" => {
                let params: DidSaveTextDocumentParams = read(method, params)?;
                // A client that watches files tells this once more by its watcher.
                if !client.watches_files {
                    let effects = self.workspace.touched(&[FileKey::of_uri(&params.text_document.uri)]);
                    self.follow(effects);
                }
            }
            "workspace/didChangeWatchedFiles" => {
                let params: DidChangeWatchedFilesParams = read(method, params)?;
                let keys: Vec<FileKey> = params.changes.iter().map(|it| FileKey::of_uri(&it.uri)).collect();
                let effects = self.workspace.touched(&keys);
                self.follow(effects);
            }
            "workspace/didChangeConfiguration" => {
                let params: DidChangeConfigurationParams = read(method, params)?;
                self.apply_settings(&params.settings);
                self.ask_for_settings(client);
            }
            "workspace/didChangeWorkspaceFolders" => {
                let event = read::<DidChangeWorkspaceFoldersParams>(method, params)?.event;
                let removed: Vec<FileKey> = event.removed.iter().map(|it| FileKey::of_uri(&it.uri)).collect();
                let mut folders = self.workspace.folders().to_vec();
                folders.retain(|it| !removed.contains(it));
                folders.extend(event.added.iter().map(|it| FileKey::of_uri(&it.uri)));
                let effects = self.workspace.set_folders(folders);
                self.follow(effects);
            }
            // Whatever else is told need not be known.
            _ => {}
        }
        Ok(())
    }

    fn initialize(&mut self, params: Value, reply: Reply) {
        let params: InitializeParams = match read("initialize", params) {
            Ok(params) => params,
            Err(message) => return reply.send(Err(error(ErrorCode::InvalidParams, message))),
        };
        let client = Client::new(&params.capabilities);
        self.phase = Phase::Running(client);
        if let Some(id) = params.process_id {
            let events = self.events.clone();
            parent::watch(id, move || _ = events.send(Event::ParentGone));
        }
        if let Some(options) = &params.initialization_options {
            self.apply_settings(options);
        }
        reply.send(Ok(serde_json::to_value(initialize_result(client)).unwrap_or_default()));
        let effects = self.workspace.set_folders(folders(&params));
        self.follow(effects);
    }

    fn initialized(&mut self, client: Client) {
        let mut registrations = Vec::new();
        if client.watches_files {
            let watchers = WATCHED
                .iter()
                .map(|it| FileSystemWatcher { glob_pattern: GlobPattern::String((*it).into()), kind: None })
                .collect();
            let options = DidChangeWatchedFilesRegistrationOptions { watchers };
            registrations.push(registration("workspace/didChangeWatchedFiles", json!(options)));
        }
        if client.tells_configuration {
            registrations
                .push(registration("workspace/didChangeConfiguration", json!({ "section": "technol" })));
        }
        if !registrations.is_empty() {
            self.outbox.ask::<RegisterCapability>(&RegistrationParams { registrations });
        }
        self.ask_for_settings(client);
    }

    fn ask_for_settings(&mut self, client: Client) {
        if client.has_configuration {
            let item = ConfigurationItem { scope_uri: None, section: Some("technol".into()) };
            self.outbox.ask::<WorkspaceConfiguration>(&ConfigurationParams { items: vec![item] });
        }
    }

    /// The client's answer to a request of ours.
    pub(crate) fn answer_to(&mut self, method: &str, result: &Value) {
        if method == WorkspaceConfiguration::METHOD {
            self.apply_settings(&result[0]);
        }
    }

    fn apply_settings(&mut self, value: &Value) {
        for complaint in self.settings.update(value) {
            self.outbox.log(MessageType::WARNING, complaint);
        }
    }
}

fn registration(method: &str, options: Value) -> Registration {
    Registration { id: format!("technol {method}"), method: method.into(), register_options: Some(options) }
}

/// The client's folders, in the newest form it gives them.
#[expect(deprecated, reason = "clients without folders still give a root")]
fn folders(params: &InitializeParams) -> Vec<FileKey> {
    match &params.workspace_folders {
        Some(folders) => folders.iter().map(|it| FileKey::of_uri(&it.uri)).collect(),
        None => params.root_uri.iter().map(FileKey::of_uri).collect(),
    }
}

fn read<T: DeserializeOwned>(method: &str, params: Value) -> Result<T, String> {
    serde_json::from_value(params).map_err(|cause| format!("{method}: {cause}"))
}
