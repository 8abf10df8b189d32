//! Logic equations and their stack.

mod lost_equation;
mod open_equation;
mod pop_without_push;
mod stack_too_deep;
mod value_left_on_stack;

pub use lost_equation::LOST_EQUATION;
pub use open_equation::OPEN_EQUATION;
pub use pop_without_push::POP_WITHOUT_PUSH;
pub use stack_too_deep::STACK_TOO_DEEP;
pub use value_left_on_stack::VALUE_LEFT_ON_STACK;
