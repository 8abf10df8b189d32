//! Tests that cross rooms; all of them are in `tests/` and `debug-adapter/`.
