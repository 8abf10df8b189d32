//! Operands made from their specification: right ones of each type, and wrong ones.

use technol_analysis::catalogue::{Entry, OperandKind, OperandSpec, Prefix, PrefixSet};

/// DATA of the frame: one name of each kind. Names of operands begin with `W_`.
pub(crate) const DATA: &str = "\
W_PORT: DFM W_BIT,W_BIT2
W_BYTE: DS 1
W_WORD: DS 2
W_DWORD: DS 4
W_REAL: DS 8
W_AREA: DS 64
W_TEXT: STR 40
EQUI W_CONST,1
";
/// MODULE_MAIN of the frame.
pub(crate) const MAIN: &str = "\
MECH_BEGIN W_MECH
EX
MECH_END W_MECH
PROC_BEGIN W_PROC
PROC_END W_PROC
";
/// MODULE_INIT of the frame.
pub(crate) const INIT: &str = "\
DEF_IN W_INPUT[4],'Walk',TYPE_WORD,-,ONDEMAND
";

/// Closing lines, whose operand is the name that opened their block.
const CLOSING: &[&str] = &["MECH_END", "PROC_END"];

/// An operand of an instruction that fits.
pub(crate) fn fitting(entry: &Entry, operand: &OperandSpec, around: Around) -> String {
    if CLOSING.contains(&entry.name) { format!("W_NEW{}", around.case) } else { sample(operand.kind, around) }
}

/// What stands around an operand in a form.
#[derive(Clone, Copy, Default)]
pub(crate) struct Around {
    /// A type prefix before it, or a sum: memory without a type of its own.
    pub(crate) memory: bool,
    /// Number of the case, for names that must be new.
    pub(crate) case: usize,
}

/// An operand that fits.
fn sample(kind: OperandKind, around: Around) -> String {
    let text = match kind {
        OperandKind::Bit { .. } | OperandKind::BitPosition => "W_BIT",
        OperandKind::Data { .. }
        | OperandKind::Value(_)
        | OperandKind::AutoCounter
        | OperandKind::Time
        | OperandKind::Address(_)
        | OperandKind::LiteralOrAddress
            if around.memory =>
        {
            "W_AREA"
        }
        OperandKind::Data { declared, .. } | OperandKind::Value(declared) => typed(declared),
        OperandKind::Address(_) | OperandKind::LiteralOrAddress => "W_AREA",
        OperandKind::AutoCounter | OperandKind::Time => "W_WORD",
        OperandKind::Label => return format!("W_LABEL{}", around.case),
        OperandKind::Mechanism { declares: false } => "W_MECH",
        OperandKind::Procedure { declares: false } => "W_PROC",
        OperandKind::Mechanism { declares: true }
        | OperandKind::Procedure { declares: true }
        | OperandKind::NewName
        | OperandKind::NewBit
        | OperandKind::Declares(_) => return format!("W_NEW{}", around.case),
        OperandKind::Number { min, max } => return 4.clamp(min, max).to_string(),
        OperandKind::NumberOf(numbers) => return numbers[numbers.len() - 1].to_string(),
        OperandKind::Constant => "5",
        OperandKind::RealConstant => "2.5",
        // A type that a single cell and an array may have.
        OperandKind::Keyword(words) if words.contains(&"TYPE_WORD") => "TYPE_WORD",
        OperandKind::Keyword(words) | OperandKind::KeywordOrNumber(words, ..) => words[0],
        OperandKind::Text(_) | OperandKind::TextOrLiteral => "W_TEXT",
        OperandKind::Identifier(_) => "'Walk'",
        OperandKind::DeclaredElement => "W_INPUT",
        OperandKind::OneOf(kinds) => return sample(kinds[0], around),
        OperandKind::Any => "EAX",
    };
    text.to_string()
}

fn typed(declared: PrefixSet) -> &'static str {
    let cells = [
        (Prefix::Word, "W_WORD"),
        (Prefix::Byte, "W_BYTE"),
        (Prefix::Dwrd, "W_DWORD"),
        (Prefix::Real, "W_REAL"),
        (Prefix::Qwrd, "W_REAL"),
        (Prefix::Cnst, "5"),
    ];
    cells.into_iter().find(|(prefix, _)| declared.contains(*prefix)).expect("a declared type").1
}

