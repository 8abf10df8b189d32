//! Fused code does what its operations do, one by one: with brackets, overlapping cells, cells at the end of memory,
//! jumps to everywhere and break-points anywhere.

use proptest::collection::vec;
use proptest::prelude::*;

use technol_image::op::{Arith, BitRef, Compare, Cond, Logic, Op, Pc, Place, Source, Width};
use technol_runtime::{Resume, TickOutcome};

use crate::support::{Bench, Builder, END, GLOBAL as A};

/// Few bytes, so that cells overlap; some at the end of memory, where no cell may be read further than it is long.
fn an_addr(width: u32) -> impl Strategy<Value = u32> {
    prop_oneof![8 => 0..12_u32, 1 => 12..20_u32]
        .prop_map(move |n| if n < 12 { A + n } else { END - width - (n - 12) })
}

fn a_bit() -> impl Strategy<Value = BitRef> {
    (an_addr(1), 0..8_u8).prop_map(|(addr, bit)| BitRef { addr, bit, indexed: false })
}

fn a_place(width: Width) -> impl Strategy<Value = Place> {
    an_addr(width.bytes()).prop_map(|addr| Place { addr, indexed: false })
}

fn a_source(width: Width) -> impl Strategy<Value = Source> {
    let bits = 64 - width.bits();
    prop_oneof![
        a_place(width).prop_map(Source::Mem),
        (-2..200_i64).prop_map(move |n| Source::Int(n << bits >> bits)),
        any::<i64>().prop_map(move |n| Source::Int(n << bits >> bits)),
    ]
}

fn a_cond() -> impl Strategy<Value = Cond> {
    prop::sample::select(vec![Cond::Always, Cond::IfRlo, Cond::IfNotRlo])
}

fn bit_op() -> impl Strategy<Value = Op> {
    let logic = || prop::sample::select(vec![Logic::And, Logic::Or, Logic::Xor]);
    prop_oneof![
        2 => (a_bit(), any::<bool>()).prop_map(|(bit, neg)| Op::Ldr { bit, neg, push: false }),
        2 => (a_bit(), any::<bool>()).prop_map(|(bit, neg)| Op::Ldr { bit, neg, push: true }),
        6 => (logic(), a_bit(), any::<bool>()).prop_map(|(op, bit, neg)| Op::Logic { op, bit, neg }),
        2 => logic().prop_map(Op::LogicPop),
        1 => Just(Op::Complement),
        2 => a_bit().prop_map(Op::Write),
        1 => (a_bit(), any::<bool>(), a_cond()).prop_map(|(bit, value, cond)| Op::Flag { value, bit, cond }),
    ]
}

fn data_op() -> impl Strategy<Value = Op> {
    use prop::sample::select;
    let functions =
        || select(vec![Arith::Add, Arith::Sub, Arith::Mul, Arith::Or, Arith::And, Arith::Xor, Arith::Div]);
    let relations = || select(vec![Compare::Eq, Compare::Lt, Compare::Gt, Compare::Le, Compare::Ge]);
    let widths = select(vec![Width::Byte, Width::Word, Width::DWord]);
    widths.prop_flat_map(move |width| {
        prop_oneof![
            3 => a_source(width).prop_map(move |src| Op::Load { src, width, neg: false }),
            3 => (a_place(width), a_cond()).prop_map(move |(dst, cond)| Op::Store { dst, width, cond }),
            4 => (functions(), a_source(width)).prop_map(move |(op, src)| Op::Arith { op, src, width }),
            3 => (relations(), a_source(width), any::<bool>())
                .prop_map(move |(op, src, if_rlo)| Op::Compare { op, src, width, if_rlo }),
            1 => (a_place(width), a_place(width), a_cond())
                .prop_map(move |(dst, src, cond)| Op::Move { dst, src, width, cond }),
        ]
    })
}

/// An operation, or a jump over the next few.
#[derive(Clone, Debug)]
pub(crate) enum Item {
    Op(Op),
    Over(usize, Cond),
}

pub(crate) fn an_item() -> impl Strategy<Value = Item> {
    prop_oneof![
        12 => bit_op().prop_map(Item::Op),
        8 => data_op().prop_map(Item::Op),
        1 => (0..6_usize, a_cond()).prop_map(|(count, cond)| Item::Over(count, cond)),
    ]
}

/// The module, and what is in memory at its beginning and its end.
pub(crate) fn started(items: &[Item], memory: &[u8]) -> Bench {
    let builder = Builder::new().main(|b| {
        let mut open = Vec::new();
        for (at, item) in items.iter().enumerate() {
            open.iter().filter(|(end, _)| *end == at).for_each(|(_, label)| b.place(*label));
            open.retain(|(end, _)| *end > at);
            match item {
                Item::Op(op) => drop(b.op(*op)),
                Item::Over(count, cond) => {
                    let label = b.label();
                    b.jump(label, *cond);
                    open.push((at + 1 + count, label));
                }
            }
        }
        for (_, label) in open {
            b.place(label);
        }
    });
    let mut bench = builder.load().started();
    bench.plc.write_memory(A, memory).expect("in memory");
    bench.plc.write_memory(END - memory.len() as u32, memory).expect("in memory");
    bench
}

/// The states after some cycles, and how often the program was held.
fn states(mut bench: Bench) -> (Vec<u64>, u32) {
    let (mut states, mut held) = (Vec::new(), 0);
    while states.len() < 4 && bench.plc.fault().is_none() {
        if bench.tick() == TickOutcome::Stopped {
            held += u32::from(bench.plc.fault().is_none());
            bench.plc.resume(Resume::Continue);
        } else if bench.plc.millis() % 20 == 1 {
            states.push(bench.plc.state_hash());
        }
    }
    states.push(bench.plc.state_hash());
    (states, held)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn fused_code_is_the_same_as_its_operations_with_break_points_anywhere(
        items in vec(an_item(), 1..90),
        memory in vec(any::<u8>(), 20),
        places in vec(any::<prop::sample::Index>(), 0..4),
    ) {
        let free = started(&items, &memory);
        let mut slow = free.clone();
        slow.plc.set_line_by_line(true);
        let mut held = free.clone();
        let len = held.plc.program().modules[0].end as usize;
        let pcs: Vec<Pc> = places.iter().map(|place| place.index(len) as Pc).collect();
        let _ = held.plc.set_breakpoints(&pcs);
        let (reference, _) = states(free);
        prop_assert_eq!(&reference, &states(slow).0, "line by line");
        prop_assert_eq!(&reference, &states(held.clone()).0, "through break-points");
        // What break-points replaced comes back.
        let _ = held.plc.set_breakpoints(&[]);
        let (cleared, stops) = states(held);
        prop_assert_eq!((&reference, 0), (&cleared, stops), "after break-points");
    }
}
