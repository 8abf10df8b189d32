//! Reading `machine.toml`.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use technol_machine::{ConfigError, MachineConfig, Plant};
use toml::de::{DeTable, DeValue};

/// Something in a machine file that does not work.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}:{line}:{col}: {message}", .file.display())]
pub struct MachineFileError {
    /// The file.
    pub file: PathBuf,
    /// 1-based line; 1 when the file cannot be read at all.
    pub line: u32,
    /// 1-based column, in characters.
    pub col: u32,
    /// What is wrong, and what would be right.
    pub message: String,
}

/// Reads and checks a machine file.
///
/// # Errors
/// The first thing that is wrong. [`parse_machine`] gives all.
pub fn load_machine(path: &Path) -> Result<MachineConfig, MachineFileError> {
    let text = fs::read_to_string(path).map_err(|error| MachineFileError {
        file: path.to_owned(),
        line: 1,
        col: 1,
        message: format!("cannot read the machine file: {error}; correct `[machine] file` in technol.toml"),
    })?;
    parse_machine(path, &text).map_err(|mut errors| {
        errors.sort_by_key(|e| (e.line, e.col));
        errors.swap_remove(0)
    })
}

/// Checks the text of a machine file; `path` is only named in errors.
///
/// # Errors
/// Everything that is wrong, at least one error: the first syntax error, or all errors of meaning.
pub fn parse_machine(path: &Path, text: &str) -> Result<MachineConfig, Vec<MachineFileError>> {
    parse_machine_for(path, text, |_| Vec::new())
}

/// The same; what `mistakes` finds in a description that is right otherwise is an error, too.
///
/// # Errors
/// As of [`parse_machine`].
pub fn parse_machine_for(
    path: &Path,
    text: &str,
    mistakes: impl FnOnce(&MachineConfig) -> Vec<ConfigError>,
) -> Result<MachineConfig, Vec<MachineFileError>> {
    let error = |span: Option<Range<usize>>, message: String| {
        let (line, col) = position(text, span.map_or(0, |s| s.start));
        MachineFileError { file: path.to_owned(), line, col, message }
    };
    let config: MachineConfig =
        toml::from_str(text).map_err(|e| vec![error(e.span(), e.message().to_owned())])?;
    let compiled = Plant::compile(&config, &|name| name.parse().ok());
    let errors = compiled.err().unwrap_or_else(|| mistakes(&config));
    if errors.is_empty() {
        return Ok(config);
    }
    let table = DeTable::parse(text).ok();
    let at = |e: &ConfigError| table.as_ref().and_then(|t| locate(t.get_ref(), e));
    Err(errors.iter().map(|e| error(at(e), e.to_string())).collect())
}

/// Where the text says what the error is about.
fn locate(root: &DeTable<'_>, error: &ConfigError) -> Option<Range<usize>> {
    let value = root.get(error.table)?;
    let element = match (value.get_ref(), error.index) {
        (DeValue::Array(elements), Some(index)) => elements.get(index)?,
        _ => value,
    };
    match element.get_ref() {
        DeValue::Table(table) => Some(table.get(error.key).map_or(element.span(), toml::Spanned::span)),
        _ => Some(element.span()),
    }
}

fn position(text: &str, offset: usize) -> (u32, u32) {
    let before = text.get(..offset).unwrap_or(text);
    let line = before.matches('\n').count() + 1;
    let col = before.rsplit('\n').next().map_or(0, |last| last.chars().count()) + 1;
    (line as u32, col as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn errors(text: &str) -> Vec<String> {
        let parsed = parse_machine(Path::new("machine.toml"), text);
        parsed.unwrap_err().iter().map(ToString::to_string).collect()
    }

    #[test]
    fn errors_name_file_line_and_column() {
        let text = "[machine]\nname = 'příklad'\n\n[[contact]]\noutput = 'P0OUT.0'\ninput = 'P1IN.9'\n\n[[contact]]\n\
                    output = 'P0OUT.1'\ninput = 'P1IN.0'\n[[limit]]\noutput-forward='P0OUT.1'\ntravel-ms=5\n";
        let expected = [
            "machine.toml:6:9: contact[0].input: `P1IN.9` is not a bit of a port; use P1IN.0 to P128IN.7 or P0OUT.0 \
             to P95OUT.7",
            "machine.toml:11:1: limit[0]: needs `input-at-start` or `input-at-end`, else nothing can be seen of it",
        ];
        assert_eq!(errors(text), expected);
    }

    #[test]
    fn every_kind_of_element_has_its_place_in_errors() {
        for (text, expected) in [
            (
                "[[latch]]\nset = 'P0OUT.0'\nreset = ['P0OUT.1', 'STOP']\ninput = 'P1IN.0'",
                "3:9: latch[0].reset: `STOP`",
            ),
            (
                "[[counter]]\npulses = 'P0OUT.0'\ncount = 0\ninput = 'P1IN.0'",
                "3:9: counter[0].count: must be",
            ),
            ("[[counter]]\npulses = 'P0OUT.0'\ncount = 2\ninputs = 'P1IN.0'", "4:1: unknown field `inputs`"),
            (
                "[[ramp]]\noutput = 'P0OUT.0'\nhigh = 9\nrise-per-s = 1\nthresholds = [{ at = 3, input = 'T' }]",
                "5:14: ramp[0].thresholds: `T` is not",
            ),
            (
                "[[ramp]]\noutput = 'P0OUT.0'\nhigh = 9\nrise-per-s = 1\nthresholds = [{ at = 3, inputs = 'T' }]",
                "5:25: unknown field `inputs`",
            ),
            (
                "[[slide]]\nforward = 'P0OUT.0'\nbackward = 'P0OUT.1'\nspeed-mm-s = 5\nstroke-mm = 'long'",
                "5:13: invalid type",
            ),
            (
                "[[fault]]\nname = 'x'\nelement = 'pump'\njammed = true",
                "3:11: fault[0].element: no element is called `pump`",
            ),
            ("[control]\nstop = 'KEY'", "2:8: control.stop: `KEY` is not"),
            ("[[m-function]]\nnumber = 3\ngroup = 4", "3:9: m-function[0].group: M03 belongs to group 2"),
        ] {
            let errors = errors(text);
            assert!(errors[0].starts_with(&format!("machine.toml:{expected}")), "{text}\n{errors:?}");
        }
    }

    #[test]
    fn syntax_errors_and_unknown_keys_have_a_place() {
        let unknown = errors("[[contact]]\noutput = 'P0OUT.0'\ninput = 'P1IN.0'\ndelay = 3\n");
        assert!(unknown[0].starts_with("machine.toml:4:1: unknown field `delay`"), "{unknown:?}");
        let syntax = errors("[machine]\nname = \n");
        assert!(syntax[0].starts_with("machine.toml:2:8: "), "{syntax:?}");
        let kind = errors("[[contact]]\noutput = 3\ninput = 'P1IN.0'\n");
        assert!(kind[0].starts_with("machine.toml:2:10: "), "{kind:?}");
        assert!(kind[0].contains("the name of an output"), "{kind:?}");
    }

    #[test]
    fn a_file_that_is_not_there_is_named() {
        let error = load_machine(Path::new("no/such/machine.toml")).unwrap_err();
        assert!(
            error.to_string().starts_with("no/such/machine.toml:1:1: cannot read the machine file"),
            "{error}"
        );
    }
}
