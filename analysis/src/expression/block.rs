//! Members of the prepared blocks, `BLK[1].T`, `BLK[0].REAL.AxNC[2]`, as a debugger reads them.

use technol_image::system::{BLOCK_RECORD_COUNT, BLOCK_RECORDS, block_record};

use super::parse::{number, prefix};
use super::{ExpressionError, Target};
use crate::catalogue::{self, SystemKind};
use crate::semantics::program::width;

/// What an expression that begins with `BLK[` stands for; `None` for other expressions.
pub(super) fn resolve(text: &str) -> Option<Result<Target, ExpressionError>> {
    let text = text.trim();
    let (name, rest) = text.split_at_checked(3)?;
    let rest = rest.trim_start().strip_prefix('[').filter(|_| name.eq_ignore_ascii_case("BLK"))?;
    Some(member(text, rest))
}

/// `rest` is what stands behind `BLK[`.
fn member(text: &str, rest: &str) -> Result<Target, ExpressionError> {
    let unknown = || ExpressionError::Unknown(text.to_owned(), None);
    let (index, behind) = rest.split_once(']').ok_or(ExpressionError::Unexpected(0, String::new()))?;
    let block = number(index.trim()).ok_or_else(|| ExpressionError::Number(index.trim().to_owned()))?;
    let block =
        u32::try_from(block).ok().filter(|n| *n < BLOCK_RECORD_COUNT).ok_or(ExpressionError::Address)?;
    let path = behind.trim_start().strip_prefix('.').ok_or_else(unknown)?;
    let (typed, path) = match path.split_once('.') {
        Some((name, path)) => (Some(prefix(name.trim()).ok_or_else(unknown)?), path),
        None => (None, path),
    };
    let (name, element) = match path.trim().strip_suffix(']').and_then(|path| path.split_once('[')) {
        Some((name, index)) => {
            let element =
                number(index.trim()).ok_or_else(|| ExpressionError::Number(index.trim().to_owned()))?;
            (name.trim(), Some(element))
        }
        None => (path.trim(), None),
    };
    let member = catalogue::block_member(name).ok_or_else(unknown)?;
    let base = BLOCK_RECORDS + block * block_record::LEN;
    let cell = |offset: u32, declared| match typed {
        Some(prefix) => {
            let addr = super::moved(base + offset, prefix.offset)?;
            Ok(Target::Cell { addr, width: prefix.width })
        }
        None => Ok(Target::Cell { addr: base + offset, width: width(declared) }),
    };
    match (member.kind, element) {
        (SystemKind::Bit { addr, bit }, None) if typed.is_none() => {
            Ok(Target::Bit { addr: base + addr, bit })
        }
        (SystemKind::Cell { addr, prefix }, None) => cell(addr, prefix),
        (SystemKind::Array { addr, element: prefix, len }, Some(element)) => {
            let n = u32::try_from(element).ok().filter(|n| *n < len).ok_or(ExpressionError::Address)?;
            cell(addr + n * prefix.bytes(), prefix)
        }
        (SystemKind::Array { .. }, None) => Err(ExpressionError::NeedsType(name.to_owned())),
        _ => Err(unknown()),
    }
}

#[cfg(test)]
mod tests {
    use technol_image::op::Width;

    use super::*;

    fn at(block: u32, offset: u32, width: Width) -> Target {
        Target::Cell { addr: BLOCK_RECORDS + block * block_record::LEN + offset, width }
    }

    #[test]
    fn members_are_found_in_their_record() {
        let bit = |addr, bit| Target::Bit { addr: BLOCK_RECORDS + addr, bit };
        for (text, expected) in [
            ("BLK[0].M3", bit(0, 3)),
            ("blk[1].lastblock", bit(block_record::LEN + 5, 6)),
            ("BLK[2].T", at(2, block_record::T, Width::DWord)),
            (" BLK [ 1 ] . WORD . T ", at(1, block_record::T, Width::Word)),
            ("BLK[0].M[14]", at(0, block_record::M + 56, Width::DWord)),
            ("BLK[16].REAL.AxNC[15]", at(16, block_record::AXES + 120, Width::Real)),
            ("BLK[0].H", at(0, block_record::H, Width::Real)),
        ] {
            assert_eq!(resolve(text), Some(Ok(expected)), "{text}");
        }
        for text in ["BLK", "T", "BLKX[0].T", "BL", "ž[0]", "BLKÁ[0]"] {
            assert_eq!(resolve(text), None, "{text}");
        }
        for text in [
            "BLK[0]",
            "BLK[0].",
            "BLK[",
            "BLK[].T",
            "BLK[BX].T",
            "BLK[17].T",
            "BLK[-1].T",
            "BLK[0].NOBODY",
            "BLK[0].M[15]",
            "BLK[0].M",
            "BLK[0].T[0]",
            "BLK[0].REAL.M3",
            "BLK[0].SHOE.T",
            "BLK[0].M3.1",
            "BLK[99999999999].T",
        ] {
            assert!(matches!(resolve(text), Some(Err(_))), "{text}");
        }
    }
}
