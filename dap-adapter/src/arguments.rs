//! Arguments of `launch` and `attach`: what a launch configuration may say.

use std::path::PathBuf;

use serde::Deserialize;

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
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

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
            }
        );
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
        ] {
            let error = serde_json::from_value::<LaunchArguments>(arguments).unwrap_err();
            assert_eq!(error.to_string(), words);
        }
    }
}
