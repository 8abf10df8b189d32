//! Mistakes in declarations.

mod bad_declaration;
mod bad_length;
mod circular_constant;
mod conflicting_constant;
mod duplicate_name;
mod hides_system_symbol;
mod long_name;
mod missing_name;
mod name_like_instruction;
mod not_constant;
mod text_too_long;
mod too_many_bits;

pub use bad_declaration::BAD_DECLARATION;
pub use bad_length::BAD_LENGTH;
pub use circular_constant::CIRCULAR_CONSTANT;
pub use conflicting_constant::CONFLICTING_CONSTANT;
pub use duplicate_name::DUPLICATE_NAME;
pub use hides_system_symbol::HIDES_SYSTEM_SYMBOL;
pub use long_name::LONG_NAME;
pub use missing_name::MISSING_NAME;
pub use name_like_instruction::NAME_LIKE_INSTRUCTION;
pub use not_constant::NOT_CONSTANT;
pub use text_too_long::TEXT_TOO_LONG;
pub use too_many_bits::TOO_MANY_BITS;
