//! What is wrong with a description of buses is told, all at once.

use technol_machine::{MachineConfig, Plant};

#[test]
fn numbers_out_of_range_are_told_with_their_place() {
    let config: MachineConfig = toml::from_str(
        "licences = { features = [0, 10] }
         can-unit = [{ can = 3, group = 0, board = 33 }, { can = 1, group = 3, board = 32 }]
         can-drive = [{ axis = 1 }, { axis = 17, node = 128 }]",
    )
    .unwrap();
    let errors = Plant::compile(&config, &|name| name.parse().ok()).unwrap_err();
    let errors: Vec<String> = errors.iter().map(ToString::to_string).collect();
    assert_eq!(
        errors,
        [
            "licences.features: 10 is not between 0 and 9",
            "can-unit[0].can: 3 is not between 1 and 2",
            "can-unit[0].group: 0 is not between 1 and 3",
            "can-unit[0].board: 33 is not between 1 and 32",
            "can-drive[1].axis: 17 is not between 1 and 16",
            "can-drive[1].node: 128 is not between 1 and 127",
        ]
    );
}
