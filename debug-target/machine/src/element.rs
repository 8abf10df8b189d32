//! An element in its place, with what hinders it.

use alloc::string::String;

use crate::analog::AnalogInputs;
use crate::contact::Contact;
use crate::counter::Counter;
use crate::drive::World;
use crate::encoder::Encoder;
use crate::latch::Latch;
use crate::limit::Limit;
use crate::ramp::Ramp;
use crate::signal::InputImage;
use crate::slide::Slide;
use crate::turret::Turret;

/// What there is.
#[derive(Clone, Debug)]
pub(crate) enum Element {
    Contact(Contact),
    Limit(Limit),
    Encoder(Encoder),
    Turret(Turret),
    Latch(Latch),
    Counter(Counter),
    Ramp(Ramp),
    Slide(Slide),
}

/// An element of the machine.
#[derive(Clone, Debug)]
pub(crate) struct Mounted {
    pub(crate) name: String,
    pub(crate) element: Element,
    /// It moves in every n-th millisecond; 0: never.
    pub(crate) pace: u32,
    /// A contact or latch is held like this.
    pub(crate) held: Option<bool>,
    phase: u32,
}

impl Mounted {
    pub(crate) fn new(name: &str, element: Element) -> Mounted {
        Mounted { name: name.into(), element, pace: 1, held: None, phase: 0 }
    }

    /// Whether it can be held closed or open.
    pub(crate) fn can_be_held(&self) -> bool {
        matches!(self.element, Element::Contact(_) | Element::Latch(_))
    }

    pub(crate) fn reset(&mut self) {
        self.phase = 0;
        match &mut self.element {
            Element::Contact(e) => e.reset(),
            Element::Limit(e) => e.reset(),
            Element::Encoder(e) => e.reset(),
            Element::Turret(e) => e.reset(),
            Element::Latch(e) => e.reset(),
            Element::Counter(e) => e.reset(),
            Element::Ramp(e) => e.reset(),
            Element::Slide(e) => e.reset(),
        }
    }

    pub(crate) fn step(&mut self, world: World<'_>, inputs: &mut InputImage) {
        let moves = self.moves();
        match (&mut self.element, self.held) {
            (Element::Contact(e), Some(closed)) => {
                e.hold(closed);
                e.show(inputs);
            }
            (Element::Latch(e), Some(on)) => {
                e.hold(on);
                e.show(inputs);
            }
            (Element::Contact(e), None) => e.step(world, moves, inputs),
            (Element::Latch(e), None) => e.step(world, moves, inputs),
            (Element::Limit(e), _) => e.step(world, moves, inputs),
            (Element::Encoder(e), _) => e.step(world, moves, inputs),
            (Element::Turret(e), _) => e.step(world, moves, inputs),
            (Element::Counter(e), _) => e.step(world, moves, inputs),
            (Element::Ramp(e), _) => e.step(world, moves, inputs),
            (Element::Slide(e), _) => e.step(world, moves, inputs),
        }
    }

    /// It looks at a voltage.
    pub(crate) fn sees_volts(&self) -> bool {
        matches!(&self.element, Element::Ramp(ramp) if ramp.sees_volts())
    }

    /// The voltages that it drives.
    pub(crate) fn show_volts(&self, volts: &mut AnalogInputs) {
        if let Element::Ramp(ramp) = &self.element {
            ramp.show_volts(volts);
        }
    }

    fn moves(&mut self) -> bool {
        if self.pace == 0 {
            return false;
        }
        self.phase = (self.phase + 1) % self.pace;
        self.phase == 0
    }
}
