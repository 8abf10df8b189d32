//! What a build after an edit does again.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex};

use technol_analysis::database::Database;
use technol_analysis::project::load;
use technol_analysis::{AnalysisHost, Change};

use crate::{Memory, source};

/// How often each query ran in a build of `after` that follows a build of `before`.
fn executed_by(before: &str, after: &str) -> BTreeMap<String, usize> {
    let log = Arc::new(Mutex::new(Vec::new()));
    let sink = Arc::clone(&log);
    let db = Database::with_events(Box::new(move |event| {
        if let salsa::EventKind::WillExecute { database_key } = event.kind {
            sink.lock().expect("one thread").push(format!("{database_key:?}"));
        }
    }));
    let mut host = AnalysisHost::with_database(db);
    let files = Memory(BTreeMap::from([("main.plc".to_string(), before.as_bytes().to_vec())]));
    host.apply(Change {
        project: Some(load("main.plc", &files)),
        texts: vec![("main.plc".to_string(), Arc::from(before))],
    });
    assert!(host.analysis().build().expect("nothing cancels it").is_ok());
    log.lock().expect("one thread").clear();
    host.apply(Change { project: None, texts: vec![("main.plc".to_string(), Arc::from(after))] });
    assert!(host.analysis().build().expect("nothing cancels it").is_ok());
    let mut counts = BTreeMap::new();
    for query in log.lock().expect("one thread").iter() {
        *counts.entry(query.split('(').next().unwrap_or_default().to_string()).or_default() += 1;
    }
    counts
}

const MAIN: &str = "MECH_BEGIN ONE\nFL 1,A\nEX\nMECH_END ONE\nMECH_BEGIN TWO\nLDR A\nEX0\nMECH_END TWO\n";

#[test]
fn an_edit_in_one_mechanism_translates_that_one_only() {
    let before = source("CTL: DFM A,B\n", MAIN);
    let after = before.replace("FL 1,A", "FL 1,B");
    let executed = executed_by(&before, &after);
    assert_eq!(executed.get("section_code"), Some(&1), "{executed:?}");
    assert_eq!(executed.get("layout"), None, "{executed:?}");
}

#[test]
fn a_comment_translates_nothing() {
    let before = source("CTL: DFM A,B\n", MAIN);
    let executed = executed_by(&before, &before.replace("FL 1,A", "FL 1,A ;on"));
    assert_eq!(executed.get("section_code"), None, "{executed:?}");
}

#[test]
fn moved_data_translate_nothing() {
    // Addresses come with the link, so that a new cell before all others changes no section's code.
    let before = source("CTL: DFM A,B\n", MAIN);
    let executed = executed_by(&before, &source("NEW: DS 2\nCTL: DFM A,B\n", MAIN));
    assert_eq!(executed.get("section_code"), None, "{executed:?}");
    assert_eq!(executed.get("layout"), Some(&1), "{executed:?}");
}
