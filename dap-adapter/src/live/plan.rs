//! Spreading what is watched over the streams of a target and over what the line carries.

use technol_wire::Layout;
use technol_wire::message::{Item, MOST_STREAMS, Subject, Subscription, TracedLine, TracedRegister};

/// Length of a cycle in milliseconds.
pub(crate) const CYCLE_MS: u32 = 20;
/// Bytes of a frame around the values of its sample.
const AROUND: u32 = 10;
/// Percent of the line that may be planned for; the rest is for stops, steps and what is asked.
const SHARE: u64 = 50;

/// What somebody wants to see.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Wishes {
    /// Asked for by the client, and how often in cycles.
    pub(crate) watches: Vec<Item>,
    pub(crate) period: u16,
    /// Looked at lately.
    pub(crate) interest: Vec<Item>,
    pub(crate) mechanisms: Vec<u16>,
    pub(crate) trace: Vec<TracedLine>,
    /// The target tells one register of each line, whichever it is ([`Subject::Lines`]).
    pub(crate) any_register: bool,
}

/// Cycles between two samples of what was only looked at.
const INTEREST: u16 = 10;
/// Cycles between two samples of mechanisms: quick enough for eyes.
const MECHANISMS: u16 = 5;

/// What is subscribed.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Plan {
    pub(crate) subscriptions: Vec<Subscription>,
    /// Cycles between two samples of what the client asked for.
    pub(crate) period: u16,
    /// Cycles between two samples of the trace.
    pub(crate) trace_period: u16,
    /// Things that found no room.
    pub(crate) left_out: usize,
}

/// Plans for frames of that much payload on a line of that many bytes a second (`None`: it is fast).
pub(crate) fn plan(wishes: &Wishes, max_payload: u16, line: Option<u32>) -> Plan {
    let mut plan = Plan { period: wishes.period.max(1), trace_period: 1, ..Plan::default() };
    plan.pack(&wishes.trace, 1, max_payload, 2, |lines| trace(lines, wishes.any_register));
    plan.pack(&wishes.watches, plan.period, max_payload, 4, |i| Subject::Variables(i.to_vec()));
    plan.pack(&wishes.mechanisms, MECHANISMS, max_payload, 1, |m| Subject::Mechanisms(m.to_vec()));
    let left = usize::from(MOST_STREAMS) - plan.subscriptions.len();
    plan.pack(&wishes.interest, INTEREST, max_payload, left, |i| Subject::Variables(i.to_vec()));
    plan.slow_down(line);
    plan
}

/// A target that tells DR only tells all of it when some line needs that.
fn trace(lines: &[TracedLine], any_register: bool) -> Subject {
    if any_register {
        return Subject::Lines(lines.to_vec());
    }
    let wide = lines.iter().any(|line| line.register != TracedRegister::Dr32);
    Subject::Trace { pcs: lines.iter().map(|line| line.pc).collect(), wide }
}

impl Plan {
    /// Fills at most `most` streams.
    fn pack<T>(
        &mut self,
        things: &[T],
        period: u16,
        max_payload: u16,
        most: usize,
        subject: impl Fn(&[T]) -> Subject,
    ) {
        let mut rest = things;
        for _ in 0..most {
            let id = self.subscriptions.len() as u8;
            let of = |count: usize| Subscription { id, period, subject: subject(&rest[..count]) };
            let fits = |count: &usize| {
                Layout::of(&of(*count)).is_ok_and(|layout| layout.longest() <= usize::from(max_payload))
            };
            // Each takes a bit at least.
            let bound = rest.len().min(usize::from(max_payload) * 8);
            let count = longest_prefix(bound, fits);
            if count == 0 {
                break;
            }
            self.subscriptions.push(of(count));
            rest = &rest[count..];
        }
        self.left_out += rest.len();
    }

    /// Lengthens all periods alike until the line carries everything: variables even when all of them change in
    /// each sample, mechanisms and traces when a quarter does.
    fn slow_down(&mut self, line: Option<u32>) {
        let Some(line) = line else { return };
        let wanted: u64 =
            self.subscriptions.iter().map(|s| u64::from(cost(s)) * 1000 / u64::from(s.period)).sum();
        // Thousandths of a byte in a cycle.
        let there = u64::from(line) * u64::from(CYCLE_MS) * SHARE / 100;
        if wanted <= there || there == 0 {
            return;
        }
        let slower = |period: u16| {
            let longer = (u64::from(period) * wanted).div_ceil(there);
            u16::try_from(longer).unwrap_or(u16::MAX)
        };
        for subscription in &mut self.subscriptions {
            subscription.period = slower(subscription.period);
        }
        self.period = slower(self.period);
        self.trace_period = slower(self.trace_period);
    }
}

