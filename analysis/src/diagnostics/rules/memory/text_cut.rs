//! T0424 text-cut.

use crate::diagnostics::{Rule, Severity};

/// T0424 text-cut.
pub static TEXT_CUT: Rule = Rule {
    code: "T0424",
    name: "text-cut",
    severity: Severity::Warning,
    explanation: "The literal has more characters than the text buffer has room for from the given place, so its end is \
        cut off. Declare a larger buffer or shorten the literal.",
    why: "STRCPY and STRADD never write past the size of the destination; what does not fit is lost without a message.",
    wrong: "DATA\nTITLE:  STR 4\nDATA_END\nMODULE_MAIN\n        STRCPY TITLE,'Spindle'\nMODULE_MAIN_END\n",
    right: "DATA\nTITLE:  STR 8\nDATA_END\nMODULE_MAIN\n        STRCPY TITLE,'Spindle'\nMODULE_MAIN_END\n",
    chapter: "3.18",
    ..Rule::BASE
};
