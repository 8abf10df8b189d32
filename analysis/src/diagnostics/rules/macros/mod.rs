//! User instructions and macros (manual chapter 22).

#![allow(clippy::needless_update, reason = "a rule may get another field, which these leave at its default")]

mod appended_unknown;
mod duplicate_parameter;
mod macro_arguments;
mod macro_bits;
mod macro_brackets;
mod macro_data;
mod macro_flag_mismatch;
mod macro_flag_order;
mod macro_flags;
mod macro_hidden;
mod macro_nested;
mod macro_recursion;
mod macro_redefined;
mod macro_structure;
mod macro_too_large;
mod macro_used_before;
mod missing_t_local;
mod missing_tmac;
mod parameter_bypassed;
mod t_local_place;
mod unknown_parameter;
mod unused_t_local;

pub use appended_unknown::APPENDED_UNKNOWN;
pub use duplicate_parameter::DUPLICATE_PARAMETER;
pub use macro_arguments::MACRO_ARGUMENTS;
pub use macro_bits::MACRO_BITS;
pub use macro_brackets::MACRO_BRACKETS;
pub use macro_data::MACRO_DATA;
pub use macro_flag_mismatch::MACRO_FLAG_MISMATCH;
pub use macro_flag_order::MACRO_FLAG_ORDER;
pub use macro_flags::MACRO_FLAGS;
pub use macro_hidden::MACRO_HIDDEN;
pub use macro_nested::MACRO_NESTED;
pub use macro_recursion::MACRO_RECURSION;
pub use macro_redefined::MACRO_REDEFINED;
pub use macro_structure::MACRO_STRUCTURE;
pub use macro_too_large::MACRO_TOO_LARGE;
pub use macro_used_before::MACRO_USED_BEFORE;
pub use missing_t_local::MISSING_T_LOCAL;
pub use missing_tmac::MISSING_TMAC;
pub use parameter_bypassed::PARAMETER_BYPASSED;
pub use t_local_place::T_LOCAL_PLACE;
pub use unknown_parameter::UNKNOWN_PARAMETER;
pub use unused_t_local::UNUSED_T_LOCAL;
