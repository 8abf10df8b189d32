//! What the target cannot run.

mod not_executable;
mod not_translatable;
mod too_large;

pub use not_executable::NOT_EXECUTABLE;
pub use not_translatable::NOT_TRANSLATABLE;
pub use too_large::TOO_LARGE;
