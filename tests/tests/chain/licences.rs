//! LDR_LIC (manual 8.4.7).

use crate::plc::Plc;

#[test]
fn a_licence_needs_the_key_that_holds_it() {
    let lines = "LDR_LIC HwKeyConnected / WR O0 / LDR_LIC FeaturePlc0 / WR O1 / LDR_LIC FeaturePlc9 / WR O2";
    let mut plc = Plc::of(lines);
    plc.run(1);
    assert_eq!(plc.differences("OB=0"), [""; 0]);
    plc.control().licences_mut().set_feature(9, true);
    plc.run(1);
    assert_eq!(plc.differences("OB=0"), [""; 0]);
    plc.control().licences_mut().connect_key(true);
    plc.run(1);
    assert_eq!(plc.differences("OB=5"), [""; 0]);
    plc.control().licences_mut().set_feature(0, true);
    plc.control().licences_mut().set_feature(9, false);
    plc.control().licences_mut().set_feature(10, true);
    plc.run(1);
    assert_eq!(plc.differences("OB=3"), [""; 0]);
}

#[test]
fn each_feature_has_its_licence() {
    for n in 0..=9 {
        let mut plc = Plc::of(&format!("LDR_LIC FeaturePlc{n} / WR O0"));
        plc.control().licences_mut().connect_key(true);
        for other in 0..=9 {
            plc.control().licences_mut().set_feature(other, other != n);
        }
        plc.run(1);
        assert_eq!(plc.differences("O0=0"), [""; 0], "{n}");
        for other in 0..=9 {
            plc.control().licences_mut().set_feature(other, other == n);
        }
        plc.run(1);
        assert_eq!(plc.differences("O0=1"), [""; 0], "{n}");
    }
}

#[test]
fn it_opens_an_equation_and_pushes_when_one_is_open() {
    let lines = "LDR I0 / LDR_LIC FeaturePlc3 / LA I1 / LO / WR O0 / LDR_LIC FeaturePlc3 / LA I2 / WR O1";
    for (licence, inputs, expected) in [
        (true, 0b010, 0b01),
        (false, 0b010, 0b00),
        (false, 0b001, 0b01),
        (true, 0b100, 0b10),
        (true, 0b000, 0b00),
        (false, 0b111, 0b01),
    ] {
        let mut plc = Plc::of(lines);
        plc.control().licences_mut().connect_key(true);
        plc.control().licences_mut().set_feature(3, licence);
        plc.set(&format!("IB={inputs}"));
        plc.run(1);
        assert_eq!(plc.differences(&format!("OB={expected}")), [""; 0], "{licence} {inputs:b}");
    }
}
