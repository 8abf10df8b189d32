//! Messages that the program has shown in a test.

/// A message (ESET).
#[derive(Clone, Debug)]
struct Shown {
    number: u32,
    /// A step has expected it.
    ticked: bool,
}

/// All of them, in order.
#[derive(Clone, Debug, Default)]
pub(super) struct Messages {
    shown: Vec<Shown>,
}

impl Messages {
    pub(super) fn show(&mut self, number: u32) {
        // A program that reports in each cycle must not fill the memory: what is open already needs no second entry.
        if !self.is_open(number) {
            self.shown.push(Shown { number, ticked: false });
        }
    }

    /// Shown, and no step has ticked it off yet.
    pub(super) fn is_open(&self, number: u32) -> bool {
        self.shown.iter().any(|message| message.number == number && !message.ticked)
    }

    /// Those that no step has ticked off.
    pub(super) fn open(&self) -> impl Iterator<Item = u32> {
        self.shown.iter().filter(|message| !message.ticked).map(|message| message.number)
    }

    /// Ticks a message off; false when it has not been shown.
    pub(super) fn tick_off(&mut self, number: u32) -> bool {
        match self.shown.iter_mut().find(|message| message.number == number && !message.ticked) {
            Some(message) => {
                message.ticked = true;
                true
            }
            None => false,
        }
    }
}
