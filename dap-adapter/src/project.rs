//! From a project folder to a program that can be loaded and debugged.

use std::fmt;
use std::path::{Path, PathBuf};

use technol_analysis::project::Encoding;
use technol_image::Image;

use crate::arguments::Policy;

/// Builds programs. The adapter's own one is [`FileBuilder`](crate::FileBuilder).
pub trait Builder: Send + Sync {
    /// Builds the project at `program`: its folder, its manifest or a lone source file.
    fn build(&self, program: &Path, policy: Policy) -> Result<BuiltProject, BuildFailure>;
}

/// A program ready for debugging.
#[derive(Clone, Debug)]
pub struct BuiltProject {
    /// Absolute project folder.
    pub root: PathBuf,
    /// Program and debug information; the latter must be there.
    pub image: Image,
    /// Absolute path of the simulated machine that the manifest names.
    pub machine: Option<PathBuf>,
    /// Target address that the manifest names.
    pub target: Option<String>,
    /// Lines outside DEBUG regions take break-points as well.
    pub break_everywhere: bool,
    /// Encoding of the sources; `None`: each file's own.
    pub encoding: Option<Encoding>,
    /// What happened, in one line for the user.
    pub summary: String,
    /// Warnings of the build.
    pub warnings: Vec<Problem>,
    /// Errors in configuration files, which the program is built without.
    pub configuration_errors: Vec<Problem>,
}

/// Something wrong in a source file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Absolute path.
    pub file: PathBuf,
    /// 1-based.
    pub line: u32,
    /// 1-based.
    pub column: u32,
    /// `T0123`.
    pub code: String,
    /// One sentence.
    pub message: String,
}

/// Why there is no program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BuildFailure {
    /// There is no project at that place.
    NoProject {
        /// As asked for.
        program: PathBuf,
        /// What was found instead.
        reason: String,
    },
    /// The sources have errors.
    Errors(Vec<Problem>),
    /// `build: "never"`, and there is no usable image.
    NoImage {
        /// Where it was looked for.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
}

/// Errors named in the message box; all go to the debug console.
const NAMED: usize = 3;

impl fmt::Display for BuildFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildFailure::NoProject { program, reason } => {
                write!(
                    f,
                    "no project at {}: {reason}; set `program` to the project folder",
                    program.display()
                )
            }
            BuildFailure::Errors(problems) => {
                let plural = if problems.len() == 1 { "" } else { "s" };
                write!(f, "the build failed with {} error{plural}: ", problems.len())?;
                for (n, problem) in problems.iter().take(NAMED).enumerate() {
                    let name = problem.file.file_name().unwrap_or(problem.file.as_os_str()).to_string_lossy();
                    let gap = if n == 0 { "" } else { "; " };
                    write!(f, "{gap}{name}:{}: {} [{}]", problem.line, problem.message, problem.code)?;
                }
                if problems.len() > NAMED {
                    write!(f, "; the rest is listed in the debug console and by `technol check`")?;
                }
                Ok(())
            }
            BuildFailure::NoImage { path, reason } => write!(
                f,
                "there is no image to run at {}: {reason}; build the project first, or leave `build` at \"ifStale\"",
                path.display()
            ),
        }
    }
}

impl std::error::Error for BuildFailure {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_build_names_the_first_errors_and_where_the_rest_is() {
        let problem = |line: u32| Problem {
            file: "/p/src/spindle.plc".into(),
            line,
            column: 1,
            code: "T0201".into(),
            message: format!("unknown name `A{line}`"),
        };
        let text = |n| BuildFailure::Errors((1..=n).map(problem).collect()).to_string();
        assert_eq!(text(1), "the build failed with 1 error: spindle.plc:1: unknown name `A1` [T0201]");
        assert_eq!(
            text(5),
            "the build failed with 5 errors: spindle.plc:1: unknown name `A1` [T0201]; \
             spindle.plc:2: unknown name `A2` [T0201]; spindle.plc:3: unknown name `A3` [T0201]; \
             the rest is listed in the debug console and by `technol check`"
        );
    }
}
