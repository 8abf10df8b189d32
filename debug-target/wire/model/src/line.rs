//! One direction of a cable, and both.

use crate::fault::{Fault, Faults};
use crate::random::Random;

/// Bits of a byte on the line: start, eight of data, stop.
const BITS: u64 = 10;
/// Longest delay of a frame that is late, in microseconds.
const LATE_US: usize = 60_000;

/// A cut that comes again and again: from time 0 on, each period ends with one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cuts {
    /// From the end of one to the end of the next, in microseconds.
    pub every_us: u64,
    /// How long each lasts, in microseconds.
    pub len_us: u64,
}

/// What a line is like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineOptions {
    /// Bits per second; a byte takes ten.
    pub baud: u32,
    /// The adapter at the receiving end hands over what has come in only every so many microseconds (the latency
    /// timer of a USB adapter: 16 ms unless set otherwise, 1 ms at least); 0: at once.
    pub latency_us: u64,
    /// What goes wrong.
    pub faults: Faults,
    /// Cuts that come by themselves.
    pub cuts: Option<Cuts>,
}

impl Default for LineOptions {
    /// 115200 baud, and nothing goes wrong.
    fn default() -> Self {
        LineOptions { baud: 115_200, latency_us: 0, faults: Faults::default(), cuts: None }
    }
}

/// One direction.
#[derive(Clone, Debug)]
pub struct Line {
    options: LineOptions,
    random: Random,
    /// When the last byte handed over will have gone out, in nanoseconds.
    free_at: u64,
    burst_left: usize,
    /// Arrival time in microseconds and bytes, ascending.
    travelling: Vec<(u64, Vec<u8>)>,
    /// Nothing arrives while this is set.
    pub cut: bool,
    /// Bytes sent so far.
    pub bytes: u64,
    /// Frames among them: what ends with a zero and has something before it.
    pub frames: u64,
}

impl Line {
    /// A line; the seed decides where its faults hit.
    #[must_use]
    pub fn new(options: LineOptions, seed: u64) -> Self {
        let random = Random::new(seed);
        let (travelling, cut) = (Vec::new(), false);
        Line { options, random, free_at: 0, burst_left: 0, travelling, cut, bytes: 0, frames: 0 }
    }

    /// Hands bytes over at `now` (microseconds). They go out behind what was handed over before.
    pub fn send(&mut self, now: u64, bytes: &[u8]) {
        self.bytes += bytes.len() as u64;
        let byte_ns = BITS * 1_000_000_000 / u64::from(self.options.baud.max(1));
        for frame in bytes.split_inclusive(|b| *b == 0) {
            self.frames += u64::from(frame.len() > 1);
            let mut out = Vec::with_capacity(frame.len());
            for byte in frame {
                self.free_at = self.free_at.max(now * 1000) + byte_ns;
                if !self.is_cut(self.free_at / 1000) {
                    self.carry(*byte, &mut out);
                }
            }
            if !out.is_empty() {
                self.deliver(out);
            }
        }
        self.travelling.sort_by_key(|t| t.0);
    }

    /// Bytes handed over that have not gone out yet, about.
    #[must_use]
    pub fn backlog(&self, now: u64) -> u64 {
        let byte_ns = BITS * 1_000_000_000 / u64::from(self.options.baud.max(1));
        self.free_at.saturating_sub(now * 1000) / byte_ns.max(1)
    }

    /// Whether nothing gets through at this time.
    #[must_use]
    pub fn is_cut(&self, at: u64) -> bool {
        self.cut
            || self
                .options
                .cuts
                .is_some_and(|cuts| at % cuts.every_us.max(1) >= cuts.every_us.saturating_sub(cuts.len_us))
    }

    fn carry(&mut self, byte: u8, out: &mut Vec<u8>) {
        let faults = self.options.faults;
        if faults.spares_bytes() {
            out.push(byte);
            return;
        }
        let at = out.len();
        out.push(byte);
        if self.burst_left > 0 {
            self.burst_left -= 1;
            return Fault::Burst(1).strike(out, at, &mut self.random);
        }
        if self.random.chance(faults.burst) {
            self.burst_left = faults.burst_len.saturating_sub(1);
            return Fault::Burst(1).strike(out, at, &mut self.random);
        }
        // At these rates two flipped bits in a byte are rare, but they happen.
        while self.random.chance(faults.bit_error * 8.0) {
            Fault::BitError.strike(out, at, &mut self.random);
        }
        let kinds = [
            (Fault::Inserted, faults.inserted),
            (Fault::Repeated, faults.repeated),
            (Fault::Lost, faults.lost),
        ];
        for (fault, rate) in kinds {
            if self.random.chance(rate) {
                fault.strike(out, at, &mut self.random);
                break;
            }
        }
    }

    fn deliver(&mut self, bytes: Vec<u8>) {
        let faults = self.options.faults;
        if self.random.chance(faults.frame_lost) {
            return;
        }
        let mut at = self.free_at / 1000;
        if self.options.latency_us > 0 {
            at = at.next_multiple_of(self.options.latency_us);
        }
        if self.random.chance(faults.frame_doubled) {
            self.travelling.push((at + self.random.below(LATE_US) as u64, bytes.clone()));
        }
        if self.random.chance(faults.frame_late) {
            at += self.random.below(LATE_US) as u64;
        }
        self.travelling.push((at, bytes));
    }

