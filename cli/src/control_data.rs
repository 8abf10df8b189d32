//! What the simulated control has on its disk, from the configuration files of a project.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io;
use std::path::{Path, PathBuf};

use technol_analysis::configuration::channel::{self, Channel, Parameter, ParameterKind, Point};
use technol_analysis::configuration::constants::{Constant, ConstantValue};
use technol_analysis::configuration::document::integer;
use technol_analysis::configuration::messages::Message;
use technol_analysis::configuration::places::{Place, place};
use technol_analysis::configuration::table::{self, ColumnKind, TableDefinition};
use technol_analysis::configuration::{ConfigKind, Contents, control_bytes, control_text, read};
use technol_analysis::project::LoadedProject;
use technol_machine::motion::config::Gear;
use technol_machine::{
    Analog, ChannelWiring, Column, Connection, ControlData, Conversion, MachineConfig, Mapping, MessageKind,
    MessageText, Physical, SpindleGears, Table, Value, ValueKind,
};
use technol_target::{EventLog, Keep, TableWriter};

use crate::exit::Failure;

/// First offset of reals in shared area 0; integers begin at 0.
const FIRST_REAL: i64 = 16_000;

/// What the configuration files define, and where changes of it are kept. `machine` is the machine file with its path;
/// `backup` wins over the file it names.
///
/// # Errors
/// A kept file cannot be read.
pub(crate) fn control_data(
    project: Option<&LoadedProject>,
    machine: Option<(&MachineConfig, &Path)>,
    backup: Option<PathBuf>,
) -> Result<(ControlData, Keep), String> {
    let (mut data, sources) = project.map(collect).unwrap_or_default();
    let keep = machine.map(|(config, path)| (&config.keep, path.parent().unwrap_or(Path::new(""))));
    let named = keep.and_then(|(keep, folder)| keep.backup.as_ref().map(|file| folder.join(file)));
    let writes = keep.is_some_and(|(keep, _)| keep.tables) && !sources.is_empty();
    let writer = writes.then(|| TableWriter::new(move |tables| write(&sources, tables)));
    let mut keep = Keep::new(backup.or(named), writer);
    keep.load(&mut data)?;
    Ok((data, keep))
}

/// Inputs, outputs and connections of the configuration files.
pub(crate) fn channel(project: &LoadedProject) -> ChannelWiring {
    collect(project).0.wiring
}

/// The event log that `--log` names. `dated`: its lines begin with the time of day.
///
/// # Errors
/// The file cannot be written.
pub(crate) fn event_log(path: Option<&Path>, dated: bool) -> Result<Option<EventLog>, Failure> {
    let log = path.map(|path| EventLog::new(path.to_owned(), control_text, dated)).transpose();
    log.map_err(Failure::usage)
}

/// What the control knows of a message. A kind or validity that is wrong, which the check reports, is that of an error to be
/// confirmed.
fn message(it: &Message) -> MessageText {
    MessageText {
        kind: MessageKind::of(&it.kind).unwrap_or(MessageKind::Err),
        persistent: it.persistent.unwrap_or(false),
        text: control_bytes(it.text.text.trim()),
    }
}

/// Name and file of a table.
type Source = (String, PathBuf);

fn collect(project: &LoadedProject) -> (ControlData, Vec<Source>) {
    let mut data = ControlData::default();
    let (mut constants, mut definitions, mut rows) = (Vec::new(), Vec::new(), BTreeMap::new());
    for file in &project.configuration {
        let Some(kind) = ConfigKind::of_path(&file.path) else { continue };
        let path = Path::new(&project.root).join(&file.path);
        match read(kind, &file.text).contents {
            Contents::Channel(channel) => {
                for it in &channel.parameters {
                    if let Some(value) = parameter(it) {
                        data.parameters.entry(control_bytes(&it.id.text)).or_insert(value);
                    }
                }
                data.wiring.points.extend(channel.points.iter().filter_map(mapping));
                data.wiring.connections.extend(connections(&channel));
                data.gears.extend(channel.spindles.iter().filter_map(gears));
                let small = |number: i64| u8::try_from(number).ok();
                let groups = channel.m_functions.iter();
                data.m_groups.extend(groups.filter_map(|it| Some((small(it.number)?, small(it.group)?))));
            }
            Contents::Constants(own) => constants.extend(own),
            Contents::TableDefinition(it) => definitions.push((it, path.with_extension("PlcT"))),
            Contents::Table(it) => {
                rows.entry(it.id.text.clone()).or_insert((it, path));
            }
            Contents::Messages(own) => {
                let numbered = own.iter().filter_map(|it| Some((u32::try_from(it.number).ok()?, it)));
                for (number, it) in numbered {
                    data.messages.entry(number).or_insert_with(|| message(it));
                }
            }
            Contents::Keyboard(_) => {}
        }
    }
    data.constants = numbered(&constants);
    let mut sources = Vec::new();
    for (definition, beside) in definitions {
        let found = rows.get(&definition.id.text);
        data.tables.push(table(&definition, found.map(|(rows, _)| rows)));
        sources.push((definition.id.text, found.map_or(beside, |(_, path)| path.clone())));
    }
    (data, sources)
}

