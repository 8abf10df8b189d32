//! Requests of the tests: one that stumbles, and one that takes its time.

use std::time::{Duration, Instant};

use serde_json::Value;
use technol_analysis::Cancellable;
use tower_lsp::ls_types::request::Request;

use super::{Feature, Views};
use crate::view::View;

pub(super) struct Stumble;

impl Feature for Stumble {
    type Request = Stumble;

    fn views(_: &Value, _: &dyn Views) -> Vec<View> {
        Vec::new()
    }

    fn answer(_: &[View], params: &Value) -> Cancellable<Value> {
        panic!("stumbled over {params}")
    }
}

impl Request for Stumble {
    type Params = Value;
    type Result = Value;
    const METHOD: &'static str = "test/stumble";
}

/// Checks all projects again and again for so many milliseconds.
pub(super) struct KeepChecking;

impl Feature for KeepChecking {
    type Request = KeepChecking;

    fn views(_: &u64, views: &dyn Views) -> Vec<View> {
        views.of_projects()
    }

    fn answer(views: &[View], params: &u64) -> Cancellable<Value> {
        let end = Instant::now() + Duration::from_millis(*params);
        while Instant::now() < end {
            for view in views {
                view.analysis.all_diagnostics()?;
            }
            std::thread::sleep(Duration::from_millis(2));
        }
        Ok(Value::from("done"))
    }
}

impl Request for KeepChecking {
    type Params = u64;
    type Result = Value;
    const METHOD: &'static str = "test/keepChecking";
}
