//! Whatever a program does with its axes: no panic, the same again from the same state, and rest in the end.

use proptest::collection::vec;
use proptest::prelude::*;

use technol_image::system::motion as place;
use technol_machine::motion::{Analog, BlockMove, Direction, Hold, PosControl, PosMode, Role, SpiAx};
use technol_machine::{Cells, MachineConfig, Motion};

use crate::support::{CONTROL, STATUS};

/// Something that program or operator do; axes 1 to 4.
#[derive(Clone, Debug)]
enum Act {
    Init(u8, u8),
    Reset(u8),
    Mode(u8, i32, u16, u16),
    Control(u8, i32, Option<bool>),
    /// A bit of a family of bits of the program.
    Bit(usize, u8, bool),
    Word(u32, u16),
    Flag(usize, bool),
    Block(Vec<(u8, i64)>, u16, bool),
    Hold(Hold),
    Home(u8),
    ToSpindle(u8, Option<Role>),
    ToAxis(u8, Option<i16>, Option<i32>),
    Analog(i32, u8),
    Key(u8, Option<Direction>),
    Wheel(u8, i32),
    Annul,
    Run(u16),
}

fn act() -> impl Strategy<Value = Act> {
    let axis = || 1_u8..=4;
    let hold = prop_oneof![Just(Hold::Go), Just(Hold::Stop), Just(Hold::Emergency)];
    let role = prop_oneof![Just(Role::Off), Just(Role::Main), Just(Role::Assist), Just(Role::Set)];
    let way = prop_oneof![Just(Direction::Plus), Just(Direction::Minus)];
    let word = prop_oneof![
        Just(place::HOMING),
        Just(place::HOMING_REQ),
        Just(place::HOMING_START_REQ),
        Just(place::SLS_REFER),
        Just(place::EXTERNAL_FEED),
        Just(place::SERVO_SWITCH.addr),
        Just(place::JOG_SPACE),
        Just(place::GEAR),
    ];
    prop_oneof![
        (axis(), 0_u8..=7).prop_map(|(axis, space)| Act::Init(axis, space)),
        axis().prop_map(Act::Reset),
        (axis(), -80_000..80_000, 200_u16..5000, 0_u16..300).prop_map(|(n, l, a, d)| Act::Mode(n, l, a, d)),
        (axis(), -30_000..30_000, any::<Option<bool>>()).prop_map(|(n, f, mp)| Act::Control(n, f, mp)),
        (0..FAMILIES.len(), axis(), any::<bool>()).prop_map(|(f, n, v)| Act::Bit(f, n, v)),
        (word, any::<u16>()).prop_map(|(at, value)| Act::Word(at, value)),
        (0..FLAGS.len(), any::<bool>()).prop_map(|(f, v)| Act::Flag(f, v)),
        (vec((axis(), -50_000_i64..50_000), 0..3), 1_u16..20_000, any::<bool>())
            .prop_map(|(travel, feed, rapid)| Act::Block(travel, feed, rapid)),
        hold.prop_map(Act::Hold),
        axis().prop_map(Act::Home),
        (axis(), proptest::option::of(role)).prop_map(|(n, role)| Act::ToSpindle(n, role)),
        (axis(), any::<Option<i16>>(), any::<Option<i32>>()).prop_map(|(n, f, a)| Act::ToAxis(n, f, a)),
        (any::<i32>(), axis()).prop_map(|(value, n)| Act::Analog(value, n)),
        (axis(), proptest::option::of(way)).prop_map(|(n, way)| Act::Key(n, way)),
        (axis(), -50..50).prop_map(|(n, steps)| Act::Wheel(n, steps)),
        Just(Act::Annul),
        (1_u16..300).prop_map(Act::Run),
        (1_u16..300).prop_map(Act::Run),
        (1_u16..300).prop_map(Act::Run),
    ]
}

const FAMILIES: [place::AxisBits; 9] = [
    place::ENABLE,
    place::LOOP_CLOSED,
    place::ORIENTING,
    place::REFERENCE_SWITCH,
    place::REVERSING_SWITCH,
    place::SLOW_DOWN_SWITCH,
    place::LIMIT_PLUS,
    place::LIMIT_MINUS,
    place::SLOW_LIMIT_PLUS,
];
const FLAGS: [technol_image::op::BitRef; 9] = [
    place::JOG_REQ,
    place::JOG_BEGIN,
    place::JOG_END,
    place::EXTERNAL_JOG,
    place::EXTERNAL_SELECT,
    place::EXTERNAL_PLUS.of(1),
    place::EXTERNAL_MINUS.of(1),
    place::OFFSET_MODE,
    place::OFFSET_ACTIVE,
];

const MACHINE: &str = "[[axis]]\nnumber=1\nlimit-plus=30\nlimit-minus=-20\nlimit-zone=3\nref-switch='none'\n\
                       [[axis]]\nnumber=2\nref-method=10\nafter-ref='relative'\npos-after-ref=4\n\
                       [[axis]]\nnumber=3\nref-method=15\nservos=[3,5]\nslow-down-switch=true\n\
                       [[axis]]\nnumber=4\nref-method=5\ndifference-limit=0\n\
                       [[spindle]]\naxis=4\nacceleration=20000\ngear=[{max-speed=100},{max-speed=900}]\n";

