//! The protocol's nearest word for a kind of symbol.

use technol_analysis::SymbolTag;
use tower_lsp::ls_types::SymbolKind;

/// The protocol knows no machines; its icons are chosen so that the kinds look different.
pub(super) fn symbol_kind(tag: SymbolTag) -> SymbolKind {
    match tag {
        SymbolTag::Module => SymbolKind::MODULE,
        SymbolTag::Data => SymbolKind::NAMESPACE,
        SymbolTag::Mechanism => SymbolKind::CLASS,
        SymbolTag::Procedure => SymbolKind::FUNCTION,
        SymbolTag::Macro => SymbolKind::OPERATOR,
        SymbolTag::Bit => SymbolKind::BOOLEAN,
        SymbolTag::Cell => SymbolKind::VARIABLE,
        SymbolTag::Area => SymbolKind::ARRAY,
        SymbolTag::Constant => SymbolKind::CONSTANT,
        SymbolTag::Text => SymbolKind::STRING,
    }
}
