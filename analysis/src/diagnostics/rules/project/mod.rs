//! Mistakes in `technol.toml` and in the set of files.

mod cyclic_include;
mod duplicate_file;
mod included_code;
mod included_twice;
mod machine_file;
mod manifest_syntax;
mod missing_file;
mod missing_include;
mod outside_file;
mod too_many_files;
mod undecodable_file;
mod unknown_key;
mod unknown_lint;
mod wrong_value;

pub use cyclic_include::CYCLIC_INCLUDE;
pub use duplicate_file::DUPLICATE_FILE;
pub use included_code::INCLUDED_CODE;
pub use included_twice::INCLUDED_TWICE;
pub use machine_file::MACHINE_FILE;
pub use manifest_syntax::MANIFEST_SYNTAX;
pub use missing_file::MISSING_FILE;
pub use missing_include::MISSING_INCLUDE;
pub use outside_file::OUTSIDE_FILE;
pub use too_many_files::TOO_MANY_FILES;
pub use undecodable_file::UNDECODABLE;
pub use unknown_key::UNKNOWN_KEY;
pub use unknown_lint::UNKNOWN_LINT;
pub use wrong_value::WRONG_VALUE;
