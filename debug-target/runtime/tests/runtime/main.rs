//! Acceptance of the runtime: every operation, rulings on mechanisms and time, modules, debugger, properties.

mod assembler;
mod bit_logic;
mod blocks;
mod coverage;
mod data;
mod debugger;
mod dwell;
mod fused;
mod interface;
mod limits;
mod mechanisms;
mod modules;
mod numbers;
mod operation;
mod prepared;
mod procedures;
mod properties;
mod support;
mod timing;
mod trace;
mod validation;
