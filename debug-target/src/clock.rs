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
}

impl Pacer {
    pub(crate) fn new() -> Self {
        Pacer { next: Instant::now() }
    }

    pub(crate) fn next(&self) -> Instant {
        self.next
    }

    pub(crate) fn is_due(&self, now: Instant) -> bool {
        now >= self.next
    }

    /// The next cycle is due now: somebody waits for its effect.
    pub(crate) fn at_once(&mut self) {
        self.next = self.next.min(Instant::now());
    }

    /// The cycle that was due has run from `began` to `ended`; true when it took longer than a cycle may.
    pub(crate) fn done(&mut self, began: Instant, ended: Instant) -> bool {
        self.next += CYCLE;
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
        let start = pacer.next();
        let ms = |n| start + Duration::from_millis(n);
        assert!(pacer.is_due(start));
        assert!(!pacer.done(ms(3), ms(4)));
        assert_eq!(pacer.next(), ms(20), "being late does not move the next one");
        assert!(!pacer.is_due(ms(19)));
        assert!(pacer.done(ms(20), ms(45)), "25 ms are too long");
        assert_eq!(pacer.next(), ms(40), "but are caught up");
        pacer.done(ms(900), ms(901));
        assert_eq!(pacer.next(), ms(901), "a pause of most of a second is not");
    }
}
