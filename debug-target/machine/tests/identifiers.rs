//! What is wrong in the tables of elements, each mistake at its place.
#![allow(clippy::unwrap_used)] // tests

use technol_machine::Plant;

#[test]
fn mistakes_are_reported_where_they_are() {
    for (toml, expected) in [
        ("[[input]]\nid = 'a'\nport = 'P1IN.0'\n[[input]]\nid = 'b'\nvalue = true", ""),
        (
            "[[input]]\nid = 'a'\nvalue = 2.5\n[[input]]\nid = 'A[0]'\nvalue = 'x'",
            "input[1].id: `A[0]` is described twice",
        ),
        ("[[input]]\nid = ''\nvalue = 1", "input[0].id: an identifier has 1 to 255 ASCII characters"),
        ("[[input]]\nid = 'a'", "input[0]: needs either `port` or `value`"),
        ("[[input]]\nid = 'a'\nvalue = 1\ninvert = true", "input[0].invert: belongs to `port`"),
        (
            "[[input]]\nid = 'a'\nport = 'P0OUT.0'",
            "input[0].port: `P0OUT.0` is an output; an input of the PLC is needed, such as P1IN.0",
        ),
        (
            "[[output]]\nid = 'a'\nport = 'P1IN.0'",
            "output[0].port: `P1IN.0` is an input; an output of the PLC is needed, such as P0OUT.0",
        ),
        (
            "[[link]]\nsource = ''\ndestination = 'b'",
            "link[0].source: an identifier has 1 to 255 ASCII characters",
        ),
        (
            "[[link]]\nsource = 'a'\ndestination = 'b'\ninvert = true\nscale = 2",
            "link[0].scale: does not go with `invert`, which makes a bit",
        ),
        (
            "[[link]]\nsource = 'a'\ndestination = 'b'\noffset = nan",
            "link[0].offset: must be a finite number",
        ),
        (
            "[[link]]\nsource = 'RTM.Control.M03'\ndestination = 'b'\n[[link]]\nsource = 'CAN[1].INOUT08[2].IP0.Bit[3]'\n\
             destination = 'RTM.Control.FeedOvrVal'",
            "",
        ),
        (
            "[[link]]\nsource = 'RTM.Control.M99'\ndestination = 'VKeyboard.VKey[3]'",
            "link[0].source: `RTM.Control.M99` is an element that the simulated control does not have\n\
             link[0].destination: `VKeyboard.VKey[3]` is an element that the simulated control does not have",
        ),
        (
            "[[ethercat]]\nname = 'A'\ninputs = [{ name = 'Ready.Bit[3]', type = 'bit' }, { name = 'x.bits', type = 'bit' }]",
            "ethercat[0].inputs: `ECAT.A.Inputs.Ready.Bit[3]` would mean one bit of a number; give it a name that does not \
             end with `.Bit`",
        ),
        (
            "[[link]]\nsource = 'a'\ndestination = 'b'\n[[link]]\nsource = 'c'\ndestination = 'B'",
            "link[1].destination: `B` is described twice",
        ),
    ] {
        let errors = Plant::compile(&toml::from_str(toml).unwrap(), &|name| name.parse().ok()).err();
        let errors: Vec<String> = errors.into_iter().flatten().map(|error| error.to_string()).collect();
        assert_eq!(errors.join("\n"), expected, "{toml}");
    }
}
