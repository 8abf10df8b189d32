//! Changes words, numbers and lines of a text, so that most of it still means something.

/// Numbers at which something ends.
const NUMBERS: &[&str] = &[
    "0",
    "1",
    "-1",
    "7",
    "8",
    "255",
    "256",
    "65535",
    "65536",
    "2147483647",
    "4294967295",
    "4294967296",
    "9223372036854775807",
    "-9223372036854775808",
    "0.0",
    "1e300",
    "nan",
    "inf",
    "-0.5",
    "true",
    "\"\"",
    "[]",
    "{}",
];

/// The text with some changes; words come from the other texts too. The same seed makes the same changes.
pub(crate) fn mutate(text: &str, others: &[String], seed: u64) -> String {
    let mut random = Random(seed ^ 0x9E37_79B9_7F4A_7C15);
    let mut text = text.to_owned();
    for _ in 0..=random.below(3) {
        text = match random.below(8) {
            0 => lines(&text, others, &mut random),
            1 => bytes(&text, &mut random),
            _ => words(&text, others, &mut random),
        };
    }
    text
}

struct Random(u64);

impl Random {
    /// A number below another, which is not 0.
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % end
    }
}

fn lines(text: &str, others: &[String], random: &mut Random) -> String {
    let mut lines: Vec<&str> = text.lines().collect();
    if lines.is_empty() {
        return text.to_owned();
    }
    let (at, to) = (random.below(lines.len()), random.below(lines.len()));
    let other = others.get(random.below(others.len().max(1))).map_or("", String::as_str);
    match random.below(4) {
        0 => drop(lines.remove(at)),
        1 => lines.insert(to, lines[at]),
        2 => lines.swap(at, to),
        _ => lines.insert(at, other.lines().nth(random.below(other.lines().count().max(1))).unwrap_or("")),
    }
    lines.join("\n")
}

fn bytes(text: &str, random: &mut Random) -> String {
    let mut bytes = text.as_bytes().to_vec();
    if !bytes.is_empty() {
        let at = random.below(bytes.len());
        bytes[at] = random.below(256) as u8;
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn words(text: &str, others: &[String], random: &mut Random) -> String {
    let mut words = split(text);
    let real: Vec<usize> = (0..words.len()).filter(|at| !words[*at].trim().is_empty()).collect();
    if real.is_empty() {
        return text.to_owned();
    }
    let at = real[random.below(real.len())];
    let other = others.get(random.below(others.len().max(1))).map_or("", String::as_str);
    let theirs = split(other);
    match random.below(4) {
        0 => words[at] = "",
        1 => words[at] = words[real[random.below(real.len())]],
        2 if !theirs.is_empty() => words[at] = theirs[random.below(theirs.len())],
        _ => {
            // A number for a number, mostly: elsewhere it is a mistake of form at once.
            let numbers: Vec<usize> = real
                .iter()
                .copied()
                .filter(|at| words[*at].starts_with(|c: char| c.is_ascii_digit()))
                .collect();
            let at = if numbers.is_empty() { at } else { numbers[random.below(numbers.len())] };
            words[at] = NUMBERS[random.below(NUMBERS.len())];
        }
    }
    words.concat()
}

/// Words, and the single characters between them.
fn split(text: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut start = 0;
    for (at, c) in text.char_indices() {
        if !(c.is_alphanumeric() || c == '_' || c == '-') {
            if start < at {
                words.push(&text[start..at]);
            }
            words.push(&text[at..at + c.len_utf8()]);
            start = at + c.len_utf8();
        }
    }
    if start < text.len() {
        words.push(&text[start..]);
    }
    words
}

/// The same for a fuzzer, which gives `size` bytes and room for `max`; answers the new length. Of nothing one of the seeds is made.
#[allow(dead_code)] // only fuzz targets use it
pub(crate) fn mutate_in_place(
    data: &mut [u8],
    size: usize,
    max: usize,
    seeds: &[String],
    seed: u32,
) -> usize {
    let own = String::from_utf8_lossy(&data[..size]).into_owned();
    let begin =
        if size < 8 || seed.is_multiple_of(31) { &seeds[seed as usize / 31 % seeds.len()] } else { &own };
    let changed = mutate(begin, seeds, u64::from(seed));
    let len = changed.len().min(max);
    data[..len].copy_from_slice(&changed.as_bytes()[..len]);
    len
}
