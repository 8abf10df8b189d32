//! Analogue outputs and who drives which (manual 12.2 and 12.4).

/// Analogue outputs of the control.
pub const PORTS: usize = 16;
/// Full voltage, 10 V.
pub(crate) const FULL: i32 = 0x7FFF;

/// Where ANALOG sends its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Analog {
    /// One operand or none: to the port of ANALOG_PORT.
    Port,
    /// Two operands: to the rotary axis of this number (1 to 16), if it works as spindle; otherwise, and for a letter
    /// (`None`), to that of the last AX_SPI.
    Axis(Option<u8>),
    /// Third operand 1: to the main spindle.
    Main,
    /// Third operand 2: to the auxiliary spindle.
    Assist,
}

/// What AX_SPI makes of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// 0: a spindle that stands.
    Off,
    /// 1: the main spindle.
    Main,
    /// 2: the auxiliary spindle.
    Assist,
    /// 3: what it was.
    Set,
}

/// The outputs and the roles of axes that work as spindles.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outputs {
    pub(crate) values: [i16; PORTS],
    /// Port of ANALOG_PORT, from 0.
    pub(crate) active: Option<usize>,
    /// Indices of axes.
    pub(crate) main: Option<usize>,
    pub(crate) assist: Option<usize>,
    pub(crate) last: Option<usize>,
}

impl Outputs {
    /// Sends a value, cut to the full voltage of either sign.
    pub(crate) fn send(&mut self, port: usize, value: i32) {
        if let Some(output) = self.values.get_mut(port) {
            *output = value.clamp(-FULL, FULL) as i16;
        }
    }

    /// AX_SPI without a role makes an axis the main spindle only when there is none.
    pub(crate) fn assign(&mut self, axis: usize, role: Option<Role>) {
        self.last = Some(axis);
        match role {
            Some(Role::Main) => self.make_main(axis, false),
            Some(Role::Assist) => {
                self.forget(axis);
                self.assist = Some(axis);
            }
            Some(Role::Off) => {
                self.forget(axis);
                self.send(axis, 0);
            }
            None if self.main.is_none() && self.assist != Some(axis) => self.main = Some(axis),
            Some(Role::Set) | None => {}
        }
    }

    /// The axis is the main spindle; with `swap` the former one becomes the auxiliary one.
    pub(crate) fn make_main(&mut self, axis: usize, swap: bool) {
        let former = self.main.filter(|main| *main != axis);
        self.forget(axis);
        if swap && former.is_some() {
            self.assist = former;
        }
        self.main = Some(axis);
    }

    fn forget(&mut self, axis: usize) {
        self.main = self.main.filter(|main| *main != axis);
        self.assist = self.assist.filter(|assist| *assist != axis);
    }
}
