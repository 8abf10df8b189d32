//! Changes of a text by tokens and lines, with words of the language and pieces of other texts.

use technol_analysis::catalogue;

use super::input::{EDIT, FILE};

/// Words that are not in the catalogue, marks, numbers and whole lines that matter.
const PIECES: &[&str] = &[
    "DATA",
    "DATA_END",
    "DATA_LOCAL",
    "DATA_LOCAL_END",
    "MODULE_MAIN",
    "MODULE_MAIN_END",
    "MODULE_INIT",
    "MODULE_INPUT_END",
    "STOP",
    "DUP",
    "?",
    "$",
    "TMAC.",
    "BYTE.",
    "WORD.",
    "HIGH.",
    "(",
    ")",
    "((",
    "[",
    "]",
    "'",
    "''",
    "\"",
    ";",
    ":",
    ",",
    "+",
    "-",
    "*",
    "/",
    "<",
    ">",
    "=",
    "&",
    "&#1;",
    "<!--",
    "-->",
    "<![CDATA[",
    "/>",
    "0",
    "1",
    "7",
    "8",
    "255",
    "256",
    "65535",
    "65536",
    "4294967295",
    "4294967296",
    "18446744073709551616",
    "-1",
    "0FFFFFFFFh",
    "0F8h",
    "1.8",
    "3.",
    ".5",
    "1e308",
    "101b",
    "\t",
    "\r",
    "\r\n",
    "\n",
    "\u{1a}",
    "\u{a0}",
    "\u{feff}",
    "ž",
    "€",
    "‘",
    "’",
    "\0",
    ".3",
    ".63",
    "DEF_T_MACRO M A,B\nM TMAC.A,B\nEND_T_MACRO T_END\n",
    "DEF_T_MACRO",
    "END_T_MACRO",
    "T_LOCAL X\n",
    "CONTROL_T_MACRO POS\n",
    "T_INCLUDE main.plc\n",
    "; technol: allow(T1101)\n",
    "X: DS 100 DUP(100 DUP(1))\n",
    "[project]\n",
    "files = [\"b.plc\"]\n",
    "[lints]\n",
    "<?xml version=\"1.0\"?>",
    "Item=",
    "Value=\"1\"",
];

/// Paths of files that mean something.
const NAMES: &[&str] = &[
    "main.plc",
    "b.plc",
    "x.inc",
    "technol.toml",
    "Channel0.ChannelConfig",
    "Plc0.PlcErrors",
    "a.PlcConstants",
    "a.PlcTDef",
    "a.PlcT",
    "Panel.KbdConfig",
];

/// Changes texts; the same seed and text give the same change.
pub(crate) struct Mutator {
    seeds: Vec<Vec<u8>>,
    words: Vec<&'static str>,
}

/// Split mix: small, and the same everywhere.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number below `count`; 0 when there is none.
    fn below(&mut self, count: usize) -> usize {
        if count == 0 { 0 } else { (self.next() % count as u64) as usize }
    }
}

impl Mutator {
    pub(crate) fn new(seeds: Vec<Vec<u8>>) -> Mutator {
        assert!(!seeds.is_empty(), "there is something to begin with");
        let mut words: Vec<&'static str> = catalogue::entries().map(|entry| entry.name).collect();
        words.extend(catalogue::Prefix::ALL.iter().map(|prefix| prefix.name()));
        Mutator { seeds, words }
    }

    /// The text after one to five changes, cut at `longest` bytes.
    pub(crate) fn mutate(&self, text: &[u8], longest: usize, seed: u64) -> Vec<u8> {
        let mut random = Random(seed ^ ((text.len() as u64) << 32));
        let mut text = text.to_vec();
        if text.len() < 2 || random.below(24) == 0 {
            text.clone_from(&self.seeds[random.below(self.seeds.len())]);
        }
        for _ in 0..=random.below(5) {
            text = match random.below(12) {
                0..=5 => self.tokens_changed(&text, &mut random),
                6..=8 => self.lines_changed(&text, &mut random),
                9 => new_edit(&text, &mut random),
                10 => further_file(&text, &mut random),
                _ => numbers_changed(&text, &mut random),
            };
        }
        text.truncate(longest);
        text
    }

