//! Mistakes in declarations.

use crate::diagnostics::{Rule, Severity};

/// T0201 duplicate-name.
pub static DUPLICATE_NAME: Rule = Rule {
    code: "T0201",
    name: "duplicate-name",
    severity: Severity::Error,
    fixed: true,
    explanation: "A name is declared twice where both can be seen: twice in DATA of any files, twice in the \
        DATA_LOCAL of one file, or both in DATA and in DATA_LOCAL of a file. A mechanism declares a bit of \
        its name, so a cell and a mechanism cannot share one (manual 3.3, 4.2). Only the first 31 \
        characters count. Rename one of them.",
    ..Rule::BASE
};

/// T0202 long-name.
pub static LONG_NAME: Rule = Rule {
    code: "T0202",
    name: "long-name",
    severity: Severity::Warning,
    fixed: false,
    explanation: "Only the first 31 characters of a name are significant (manual 3.3): two names that differ later \
        are one name. Shorten it.",
    ..Rule::BASE
};

/// T0203 name-like-instruction.
pub static NAME_LIKE_INSTRUCTION: Rule = Rule {
    code: "T0203",
    name: "name-like-instruction",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The name is also an instruction or keyword. It is read as a name where the place leaves no doubt, \
        but it confuses readers and other tools. Rename it.",
    ..Rule::BASE
};

/// T0204 conflicting-constant.
pub static CONFLICTING_CONSTANT: Rule = Rule {
    code: "T0204",
    name: "conflicting-constant",
    severity: Severity::Error,
    fixed: true,
    explanation: "EQUI gives one name two different values; constants are known in the whole project. Remove one or \
        rename it.",
    ..Rule::BASE
};

/// T0205 not-constant.
pub static NOT_CONSTANT: Rule = Rule {
    code: "T0205",
    name: "not-constant",
    severity: Severity::Error,
    fixed: true,
    explanation: "A constant is needed here: a number, a character, the name of an EQUI constant, or a sum of those \
        (manual 3.4). A number with a decimal point is no integer constant.",
    ..Rule::BASE
};

/// T0206 circular-constant.
pub static CIRCULAR_CONSTANT: Rule = Rule {
    code: "T0206",
    name: "circular-constant",
    severity: Severity::Error,
    fixed: true,
    explanation: "The value of an EQUI constant depends on itself. Break the circle with a number.",
    ..Rule::BASE
};

/// T0207 too-many-bits.
pub static TOO_MANY_BITS: Rule = Rule {
    code: "T0207",
    name: "too-many-bits",
    severity: Severity::Error,
    fixed: true,
    explanation: "One DFM declares one byte with at most 8 bits, d0 first (manual 3.4). Put the further bits into \
        another DFM.",
    ..Rule::BASE
};

/// T0208 bad-length.
pub static BAD_LENGTH: Rule = Rule {
    code: "T0208",
    name: "bad-length",
    severity: Severity::Error,
    fixed: true,
    explanation: "The length of DS or STR must be a positive constant: `DS 1`, `DS 2` and `DS 4` declare a BYTE, \
        WORD or DWORD, other lengths an area without type (manual 3.4).",
    ..Rule::BASE
};

/// T0209 text-too-long.
pub static TEXT_TOO_LONG: Rule = Rule {
    code: "T0209",
    name: "text-too-long",
    severity: Severity::Error,
    fixed: true,
    explanation: "The initial text is longer than its STR (manual 3.18). Declare a larger one or shorten the text.",
    ..Rule::BASE
};

/// T0210 missing-name.
pub static MISSING_NAME: Rule = Rule {
    code: "T0210",
    name: "missing-name",
    severity: Severity::Warning,
    fixed: false,
    explanation: "Memory is reserved without a name, so nothing can use it. Put `NAME:` before DS or STR, or delete \
        the line.",
    ..Rule::BASE
};

/// T0211 bad-declaration.
pub static BAD_DECLARATION: Rule = Rule {
    code: "T0211",
    name: "bad-declaration",
    severity: Severity::Error,
    fixed: true,
    explanation: "The declaration does not have the form its instruction needs; the message shows it.",
    ..Rule::BASE
};

/// T0212 hides-system-symbol.
pub static HIDES_SYSTEM_SYMBOL: Rule = Rule {
    code: "T0212",
    name: "hides-system-symbol",
    severity: Severity::Warning,
    fixed: false,
    explanation: "The name is also a predefined cell or bit of the control. The declaration hides it, so the program \
        reads and writes its own memory instead. Rename it unless this is meant.",
    ..Rule::BASE
};
