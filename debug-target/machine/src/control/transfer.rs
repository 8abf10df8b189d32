//! Transfers that take several cycles: what an instruction asked for is done when its line is executed in a later
//! cycle. A line that was not executed in the cycle before begins anew.

use alloc::vec::Vec;

use technol_runtime::{Call, FaultKind};

/// Milliseconds of a cycle.
const CYCLE: u64 = 20;

/// Transfers by the number of their call, ascending; as many as the program has such lines at most. A place stays when its
/// transfer ends, so that the next one needs no memory.
#[derive(Clone, Debug)]
pub(super) struct Transfers<T>(Vec<Transfer<T>>);

#[derive(Clone, Debug)]
struct Transfer<T> {
    call: u16,
    under_way: bool,
    begun: u64,
    /// Last time the line was executed.
    seen: u64,
    request: T,
}

impl<T> Default for Transfers<T> {
    fn default() -> Transfers<T> {
        Transfers(Vec::new())
    }
}

impl<T> Transfers<T> {
    /// Makes a place for a call, before the program runs.
    pub(super) fn prepare(&mut self, call: u16, request: T) {
        let place = Transfer { call, under_way: false, begun: 0, seen: 0, request };
        match self.0.binary_search_by_key(&call, |it| it.call) {
            Ok(at) => self.0[at] = place,
            Err(at) => self.0.insert(at, place),
        }
    }

    /// Nothing is under way any more.
    pub(super) fn forget(&mut self) {
        self.0.iter_mut().for_each(|it| it.under_way = false);
    }

    /// Whether the transfer of this call is still under way, executed in this cycle or the one before.
    pub(super) fn is_under_way(&self, call: &Call<'_>) -> bool {
        let found = self.0.binary_search_by_key(&call.index(), |it| it.call).map(|at| &self.0[at]);
        found.is_ok_and(|it| {
            it.under_way && call.millis().checked_sub(it.seen).is_some_and(|past| past <= CYCLE)
        })
    }

    /// The requests under way.
    pub(super) fn under_way_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.0.iter_mut().filter(|it| it.under_way).map(|it| &mut it.request)
    }

    /// The request, once, when its cycle has passed.
    pub(super) fn end(&mut self, call: &Call<'_>) -> Option<&T> {
        let transfer = self.executed(call)?;
        if call.millis().saturating_sub(transfer.begun) < CYCLE {
            return None;
        }
        transfer.under_way = false;
        Some(&transfer.request)
    }

    /// Ends the transfer under way when `finish` says that it is done.
    pub(super) fn end_when(
        &mut self,
        call: &mut Call<'_>,
        finish: impl FnOnce(&T, &mut Call<'_>) -> Result<bool, FaultKind>,
    ) -> Result<(), FaultKind> {
        if let Some(transfer) = self.executed(call) {
            transfer.under_way = !finish(&transfer.request, call)?;
        }
        Ok(())
    }

    /// The transfer under way, whose line is executed once more.
    fn executed(&mut self, call: &Call<'_>) -> Option<&mut Transfer<T>> {
        let at = self.0.binary_search_by_key(&call.index(), |it| it.call).ok()?;
        let transfer = self.0.get_mut(at).filter(|it| it.under_way)?;
        transfer.seen = call.millis();
        Some(transfer)
    }
}

impl<T: Default> Transfers<T> {
    /// Begins the transfer of this call anew; `fill` takes the operands into what the last one left. Gives the request.
    pub(super) fn begin(
        &mut self,
        call: &Call<'_>,
        fill: impl FnOnce(&mut T) -> Result<(), FaultKind>,
    ) -> Result<&T, FaultKind> {
        let index = call.index();
        let at = match self.0.binary_search_by_key(&index, |it| it.call) {
            Ok(at) => at,
            Err(at) => {
                let place =
                    Transfer { call: index, under_way: false, begun: 0, seen: 0, request: T::default() };
                self.0.insert(at, place);
                at
            }
        };
        let transfer = &mut self.0[at];
        transfer.under_way = false;
        fill(&mut transfer.request)?;
        let now = call.millis();
        (transfer.under_way, transfer.begun, transfer.seen) = (true, now, now);
        Ok(&transfer.request)
    }
}
