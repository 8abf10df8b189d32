//! Mistakes in memory: cells that instructions declare, structures, arrays, prepared blocks, identifiers.

mod array_of_bits;
mod bad_identifier;
mod index_outside_array;
mod no_alternative;

pub use array_of_bits::ARRAY_OF_BITS;
pub use bad_identifier::BAD_IDENTIFIER;
pub use index_outside_array::INDEX_OUTSIDE_ARRAY;
pub use no_alternative::NO_ALTERNATIVE;
