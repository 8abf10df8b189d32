//! What the expansions of a section declare.

use super::expand::Expansion;
use super::remap;
use crate::diagnostics::rules::declarations as rules;
use crate::semantics::collect::{self, Reader};
use crate::semantics::declarations::{Declarations, Exports};
use crate::syntax::section::SectionKind;

/// Declarations in the expansions of a section. Their lines are own lines: those of the calls.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ExpansionDeclarations {
    /// In DATA_LOCAL of the bodies.
    pub local: Declarations,
    /// Elsewhere in them: constants, labels.
    pub other: Declarations,
    /// Line in the expansion of each name of `local`.
    pub local_lines: Vec<u32>,
    /// Line in the expansion of each name of `other`.
    pub other_lines: Vec<u32>,
}

/// What others see of them.
#[derive(Clone, Debug, Default, PartialEq, salsa::SalsaValue)]
pub struct ExpansionExports {
    /// Of DATA_LOCAL.
    pub local: Exports,
    /// Of the rest.
    pub other: Exports,
}

/// Reads the declarations of an expansion in a section of a kind.
pub(crate) fn declarations(expansion: &Expansion<'_>, kind: SectionKind) -> ExpansionDeclarations {
    let errors = expansion.parsed.error_lines();
    let mut local = Reader::new(SectionKind::DataLocal, errors.clone());
    let mut other = Reader::new(kind, errors);
    for (number, (line, origin)) in expansion.parsed.lines.iter().zip(&expansion.origins).enumerate() {
        let Some(body) = &origin.body else { continue };
        let reader = if body.local { &mut local } else { &mut other };
        reader.line(number as u32, line, &body.text);
    }
    let (local, local_lines) = finish(local, expansion);
    let (other, other_lines) = finish(other, expansion);
    ExpansionDeclarations { local, other, local_lines, other_lines }
}

fn finish(mut reader: Reader, expansion: &Expansion<'_>) -> (Declarations, Vec<u32>) {
    reader.labels_of_code();
    let mut found = reader.found;
    found.includes.clear();
    found.macro_lines.clear();
    let mut lines = Vec::with_capacity(found.names.len());
    for declared in &mut found.names {
        lines.push(declared.line);
        declared.line = expansion.origins.get(declared.line as usize).map_or(0, |origin| origin.own);
    }
    let findings = std::mem::take(&mut found.findings);
    found.findings = findings
        .into_iter()
        // How a body names its symbols is a matter of the definition.
        .filter(|f| f.rule != &rules::LONG_NAME && f.rule != &rules::NAME_LIKE_INSTRUCTION)
        .map(|finding| remap::finding(expansion, finding))
        .collect();
    (found, lines)
}

/// What others see of them.
pub(crate) fn exports(declarations: &ExpansionDeclarations) -> ExpansionExports {
    ExpansionExports {
        local: collect::exports(&declarations.local),
        other: collect::exports(&declarations.other),
    }
}
