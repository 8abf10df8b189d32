//! `technol explain NAME`: the help page of an instruction, a symbol of the control or a diagnostic.

use technol_analysis::{Language, explain as page};

use crate::arguments::{self, ExplainArguments};
use crate::exit::{self, Failure, Outcome};
use crate::out::say;

/// Prints the page. Exit 2 when there is none.
pub(crate) fn explain(arguments: &ExplainArguments) -> Outcome {
    let language = match arguments.language {
        arguments::Language::En => Language::En,
        arguments::Language::Cs => Language::Cs,
    };
    match page(&arguments.name, language) {
        Ok(markdown) => {
            say!("{}", markdown.trim_end());
            Ok(exit::OK)
        }
        Err(near) => {
            let hint = match near {
                Some(near) => format!("did you mean {near}?"),
                None => "try an instruction (LDR), a symbol (P1IN) or a code (T0101)".to_owned(),
            };
            Err(Failure::usage(format!("nothing is known by the name `{}`; {hint}", arguments.name)))
        }
    }
}
