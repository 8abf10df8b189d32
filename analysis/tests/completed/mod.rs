//! The complete project that a part of a program stands for, as `diagnostics::rules` describes it.

use std::collections::BTreeMap;

const MAIN_FILE: &str = "\
DATA
INPUTS: DFM START,HALT_KEY,DOOR,LIMIT,,,READY,FAULT
OUTPUTS: DFM MOTOR,PUMP,LAMP,VALVE
DFM M0,M1,M2,M3,M4,M5,M6,M7
SMALL: DS 1
MIDDLE: DS 2
LARGE: DS 4
RATIO: DS 8
TABLE: DS 30
EQUI TEN,10
DATA_END
MODULE_INPUT
MODULE_INPUT_END
MODULE_BLOCK_INIT
MODULE_BLOCK_INIT_END
MODULE_BLOCK_DONE
MODULE_BLOCK_DONE_END
MODULE_MAIN
MODULE_MAIN_END
MODULE_INIT
MODULE_INIT_END
MODULE_CLEAR
MODULE_CLEAR_END
MODULE_HALT
MODULE_HALT_END
STOP
";

const FURTHER_FILE: &str = "DATA\nDATA_END\nMODULE_MAIN\nMODULE_MAIN_END\n";

/// Path and text of each file of the project, its manifest included.
pub(crate) fn project_of(text: &str) -> BTreeMap<String, String> {
    let mut files: Vec<(String, String)> = vec![("main.plc".to_string(), String::new())];
    let mut raw = false;
    for (number, line) in text.lines().enumerate() {
        if let Some(name) = line.strip_prefix(";=== ") {
            let main = number == 0 && name.trim() == "main.plc";
            raw |= main;
            if !main {
                files.push((name.trim().to_string(), String::new()));
            }
            continue;
        }
        if let Some((_, text)) = files.last_mut() {
            text.push_str(line);
            text.push('\n');
        }
    }
    let mut project: BTreeMap<String, String> = files
        .into_iter()
        .map(|(name, text)| {
            let whole = match name.as_str() {
                "main.plc" if raw => text,
                "main.plc" => completed(MAIN_FILE, &text),
                further if is_program(further) => completed(FURTHER_FILE, &text),
                _ => text,
            };
            (name, whole)
        })
        .collect();
    if !project.contains_key("technol.toml") {
        let further: Vec<String> = project
            .keys()
            .filter(|name| is_program(name) && *name != "main.plc")
            .map(|name| format!("{name:?}"))
            .collect();
        let manifest = format!("[project]\nname = \"example\"\nfiles = [{}]\n", further.join(", "));
        project.insert("technol.toml".to_string(), manifest);
    }
    project
}

fn is_program(name: &str) -> bool {
    std::path::Path::new(name).extension().is_some_and(|it| it == "plc")
}

/// A part between modules (`keyword` is `None`) or a section with its opening line.
struct Part {
    keyword: Option<String>,
    text: String,
}

fn completed(skeleton: &str, text: &str) -> String {
    let mut own = parts(text);
    if own.iter().all(|part| part.keyword.is_none()) {
        own = vec![Part {
            keyword: Some("MODULE_MAIN".to_string()),
            text: format!("MODULE_MAIN\n{text}MODULE_MAIN_END\n"),
        }];
    }
    let mut whole: String =
        own.iter().filter(|part| part.keyword.is_none()).map(|part| part.text.as_str()).collect();
    let mut used = vec![false; own.len()];
    for part in parts(skeleton) {
        let Some(keyword) = &part.keyword else {
            // STOP: sections that the skeleton does not have, and repeated ones, stand before it.
            for (part, used) in own.iter().zip(&mut used) {
                if part.keyword.is_some() && !std::mem::replace(used, true) {
                    whole.push_str(&part.text);
                }
            }
            whole.push_str(&part.text);
            continue;
        };
        let same = own.iter().position(|other| other.keyword.as_ref() == Some(keyword));
        match same {
            Some(at) => {
                used[at] = true;
                whole.push_str(&own[at].text);
            }
            None => whole.push_str(&part.text),
        }
    }
    for (part, used) in own.iter().zip(used) {
        if part.keyword.is_some() && !used {
            whole.push_str(&part.text);
        }
    }
    whole
}

fn parts(text: &str) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    let mut open: Option<String> = None;
    let mut in_macro = false;
    for line in text.lines() {
        let word = line.split_whitespace().next().unwrap_or_default().to_ascii_uppercase();
        in_macro = word == "DEF_T_MACRO" || (in_macro && word != "END_T_MACRO");
        let top = !in_macro && (word == "DATA" || word == "DATA_LOCAL" || word.starts_with("MODULE_"));
        let finished = ["MODULE_INIT_FINISHED", "MODULE_DONE_FINISHED"].contains(&word.as_str());
        if top && !word.ends_with("_END") && !finished {
            parts.push(Part { keyword: Some(word.clone()), text: String::new() });
            open = Some(word.clone());
        } else if open.is_none() && parts.last().is_none_or(|part| part.keyword.is_some()) {
            parts.push(Part { keyword: None, text: String::new() });
        }
        if let Some(part) = parts.last_mut() {
            part.text.push_str(line);
            part.text.push('\n');
        }
        if open.as_ref().is_some_and(|open| word == format!("{open}_END")) {
            open = None;
        }
    }
    parts
}
