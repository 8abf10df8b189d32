//! A program that uses every family of instructions in each cycle, and what it needs around it.

use technol_analysis::project::{FileReader, load};
use technol_analysis::{AnalysisHost, Change};
use technol_image::{Op, Program};
use technol_machine::{
    CanPacket, Column, ControlData, ElementValue, MessageKind, MessageText, Table, Value, ValueKind,
};
use technol_runtime::Runtime;
use technol_target::Simulation;

/// One file as a project.
pub(crate) struct Lone(pub(crate) &'static str);

impl FileReader for Lone {
    fn read(&self, path: &str) -> Result<Vec<u8>, String> {
        if path == "plc.plc" { Ok(self.0.into()) } else { Err("no such file".to_owned()) }
    }
}

/// The program of a project.
pub(crate) fn build(path: &str, reader: &dyn FileReader) -> Program {
    let mut host = AnalysisHost::new();
    host.apply(Change { project: Some(load(path, reader)), texts: Vec::new() });
    let built = host.analysis().build().expect("nothing cancels it");
    built.unwrap_or_else(|findings| panic!("{path} cannot be built: {findings:?}")).image.program
}

/// The program of all families.
pub(crate) fn program() -> Program {
    build("plc.plc", &Lone(include_str!("families.plc")))
}

/// What the instructions of the control find, so that they do not end at once.
pub(crate) fn furnish(simulation: &mut Simulation) {
    simulation.set_data(data());
    let control = simulation.control_mut();
    control.serial_mut(1);
    control.can_unit_mut(2, 1, 3);
    control.can_unit_mut(2, 1, 4);
    control.can_drive_mut(2);
    let ethercat = control.ethercat_mut();
    if let Some(slave) = ethercat.slave_mut(1) {
        slave.set_object(0x603F, 0, &[0x34, 0x12], false);
        slave.set_object(0x6060, 0, &[1], false);
        slave.set_register(0, 51, &[1, 2, 3, 4], false);
    }
    let _ = ethercat.slave_mut(2);
}

/// What the control has on its disk.
pub(crate) fn data() -> ControlData {
    let text = |text: &str| text.as_bytes().to_vec();
    let columns = [
        ("Name", ValueKind::Text),
        ("Teeth", ValueKind::Int),
        ("Feed", ValueKind::Real),
        ("Blob", ValueKind::Bytes),
    ];
    let columns = columns.map(|(id, kind)| Column { id: text(id), kind }).to_vec();
    let row =
        vec![Value::Text(text("Steel")), Value::Int(-3), Value::Real(120.5), Value::Bytes(vec![1, 2, 3])];
    let parameters = [
        ("Delay", Value::Int(7)),
        ("Gain", Value::Real(2.5)),
        ("Name", Value::Text(text("xyz"))),
        ("Raw", Value::Bytes(vec![9; 40])),
    ];
    ControlData {
        parameters: parameters.map(|(id, value)| (text(id), value)).into(),
        constants: [(text("Offs"), 260)].into(),
        tables: vec![Table { columns, rows: vec![row.clone(), row, Vec::new()] }],
        backup: vec![1; 100],
        messages: [
            (12, MessageKind::Err, false, "%d of %X"),
            (67, MessageKind::Wrn1, true, "%d, then %d"),
            (1003, MessageKind::Event, false, "both edges"),
        ]
        .map(|(number, kind, persistent, it)| (number, MessageText { kind, persistent, text: text(it) }))
        .into(),
        ..ControlData::default()
    }
}

/// What comes in from the buses and from the operator in a cycle.
pub(crate) fn feed(simulation: &mut Simulation, cycle: u32) {
    let value = cycle as u8;
    let control = simulation.control_mut();
    // Both queues run full in between.
    for n in 0..if cycle.is_multiple_of(50) { 100 } else { 3 } {
        control.can_mut().feed(1, CanPacket::new(0x300, &[value, n]));
        control.can_mut().feed(2, CanPacket::new(0x581, &[value, n]));
    }
    control.serial_mut(1).feed(&[value; 5]);
    control.set_input("inDoor", ElementValue::from(cycle.is_multiple_of(2))).expect("an input");
    control.set_input("In", ElementValue::from(i64::from(value))).expect("an input");
    control.edit_table(0, 0, 1, Value::Int(i64::from(value)));
    control.select_row(0, cycle as usize % 3);
}

/// The operations of all statements that were executed at least once, while statements are counted. A jump out of the middle of
/// a statement is not seen: what stands behind it counts too.
#[allow(dead_code)] // a fuzz target does not count
pub(crate) fn executed(plc: &Runtime) -> Vec<Op> {
    let program = plc.program();
    let counts = plc.statement_counts().expect("somebody counts");
    let mut starts = program.statements.clone();
    starts.push(program.code.len() as u32);
    let ranges = starts.windows(2).map(|pair| pair[0] as usize..pair[1] as usize);
    ranges.filter(|range| counts[range.start] > 0).flat_map(|range| program.code[range].to_vec()).collect()
}

/// Everything that the program does went all the way through.
pub(crate) fn happened(simulation: &mut Simulation) {
    let row = simulation.control().data().tables[0].rows[0].clone();
    assert_ne!(
        (&row[0], &row[3]),
        (&Value::Text(b"Steel".to_vec()), &Value::Bytes(vec![1, 2, 3])),
        "{row:?}"
    );
    let control = simulation.control_mut();
    assert!(control.can_mut().take_sent(2).len() > 100, "packets were sent");
    assert!(control.can_mut().lost() > 0, "and queues were full");
    assert!(control.serial_mut(1).take_sent().len() > 100, "characters were sent");
    let written = control.shared_area_mut(0).expect("an area").iter().any(|byte| *byte != 0);
    assert!(written, "the shared area was written");
    assert!(control.output("Lamp").is_some(), "outputs left");
    assert!(control.board().transient().count() > 10, "messages wait to be acknowledged");
    let slave = control.ethercat_mut().slave_mut(1).expect("a slave");
    assert_ne!(slave.object(0x6060, 0), Some(&[1][..]), "the object was written");
}
