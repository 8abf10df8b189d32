//! Comments that allow what a rule reports.

mod allow_fixed;
mod bad_allow;
mod unknown_allow;
mod unused_allow;

pub use allow_fixed::ALLOW_FIXED;
pub use bad_allow::BAD_ALLOW;
pub use unknown_allow::UNKNOWN_ALLOW;
pub use unused_allow::UNUSED_ALLOW;
