//! Operands that do not fit their instruction.

mod access_outside_data;
mod access_past_cell;
mod constant_destination;
mod constant_too_large;
mod different_types;
mod division_by_zero;
mod never_equal;
mod number_out_of_range;
mod operand_count;
mod operand_kind;
mod prefix_covers_time;
mod prefix_not_allowed;
mod real_not_allowed;
mod sign_not_allowed;
mod stale_dividend;
mod untyped_area;

pub use access_outside_data::ACCESS_OUTSIDE_DATA;
pub use access_past_cell::ACCESS_PAST_CELL;
pub use constant_destination::CONSTANT_DESTINATION;
pub use constant_too_large::CONSTANT_TOO_LARGE;
pub use different_types::DIFFERENT_TYPES;
pub use division_by_zero::DIVISION_BY_ZERO;
pub use never_equal::NEVER_EQUAL;
pub use number_out_of_range::NUMBER_OUT_OF_RANGE;
pub use operand_count::OPERAND_COUNT;
pub use operand_kind::OPERAND_KIND;
pub use prefix_covers_time::PREFIX_COVERS_TIME;
pub use prefix_not_allowed::PREFIX_NOT_ALLOWED;
pub use real_not_allowed::REAL_NOT_ALLOWED;
pub use sign_not_allowed::SIGN_NOT_ALLOWED;
pub use stale_dividend::STALE_DIVIDEND;
pub use untyped_area::UNTYPED_AREA;
