//! Acceptance of the runtime: every operation, rulings on mechanisms and time, modules, debugger, properties.

mod bit_logic;
mod blocks;
mod data;
mod debugger;
mod fused;
mod limits;
mod mechanisms;
mod modules;
mod numbers;
mod operation;
mod procedures;
mod properties;
mod support;
mod timing;
mod validation;
