//! Between editor positions and code: files, lines, sections.

use std::collections::HashSet;
use std::path::{Component, Path, PathBuf};

use technol_analysis::project::{Encoding, decode};
use technol_analysis::syntax::section::SectionKind;
use technol_analysis::syntax::split;
use technol_image::Op;
use technol_image::container::hash_bytes;
use technol_image::debug_info::DebugInfo;
use technol_image::op::Pc;
use technol_image::program::{ModuleKind, Program};

/// Where a break-point goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Placement {
    /// The line with code, 1-based.
    pub(crate) line: u32,
    /// Its statements: more than one where a file is included several times.
    pub(crate) pcs: Vec<Pc>,
}

/// Why no break-point can go there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoPlace {
    NoCode,
    Fast,
    Cont,
    OutsideDebug,
}

impl NoPlace {
    pub(crate) fn text(self) -> &'static str {
        match self {
            NoPlace::NoCode => "no code follows this line in its section",
            NoPlace::Fast => "a module of the 1 ms raster takes no break-points: it cannot be held",
            NoPlace::Cont => "MODULE_CONT never stops: it keeps running while the debugger holds the rest",
            NoPlace::OutsideDebug => {
                "outside a DEBUG region; enclose it in DEBUG … DEBUG OFF, or set `everywhere = true` under [debug] in technol.toml"
            }
        }
    }
}

/// A line with code.
#[derive(Clone, Copy, Debug)]
struct Entry {
    line: u32,
    pc: Pc,
    in_debug_region: bool,
}

/// Source positions of one program.
pub(crate) struct SourceMap {
    /// Absolute path of each file.
    paths: Vec<PathBuf>,
    /// Lines with statements of each file, ascending by line, then code.
    entries: Vec<Vec<Entry>>,
    /// Sections of each file; `None` when its text is not the one that was built.
    sections: Vec<Option<Sections>>,
}

/// Which line of a file belongs to which section.
struct Sections {
    /// By 0-based line.
    of_line: Vec<usize>,
    /// The section around each, and whether it holds code.
    all: Vec<(Option<usize>, bool)>,
}

impl Sections {
    fn new(text: &str) -> Self {
        let raw = split(text);
        let mut of_line = vec![0; raw.iter().flat_map(|s| &s.lines).max().map_or(0, |n| *n as usize + 1)];
        for (index, section) in raw.iter().enumerate() {
            for line in &section.lines {
                of_line[*line as usize] = index;
            }
        }
        let holds_code =
            |kind| matches!(kind, SectionKind::Module(_) | SectionKind::Mechanism | SectionKind::Procedure);
        Sections { of_line, all: raw.iter().map(|s| (s.parent, holds_code(s.kind))).collect() }
    }

    fn of(&self, line: u32) -> Option<usize> {
        self.of_line.get((line as usize).checked_sub(1)?).copied()
    }

    /// Both lines lie in the same section with code; the second may lie in one nested in it.
    fn encloses(&self, line: u32, next: u32) -> bool {
        let Some(section) = self.of(line).filter(|n| self.all.get(*n).is_some_and(|s| s.1)) else {
            return false;
        };
        let outwards = std::iter::successors(self.of(next), |n| self.all.get(*n)?.0);
        outwards.take(self.all.len()).any(|n| n == section)
    }
}

impl SourceMap {
    /// Reads the texts of the files to know their sections; one that cannot be read, or has changed since the
    /// build, is done without.
    pub(crate) fn new(root: &Path, program: &Program, debug: &DebugInfo, encoding: Option<Encoding>) -> Self {
        let statements: HashSet<Pc> = program.statements.iter().copied().collect();
        let mut entries = vec![Vec::new(); debug.files.len()];
        for line in debug.lines.iter().filter(|l| statements.contains(&l.pc)) {
            if let Some(file) = entries.get_mut(usize::from(line.file)) {
                file.push(Entry { line: line.line, pc: line.pc, in_debug_region: line.in_debug_region });
            }
        }
        for file in &mut entries {
            file.sort_by_key(|e| (e.line, e.pc));
        }
        let paths: Vec<PathBuf> = debug.files.iter().map(|f| plain(&root.join(&f.path))).collect();
        let sections = paths.iter().zip(&debug.files).map(|(path, file)| {
            let text = decode(&std::fs::read(path).ok()?, encoding).text;
            (hash_bytes(text.as_bytes()) == file.hash).then(|| Sections::new(&text))
        });
        SourceMap { entries, sections: sections.collect(), paths }
    }

