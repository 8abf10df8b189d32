//! Logical elements of the control show what their symbols show (manual 27.4).

use technol_analysis::catalogue::logical_elements::{ElementType, LogicalElement, logical_elements};
use technol_analysis::catalogue::{SystemKind, symbol};
use technol_machine::{Conversion, ElementValue};

use crate::scene::Scene;

/// Elements with a symbol that a link cannot carry here.
const EXEMPT: &[(&str, &str)] = &[
    ("RTM.Man.ManControlKnob", "there is no wheel panel"),
    ("RTM.Man.Knob1Disable", "there is no wheel panel"),
    ("RTM.Man.Knob2Disable", "there is no wheel panel"),
];

/// The symbol of an element for its number `nth`, with the name that X, Y, Z, 4 … have.
fn symbol_of(element: &LogicalElement, nth: u32) -> Option<SystemKind> {
    let axis = ["X", "Y", "Z"].get(nth as usize).map_or_else(|| (nth + 1).to_string(), |it| (*it).to_owned());
    symbol(&element.symbol.replace('x', &axis)).map(|symbol| symbol.kind)
}

/// Sets the symbol, or the bit of the axis in it.
fn set(memory: &mut [u8], kind: SystemKind, bit_of_axis: Option<u32>) -> Option<()> {
    match (kind, bit_of_axis) {
        (SystemKind::Bit { addr, bit }, _) => memory[addr as usize] |= 1 << bit,
        (kind, Some(nth)) => memory[kind.bytes()?.0 as usize + nth as usize / 8] |= 1 << (nth % 8),
        (kind, None) => memory[kind.bytes()?.0 as usize] = 1,
    }
    Some(())
}

#[test]
fn an_element_of_the_control_has_the_value_of_its_symbol() {
    let mut wrong = Vec::new();
    let mut seen = 0;
    for element in logical_elements().filter(|it| !it.symbol.is_empty()) {
        // Of a family, the first and the last; a mask of bits is one symbol for all of them.
        let last = element.len.unwrap_or(1).min(6) - 1;
        for nth in [0, last] {
            let id = element.identifier.replace("[#]", &format!("[{nth}]"));
            let Some(kind) = symbol_of(element, nth) else { continue };
            let family = element.len.unwrap_or(1) > 1;
            let of_axis = (family && element.element == ElementType::Bit && !element.symbol.contains('x'))
                .then_some(nth);
            let shown = shown(&id, |memory| {
                let area = matches!(kind, SystemKind::Area { .. });
                if area {
                    memory[kind.bytes().map_or(0, |(addr, _)| addr + nth) as usize] = 1;
                } else {
                    set(memory, kind, of_axis).expect("a symbol with memory");
                }
            });
            let exempt = EXEMPT.iter().any(|(name, _)| *name == element.identifier);
            if shown == exempt {
                wrong.push(id);
            }
            seen += 1;
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join(" "));
    assert!(seen > 100, "{seen}");
}

/// Whether an output of this name goes on when the memory is changed.
fn shown(id: &str, change: impl FnOnce(&mut [u8])) -> bool {
    let mut control = technol_machine::SimulatedControl::new();
    control.connect(id, "Probe", Conversion::default()).expect("a link");
    let mut memory = vec![0; technol_image::system::LEN as usize];
    technol_runtime::Control::inputs(&mut control, technol_runtime::Rate::Slow, 0, &mut memory);
    let off = control.output(id) == Some(&false.into());
    change(&mut memory);
    technol_runtime::Control::outputs(&mut control, technol_runtime::Rate::Slow, 0, &mut memory);
    off && control.output(id).is_some_and(ElementValue::is_on)
}

#[test]
fn numbers_come_in_the_unit_of_the_element() {
    let scene = Scene {
        machine: "[[axis]]\nnumber = 2\nstart = 5.5\n[[link]]\nsource = 'RTM.Axis[1].Pos0_Ax'\ndestination = 'Place'\n\
                  [[link]]\nsource = 'RTM.Servo[1].ServoPosition'\ndestination = 'Servo'\n\
                  [[link]]\nsource = 'RTM.Control.InPos'\ndestination = 'There'\n\
                  [[link]]\nsource = 'RTM.Spindle.ReqSpeedPm'\ndestination = 'Speed'\n\
                  [[spindle]]\nport = 1\ngear = [{ max-speed = 1000 }]\n\
                  [[block]]\nat-cycle = 1\nfeed = 6000\nspeed = 500.0\naxes = [[1, 12.5]]\n"
            .to_owned(),
        ..Scene::new("elements", 30)
    };
    let of =
        |id: &str| scene.played().control().output(id).and_then(ElementValue::as_real).unwrap_or(f64::NAN);
    assert!((of("RTM.Axis[1].Pos0_Ax") - 12.5).abs() < 1e-6, "{}", of("RTM.Axis[1].Pos0_Ax"));
    assert!((of("RTM.Servo[1].ServoPosition") - of("RTM.Axis[1].Pos0_Ax")).abs() < 10.0);
    assert!((of("RTM.Spindle.ReqSpeedPm") - 500.0).abs() < 0.1, "{}", of("RTM.Spindle.ReqSpeedPm"));
    assert!((of("RTM.Control.InPos") - 1.0).abs() < 1e-9);
}
