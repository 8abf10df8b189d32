//! Axes, positioning units and spindles, driven as the control drives them: a call is a millisecond.
#![allow(clippy::unwrap_used, clippy::float_cmp)] // tests; exact results are what is tested

mod axes;
mod blocks;
mod description;
mod homing;
mod positioning;
mod properties;
mod spindles;
mod support;