    /// Absolute path of a file.
    pub(crate) fn path(&self, file: u16) -> Option<&Path> {
        self.paths.get(usize::from(file)).map(PathBuf::as_path)
    }

    /// The file that an editor calls `path`.
    pub(crate) fn file(&self, path: &str) -> Option<u16> {
        let wanted = plain(Path::new(path));
        let found = self.paths.iter().position(|p| same_path(p, &wanted)).or_else(|| {
            // The same file under another name: symbolic links, short names.
            let real = wanted.canonicalize().ok()?;
            self.paths.iter().position(|p| p.canonicalize().is_ok_and(|p| p == real))
        })?;
        u16::try_from(found).ok()
    }

    /// Lines of the file that can take a break-point, ascending, each once.
    pub(crate) fn lines(&self, file: u16, from: u32, to: u32) -> Vec<u32> {
        let mut lines: Vec<u32> =
            self.entries(file).iter().map(|e| e.line).filter(|l| (from..=to).contains(l)).collect();
        lines.dedup();
        lines
    }

    fn entries(&self, file: u16) -> &[Entry] {
        self.entries.get(usize::from(file)).map_or(&[], Vec::as_slice)
    }

    /// Finds the statement at `line`, or the next one in the same section.
    pub(crate) fn place(
        &self,
        program: &Program,
        debug: &DebugInfo,
        file: u16,
        line: u32,
        everywhere: bool,
    ) -> Result<Placement, NoPlace> {
        let entries = self.entries(file);
        let at = entries.partition_point(|e| e.line < line);
        let first = entries.get(at).ok_or(NoPlace::NoCode)?;
        let before = at.checked_sub(1).and_then(|n| entries.get(n)).map(|e| e.pc);
        let leaves = || match self.sections.get(usize::from(file)) {
            Some(Some(sections)) => !sections.encloses(line, first.line),
            _ => leaves_section(program, debug, (file, line), before, first.pc),
        };
        if first.line != line && leaves() {
            return Err(NoPlace::NoCode);
        }
        let here = entries[at..].iter().take_while(|e| e.line == first.line);
        let mut reason = NoPlace::NoCode;
        let mut pcs = Vec::new();
        for entry in here {
            match module_kind(program, entry.pc) {
                Some(kind) if kind.is_fast() => reason = NoPlace::Fast,
                Some(ModuleKind::Cont) => reason = NoPlace::Cont,
                _ if !everywhere && !entry.in_debug_region => reason = NoPlace::OutsideDebug,
                _ => pcs.push(entry.pc),
            }
        }
        if pcs.is_empty() { Err(reason) } else { Ok(Placement { line: first.line, pcs }) }
    }
}

/// The line lies inside a section, and the next code is not in it any more; as far as code alone tells.
fn leaves_section(
    program: &Program,
    debug: &DebugInfo,
    (file, line): (u16, u32),
    before: Option<Pc>,
    after: Pc,
) -> bool {
    let around = debug.mechanisms.iter().find(|m| m.file == file && (m.lines.0..=m.lines.1).contains(&line));
    if let Some(mechanism) = around {
        return sequence_of(program, after) != Some(mechanism.sequence);
    }
    let Some(before) = before else { return false };
    // A section whose closing line is behind us is over: what follows is between sections.
    let last = program.code.get(before as usize);
    let closed = matches!(last, Some(Op::ModuleEnd | Op::Return | Op::SeqEnd(_)));
    !closed && module_of(program, before) != module_of(program, after)
}

