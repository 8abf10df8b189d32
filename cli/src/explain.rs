//! `technol explain`: the help page of an instruction, a symbol of the control or a diagnostic; the list of pages; a
//! search in them.

use technol_analysis::explain::{Title, Topic, search, titles};
use technol_analysis::{Language, explain};

use crate::arguments::{self, ExplainArguments};
use crate::exit::{self, Failure, Outcome};
use crate::out::say;

/// Prints a page, or titles. Exit 2 when there is none.
pub(crate) fn explain(arguments: &ExplainArguments) -> Outcome {
    let language = match arguments.language {
        arguments::Language::En => Language::En,
        arguments::Language::Cs => Language::Cs,
    };
    if arguments.list {
        list(&titles(language));
        return Ok(exit::OK);
    }
    if let Some(words) = &arguments.search {
        let found = search(words, language);
        if found.is_empty() {
            return Err(Failure::usage(format!("no page holds `{words}`; use fewer or shorter words")));
        }
        list(&found);
        return Ok(exit::OK);
    }
    page(arguments.name.as_deref().unwrap_or_default(), language)
}

fn page(name: &str, language: Language) -> Outcome {
    match explain::explain(name, language) {
        Ok(markdown) => {
            say!("{}", markdown.trim_end());
            Ok(exit::OK)
        }
        Err(near) => {
            let hint = match near {
                Some(near) => format!("did you mean {near}?"),
                None => "try an instruction (LDR), a symbol (P1IN), a code (T0101), or --search".to_owned(),
            };
            Err(Failure::usage(format!("nothing is known by the name `{name}`; {hint}")))
        }
    }
}

/// One title a line: name, kind, chapter, summary.
fn list(titles: &[Title]) {
    let width = titles.iter().map(|title| title.name.chars().count()).max().unwrap_or(0).min(24);
    for title in titles {
        let kind = match title.topic {
            Topic::Instruction => "instruction",
            Topic::Keyword => "keyword",
            Topic::Symbol => "symbol",
            Topic::Configuration => "configuration",
            Topic::Rule => "diagnostic",
        };
        say!("{:width$}  {kind:11}  {:6}  {}", title.name, title.chapter, title.summary);
    }
}