/// Everything that fits: each prefix, each declared type, each keyword, both bounds, each alternative, `-`.
pub(crate) fn samples(operand: &OperandSpec) -> Vec<String> {
    let mut all = of_kind(operand.kind);
    if operand.skippable || operand.kind == OperandKind::AutoCounter {
        all.extend(["-".to_string(), "NIL".to_string()]);
    }
    all
}

fn of_kind(kind: OperandKind) -> Vec<String> {
    let list = |all: &[&str]| all.iter().map(ToString::to_string).collect::<Vec<_>>();
    match kind {
        OperandKind::Bit { negatable, extended, .. } => {
            let mut all = list(&["W_BIT"]);
            if negatable {
                all.push("-W_BIT".to_string());
            }
            if extended {
                all.extend(list(&[
                    "W_BYTE.W_BIT",
                    "W_AREA+3.W_BIT",
                    "W_AREA[BX].W_BIT",
                    "$.W_BIT",
                    "$+0.W_BIT",
                ]));
            }
            all
        }
        OperandKind::Data { prefixes, declared, negatable, .. } => {
            let mut all: Vec<String> = typed_all(declared);
            for prefix in Prefix::ALL.into_iter().filter(|prefix| prefixes.contains(*prefix)) {
                all.extend(prefixed(prefix));
            }
            if negatable {
                all.push(format!("-{}", typed(declared)));
            }
            all
        }
        OperandKind::Value(declared) => typed_all(declared),
        OperandKind::Address(_) => list(&["W_WORD", "W_AREA", "W_AREA+8", "W_AREA[BX]", "W_TEXT"]),
        OperandKind::LiteralOrAddress => list(&["W_AREA", "W_AREA+8", "'Walk'"]),
        OperandKind::AutoCounter => list(&["W_BYTE", "W_WORD"]),
        OperandKind::Time => list(&["W_WORD", "W_BYTE", "50", "W_CONST"]),
        OperandKind::Number { min, max } => {
            let mut all = vec![min.to_string(), max.to_string()];
            if (min..=max).contains(&1) {
                all.extend(list(&["W_CONST", "CNST.1"]));
            }
            all
        }
        OperandKind::NumberOf(numbers) => numbers.iter().map(ToString::to_string).collect(),
        OperandKind::Constant => list(&["5", "2.5", "W_CONST"]),
        OperandKind::RealConstant => list(&["2.5", "-0.5"]),
        OperandKind::Keyword(words) => list(words),
        OperandKind::KeywordOrNumber(words, min, max) => {
            list(words).into_iter().chain([min.to_string(), max.to_string()]).collect()
        }
        OperandKind::Text(_) => list(&["W_TEXT", "W_TEXT+2", "W_TEXT+BX"]),
        OperandKind::TextOrLiteral => list(&["W_TEXT", "W_TEXT+2", "'Walk'"]),
        OperandKind::Identifier(_) => list(&["'Walk'", "W_TEXT"]),
        OperandKind::DeclaredElement => list(&["W_INPUT", "W_INPUT[3]"]),
        OperandKind::OneOf(kinds) => kinds.iter().flat_map(|kind| of_kind(*kind)).collect(),
        OperandKind::BitPosition => list(&["W_BIT"]),
        // The usual operand is all there is.
        OperandKind::Label
        | OperandKind::Mechanism { .. }
        | OperandKind::Procedure { .. }
        | OperandKind::NewName
        | OperandKind::NewBit
        | OperandKind::Declares(_)
        | OperandKind::Any => Vec::new(),
    }
}