/// An input or output; `None` when there is no such port, which the check reports.
fn mapping(it: &Point) -> Option<Mapping> {
    let channel::Conversion { scale, offset, min, max } = it.conversion;
    let analog = |channel| Analog {
        channel,
        scale,
        offset,
        min: min.unwrap_or(f64::NEG_INFINITY),
        max: max.unwrap_or(f64::INFINITY),
    };
    let physical = match place(it)? {
        Place::Bit(signal) => Physical::Bit { signal, invert: it.invert },
        Place::AnalogInput(channel) => Physical::AnalogInput(analog(channel)),
        Place::AnalogOutput(channel) => Physical::AnalogOutput(analog(channel)),
    };
    Some(Mapping {
        id: control_bytes(&it.id.text),
        physical,
        connected: it.connected == Some(true),
        default: it.default.trim().parse().unwrap_or(0.0),
    })
}

/// The gears of a spindle; `None` when there is no such spindle. Speeds are whole numbers.
fn gears(it: &channel::Spindle) -> Option<SpindleGears> {
    let gear = |(speed, output): &(f64, i64)| {
        let max_output = u16::try_from(*output).ok()?;
        Some(Gear { max_speed: speed.round() as u32, max_output })
    };
    Some(SpindleGears {
        spindle: u8::try_from(it.number).ok()?,
        speed_limit: it.speed_limit.round() as u32,
        gears: it.gears.iter().filter_map(gear).collect(),
    })
}

/// The connections that are connected.
fn connections(channel: &Channel) -> impl Iterator<Item = Connection> {
    let connected = channel.connections.iter().filter(|it| it.connected == Some(true));
    connected.map(|it| Connection {
        source: it.source.text.clone(),
        destination: it.destination.text.clone(),
        conversion: Conversion {
            invert: it.invert.is_some(),
            scale: it.conversion.scale,
            offset: it.conversion.offset,
        },
    })
}

/// The value of a parameter; `None` when it is not of its type, which the check reports.
fn parameter(it: &Parameter) -> Option<Value> {
    Some(match it.kind? {
        ParameterKind::Int => Value::Int(integer(it.value.text.trim())?),
        ParameterKind::Real => Value::Real(it.value.text.trim().parse().ok()?),
        ParameterKind::String => Value::Text(control_bytes(&it.value.text)),
        ParameterKind::Binary => Value::Bytes(hexadecimal(&it.value.text)?),
    })
}

/// Constants with their numbers. Those the control numbers by itself: integers each 4 bytes from 0 on in the shared area,
/// reals each 8 bytes from 16000 on, commands from 1 on, past numbers that are given.
fn numbered(constants: &[Constant]) -> BTreeMap<Vec<u8>, i64> {
    let given = |it: &Constant| match it.value {
        ConstantValue::Number(number) => Some(number),
        _ => None,
    };
    let given: BTreeSet<i64> = constants.iter().filter_map(given).collect();
    let (mut int, mut real, mut command) = (0, FIRST_REAL, 1);
    let mut all = BTreeMap::new();
    for it in constants {
        let value = match it.value {
            ConstantValue::Number(number) => number,
            ConstantValue::Automatic("SA0INT") => next(&mut int, 4),
            ConstantValue::Automatic("SA0REAL") => next(&mut real, 8),
            ConstantValue::Automatic(_) => {
                while given.contains(&command) {
                    command += 1;
                }
                next(&mut command, 1)
            }
            ConstantValue::Wrong => continue,
        };
        all.entry(control_bytes(&it.id.text)).or_insert(value);
    }
    all
}

fn next(number: &mut i64, step: i64) -> i64 {
    let own = *number;
    *number += step;
    own
}

