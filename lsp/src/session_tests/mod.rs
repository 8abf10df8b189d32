//! Whole sessions in one process: a client at one end of a pipe, the server at the other.

mod client;
mod language;
mod projects;
mod protocol;