fn typed_all(declared: PrefixSet) -> Vec<String> {
    let only_eight = ![Prefix::Byte, Prefix::Word, Prefix::Dwrd].iter().any(|it| declared.contains(*it));
    let cells: [(Prefix, &[&str]); 5] = [
        (Prefix::Byte, &["W_BYTE"]),
        (Prefix::Word, &["W_WORD"]),
        (Prefix::Dwrd, &["W_DWORD"]),
        (Prefix::Cnst, &["5", "CNST.5", "W_CONST", "CNST.W_CONST+1", "'A'"]),
        (Prefix::Real, if only_eight { &["W_REAL"] } else { &[] }),
    ];
    let fits = cells.iter().filter(|(prefix, _)| declared.contains(*prefix));
    fits.flat_map(|(_, names)| names.iter().map(ToString::to_string)).collect()
}

fn prefixed(prefix: Prefix) -> Vec<String> {
    let name = prefix.name();
    match prefix {
        Prefix::Cnst => vec!["CNST.5".to_string(), "CNST.0FFh".to_string()],
        Prefix::High => vec!["HIGH.W_WORD".to_string()],
        _ => vec![format!("{name}.W_AREA"), format!("{name}.(W_AREA+8)"), format!("{name}.W_AREA[BX]")],
    }
}

/// Operands of a wrong kind or value, at least one.
pub(crate) fn wrong(kind: OperandKind) -> Vec<String> {
    let list = |all: &[&str]| all.iter().map(ToString::to_string).collect::<Vec<_>>();
    match kind {
        OperandKind::Bit { .. } => list(&["W_BYTE", "5", "'Walk'", "W_PROC", "BYTE.W_AREA"]),
        OperandKind::Data { .. } | OperandKind::Value(_) | OperandKind::AutoCounter | OperandKind::Time => {
            list(&["W_BIT", "W_PROC", "'Walk'", "W_NOBODY"])
        }
        OperandKind::Address(_) => list(&["W_BIT", "5", "W_PROC", "'Walk'", "W_NOBODY"]),
        OperandKind::LiteralOrAddress => list(&["W_BIT", "5", "W_PROC"]),
        OperandKind::Label => list(&["5", "W_NOBODY", "'Walk'"]),
        OperandKind::Mechanism { declares: false } => list(&["W_BYTE", "5", "W_PROC", "W_NOBODY"]),
        OperandKind::Procedure { declares: false } => list(&["W_BYTE", "5", "W_MECH", "W_NOBODY"]),
        OperandKind::Mechanism { declares: true } | OperandKind::Procedure { declares: true } => {
            list(&["5", "'Walk'"])
        }
        OperandKind::NewName | OperandKind::NewBit => list(&["5", "'Walk'"]),
        OperandKind::Declares(_) => list(&["5", "'Walk'", "BYTE.W_AREA"]),
        OperandKind::Number { min, max } => {
            let mut all = list(&["W_BYTE", "W_BIT", "2.5", "'Walk'", "W_NOBODY"]);
            all.extend([(min - 1).to_string(), (max + 1).to_string()]);
            all
        }
        OperandKind::NumberOf(numbers) => {
            let missing = (0..=i64::MAX).find(|number| !numbers.contains(number)).expect("the list ends");
            vec!["W_BYTE".to_string(), "2.5".to_string(), missing.to_string()]
        }
        OperandKind::Constant => list(&["W_BYTE", "W_BIT", "'Walk'", "W_NOBODY"]),
        OperandKind::RealConstant => list(&["5", "W_BYTE", "'Walk'"]),
        OperandKind::Keyword(_) => list(&["5", "W_BYTE", "W_NOBODY", "'Walk'"]),
        OperandKind::KeywordOrNumber(_, min, max) => {
            vec!["W_BYTE".to_string(), "2.5".to_string(), (min - 1).to_string(), (max + 1).to_string()]
        }
        OperandKind::Text(_) | OperandKind::TextOrLiteral => list(&["W_BYTE", "5", "W_BIT", "W_PROC"]),
        OperandKind::Identifier(_) => list(&["5", "W_BYTE", "W_PROC", "''"]),
        OperandKind::DeclaredElement => list(&["W_BYTE", "5", "W_BIT", "W_NOBODY"]),
        OperandKind::BitPosition => list(&["W_BYTE", "5", "W_PROC", "W_NOBODY"]),
        OperandKind::OneOf(_) => list(&["W_PROC", "W_NOBODY"]),
        OperandKind::Any => Vec::new(),
    }
}
