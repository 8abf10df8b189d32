//! Names that mean nothing, or something else than the place needs.

mod duplicate_label;
mod unknown_label;
mod unknown_symbol;
mod wrong_symbol;

pub use duplicate_label::DUPLICATE_LABEL;
pub use unknown_label::UNKNOWN_LABEL;
pub use unknown_symbol::UNKNOWN_SYMBOL;
pub use wrong_symbol::WRONG_SYMBOL;
