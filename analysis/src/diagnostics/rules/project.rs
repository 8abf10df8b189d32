//! Mistakes in `technol.toml` and in the set of files.

use crate::diagnostics::{Rule, Severity};

/// T0001 manifest-syntax.
pub static MANIFEST_SYNTAX: Rule = Rule {
    code: "T0001",
    name: "manifest-syntax",
    severity: Severity::Error,
    fixed: true,
    explanation: "`technol.toml` is not valid TOML. Nothing after the mistake can be trusted, so the project may \
        look incomplete until it is mended. Correct the line shown; strings stand in double quotes, lists \
        in square brackets.",
    ..Rule::BASE
};

/// T0002 unknown-key.
pub static UNKNOWN_KEY: Rule = Rule {
    code: "T0002",
    name: "unknown-key",
    severity: Severity::Warning,
    fixed: false,
    explanation: "`technol.toml` holds a table or key this version does not know, usually a misspelling, so it has \
        no effect. Keys are written in kebab-case: `[project] name, main, files, include-dirs, system-dir, \
        configuration, encoding`, `[machine] file`, `[target] address`, `[debug] everywhere`, `[lints]`.",
    ..Rule::BASE
};

/// T0003 wrong-value.
pub static WRONG_VALUE: Rule = Rule {
    code: "T0003",
    name: "wrong-value",
    severity: Severity::Error,
    fixed: true,
    explanation: "A value of `technol.toml` has the wrong type or is not one of the allowed words. The default is \
        used instead. The message names what is expected.",
    ..Rule::BASE
};

/// T0004 missing-file.
pub static MISSING_FILE: Rule = Rule {
    code: "T0004",
    name: "missing-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file the project names cannot be read, so the program is incomplete. Correct the path (relative \
        to the folder of `technol.toml`, with `/`) or create the file.",
    ..Rule::BASE
};

/// T0005 too-many-files.
pub static TOO_MANY_FILES: Rule = Rule {
    code: "T0005",
    name: "too-many-files",
    severity: Severity::Error,
    fixed: true,
    explanation: "A program has at most 64 source files: the main file and 63 further ones (manual 5.4). Join files, \
        or move constants into included files, which do not count.",
    ..Rule::BASE
};

/// T0006 outside-file.
pub static OUTSIDE_FILE: Rule = Rule {
    code: "T0006",
    name: "outside-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "A program file lies outside the folder of `technol.toml`. A project is one folder, so that it can \
        be copied and built elsewhere. Move the file into it; shared text can be included from `include- \
        dirs`.",
    ..Rule::BASE
};

/// T0007 duplicate-file.
pub static DUPLICATE_FILE: Rule = Rule {
    code: "T0007",
    name: "duplicate-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file is listed twice in `main` and `files`. It would be compiled twice and all its names would \
        clash. Remove one entry.",
    ..Rule::BASE
};

/// T0008 unknown-lint.
pub static UNKNOWN_LINT: Rule = Rule {
    code: "T0008",
    name: "unknown-lint",
    severity: Severity::Warning,
    fixed: false,
    explanation: "`[lints]` names a code that no rule has, or tries to lower the severity of an error that makes a \
        program impossible to build. `technol explain T0301` shows a rule; a rule can be set to `off`, \
        `hint`, `warning` or `error`.",
    ..Rule::BASE
};

/// T0009 missing-include.
pub static MISSING_INCLUDE: Rule = Rule {
    code: "T0009",
    name: "missing-include",
    severity: Severity::Error,
    fixed: true,
    explanation: "The file named by T_INCLUDE is not found. Without apostrophes it is searched in the folder of the \
        main file, then in `include-dirs`; in apostrophes in `system-dir` (manual 22). Correct the name or \
        add the folder to `technol.toml`.",
    ..Rule::BASE
};

/// T0010 cyclic-include.
pub static CYCLIC_INCLUDE: Rule = Rule {
    code: "T0010",
    name: "cyclic-include",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file includes itself, directly or through other files. The inclusion that closes the circle is \
        ignored. Move what both files need into a third one.",
    ..Rule::BASE
};

/// T0011 included-code.
pub static INCLUDED_CODE: Rule = Rule {
    code: "T0011",
    name: "included-code",
    severity: Severity::Error,
    fixed: true,
    explanation: "An included file may hold constants (EQUI), macros, comments and further T_INCLUDE; DFM and DS \
        only when it is included inside DATA or DATA_LOCAL. Executable code and modules belong into a \
        program file (`files` in `technol.toml`).",
    ..Rule::BASE
};

/// T0012 included-twice.
pub static INCLUDED_TWICE: Rule = Rule {
    code: "T0012",
    name: "included-twice",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file that declares memory is included more than once, so each of its names would be declared \
        twice. Include it in one DATA only: its names are known in all files.",
    ..Rule::BASE
};

/// T0013 undecodable-file.
pub static UNDECODABLE: Rule = Rule {
    code: "T0013",
    name: "undecodable-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "A file holds bytes that are no text in the encoding the project declares. They were replaced by \
        U+FFFD for reading. Set `encoding` in `technol.toml` to `auto`, `utf-8`, `windows-1250` or \
        `cp852`, or save the file again.",
    ..Rule::BASE
};

/// T0014 machine-file.
pub static MACHINE_FILE: Rule = Rule {
    code: "T0014",
    name: "machine-file",
    severity: Severity::Error,
    fixed: true,
    explanation: "The file that `[machine] file` of `technol.toml` names cannot be read, or describes a machine that \
        does not work: an unknown key, a signal that is no port bit, one input driven twice. `technol check` reports \
        it in that file; the program itself builds, but `technol run` and the embedded target need the machine.",
    ..Rule::BASE
};
