//! What somebody relies on who brings the runtime to a controller: it links without a standard library and works
//! from C, asks for no memory in a cycle, has a bounded stack, and does the same again.

mod allocations;
mod bare;
#[path = "../common/families.rs"]
mod families;
mod from_c;
mod in_rust;
mod lathe;
mod same_again;
mod stack;