    /// What has arrived by `now`.
    pub fn arrived(&mut self, now: u64) -> Vec<u8> {
        let count = self.travelling.partition_point(|t| t.0 <= now);
        self.travelling.drain(..count).flat_map(|t| t.1).collect()
    }

    /// When something arrives next.
    #[must_use]
    pub fn next_arrival(&self) -> Option<u64> {
        self.travelling.first().map(|t| t.0)
    }

    /// What is on its way is gone, as after a plug was pulled.
    pub fn clear(&mut self) {
        self.travelling.clear();
    }
}

/// Both directions.
#[derive(Clone, Debug)]
pub struct Cable {
    /// From the host to the target.
    pub to_target: Line,
    /// From the target to the host.
    pub to_host: Line,
}

impl Cable {
    /// Both directions alike, with faults at different places.
    #[must_use]
    pub fn new(options: LineOptions, seed: u64) -> Self {
        Cable { to_target: Line::new(options, seed * 2 + 1), to_host: Line::new(options, seed * 2 + 2) }
    }

    /// Cuts or mends it. What is on its way when it is cut is lost.
    pub fn set_cut(&mut self, cut: bool) {
        if cut {
            self.to_target.clear();
            self.to_host.clear();
        }
        self.to_target.cut = cut;
        self.to_host.cut = cut;
    }

    /// When something arrives next at either end.
    #[must_use]
    pub fn next_arrival(&self) -> Option<u64> {
        self.to_target.next_arrival().into_iter().chain(self.to_host.next_arrival()).min()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(options: LineOptions) -> Line {
        Line::new(options, 1)
    }

    #[test]
    fn a_byte_takes_its_time_and_a_frame_arrives_with_its_last_one() {
        let mut line = line(LineOptions::default());
        line.send(1000, &[1, 2, 3, 0]);
        assert_eq!(line.next_arrival(), Some(1000 + 4 * 86_805 / 1000));
        assert_eq!(line.arrived(1346), []);
        line.send(1100, &[4, 0]);
        assert_eq!(line.arrived(1347), [1, 2, 3, 0]);
        assert_eq!(line.next_arrival(), Some(1000 + 6 * 86_805 / 1000), "it went out behind the first");
        assert_eq!((line.bytes, line.backlog(1347)), (6, 2));
    }

    #[test]
    fn a_slow_adapter_hands_over_in_steps() {
        let mut line = line(LineOptions { latency_us: 16_000, ..LineOptions::default() });
        line.send(1000, &[1, 0]);
        assert_eq!(line.next_arrival(), Some(16_000));
        line.send(15_900, &[1, 0]);
        assert_eq!(line.travelling[1].0, 32_000);
    }

    #[test]
    fn what_goes_out_during_a_cut_is_lost_and_the_rest_is_not() {
        let cuts = Some(Cuts { every_us: 20_000, len_us: 1000 });
        let mut line = line(LineOptions { cuts, ..LineOptions::default() });
        line.send(18_800, &[1, 2, 3, 4, 5, 0]);
        assert_eq!(line.arrived(30_000), [1, 2], "the rest falls into the cut");
        line.send(30_000, &[6, 0]);
        line.cut = true;
        line.send(31_000, &[7, 0]);
        line.cut = false;
        assert_eq!(line.arrived(40_000), [6, 0]);
    }

    #[test]
    fn faults_are_as_frequent_as_asked_for_and_the_same_again() {
        let sent = vec![0x55; 100_000];
        let carried = |faults, seed| {
            let mut line = Line::new(LineOptions { faults, ..LineOptions::default() }, seed);
            line.send(0, &sent);
            line.arrived(u64::MAX)
        };
        let none = Faults::default();
        assert_eq!(carried(none, 3), sent);
        let flips = |bytes: &[u8]| bytes.iter().map(|b| (b ^ 0x55).count_ones()).sum::<u32>();
        let noisy = carried(Faults::bit_errors(1e-3), 3);
        assert!((700..900).contains(&flips(&noisy)), "{}", flips(&noisy));
        assert_eq!(noisy, carried(Faults::bit_errors(1e-3), 3));
        assert_ne!(noisy, carried(Faults::bit_errors(1e-3), 4));
        let lost = carried(Faults { lost: 1e-2, ..none }, 3).len();
        assert!((98_850..99_150).contains(&lost), "{lost}");
        let more = carried(Faults { inserted: 1e-2, ..none }, 3).len();
        assert!((100_850..101_150).contains(&more), "{more}");
        let repeated = carried(Faults { repeated: 1e-2, ..none }, 3);
        assert!((100_850..101_150).contains(&repeated.len()) && repeated.iter().all(|b| *b == 0x55));
        let noise = carried(Faults { burst: 1e-3, burst_len: 50, ..none }, 3);
        let hit = noise.iter().filter(|b| **b != 0x55).count();
        assert!((3_500..6_500).contains(&hit), "about a hundred bursts of fifty: {hit}");
    }
}
