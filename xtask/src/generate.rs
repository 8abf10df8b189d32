//! `cargo xtask generate`: files derived from the catalogue, so that nothing repeats it by hand.

mod book;
mod case;
mod language_configuration;
mod textmate;

use std::fs;

use serde_json::Value;

use crate::run::root;

/// A derived file: where it is, and what has to be in it.
struct Derived {
    path: String,
    content: String,
}

/// Writes the derived files; with `check` compares them instead and fails when one is not as it should be.
pub(crate) fn generate(check: bool) -> Result<(), String> {
    let mut stale = Vec::new();
    for file in derived() {
        let path = root().join(&file.path);
        let present = fs::read_to_string(&path).unwrap_or_default();
        // A checkout may have turned the line ends.
        if present.replace("\r\n", "\n") == file.content {
            continue;
        }
        if check {
            stale.push(file.path);
            continue;
        }
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)
                .map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
        }
        fs::write(&path, &file.content)
            .map_err(|error| format!("cannot write {}: {error}", path.display()))?;
        println!("written: {}", file.path);
    }
    if stale.is_empty() {
        return Ok(());
    }
    Err(format!("not as the catalogue has it: {}; run `cargo xtask generate`", stale.join(", ")))
}

fn derived() -> Vec<Derived> {
    let mut files = vec![
        Derived {
            path: "editors/vscode/syntaxes/technol.tmLanguage.json".to_owned(),
            content: json_text(&textmate::grammar()),
        },
        Derived {
            path: "editors/vscode/language-configuration.json".to_owned(),
            content: json_text(&language_configuration::configuration()),
        },
    ];
    files.extend(book::pages().into_iter().map(|(path, content)| Derived { path, content }));
    files
}

/// JSON with sorted keys, whatever order other users of the JSON library ask it to keep.
fn json_text(value: &Value) -> String {
    format!("{:#}\n", sorted(value))
}

fn sorted(value: &Value) -> Value {
    match value {
        Value::Object(map) => {
            let mut entries: Vec<_> = map.iter().map(|(key, value)| (key.clone(), sorted(value))).collect();
            entries.sort_by(|a, b| a.0.cmp(&b.0));
            Value::Object(entries.into_iter().collect())
        }
        Value::Array(items) => Value::Array(items.iter().map(sorted).collect()),
        other => other.clone(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derived_files_are_as_the_catalogue_has_it() {
        assert_eq!(generate(true), Ok(()));
    }

    #[test]
    fn keys_are_sorted_all_the_way_down() {
        let value = serde_json::json!({ "b": [{ "z": 1, "y": 2 }], "a": 0 });
        assert_eq!(sorted(&value).to_string(), r#"{"a":0,"b":[{"y":2,"z":1}]}"#);
    }
}