/// The greatest count that fits, where fewer always fit as well.
fn longest_prefix(bound: usize, fits: impl Fn(&usize) -> bool) -> usize {
    let (mut low, mut high) = (0, bound);
    while low < high {
        let middle = (low + high).div_ceil(2);
        if fits(&middle) { low = middle } else { high = middle - 1 }
    }
    low
}

/// Bytes of a sample.
fn cost(subscription: &Subscription) -> u32 {
    let bits: u32 = Layout::of(subscription).map_or(0, |l| l.widths().iter().map(|w| u32::from(*w)).sum());
    let values = bits.div_ceil(8);
    AROUND + if matches!(subscription.subject, Subject::Variables(_)) { values } else { values.div_ceil(4) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use technol_wire::message::{ItemKind, Mode};

    fn words(count: u32) -> Vec<Item> {
        (0..count).map(|n| Item { addr: n * 4, kind: ItemKind::Unsigned(4), mode: Mode::Value }).collect()
    }

    fn bits(count: u32) -> Vec<Item> {
        (0..count).map(|n| Item { addr: n, kind: ItemKind::Bit(0), mode: Mode::Value }).collect()
    }

    #[test]
    fn a_slow_line_gets_longer_periods_and_says_so() {
        for (watches, line, period) in [
            // 16 bits and 4 double words are 28 bytes; half of 230 in a cycle is there.
            ([bits(16), words(4)].concat(), 11_520, 1),
            // 223 bytes want two cycles.
            ([bits(100), words(50)].concat(), 11_520, 2),
            ([bits(100), words(50)].concat(), 960, 24),
            // 800 bytes of values and four frames.
            (words(200), 11_520, 8),
        ] {
            let wishes = Wishes { watches, period: 1, ..Wishes::default() };
            let plan = plan(&wishes, 240, Some(line));
            assert_eq!((plan.period, plan.left_out), (period, 0), "{line}");
        }
        let wishes = Wishes { watches: words(200), period: 1, ..Wishes::default() };
        assert_eq!(plan(&wishes, 4000, None).period, 1);
    }

    fn lines(count: u32, register: TracedRegister) -> Vec<TracedLine> {
        (0..count).map(|pc| TracedLine { pc, register }).collect()
    }

    #[test]
    fn a_trace_of_forty_lines_goes_each_cycle() {
        for (register, streams) in
            [(TracedRegister::Dr32, 1), (TracedRegister::Dr64, 2), (TracedRegister::Real, 2)]
        {
            let trace = lines(40, register);
            let wishes = Wishes { trace, any_register: true, ..Wishes::default() };
            let plan = plan(&wishes, 240, Some(11_520));
            assert_eq!((plan.subscriptions.len(), plan.trace_period), (streams, 1), "{register:?}");
        }
    }

    #[test]
    fn a_target_that_tells_dr_only_tells_all_of_it_where_that_is_needed() {
        let subject = |register| {
            let mut trace = lines(2, TracedRegister::Dr32);
            trace.push(TracedLine { pc: 7, register });
            let wishes = Wishes { trace, ..Wishes::default() };
            plan(&wishes, 240, None).subscriptions.remove(0).subject
        };
        for (register, wide) in
            [(TracedRegister::Dr32, false), (TracedRegister::Dr64, true), (TracedRegister::Real, true)]
        {
            assert_eq!(subject(register), Subject::Trace { pcs: vec![0, 1, 7], wide });
        }
    }

    #[test]
    fn everything_has_a_stream_of_its_own_number_or_is_left_out() {
        let wishes = Wishes {
            watches: words(1000),
            period: 5,
            interest: words(300),
            mechanisms: (0..100).collect(),
            trace: lines(500, TracedRegister::Dr32),
            any_register: true,
        };
        for max_payload in [64, 240, 4000] {
            let plan = plan(&wishes, max_payload, Some(11_520));
            let ids: Vec<u8> = plan.subscriptions.iter().map(|s| s.id).collect();
            assert_eq!(ids, (0..ids.len() as u8).collect::<Vec<_>>());
            assert!(ids.len() <= usize::from(MOST_STREAMS));
            let mut there = 0;
            for subscription in &plan.subscriptions {
                let layout = Layout::of(subscription).unwrap();
                assert!(layout.longest() <= usize::from(max_payload));
                there += match &subscription.subject {
                    Subject::Variables(items) => items.len(),
                    Subject::Mechanisms(sequences) => sequences.len(),
                    Subject::Trace { pcs, .. } => pcs.len(),
                    Subject::Lines(lines) => lines.len(),
                };
            }
            assert_eq!(there + plan.left_out, 1900, "{max_payload}");
        }
    }
}
