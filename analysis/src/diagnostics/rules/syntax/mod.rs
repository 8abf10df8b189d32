//! Mistakes in the form of a line.

mod bad_number;
mod expected_colon;
mod expected_comma;
mod expected_operand;
mod expected_operation;
mod misspelled_prefix;
mod too_complex;
mod typographic_quote;
mod unbalanced_bracket;
mod unclosed_text;
mod unexpected_character;
mod unknown_instruction;

pub use bad_number::BAD_NUMBER;
pub use expected_colon::EXPECTED_COLON;
pub use expected_comma::EXPECTED_COMMA;
pub use expected_operand::EXPECTED_OPERAND;
pub use expected_operation::EXPECTED_OPERATION;
pub use misspelled_prefix::MISSPELLED_PREFIX;
pub use too_complex::TOO_COMPLEX;
pub use typographic_quote::TYPOGRAPHIC_QUOTE;
pub use unbalanced_bracket::UNBALANCED_BRACKET;
pub use unclosed_text::UNCLOSED_TEXT;
pub use unexpected_character::UNEXPECTED_CHARACTER;
pub use unknown_instruction::UNKNOWN_INSTRUCTION;
