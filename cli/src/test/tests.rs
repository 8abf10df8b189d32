//! The reader, the conditions and the reports on a small program.

mod conditions;
mod failures;
mod reading;

use super::fixture::Fixture;
