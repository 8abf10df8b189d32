//! Symbols in words.

use technol_image::op::Width;

use crate::catalogue::Language;
use crate::semantics::scope::{Symbol, SymbolKind};

/// What a symbol is, in a few words: `WORD cell`, `bit d3`, `constant 1000 (3E8h)`.
pub(super) fn kind(symbol: &Symbol, language: Language) -> String {
    let say = |en: &'static str, cs: &'static str| match language {
        Language::En => en,
        Language::Cs => cs,
    };
    match &symbol.kind {
        SymbolKind::Bit { bit } => format!("bit d{bit}"),
        SymbolKind::FormalBit { bit } => format!("{} d{bit}", say("bit position", "pozice bitu")),
        SymbolKind::Cell(width) => match language {
            Language::En => format!("{} cell", width_name(*width)),
            Language::Cs => format!("buňka {}", width_name(*width)),
        },
        SymbolKind::Array { element, len } => format!("{len} × {}", width_name(*element)),
        SymbolKind::Area { len } => format!("{} {len} {}", say("area,", "oblast,"), say("bytes", "bajtů")),
        SymbolKind::Text { len } => format!("{} {len} {}", say("text,", "text,"), say("characters", "znaků")),
        SymbolKind::Member { offset, element, len: 1 } => {
            format!(
                "{} +{offset}, {}",
                say("member of a structure at", "položka struktury na"),
                width_name(*element)
            )
        }
        SymbolKind::Member { offset, element, len } => {
            let place = say("member of a structure at", "položka struktury na");
            format!("{place} +{offset}, {len} × {}", width_name(*element))
        }
        SymbolKind::Structure { len } => {
            format!("{} {len} {}", say("structure,", "struktura,"), say("bytes", "bajtů"))
        }
        SymbolKind::Constant(value) => format!("{} {}", say("constant", "konstanta"), number(*value)),
        SymbolKind::Mechanism => say("mechanism", "mechanismus").to_owned(),
        SymbolKind::MechanismLine => say(
            "WORD cell: source line where the mechanism stands, 0 when it is not active",
            "buňka WORD: řádek zdrojového textu, na kterém mechanismus stojí, 0 když není aktivní",
        )
        .to_owned(),
        SymbolKind::Procedure => say("procedure", "procedura").to_owned(),
        SymbolKind::Macro => say("user instruction", "uživatelská instrukce").to_owned(),
        SymbolKind::Unknown => say("declared with a mistake", "deklarováno s chybou").to_owned(),
    }
}

/// A number in decimal and, where that says more, in hexadecimal.
fn number(value: i64) -> String {
    match u64::try_from(value) {
        Ok(value) if value > 9 => format!("{value} ({})", hexadecimal(value)),
        _ => value.to_string(),
    }
}

/// As the language spells it: a leading digit and `h`.
pub(super) fn hexadecimal(value: u64) -> String {
    let digits = format!("{value:X}");
    let zero = if digits.starts_with(|c: char| c.is_ascii_digit()) { "" } else { "0" };
    format!("{zero}{digits}h")
}

/// Name of a type as the manual writes it.
pub(super) const fn width_name(width: Width) -> &'static str {
    match width {
        Width::Byte => "BYTE",
        Width::Word => "WORD",
        Width::DWord => "DWORD",
        Width::QWord => "QWORD",
        Width::Real => "REAL",
    }
}
