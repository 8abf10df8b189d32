//! The calendar clock of the control (manual 8.4.2). It begins where the description says and goes on with PLC time, so
//! that a run gives the same each time; a host that runs in real time may set it.

use alloc::format;
use alloc::string::String;

use technol_image::op::Addr;

use crate::motion::Cells;

/// SYST_TIME_INFO and SYST_DATE_INFO, then UTC_TIME_INFO and UTC_DATE_INFO: four bytes each.
const LOCAL: Addr = 0x1357;
const UTC: Addr = 0x135F;
/// FILETIME_INFO: hundreds of nanoseconds since 1601.
const FILETIME: Addr = 0x1367;

const DAY: i64 = 86_400_000;
/// Days from 1601 to 2000; both begin a period of 400 years with their calendar.
const SINCE_1601: i64 = 145_731;
/// The first and the last year that can be set.
const YEARS: core::ops::RangeInclusive<i64> = 1980..=2999;

/// A clock.
#[derive(Clone, Debug, Default)]
pub(super) struct Clock {
    /// UTC in milliseconds since the beginning of 2000.
    now: i64,
    /// What local time is ahead.
    ahead: i64,
}

impl Clock {
    /// It shows this local time; `offset` minutes ahead of UTC.
    pub(super) fn of(text: Option<&str>, offset: i32) -> Clock {
        let ahead = i64::from(offset) * 60_000;
        let local = text.and_then(|text| parse(text).ok()).unwrap_or(ahead);
        Clock { now: local - ahead, ahead }
    }

    /// It shows a time: milliseconds since 1970, UTC.
    pub(super) fn set(&mut self, unix_millis: i64) {
        self.now = unix_millis.saturating_sub(10_957 * DAY).clamp(-20 * 366 * DAY, 1000 * 365 * DAY);
    }

    /// A millisecond.
    pub(super) fn tick(&mut self) {
        self.now += 1;
    }

    /// Brings the cells up to date.
    pub(super) fn tell(&self, cells: &mut Cells<'_>) {
        show(cells, LOCAL, self.now + self.ahead);
        show(cells, UTC, self.now);
        cells.set_qword(FILETIME, (self.now + SINCE_1601 * DAY) * 10_000);
    }
}

/// Minutes, hours, hundredths and seconds; year, day and month.
fn show(cells: &mut Cells<'_>, at: Addr, millis: i64) {
    let of_day = millis.rem_euclid(DAY);
    let part = |unit: i64, count: i64| (of_day / unit % count) as u8;
    let time = [part(60_000, 60), part(3_600_000, 24), part(10, 100), part(1000, 60)];
    for (byte, value) in (at..).zip(time) {
        cells.set_byte(byte, value);
    }
    let (year, month, day) = date(millis.div_euclid(DAY));
    cells.set_word(at + 4, year as u16);
    cells.set_byte(at + 6, day as u8);
    cells.set_byte(at + 7, month as u8);
}

/// Days of a year from 1 March up to each month, March first.
const fn days_before(month_from_march: i64) -> i64 {
    (153 * month_from_march + 2) / 5
}

/// Year, month and day of a number of days since the beginning of 2000.
fn date(days: i64) -> (i64, i64, i64) {
    // Counted from 1 March 2000, a leap day is the last of its year.
    let days = days - 60;
    let (period, day) = (days.div_euclid(146_097), days.rem_euclid(146_097));
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let of_year = day - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let begins_next = i64::from(month >= 10);
    (2000 + 400 * period + year + begins_next, (month + 2) % 12 + 1, of_year - days_before(month) + 1)
}

/// Days since the beginning of 2000.
fn days(year: i64, month: i64, day: i64) -> i64 {
    let year = if month < 3 { year - 1 } else { year } - 2000;
    let (period, year) = (year.div_euclid(400), year.rem_euclid(400));
    let of_year = days_before((month + 9) % 12) + day - 1;
    period * 146_097 + year * 365 + year / 4 - year / 100 + of_year + 60
}

/// Milliseconds of `2026-03-01 06:30:00` since the beginning of 2000.
fn parse(text: &str) -> Result<i64, String> {
    let wrong = || format!("`{text}` is no time; write it as \"2026-03-01 06:30:00\"");
    let numbers = |text: &str, sign: char| -> Option<[i64; 3]> {
        let mut parts = text.split(sign).map(|part| {
            let digits =
                !part.is_empty() && part.len() <= 4 && part.bytes().all(|byte| byte.is_ascii_digit());
            digits.then(|| part.parse::<i64>().ok())?
        });
        let three = [parts.next()??, parts.next()??, parts.next()??];
        parts.next().is_none().then_some(three)
    };
    let (left, right) = text.trim().split_once([' ', 'T']).ok_or_else(wrong)?;
    let [year, month, day] = numbers(left, '-').ok_or_else(wrong)?;
    let [hour, minute, second] = numbers(right, ':').ok_or_else(wrong)?;
    let all = days(year, month, day);
    let exists = (1..=12).contains(&month) && date(all) == (year, month, day);
    if !YEARS.contains(&year) || !exists || hour > 23 || minute > 59 || second > 59 {
        return Err(wrong());
    }
    Ok(all * DAY + ((hour * 60 + minute) * 60 + second) * 1000)
}

/// What is wrong with the text of a time.
pub(crate) fn check(text: &str) -> Result<(), String> {
    parse(text).map(drop)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_and_dates_are_the_same_thing() {
        for (day, expected) in [
            (0, (2000, 1, 1)),
            (59, (2000, 2, 29)),
            (60, (2000, 3, 1)),
            (366, (2001, 1, 1)),
            (-1, (1999, 12, 31)),
            (-36_465, (1900, 3, 1)),
            (9_496, (2025, 12, 31)),
            (36_583, (2100, 2, 28)),
            (36_584, (2100, 3, 1)),
        ] {
            assert_eq!(date(day), expected, "{day}");
            let (year, month, of_month) = expected;
            assert_eq!(days(year, month, of_month), day, "{expected:?}");
        }
        for day in -150_000..200_000 {
            let (year, month, of_month) = date(day);
            assert_eq!(days(year, month, of_month), day);
        }
    }

    #[test]
    fn a_time_is_read_or_refused() {
        assert_eq!(parse("2000-01-01 00:00:01"), Ok(1000));
        assert_eq!(parse("2000-03-01T06:30:00"), Ok(60 * DAY + 23_400_000));
        for wrong in [
            "",
            "2026-03-01",
            "2026-02-29 00:00:00",
            "2026-13-01 00:00:00",
            "2026-00-10 00:00:00",
            "2026-01-01 24:00:00",
            "2026-01-01 00:60:00",
            "2026-01-01 00:00:00:0",
            "1601-01-01 00:00:00",
            "99999-01-01 0:0:0",
        ] {
            assert!(parse(wrong).is_err(), "{wrong}");
        }
    }
}
