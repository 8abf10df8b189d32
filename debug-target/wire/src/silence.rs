//! How long nothing has been heard from the peer.

/// Counts silence, but only time during which this end was itself awake: an end that was held up for a second
/// must not blame its peer for it.
#[derive(Clone, Debug)]
pub(crate) struct Silence {
    limit: Option<u64>,
    step: u64,
    last_look: Option<u64>,
    silent: u64,
}

impl Silence {
    /// `step` is the longest time between two looks that counts in full.
    pub(crate) fn new(limit: Option<u64>, step: u64) -> Self {
        Silence { limit, step, last_look: None, silent: 0 }
    }

    pub(crate) fn heard(&mut self) {
        self.silent = 0;
    }

    /// Lets time pass; true when the peer counts as gone.
    pub(crate) fn look(&mut self, now: u64) -> bool {
        let passed = now.saturating_sub(self.last_look.unwrap_or(now));
        self.last_look = Some(now);
        self.silent = self.silent.saturating_add(passed.min(self.step));
        self.limit.is_some_and(|limit| self.silent >= limit)
    }

    /// When to look again.
    pub(crate) fn deadline(&self, now: u64) -> Option<u64> {
        let left = self.limit?.saturating_sub(self.silent);
        Some(now + left.min(self.step).max(1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn silence_adds_up_only_while_this_end_is_awake() {
        let mut silence = Silence::new(Some(900), 100);
        assert!(!silence.look(0));
        for now in [100, 200, 300] {
            assert!(!silence.look(now));
        }
        assert!(!silence.look(100_000), "a long sleep of this end counts as one step");
        silence.heard();
        for step in 1..9 {
            assert!(!silence.look(100_000 + step * 100));
        }
        assert!(silence.look(100_900));
    }

    #[test]
    fn a_link_that_tells_itself_has_no_limit() {
        let mut silence = Silence::new(None, 100);
        assert!(!(0..10_000).any(|n| silence.look(n * 100)));
        assert_eq!(silence.deadline(5), None);
    }
}
