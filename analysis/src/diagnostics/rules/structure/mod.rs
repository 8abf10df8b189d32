//! Modules, blocks and what may stand in them.

mod data_not_first;
mod forbidden_module;
mod missing_module;
mod nested_block;
mod repeated_module;
mod stop_misplaced;
mod unclosed_block;
mod unexpected_end;
mod wrong_place;

pub use data_not_first::DATA_NOT_FIRST;
pub use forbidden_module::FORBIDDEN_MODULE;
pub use missing_module::MISSING_MODULE;
pub use nested_block::NESTED_BLOCK;
pub use repeated_module::REPEATED_MODULE;
pub use stop_misplaced::STOP_MISPLACED;
pub use unclosed_block::UNCLOSED_BLOCK;
pub use unexpected_end::UNEXPECTED_END;
pub use wrong_place::WRONG_PLACE;
