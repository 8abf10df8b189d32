//! Who may know whom (docs/design/rooms.md): read from `cargo metadata`, so that a new dependency has to be
//! allowed here before it can land.

use std::collections::{BTreeMap, BTreeSet};

use cargo_metadata::{DependencyKind, Metadata, MetadataCommand};

/// Each room and the rooms it may name in `[dependencies]`.
const ALLOWED: &[(&str, &[&str])] = &[
    ("technol-image", &[]),
    ("technol-wire", &[]),
    ("technol-link-model", &[]),
    ("technol-runtime", &["technol-image"]),
    ("technol-machine", &["technol-image", "technol-runtime"]),
    ("technol-analysis", &["technol-image"]),
    ("technol-target", &["technol-image", "technol-machine", "technol-runtime", "technol-wire"]),
    ("technol-dap", &["technol-analysis", "technol-image", "technol-wire"]),
    ("technol-lsp", &["technol-analysis"]),
    (
        "technol",
        &[
            "technol-analysis",
            "technol-dap",
            "technol-image",
            "technol-lsp",
            "technol-machine",
            "technol-runtime",
            "technol-target",
            "technol-wire",
        ],
    ),
    ("xtask", &["technol-analysis"]),
    // The cable of its pseudo terminals is noisy.
    ("technol-tests", &["technol-link-model"]),
];

/// Outside crates that would break what a room promises, directly or through others.
const FORBIDDEN: &[(&str, &[&str])] = &[
    ("technol-analysis", &["tokio", "tower-lsp-server", "dap", "serialport"]),
    ("technol-image", &["tokio"]),
    ("technol-runtime", &["tokio", "serialport", "rand", "getrandom"]),
    ("technol-machine", &["tokio", "serialport", "rand", "getrandom"]),
    ("technol-wire", &["tokio", "serialport", "rand", "getrandom"]),
    ("technol-target", &["tokio", "salsa", "rowan"]),
    ("technol-lsp", &["serialport", "dap"]),
];

/// Rooms that run on a controller: their sources must say `no_std`.
const NO_STD: &[&str] = &["technol-image", "technol-wire", "technol-runtime", "technol-machine"];

fn metadata() -> Metadata {
    MetadataCommand::new()
        .manifest_path(concat!(env!("CARGO_MANIFEST_DIR"), "/../Cargo.toml"))
        .other_options(vec!["--offline".to_owned()])
        .exec()
        .expect("cargo metadata runs")
}

fn direct(metadata: &Metadata) -> BTreeMap<String, BTreeSet<String>> {
    metadata
        .workspace_packages()
        .iter()
        .map(|package| {
            let names = package
                .dependencies
                .iter()
                .filter(|d| d.kind == DependencyKind::Normal)
                .map(|d| d.name.clone())
                .collect();
            (package.name.to_string(), names)
        })
        .collect()
}

#[test]
fn rooms_only_know_the_rooms_below_them() {
    let metadata = metadata();
    let rooms: BTreeSet<String> = metadata.workspace_packages().iter().map(|p| p.name.to_string()).collect();
    let listed: BTreeSet<String> = ALLOWED.iter().map(|(name, _)| (*name).to_owned()).collect();
    assert_eq!(rooms, listed, "every crate of the workspace has a row in ALLOWED");

    let direct = direct(&metadata);
    for (room, allowed) in ALLOWED {
        for dependency in direct[*room].iter().filter(|d| rooms.contains(*d)) {
            assert!(allowed.contains(&dependency.as_str()), "{room} must not know {dependency}");
        }
    }
}

#[test]
fn rooms_do_not_reach_what_they_promise_not_to_need() {
    let metadata = metadata();
    let resolve = metadata.resolve.as_ref().expect("metadata has a dependency graph");
    let by_id: BTreeMap<_, _> = resolve.nodes.iter().map(|n| (&n.id, n)).collect();
    let name_of: BTreeMap<_, _> = metadata.packages.iter().map(|p| (&p.id, p.name.to_string())).collect();
    for (room, forbidden) in FORBIDDEN {
        let root = metadata.packages.iter().find(|p| p.name.as_str() == *room).expect("room exists");
        let mut seen = BTreeSet::new();
        let mut open = vec![&root.id];
        while let Some(id) = open.pop() {
            for dependency in &by_id[id].deps {
                let normal = dependency.dep_kinds.iter().any(|k| k.kind == DependencyKind::Normal);
                if normal && seen.insert(&dependency.pkg) {
                    open.push(&dependency.pkg);
                }
            }
        }
        let reached: BTreeSet<&str> = seen.iter().map(|id| name_of[*id].as_str()).collect();
        for name in *forbidden {
            assert!(!reached.contains(name), "{room} reaches {name}");
        }
    }
}

#[test]
fn rooms_for_a_controller_are_no_std() {
    let metadata = metadata();
    for room in NO_STD {
        let package = metadata.packages.iter().find(|p| p.name.as_str() == *room).expect("room exists");
        let lib = package.targets.iter().find(|t| t.is_lib()).expect("room is a library");
        let text = std::fs::read_to_string(&lib.src_path).expect("source is readable");
        assert!(text.contains("#![no_std]"), "{room} must be no_std");
    }
}
