//! Transfers that take a cycle: what an instruction asked for is done when its line is executed in the cycle after. A
//! line that was not executed in the cycle before begins anew.

use alloc::collections::BTreeMap;

use technol_runtime::Call;

/// Milliseconds of a cycle.
const CYCLE: u64 = 20;

/// Transfers under way by the number of their call; as many as the program has such lines at most.
#[derive(Clone, Debug)]
pub(super) struct Transfers<T>(BTreeMap<u16, Transfer<T>>);

#[derive(Clone, Debug)]
struct Transfer<T> {
    begun: u64,
    /// Last time the line was executed.
    seen: u64,
    request: T,
}

impl<T> Default for Transfers<T> {
    fn default() -> Transfers<T> {
        Transfers(BTreeMap::new())
    }
}

impl<T> Transfers<T> {
    /// Whether the transfer of this call is still under way, executed in this cycle or the one before.
    pub(super) fn is_under_way(&self, call: &Call<'_>) -> bool {
        let lives = |it: &Transfer<T>| call.millis().checked_sub(it.seen).is_some_and(|past| past <= CYCLE);
        self.0.get(&call.index()).is_some_and(lives)
    }

    /// Begins the transfer of this call anew.
    pub(super) fn begin(&mut self, call: &Call<'_>, request: T) {
        let now = call.millis();
        self.0.insert(call.index(), Transfer { begun: now, seen: now, request });
    }

    /// The request, once, when its cycle has passed.
    pub(super) fn end(&mut self, call: &Call<'_>) -> Option<T> {
        let now = call.millis();
        let transfer = self.0.get_mut(&call.index())?;
        transfer.seen = now;
        if now.saturating_sub(transfer.begun) < CYCLE {
            return None;
        }
        self.0.remove(&call.index()).map(|transfer| transfer.request)
    }
}
