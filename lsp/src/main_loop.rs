//! The one thread that owns everything: documents, projects, open requests. Messages are taken in the order they
//! came; what takes long goes to the pool with a snapshot and comes back as an event.

use std::collections::{BTreeMap, BTreeSet};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use crossbeam_channel::{Receiver, RecvTimeoutError, Sender};
use futures::channel::mpsc;
use serde_json::Value;
use tower_lsp::jsonrpc::{self, ErrorCode, Response};
use tower_lsp::ls_types::notification::PublishDiagnostics;
use tower_lsp::ls_types::{MessageType, Uri};

use crate::Outcome;
use crate::client::Client;
use crate::diagnostics::{self, Diagnosed, DiagnosedFile, Published};
use crate::features::{ROUTES, Views, Work};
use crate::outbox::Outbox;
use crate::pool::Pool;
use crate::project::Home;
use crate::requests::{Requests, Ticket, error};
use crate::settings::Settings;
use crate::transport::{FromClient, Incoming, Reply};
use crate::view::View;
use crate::workspace::{Effects, Workspace};

/// How long a change may wait for its diagnostics, so that a burst of changes is looked at once.
const DEBOUNCE: Duration = Duration::from_millis(40);

/// What happens to the main loop.
#[derive(Debug)]
pub(crate) enum Event {
    /// Something came from the client.
    Client(FromClient),
    /// The work of a request is done.
    Answered(Ticket, jsonrpc::Result<Value>),
    /// A project was looked at; `Err` when that failed.
    Diagnosed(Result<Diagnosed, String>),
    /// The process that started us is gone.
    ParentGone,
}

impl From<FromClient> for Event {
    fn from(message: FromClient) -> Event {
        Event::Client(message)
    }
}

/// How far the session is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    /// `initialize` has not come.
    Fresh,
    /// Between `initialize` and `shutdown`.
    Running(Client),
    /// After `shutdown`.
    ShutDown,
}

/// The state of a session.
pub(crate) struct MainLoop {
    pub(crate) phase: Phase,
    pub(crate) settings: Settings,
    pub(crate) workspace: Workspace,
    pub(crate) outbox: Outbox,
    pub(crate) requests: Requests,
    /// Handed out to those who report back.
    pub(crate) events: Sender<Event>,
    inbox: Receiver<Event>,
    pool: Pool,
    published: Published,
    /// Projects to look at, and those to read again before that.
    due: BTreeMap<Home, Due>,
}

/// When a project is to be looked at.
#[derive(Clone, Copy, Debug)]
struct Due {
    at: Instant,
    reload: bool,
}

impl MainLoop {
    /// A session that has not begun.
    pub(crate) fn new(
        events: Sender<Event>,
        inbox: Receiver<Event>,
        outgoing: mpsc::UnboundedSender<jsonrpc::Request>,
    ) -> std::io::Result<MainLoop> {
        Ok(MainLoop {
            phase: Phase::Fresh,
            settings: Settings::default(),
            workspace: Workspace::default(),
            outbox: Outbox::new(outgoing),
            requests: Requests::default(),
            events,
            inbox,
            pool: Pool::start()?,
            published: Published::default(),
            due: BTreeMap::new(),
        })
    }

    /// Runs until the session is over.
    pub(crate) fn run(mut self) -> Outcome {
        let outcome = loop {
            let event = match self.due.values().map(|due| due.at).min() {
                Some(at) => self.inbox.recv_deadline(at),
                None => self.inbox.recv().map_err(|_| RecvTimeoutError::Disconnected),
            };
            match event {
                Ok(event) => {
                    if let Some(outcome) = self.take(event) {
                        break outcome;
                    }
                }
                Err(RecvTimeoutError::Timeout) => self.look_at_what_is_due(),
                // Cannot be: this loop holds a sender itself.
                Err(RecvTimeoutError::Disconnected) => break Outcome::InputClosed,
            }
        };
        self.requests.cancel_all();
        outcome
    }

    /// Takes one event. A panic on the way is reported and costs that event only.
    fn take(&mut self, event: Event) -> Option<Outcome> {
        match catch_unwind(AssertUnwindSafe(|| self.dispatch(event))) {
            Ok(outcome) => outcome,
            Err(panic) => {
                self.outbox.log(MessageType::ERROR, format!("internal error: {}", panic_text(&*panic)));
                None
            }
        }
    }

    fn dispatch(&mut self, event: Event) -> Option<Outcome> {
        match event {
            Event::Client(FromClient::Message(message)) => return self.message(message),
            Event::Client(FromClient::Answer(response)) => self.client_answered(response),
            Event::Answered(ticket, body) => self.requests.answer(&ticket, body),
            Event::Diagnosed(Ok(diagnosed)) => self.publish(diagnosed),
            Event::Diagnosed(Err(message)) => self.outbox.log(MessageType::ERROR, message),
            Event::ParentGone => return Some(Outcome::ParentGone),
        }
        None
    }

    fn message(&mut self, message: Incoming) -> Option<Outcome> {
        let params = message.params.unwrap_or(Value::Null);
        match message.reply {
            Some(reply) => self.request(&message.method, params, reply),
            None => return self.notification(&message.method, params),
        }
        None
    }