fn table(definition: &TableDefinition, rows: Option<&table::Table>) -> Table {
    let kind = |kind: Option<ColumnKind>| match kind {
        Some(ColumnKind::Int) => ValueKind::Int,
        Some(ColumnKind::Real) => ValueKind::Real,
        Some(ColumnKind::Binary) => ValueKind::Bytes,
        Some(ColumnKind::String) | None => ValueKind::Text,
    };
    let column = |it: &table::Column| Column { id: control_bytes(&it.id.text), kind: kind(it.kind) };
    let columns: Vec<Column> = definition.columns.iter().map(column).collect();
    let row = |cells: &[table::Cell]| {
        let value = |(column, it): (&Column, &table::Column)| {
            let cell = cells.iter().find(|cell| cell.column.text == it.id.text);
            cell.and_then(|cell| cell_value(column.kind, &cell.value.text)).unwrap_or(column.kind.empty())
        };
        columns.iter().zip(&definition.columns).map(value).collect::<Vec<Value>>()
    };
    let rows = rows.map(|table| {
        let own = |cells: &std::ops::Range<usize>| row(table.cells.get(cells.clone()).unwrap_or_default());
        table.lines.iter().map(|(_, cells)| own(cells)).collect::<Vec<_>>()
    });
    Table { rows: rows.unwrap_or_default(), columns }
}

fn cell_value(kind: ValueKind, text: &str) -> Option<Value> {
    Some(match kind {
        ValueKind::Int => Value::Int(integer(text.trim())?),
        ValueKind::Real => Value::Real(text.trim().parse().ok()?),
        ValueKind::Text => Value::Text(control_bytes(text)),
        ValueKind::Bytes => Value::Bytes(hexadecimal(text)?),
    })
}

/// Pairs of hexadecimal digits, with spaces anywhere between digits.
fn hexadecimal(text: &str) -> Option<Vec<u8>> {
    let digits = text.chars().filter(|c| !c.is_whitespace()).map(|c| c.to_digit(16));
    let digits: Vec<u32> = digits.collect::<Option<_>>()?;
    let pair = |pair: &[u32]| match pair {
        [high, low] => u8::try_from(high * 16 + low).ok(),
        _ => None,
    };
    digits.chunks(2).map(pair).collect()
}

fn write(sources: &[Source], tables: &[Table]) -> io::Result<()> {
    for ((id, path), table) in sources.iter().zip(tables) {
        let text = xml(id, table);
        // A table that has not changed keeps its file, with its comments.
        let old =
            std::fs::read(path).ok().map(|bytes| technol_analysis::configuration::decode(&bytes, None).text);
        let same = old.is_some_and(|old| old == text || same_rows(table, &old));
        if !same {
            technol_target::replace(path, text.as_bytes())
                .map_err(|error| io::Error::new(error.kind(), format!("{}: {error}", path.display())))?;
        }
    }
    Ok(())
}

/// Whether the file holds these rows already.
fn same_rows(own: &Table, text: &str) -> bool {
    let Contents::Table(rows) = read(ConfigKind::Table, text).contents else { return false };
    let column = |(number, column): (usize, &Column)| table::Column {
        number: number as i64,
        id: technol_analysis::configuration::document::Text {
            text: control_text(&column.id),
            ..Default::default()
        },
        kind: Some(match column.kind {
            ValueKind::Int => ColumnKind::Int,
            ValueKind::Real => ColumnKind::Real,
            ValueKind::Text => ColumnKind::String,
            ValueKind::Bytes => ColumnKind::Binary,
        }),
    };
    let columns = own.columns.iter().enumerate().map(column).collect();
    table(&TableDefinition { columns, ..Default::default() }, Some(&rows)) == *own
}

/// A `*.PlcT` file. Writing to a text does not fail.
fn xml(id: &str, table: &Table) -> String {
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<PLCTable>\n  <Definition>\n    <DefinitionID>{}</DefinitionID>\n    \
         <LinesCount>{}</LinesCount>\n  </Definition>\n",
        escaped(id),
        table.rows.len()
    );
    for row in 0..table.rows.len() {
        let _ = write!(text, "  <Line No=\"{row}\">");
        for (number, column) in table.columns.iter().enumerate() {
            let value = match table.value(row, number) {
                Some(Value::Int(value)) => value.to_string(),
                // XML files know no infinity.
                Some(Value::Real(value)) => if value.is_finite() { value } else { 0.0 }.to_string(),
                Some(Value::Text(bytes)) => escaped(&control_text(&bytes)),
                Some(Value::Bytes(bytes)) => bytes.iter().fold(String::new(), |mut digits, byte| {
                    let _ = write!(digits, "{byte:02X}");
                    digits
                }),
                None => continue,
            };
            let _ = write!(text, "<Col ColID=\"{}\">{value}</Col>", escaped(&control_text(&column.id)));
        }
        text += "</Line>\n";
    }
    text + "</PLCTable>\n"
}

/// As the content of an element; characters that XML does not have are left out.
fn escaped(text: &str) -> String {
    let mut all = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => all += "&amp;",
            '<' => all += "&lt;",
            '>' => all += "&gt;",
            '"' => all += "&quot;",
            '\t' | '\n' => all.push(c),
            c if c.is_control() => {}
            c => all.push(c),
        }
    }
    all
}
