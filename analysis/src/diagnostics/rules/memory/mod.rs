//! Mistakes in memory: cells that instructions declare, structures, arrays, prepared blocks, identifiers.

mod array_of_bits;
mod bad_identifier;
mod block_access;
mod index_outside_array;
mod member_form;
mod no_alternative;
mod structure_form;

pub use array_of_bits::ARRAY_OF_BITS;
pub use bad_identifier::BAD_IDENTIFIER;
pub use block_access::BLOCK_ACCESS;
pub use index_outside_array::INDEX_OUTSIDE_ARRAY;
pub use member_form::MEMBER_FORM;
pub use no_alternative::NO_ALTERNATIVE;
pub use structure_form::STRUCTURE_FORM;