    fn piece(&self, text: &[&[u8]], random: &mut Random) -> Vec<u8> {
        match random.below(4) {
            0 => PIECES[random.below(PIECES.len())].as_bytes().to_vec(),
            1 => self.words[random.below(self.words.len())].as_bytes().to_vec(),
            2 => {
                let seed = tokens(&self.seeds[random.below(self.seeds.len())]);
                seed.get(random.below(seed.len())).map(|token| token.to_vec()).unwrap_or_default()
            }
            _ => text.get(random.below(text.len())).map(|token| token.to_vec()).unwrap_or_default(),
        }
    }

    fn tokens_changed(&self, text: &[u8], random: &mut Random) -> Vec<u8> {
        let mut all = tokens(text);
        let new = self.piece(&all, random);
        let (at, other) = (random.below(all.len()), random.below(all.len()));
        match random.below(5) {
            0 if !all.is_empty() => drop(all.remove(at)),
            1 if !all.is_empty() => all.swap(at, other),
            2 if !all.is_empty() => all[at] = &new,
            3 if !all.is_empty() => all.insert(at, all[other]),
            _ => all.insert(at, &new),
        }
        all.concat()
    }

    fn lines_changed(&self, text: &[u8], random: &mut Random) -> Vec<u8> {
        let mut all: Vec<&[u8]> = text.split_inclusive(|byte| *byte == b'\n').collect();
        let seed = &self.seeds[random.below(self.seeds.len())];
        let others: Vec<&[u8]> = seed.split_inclusive(|byte| *byte == b'\n').collect();
        let (at, other) = (random.below(all.len()), random.below(all.len()));
        let to = (at + 1 + random.below(6)).min(all.len());
        match random.below(6) {
            0 => drop(all.drain(at.min(to)..to)),
            1 if !all.is_empty() => all.swap(at, other),
            2 if !all.is_empty() => all.insert(at, all[other]),
            3 => {
                let block = all[at.min(to)..to].to_vec();
                for _ in 0..=random.below(8) {
                    all.splice(other..other, block.iter().copied());
                }
            }
            _ => {
                let from = random.below(others.len());
                let to = (from + 1 + random.below(8)).min(others.len());
                all.splice(at..at, others[from..to].iter().copied());
            }
        }
        all.concat()
    }
}

/// Another `;edit` line.
fn new_edit(text: &[u8], random: &mut Random) -> Vec<u8> {
    let rest = if text.starts_with(EDIT) {
        text.split_inclusive(|byte| *byte == b'\n').skip(1).collect::<Vec<_>>().concat()
    } else {
        text.to_vec()
    };
    let from = random.below(1001);
    let longest = 10 * (1 + random.below(60));
    let to = (from + random.below(1 + longest)).min(1000);
    [format!(";edit {} {from} {to}\n", random.below(4)).into_bytes(), rest].concat()
}

/// From some line on it is another file.
fn further_file(text: &[u8], random: &mut Random) -> Vec<u8> {
    let mut all: Vec<&[u8]> = text.split_inclusive(|byte| *byte == b'\n').collect();
    let line = [FILE, NAMES[random.below(NAMES.len())].as_bytes(), b"\n"].concat();
    all.insert(random.below(all.len() + 1), &line);
    all.concat()
}

/// A number is one more, or quite another one.
fn numbers_changed(text: &[u8], random: &mut Random) -> Vec<u8> {
    let mut all = tokens(text);
    let places: Vec<usize> =
        (0..all.len()).filter(|at| all[*at].first().is_some_and(u8::is_ascii_digit)).collect();
    let Some(at) = places.get(random.below(places.len())).copied() else { return text.to_vec() };
    let old = std::str::from_utf8(all[at]).ok().and_then(|digits| digits.parse::<u64>().ok()).unwrap_or(0);
    let new = match random.below(4) {
        0 => old.wrapping_add(1),
        1 => old.wrapping_sub(1),
        2 => 1 << random.below(64),
        _ => random.next() >> random.below(64),
    };
    let new = new.to_string();
    all[at] = new.as_bytes();
    all.concat()
}

/// Words, blanks, ends of lines, and every other byte for itself.
fn tokens(text: &[u8]) -> Vec<&[u8]> {
    let class = |byte: u8| match byte {
        b' ' | b'\t' => 1,
        b'_' | b'.' | 0x80.. => 2,
        _ if byte.is_ascii_alphanumeric() => 2,
        _ => 0,
    };
    text.chunk_by(|a, b| (class(*a) == class(*b) && class(*a) != 0) || (*a, *b) == (b'\r', b'\n')).collect()
}
