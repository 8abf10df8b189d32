//! Mistakes in memory: cells that instructions declare, structures, arrays, prepared blocks, identifiers.

mod array_of_bits;
mod bad_identifier;
mod block_access;
mod copy_size;
mod index_outside_array;
mod jump_with_open_equation;
mod member_form;
mod no_alternative;
mod structure_form;
mod text_cut;

pub use array_of_bits::ARRAY_OF_BITS;
pub use bad_identifier::BAD_IDENTIFIER;
pub use block_access::BLOCK_ACCESS;
pub use copy_size::COPY_SIZE;
pub use index_outside_array::INDEX_OUTSIDE_ARRAY;
pub use jump_with_open_equation::JUMP_WITH_OPEN_EQUATION;
pub use member_form::MEMBER_FORM;
pub use no_alternative::NO_ALTERNATIVE;
pub use structure_form::STRUCTURE_FORM;
pub use text_cut::TEXT_CUT;
