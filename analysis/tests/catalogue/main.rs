//! The catalogue against the checker and the editor: examples of the help, and a walk through every form and operand.

mod examples;
mod forms;
mod program;
mod samples;
mod settings;
mod walk;
