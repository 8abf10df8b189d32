//! Reading a block that the control starts: the keys of `[[block]]` in machine.toml, without its triggers.

use technol_machine::{BlockExtra, BlockFlag, BlockMode, BlockStart};
use toml::de::{DeTable, DeValue};

use super::super::fields::{Node, Source, get, integer};
use super::step::{LONGEST, one_of};

pub(super) const BLOCK: &[&str] = &[
    "m",
    "s",
    "t",
    "h",
    "motion-ms",
    "rapid",
    "mode",
    "speed",
    "cutting-speed",
    "speed-limit",
    "feed",
    "feed-max",
    "length-mm",
    "dwell",
    "scale",
    "integers",
    "reals",
    "axes",
    "flags",
];
const MODES: [(&str, BlockMode); 4] = [
    ("auto", BlockMode::Auto),
    ("central-annulment", BlockMode::CentralAnnulment),
    ("reference", BlockMode::Reference),
    ("other", BlockMode::Other),
];
const FLAGS: [(&str, BlockFlag); 8] = [
    ("backward", BlockFlag::Backward),
    ("selected", BlockFlag::Selected),
    ("approach", BlockFlag::Approach),
    ("without-technology", BlockFlag::WithoutTechnology),
    ("rev-feed", BlockFlag::RevFeed),
    ("continuous", BlockFlag::Continuous),
    ("const-cut-speed", BlockFlag::ConstCutSpeed),
    ("thread", BlockFlag::Thread),
];
/// Parameters of each kind that a block has.
const PARAMETERS: usize = 5;
/// Highest number of an NC axis.
const LAST_AXIS: i128 = 15;

pub(super) fn block(table: &DeTable<'_>, source: &mut Source<'_>) -> BlockStart {
    source.known(table, "a block", BLOCK);
    let mut number = |key: &str, most: u64| {
        let node = get(table, key)?;
        source.number(node, &format!("`{key}`"), most)
    };
    let s = number("s", 0x7FFF);
    let t = number("t", 99_999_999);
    let h = number("h", 99);
    let motion_ms = number("motion-ms", LONGEST);
    let m = get(table, "m").map(|node| source.numbers(node, "an M function", 99)).unwrap_or_default();
    let rapid = get(table, "rapid").and_then(|node| source.boolean(node, "`rapid`"));
    let mode = get(table, "mode").and_then(|node| one_of(node, "mode", &MODES, source));
    BlockStart {
        m: m.into_iter().map(|m| m as u8).collect(),
        s: s.map(|s| s as u16),
        t: t.map(|t| t as u32),
        h: h.map(|h| h as u8),
        motion_ms: motion_ms.unwrap_or(0) as u32,
        rapid: rapid.unwrap_or(false),
        mode: mode.unwrap_or_default(),
        extra: extra(table, source),
    }
}

/// What a block tells beyond its functions.
fn extra(table: &DeTable<'_>, source: &mut Source<'_>) -> BlockExtra {
    let mut single = |key: &str| {
        let node = get(table, key)?;
        let value = real(node);
        if value.is_none() {
            source.error(node.span().start, format!("`{key}` is a number"));
        }
        value
    };
    BlockExtra {
        // Each is a program of its own.
        first: true,
        last: true,
        speed: single("speed"),
        cutting_speed: single("cutting-speed"),
        speed_limit: single("speed-limit"),
        feed: single("feed"),
        feed_max: single("feed-max"),
        length: single("length-mm"),
        dwell: single("dwell"),
        scale: single("scale"),
        integers: list(table, "integers", "whole numbers", source, |node| i32::try_from(integer(node)?).ok()),
        reals: list(table, "reals", "numbers", source, real),
        axes: axes(table, source),
        flags: flags(table, source),
    }
}

/// At most five parameters.
fn list<T>(
    table: &DeTable<'_>,
    key: &str,
    what: &str,
    source: &mut Source<'_>,
    one: impl Fn(&Node<'_>) -> Option<T>,
) -> Vec<T> {
    let Some(node) = get(table, key) else { return Vec::new() };
    let values: Option<Vec<T>> = match node.get_ref() {
        DeValue::Array(nodes) if nodes.len() <= PARAMETERS => nodes.iter().map(one).collect(),
        _ => None,
    };
    if values.is_none() {
        source.error(node.span().start, format!("`{key}` is an array of at most {PARAMETERS} {what}"));
    }
    values.unwrap_or_default()
}

/// Pairs of an NC axis and its target: `[[0, 12.5], [2, -3.0]]`.
fn axes(table: &DeTable<'_>, source: &mut Source<'_>) -> Vec<(u8, f64)> {
    let Some(node) = get(table, "axes") else { return Vec::new() };
    let pair = |node: &Node<'_>| match node.get_ref() {
        DeValue::Array(pair) => match pair.iter().collect::<Vec<_>>().as_slice() {
            [axis, target] => {
                let axis = integer(axis).filter(|axis| (0..=LAST_AXIS).contains(axis))?;
                Some((axis as u8, real(target)?))
            }
            _ => None,
        },
        _ => None,
    };
    let pairs: Option<Vec<(u8, f64)>> = match node.get_ref() {
        DeValue::Array(nodes) => nodes.iter().map(pair).collect(),
        _ => None,
    };
    if pairs.is_none() {
        let message =
            format!("`axes` is an array of pairs: NC axis (0 to {LAST_AXIS}) and target in mm, [[0, 12.5]]");
        source.error(node.span().start, message);
    }
    pairs.unwrap_or_default()
}

fn flags(table: &DeTable<'_>, source: &mut Source<'_>) -> Vec<BlockFlag> {
    let Some(node) = get(table, "flags") else { return Vec::new() };
    match node.get_ref() {
        DeValue::Array(nodes) => {
            nodes.iter().filter_map(|node| one_of(node, "flags", &FLAGS, source)).collect()
        }
        _ => one_of(node, "flags", &FLAGS, source).into_iter().collect(),
    }
}

/// A number with or without a decimal point; finite.
fn real(node: &Node<'_>) -> Option<f64> {
    let value = match node.get_ref() {
        DeValue::Float(value) => value.as_str().parse().ok()?,
        _ => integer(node)? as f64,
    };
    value.is_finite().then_some(value)
}
