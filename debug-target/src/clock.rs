//! When the next cycle is due.

use std::time::{Duration, Instant};

/// The 20 ms cycle.
pub(crate) const CYCLE: Duration = Duration::from_millis(20);
/// A target that was held up for longer than this does not catch up.
const MOST_BEHIND: Duration = Duration::from_millis(200);

/// Deadlines 20 ms apart, without drift.
#[derive(Debug)]
pub(crate) struct Pacer {
    next: Instant,
    /// The next cycle does not wait for its deadline.
    soon: bool,
}

impl Pacer {
    pub(crate) fn new() -> Self {
        Pacer { next: Instant::now(), soon: false }
    }

    /// When the next cycle is due, seen at `now`.
    pub(crate) fn next(&self, now: Instant) -> Instant {
        if self.soon { self.next.min(now) } else { self.next }
    }

    pub(crate) fn is_due(&self, now: Instant) -> bool {
        self.soon || now >= self.next
    }

    /// The next cycle is due now: somebody waits for its effect.
    pub(crate) fn at_once(&mut self) {
        self.soon = true;
    }

    /// The cycle that was due has run from `began` to `ended`; true when it took longer than a cycle may.
    pub(crate) fn done(&mut self, began: Instant, ended: Instant) -> bool {
        self.next = self.next(began) + CYCLE;
        self.soon = false;
        if ended > self.next + MOST_BEHIND {
            self.next = ended;
        }
        ended.saturating_duration_since(began) > CYCLE
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cycles_keep_their_distance_and_a_long_pause_is_not_caught_up() {
        let mut pacer = Pacer::new();
        let start = pacer.next;
        let ms = |n| start + Duration::from_millis(n);
        assert!(pacer.is_due(start));
        assert!(!pacer.done(ms(3), ms(4)));
        assert_eq!(pacer.next, ms(20), "being late does not move the next one");
        assert!(!pacer.is_due(ms(19)));
        assert!(pacer.done(ms(20), ms(45)), "25 ms are too long");
        assert_eq!(pacer.next, ms(40), "but are caught up");
        pacer.done(ms(900), ms(901));
        assert_eq!(pacer.next, ms(901), "a pause of most of a second is not");
    }
    #[test]
    fn a_cycle_that_somebody_waits_for_moves_the_ones_after_it() {
        let mut pacer = Pacer::new();
        let start = pacer.next;
        let ms = |n| start + Duration::from_millis(n);
        pacer.done(ms(0), ms(1));
        pacer.at_once();
        assert!(pacer.is_due(ms(5)));
        assert_eq!(pacer.next(ms(5)), ms(5));
        pacer.done(ms(5), ms(6));
        assert_eq!(pacer.next(ms(6)), ms(25));
        assert!(!pacer.is_due(ms(6)));
    }
}
