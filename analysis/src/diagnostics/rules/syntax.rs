//! Mistakes in the form of a line.

use crate::diagnostics::{Rule, Severity};

/// T0101 unexpected-character.
pub static UNEXPECTED_CHARACTER: Rule = Rule {
    code: "T0101",
    name: "unexpected-character",
    severity: Severity::Error,
    fixed: true,
    explanation: "The character has no meaning at this place. A line is `[label:] [operation [operand {, operand}]] \
        [;comment]` (manual 3.1).",
    ..Rule::BASE
};

/// T0102 typographic-quote.
pub static TYPOGRAPHIC_QUOTE: Rule = Rule {
    code: "T0102",
    name: "typographic-quote",
    severity: Severity::Error,
    fixed: true,
    explanation: "Texts stand in apostrophes `'…'`. Quotes that a word processor put in their place are not read. \
        The fix replaces them.",
    ..Rule::BASE
};

/// T0103 unclosed-text.
pub static UNCLOSED_TEXT: Rule = Rule {
    code: "T0103",
    name: "unclosed-text",
    severity: Severity::Error,
    fixed: true,
    explanation: "A text begins with an apostrophe and never ends on its line. Close it; an apostrophe inside a text \
        is written twice.",
    ..Rule::BASE
};

/// T0104 bad-number.
pub static BAD_NUMBER: Rule = Rule {
    code: "T0104",
    name: "bad-number",
    severity: Severity::Error,
    fixed: true,
    explanation: "The number cannot be read. Forms: `123`, `0F8h` (a hexadecimal number begins with a digit), \
        `0001b`, `'A'`, and with a decimal point `1.5` (manual 3.4).",
    ..Rule::BASE
};

/// T0105 unbalanced-bracket.
pub static UNBALANCED_BRACKET: Rule = Rule {
    code: "T0105",
    name: "unbalanced-bracket",
    severity: Severity::Error,
    fixed: true,
    explanation: "A bracket has no partner. Expressions are written `(name+n)`, indexed cells `name[BX]` (manual \
        3.5).",
    ..Rule::BASE
};

/// T0106 expected-operand.
pub static EXPECTED_OPERAND: Rule = Rule {
    code: "T0106",
    name: "expected-operand",
    severity: Severity::Error,
    fixed: true,
    explanation: "Something is missing where an operand must stand, for instance after a sign or an opening bracket.",
    ..Rule::BASE
};

/// T0107 expected-comma.
pub static EXPECTED_COMMA: Rule = Rule {
    code: "T0107",
    name: "expected-comma",
    severity: Severity::Error,
    fixed: true,
    explanation: "Operands are separated by commas; a blank between two of them is not enough (manual 3.1).",
    ..Rule::BASE
};

/// T0108 expected-operation.
pub static EXPECTED_OPERATION: Rule = Rule {
    code: "T0108",
    name: "expected-operation",
    severity: Severity::Error,
    fixed: true,
    explanation: "A line begins with a label and its colon, an instruction, or a comment after `;`.",
    ..Rule::BASE
};

/// T0109 expected-colon.
pub static EXPECTED_COLON: Rule = Rule {
    code: "T0109",
    name: "expected-colon",
    severity: Severity::Error,
    fixed: true,
    explanation: "A name before DFM, DS or STR ends with a colon (manual 3.3). The fix adds it.",
    ..Rule::BASE
};

/// T0110 too-complex.
pub static TOO_COMPLEX: Rule = Rule {
    code: "T0110",
    name: "too-complex",
    severity: Severity::Error,
    fixed: true,
    explanation: "The operand has more operators and brackets than any program needs. Give a part of it a name with \
        EQUI.",
    ..Rule::BASE
};

/// T0111 unknown-instruction.
pub static UNKNOWN_INSTRUCTION: Rule = Rule {
    code: "T0111",
    name: "unknown-instruction",
    severity: Severity::Error,
    fixed: true,
    explanation: "The word is neither an instruction nor a macro of this project. The message offers the nearest \
        instruction; a label needs a colon.",
    ..Rule::BASE
};

/// T0112 misspelled-prefix.
pub static MISSPELLED_PREFIX: Rule = Rule {
    code: "T0112",
    name: "misspelled-prefix",
    severity: Severity::Warning,
    fixed: false,
    explanation: "`CNTS.` is a common misspelling of `CNST.`. It is read as `CNST.`; the fix corrects it.",
    ..Rule::BASE
};