    /// Sends a feature's work to the pool.
    pub(crate) fn feature(&mut self, method: &str, params: Value, client: Client, reply: Reply) {
        let Some(route) = ROUTES.iter().find(|it| it.method == method) else {
            let message = format!("{method} is not a request this server answers");
            reply.send(Err(error(ErrorCode::MethodNotFound, message)));
            return;
        };
        let Some(ticket) = self.requests.take(reply) else { return };
        let snapshots = Snapshots { workspace: &self.workspace, settings: self.settings, client };
        match catch_unwind(AssertUnwindSafe(|| (route.prepare)(params, &snapshots))) {
            Ok(Ok(work)) => self.start(route.method, ticket, work),
            Ok(Err(error)) => self.requests.answer(&ticket, Err(error)),
            Err(panic) => self.requests.answer(&ticket, Err(internal_error(method, &*panic))),
        }
    }

    fn start(&self, method: &'static str, ticket: Ticket, work: Work) {
        let events = self.events.clone();
        self.pool.run(move || {
            if ticket.cancelled() {
                return;
            }
            let body = match catch_unwind(AssertUnwindSafe(work)) {
                Ok(Ok(answer)) => Ok(answer),
                Ok(Err(_)) => Err(error(ErrorCode::ContentModified, "the program was changed meanwhile")),
                Err(panic) => Err(internal_error(method, &*panic)),
            };
            let _ = events.send(Event::Answered(ticket, body));
        });
    }

    /// Notes what a step did to the projects.
    pub(crate) fn follow(&mut self, effects: Effects) {
        for home in &effects.dropped {
            self.due.remove(home);
            let messages = self.published.drop_project(home);
            self.tell(&messages);
        }
        let at = Instant::now() + DEBOUNCE;
        for (homes, reload) in [(effects.changed, false), (effects.reload, true)] {
            for home in homes {
                let due = self.due.entry(home).or_insert(Due { at, reload });
                due.reload |= reload;
            }
        }
    }

    /// Looks at the projects whose time has come.
    fn look_at_what_is_due(&mut self) {
        let now = Instant::now();
        let ready: Vec<(Home, Due)> = self
            .due
            .iter()
            .filter(|(_, due)| due.at <= now)
            .map(|(home, due)| (home.clone(), *due))
            .collect();
        for (home, _) in &ready {
            self.due.remove(home);
        }
        let reload: Vec<Home> =
            ready.iter().filter(|(_, due)| due.reload).map(|(home, _)| home.clone()).collect();
        // What a reload brought up is looked at with the rest, at once.
        let mut homes: BTreeSet<Home> = ready.into_iter().map(|(home, _)| home).collect();
        if !reload.is_empty() {
            let effects = self.workspace.reload(&reload);
            homes.extend(effects.changed.iter().cloned());
            self.follow(Effects { changed: Vec::new(), ..effects });
        }
        for home in homes {
            self.diagnose(home);
        }
    }

    fn diagnose(&self, home: Home) {
        type Look = fn(&View, &BTreeSet<String>) -> technol_analysis::Cancellable<Vec<DiagnosedFile>>;
        let whole: Look = diagnostics::diagnose;
        let Phase::Running(client) = self.phase else { return };
        let Some(project) = self.workspace.project(&home) else { return };
        let view = View::new(project, "", self.settings, client);
        let open: BTreeSet<String> = project
            .files()
            .iter()
            .filter(|(_, it)| it.version.is_some())
            .map(|(name, _)| name.clone())
            .collect();
        let revision = project.revision();
        let events = self.events.clone();
        self.pool.run(move || {
            let first: Option<Look> = (!open.is_empty()).then_some(diagnostics::diagnose_open);
            for (look, complete) in first.map(|it| (it, false)).into_iter().chain([(whole, true)]) {
                let event = match catch_unwind(AssertUnwindSafe(|| look(&view, &open))) {
                    Ok(Ok(files)) => Ok(Diagnosed { home: home.clone(), revision, complete, files }),
                    Ok(Err(_)) => return, // the change that cancelled it has asked for the next look
                    Err(panic) => Err(format!("internal error while checking: {}", panic_text(&*panic))),
                };
                let failed = event.is_err();
                let _ = events.send(Event::Diagnosed(event));
                if failed {
                    return;
                }
            }
        });
    }

    fn publish(&mut self, diagnosed: Diagnosed) {
        let present = self.workspace.project(&diagnosed.home).map(crate::project::Project::revision);
        if present == Some(diagnosed.revision) {
            let messages = self.published.update(&diagnosed.home, diagnosed.files, diagnosed.complete);
            self.tell(&messages);
        }
    }

    fn tell(&self, messages: &[tower_lsp::ls_types::PublishDiagnosticsParams]) {
        for message in messages {
            self.outbox.notify::<PublishDiagnostics>(message);
        }
    }

    fn client_answered(&mut self, response: Response) {
        let Some(method) = self.outbox.answered(&response) else { return };
        match response.into_parts().1 {
            Ok(result) => self.answer_to(method, &result),
            Err(error) => {
                self.outbox
                    .log(MessageType::WARNING, format!("the editor refused {method}: {}", error.message));
            }
        }
    }
}

/// Gives out snapshots of the present state.
struct Snapshots<'a> {
    workspace: &'a Workspace,
    settings: Settings,
    client: Client,
}

impl Views for Snapshots<'_> {
    fn of_document(&self, uri: &Uri) -> Option<View> {
        let (project, file) = self.workspace.project_of(uri)?;
        Some(View::new(project, file, self.settings, self.client))
    }

    fn of_projects(&self) -> Vec<View> {
        self.workspace.projects().map(|it| View::new(it, "", self.settings, self.client)).collect()
    }
}

fn internal_error(method: &str, panic: &(dyn std::any::Any + Send)) -> jsonrpc::Error {
    error(ErrorCode::InternalError, format!("internal error in {method}: {}", panic_text(panic)))
}

/// What a panic said.
fn panic_text(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|it| (*it).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_else(|| "unknown".into())
}
