//! Axes, positioning units and spindles, driven as the control drives them: a call is a millisecond.
#![allow(clippy::unwrap_used)] // tests

mod positioning;
mod support;