fn sequence_of(program: &Program, pc: Pc) -> Option<u16> {
    program.sequences.iter().position(|s| (s.start..=s.end).contains(&pc)).map(|n| n as u16)
}

fn module_of(program: &Program, pc: Pc) -> Option<u16> {
    program.modules.iter().position(|m| (m.start..m.end).contains(&pc)).map(|n| n as u16)
}

fn module_kind(program: &Program, pc: Pc) -> Option<ModuleKind> {
    if program.procedures.iter().any(|p| (p.start..p.end).contains(&pc)) {
        return None; // whoever calls it decides
    }
    module_of(program, pc).map(|n| program.modules[usize::from(n)].kind)
}

/// Without `.` and `..`, on paper only.
pub(crate) fn plain(path: &Path) -> PathBuf {
    let mut out = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if matches!(out.components().next_back(), Some(Component::Normal(_))) => {
                out.pop();
            }
            other => out.push(other),
        }
    }
    out
}

fn same_path(a: &Path, b: &Path) -> bool {
    if cfg!(windows) {
        let fold = |p: &Path| p.to_string_lossy().replace('/', "\\").to_lowercase();
        fold(a) == fold(b)
    } else {
        a == b
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample;

    #[test]
    fn module_kinds_have_the_indices_of_the_wire() {
        for index in 0..12 {
            assert_eq!(ModuleKind::from_number(index).map(|kind| kind as u8), Some(index));
        }
        assert_eq!(ModuleKind::from_number(12), None);
    }

    #[test]
    fn a_line_without_code_moves_within_its_section_only() {
        let image = sample::image();
        let mut debug = image.debug.clone().unwrap();
        let mut program = image.program;
        // The closing line of SPINDLE takes no break-point here, so nothing is left after its last EX.
        program.statements.retain(|pc| *pc != sample::pc(25));
        debug.mechanisms[0].lines = (18, 25);
        let map = SourceMap::new(Path::new("/p"), &program, &debug, None);
        let place = |line| map.place(&program, &debug, 0, line, true).map(|p| p.line);
        assert_eq!(place(22), Ok(23));
        assert_eq!(place(25), Err(NoPlace::NoCode));
        assert_eq!(place(26), Ok(26));
    }

    #[test]
    fn sections_enclose_what_is_nested_in_them() {
        let text = &sample::texts()[0].1;
        let sections = Sections::new(text);
        for (line, next, inside) in [
            (22, 23, true),
            (10, 11, true),
            (16, 19, true),   // from the module into the mechanism in it
            (22, 26, false),  // out of the mechanism
            (9, 11, false),   // before the module
            (27, 29, false),  // between modules
            (900, 11, false), // nowhere
            (0, 11, false),
        ] {
            assert_eq!(sections.encloses(line, next), inside, "{line} {next}");
        }
    }

    #[test]
    fn a_line_that_is_included_twice_has_two_statements() {
        let image = sample::image();
        let mut debug = image.debug.clone().unwrap();
        for line in &mut debug.lines {
            if line.line == 13 {
                line.line = 11;
            }
        }
        let map = SourceMap::new(Path::new("/p"), &image.program, &debug, None);
        let pcs = map.place(&image.program, &debug, 0, 11, true).unwrap().pcs;
        assert_eq!(pcs, [sample::pc(11), sample::pc(13)]);
        assert_eq!(map.lines(0, 0, 13), [11, 12]);
    }

    #[test]
    fn paths_are_compared_on_paper() {
        for (path, clean) in
            [("/a/./b/../c", "/a/c"), ("/../a", "/../a"), ("a/..", ""), ("../../x", "../../x")]
        {
            assert_eq!(plain(Path::new(path)), Path::new(clean));
        }
    }
}
