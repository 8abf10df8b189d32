//! Arguments of `launch` and `attach`: what a launch configuration may say.

use std::path::PathBuf;

use serde::Deserialize;

use technol_wire::message::LostPolicy;

use crate::connection::Clock;

/// When to do something that may be unnecessary.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "camelCase")]
pub enum Policy {
    /// When what is there is out of date.
    #[default]
    IfStale,
    /// In any case.
    Always,
    /// Not at all: what is there is used, or it is an error.
    Never,
}

/// What the target does with a stopped program when the link is lost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) enum OnLinkLost {
    /// It runs on.
    #[default]
    RunOn,
    /// It stays stopped until a debugger is back.
    StayStopped,
    /// The PLC is stopped through MODULE_DONE.
    StopPlc,
}

impl From<OnLinkLost> for LostPolicy {
    fn from(policy: OnLinkLost) -> LostPolicy {
        match policy {
            OnLinkLost::RunOn => LostPolicy::RunOn,
            OnLinkLost::StayStopped => LostPolicy::StayStopped,
            OnLinkLost::StopPlc => LostPolicy::StopPlc,
        }
    }
}

/// What both `launch` and `attach` say about the link to a target somewhere else.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct LinkArguments {
    #[serde(default)]
    pub(crate) on_link_lost: OnLinkLost,
    /// For so many seconds a lost link is tried again; 0: the session ends with the link.
    #[serde(default = "half_a_minute")]
    pub(crate) reconnect: u32,
    /// File with the token.
    pub(crate) token_file: Option<PathBuf>,
    /// What the session forced stays forced when it ends.
    #[serde(default)]
    pub(crate) keep_forced: bool,
}

impl Default for LinkArguments {
    fn default() -> LinkArguments {
        LinkArguments {
            on_link_lost: OnLinkLost::RunOn,
            reconnect: half_a_minute(),
            token_file: None,
            keep_forced: false,
        }
    }
}

fn half_a_minute() -> u32 {
    30
}

/// `launch`: build, load and start a program.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct LaunchArguments {
    /// Project folder, manifest or lone source file.
    pub(crate) program: PathBuf,
    /// `embedded`, `tcp:HOST:PORT`, `serial:DEVICE[@BAUD]`; else what the manifest says, else embedded.
    pub(crate) target: Option<String>,
    #[serde(default)]
    pub(crate) stop_on_entry: bool,
    /// Run without break-points.
    #[serde(default)]
    pub(crate) no_debug: bool,
    #[serde(default)]
    pub(crate) clock: Clock,
    #[serde(default)]
    pub(crate) build: Policy,
    #[serde(default)]
    pub(crate) download: Policy,
    #[serde(flatten)]
    pub(crate) link: LinkArguments,
}

/// `attach`: join a running program.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct AttachArguments {
    /// Project folder, manifest or lone source file the running program was built from.
    pub(crate) program: PathBuf,
    /// `tcp:HOST:PORT`, `serial:DEVICE[@BAUD]`; else what the manifest says.
    pub(crate) target: Option<String>,
    #[serde(default)]
    pub(crate) build: Policy,
    #[serde(flatten)]
    pub(crate) link: LinkArguments,
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;
    use std::collections::BTreeSet;

    #[test]
    fn a_program_is_enough() {
        let launch: LaunchArguments =
            serde_json::from_value(json!({"program": "/p", "name": "Debug", "type": "technol"})).unwrap();
        assert_eq!(
            launch,
            LaunchArguments {
                program: "/p".into(),
                target: None,
                stop_on_entry: false,
                no_debug: false,
                clock: Clock::Real,
                build: Policy::IfStale,
                download: Policy::IfStale,
                link: LinkArguments::default(),
            }
        );
    }

    #[test]
    fn both_ways_to_begin_say_what_becomes_of_a_lost_link() {
        let arguments = json!({
            "program": "/p", "onLinkLost": "stayStopped", "reconnect": 5, "tokenFile": "/t", "keepForced": true,
        });
        let link = LinkArguments {
            on_link_lost: OnLinkLost::StayStopped,
            reconnect: 5,
            token_file: Some("/t".into()),
            keep_forced: true,
        };
        let launch: LaunchArguments = serde_json::from_value(arguments.clone()).unwrap();
        let attach: AttachArguments = serde_json::from_value(arguments).unwrap();
        assert_eq!((launch.link, attach.link), (link.clone(), link));
    }

    /// The names of the first table of the book's page on debugging: what `launch` takes.
    const BOOK: &str = include_str!("../../docs/debugging.md");
    const VS_CODE: &str = include_str!("../../editors/vscode/package.json");

    #[test]
    fn the_book_and_vs_code_offer_the_arguments_that_there_are() {
        let book: BTreeSet<&str> = BOOK
            .lines()
            .skip_while(|line| !line.starts_with("| argument "))
            .skip(2)
            .map_while(|line| line.strip_prefix("| `")?.split('`').next())
            .collect();
        let package: serde_json::Value = serde_json::from_str(VS_CODE).unwrap();
        let schema = &package["contributes"]["debuggers"][0]["configurationAttributes"];
        let offered = |kind: &str| -> BTreeSet<&str> {
            schema[kind]["properties"].as_object().unwrap().keys().map(String::as_str).collect()
        };
        assert_eq!(offered("launch"), book);
        // What only makes sense where a program is started.
        let started = BTreeSet::from(["stopOnEntry", "clock", "download"]);
        assert_eq!(offered("attach"), book.difference(&started).copied().collect());
        for name in book {
            let wrong = json!({"program": "/p", name: {}});
            let launch = serde_json::from_value::<LaunchArguments>(wrong.clone());
            assert!(launch.is_err(), "{name} means nothing at launch");
            let attach = serde_json::from_value::<AttachArguments>(wrong);
            assert_eq!(attach.is_err(), !started.contains(name), "{name} at attach");
        }
    }

    #[test]
    fn every_editor_offers_the_address_of_the_book() {
        for text in [
            BOOK,
            VS_CODE,
            include_str!("../../editors/helix/languages.toml"),
            include_str!("../../editors/neovim/lua/technol_dap.lua"),
        ] {
            let addresses: BTreeSet<&str> = text.split("tcp:127.0.0.1:").skip(1).map(|it| &it[..4]).collect();
            assert_eq!(addresses, BTreeSet::from(["5700"]));
        }
    }

    #[test]
    fn wrong_words_are_told_with_the_right_ones() {
        for (arguments, words) in [
            (json!({}), "missing field `program`"),
            (
                json!({"program": "/p", "clock": "slow"}),
                "unknown variant `slow`, expected `real` or `virtual`",
            ),
            (
                json!({"program": "/p", "build": "sometimes"}),
                "unknown variant `sometimes`, expected one of `ifStale`, `always`, `never`",
            ),
            (
                json!({"program": "/p", "onLinkLost": "panic"}),
                "unknown variant `panic`, expected one of `runOn`, `stayStopped`, `stopPlc`",
            ),
        ] {
            let error = serde_json::from_value::<LaunchArguments>(arguments).unwrap_err();
            assert_eq!(error.to_string(), words);
        }
    }
}
