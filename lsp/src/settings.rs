//! Settings of the user, from `initializationOptions`, `workspace/didChangeConfiguration` or
//! `workspace/configuration`.

use serde_json::Value;
use technol_analysis::Language;

/// What a user can set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Settings {
    /// `language`: language of the help in hovers and completions.
    pub(crate) language: Language,
}

impl Default for Settings {
    fn default() -> Self {
        Settings { language: Language::En }
    }
}

/// Keys of the section that belong to the editor's side.
const CLIENT_KEYS: [&str; 2] = ["path", "trace"];

impl Settings {
    /// Takes over what `value` says, which is the `technol` section or an object that holds it. Returns a
    /// sentence for each thing that was not understood; such a thing changes nothing.
    pub(crate) fn update(&mut self, value: &Value) -> Vec<String> {
        let section = value.get("technol").unwrap_or(value);
        if section.is_null() {
            return Vec::new();
        }
        let Some(entries) = section.as_object() else {
            return vec![format!("The settings are ignored: an object was expected, but {section} came.")];
        };
        let mut complaints = Vec::new();
        for (key, value) in entries {
            match (key.as_str(), value.as_str()) {
                ("language", Some("en")) => self.language = Language::En,
                ("language", Some("cs")) => self.language = Language::Cs,
                ("language", _) if value.is_null() => {}
                ("language", _) => complaints.push(format!(
                    "Setting technol.language = {value} is ignored: it can be \"en\" or \"cs\"."
                )),
                (known, _) if CLIENT_KEYS.contains(&known) => {}
                (unknown, _) => {
                    complaints.push(format!("Setting technol.{unknown} is not known and was ignored."));
                }
            }
        }
        complaints
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn the_language_is_found_bare_or_in_its_section() {
        for value in [json!({"language": "cs"}), json!({"technol": {"language": "cs", "path": "x"}})] {
            let mut settings = Settings::default();
            assert_eq!(settings.update(&value), Vec::<String>::new());
            assert_eq!(settings.language, Language::Cs);
        }
    }

    #[test]
    fn what_is_not_understood_is_said_and_changes_nothing() {
        for (value, part) in [
            (json!({"language": "de"}), "can be \"en\" or \"cs\""),
            (json!({"language": 1}), "is ignored"),
            (json!({"colour": true}), "technol.colour is not known"),
            (json!([1]), "an object was expected"),
        ] {
            let mut settings = Settings::default();
            let complaints = settings.update(&value);
            assert!(complaints.len() == 1 && complaints[0].contains(part), "{complaints:?}");
            assert_eq!(settings, Settings::default());
        }
    }

    #[test]
    fn null_and_absence_keep_what_was() {
        let mut settings = Settings { language: Language::Cs };
        for value in [json!(null), json!({}), json!({"technol": null}), json!({"language": null})] {
            assert!(settings.update(&value).is_empty());
            assert_eq!(settings.language, Language::Cs);
        }
    }
}
