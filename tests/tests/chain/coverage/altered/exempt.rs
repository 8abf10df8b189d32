//! Alterations that change nothing a program can notice.

/// Alterations; why.
pub(in super::super) const EXEMPT: &[(&[&str], &str)] = &[];