#[derive(Clone)]
struct State {
    memory: Vec<u8>,
    motion: Motion,
}

impl State {
    fn new() -> State {
        let config: MachineConfig = toml::from_str(MACHINE).unwrap();
        let mut state =
            State { memory: vec![0; technol_image::system::LEN as usize + 64], motion: Motion::new(&config) };
        let mut cells = Cells::new(&mut state.memory);
        cells.set_word(place::FEED_MULTIPLIER, 1000);
        cells.set_word(place::WHEEL_STEP, 100);
        cells.set_byte(place::OFFSET_ALLOWED, 0x3F);
        cells.set_bit(place::JOG_ALLOWED, true);
        state.allow();
        state
    }

    /// Nothing is in the way.
    fn allow(&mut self) {
        let mut cells = Cells::new(&mut self.memory);
        for family in FAMILIES {
            cells.set_axes(family, 0);
        }
        cells.set_axes(place::ENABLE, 0xFFFF);
        cells.set_axes(place::LOOP_CLOSED, 0xFFFF);
    }

    fn run(&mut self, millis: u16) {
        for _ in 0..millis {
            self.motion.tick_ms(&mut Cells::new(&mut self.memory));
            for axis in 1..=4 {
                assert!(self.motion.place(axis, None).unwrap().abs() < 1e9);
            }
        }
    }

    fn act(&mut self, act: &Act) {
        let mut cells = Cells::new(&mut self.memory);
        let cells = &mut cells;
        let motion = &mut self.motion;
        // What is refused is refused; the program goes on.
        let _ = match act {
            Act::Init(axis, space) => motion.pos_init(cells, *axis, *space),
            Act::Reset(axis) => motion.pos_reset(cells, *axis),
            Act::Mode(axis, length, accel, approach) => {
                let mode = PosMode { control: CONTROL, length: *length, accel: *accel, approach: *approach };
                motion.pos_mode(cells, *axis, mode)
            }
            Act::Control(axis, feed, mp) => {
                let control = PosControl { status: STATUS, feed: *feed << 16, mp: *mp };
                motion.pos_control(cells, *axis, control)
            }
            Act::Block(travel, feed, rapid) => {
                let travel: Vec<_> = travel.iter().map(|(axis, way)| (*axis, *way as f64)).collect();
                let block = BlockMove { rapid: *rapid, ..BlockMove::at_feed(&travel, f64::from(*feed)) };
                let begun = motion.begin_block(cells, &block);
                motion.release_block();
                begun
            }
            Act::Home(axis) => motion.home(cells, *axis),
            Act::ToSpindle(axis, role) => motion.ax_spi(cells, *axis, *role),
            Act::ToAxis(axis, feed, angle) => {
                let axis = Some(*axis);
                let operands = SpiAx { feed1: *feed, feed2: *feed, angle: *angle, accel: Some(2000), axis };
                motion.spi_ax(cells, operands)
            }
            Act::Analog(value, axis) => motion.analog(*value, Analog::Axis(Some(*axis))),
            Act::Key(axis, way) => motion.jog_key(*axis, *way),
            Act::Wheel(axis, steps) => {
                motion.turn_wheel(*steps);
                motion.select_key(*axis)
            }
            other => {
                match other {
                    Act::Bit(family, axis, value) => cells.set_bit(FAMILIES[*family].of(axis - 1), *value),
                    Act::Word(at, value) => cells.set_word(*at, *value),
                    Act::Flag(flag, value) => cells.set_bit(FLAGS[*flag], *value),
                    Act::Hold(hold) => motion.hold(*hold),
                    Act::Annul => motion.annul(cells),
                    Act::Run(millis) => self.run(*millis),
                    _ => {}
                }
                Ok(())
            }
        };
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn acts_give_the_same_again_and_axes_come_to_rest(first in vec(act(), 0..40), then in vec(act(), 0..40)) {
        let mut state = State::new();
        for act in &first {
            state.act(act);
        }
        let mut copy = state.clone();
        for act in &then {
            state.act(act);
            copy.act(act);
        }
        prop_assert_eq!(&state.memory, &copy.memory);
        prop_assert_eq!(state.motion.state_hash(), copy.motion.state_hash());
        // The program gives everything back, and nothing is asked for any more.
        state.allow();
        let mut cells = Cells::new(&mut state.memory);
        for flag in FLAGS {
            cells.set_bit(flag, false);
        }
        cells.set_bit(place::JOG_END, true);
        cells.set_word(place::HOMING_START_REQ, 0);
        for axis in 1..=4 {
            state.motion.pos_reset(&mut cells, axis).unwrap();
            let _ = state.motion.analog_spi(0, axis);
        }
        state.motion.annul(&mut cells);
        state.motion.hold(Hold::Go);
        // A spindle that has just become an axis comes from 900 rev/min: 5,400 °/s by 500 °/s² take 11 s.
        for _ in 0..4 {
            state.run(4000);
            if !state.motion.moves() {
                break;
            }
        }
        prop_assert!(!state.motion.moves() && state.motion.in_position());
        prop_assert_eq!(Cells::new(&mut state.memory).axes(place::REQUESTED), 0);
        let before = state.memory.clone();
        state.run(100);
        prop_assert!(before == state.memory, "at rest nothing changes");
    }
}
