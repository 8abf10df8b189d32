//! Configuration files as the running program sees them, and what is kept from run to run.

use serde_json::{Value, json};

use crate::frame::program;
use crate::ran::{Folder, run};

const DATA: &str = "\
FLAGS: DFM ALL_FOUND,,,,,,,
TEETH: DS 2
STARTS: DS 2
DELAY: DS 4
SPEED: DS 8
TITLE: STR 8
RAW: STR 3
INT_AT: DS 2
REAL_AT: DS 2
NEXT_AT: DS 2
CMD: DS 4
OTHER: DS 4";
const INIT: &str = "\
 CNF_GET_INT DELAY,'Delay',5
 CNF_GET_REAL SPEED,'Speed'
 CNF_GET_STR TITLE,'Title'
 CNF_GET_BIN RAW,'Raw'
 CONST_GET INT_AT,'INT_AT'
 CONST_GET REAL_AT,'REAL_AT'
 CONST_GET NEXT_AT,'NEXT_AT'
 CONST_GET CMD,'START'
 CONST_GET OTHER,'STOP_IT'
 WR ALL_FOUND
 LOD WORD.PLC_MEM_BACKUP
 INR
 STO WORD.PLC_MEM_BACKUP
 STO STARTS
 FL 1,COUNT_UP";
const MAIN: &str = "\
MECH_BEGIN COUNT_UP
 PLCT_GET_INT 0,0,1,TEETH
 EX0
 LOD TEETH
 INR
 STO TEETH
 PLCT_SET_INT 0,0,1,TEETH
 EX0
MECH_END COUNT_UP";
const CHANNEL: &str = "<ChannelConfig><Plc>\
<PlcParam ID=\"Delay\" Type=\"Int\">0x50</PlcParam><PlcParam ID=\"Speed\" Type=\"Real\">2.5</PlcParam>\
<PlcParam ID=\"Title\" Type=\"String\">Saw</PlcParam><PlcParam ID=\"Raw\" Type=\"Binary\">0A 1b</PlcParam>\
</Plc></ChannelConfig>";
const CONSTANTS: &str = "<PlcConstants><Constant ID=\"INT_AT\" Value=\"SA0INT\"/><Constant ID=\"REAL_AT\" Value=\"SA0REAL\"/>\
<Constant ID=\"NEXT_AT\" Value=\"SA0INT\"/><Constant ID=\"START\" Value=\"PLCCOMMAND\"/><Constant ID=\"STOP_IT\" Value=\"1\"/>\
</PlcConstants>";
const COLUMNS: &str = "<PLCTableDef><Definition><DefinitionID>Wheels</DefinitionID><ColsCount>2</ColsCount>\
<Col No=\"0\"><ColID>Name</ColID><ColType>STRING</ColType></Col>\
<Col No=\"1\"><ColID>Teeth</ColID><ColType>INT</ColType></Col></Definition></PLCTableDef>";
const ROWS: &str = "<PLCTable><Definition><DefinitionID>Wheels</DefinitionID><LinesCount>1</LinesCount></Definition>\
<Line No=\"0\"><Col ColID=\"Name\">A &amp; B</Col><Col ColID=\"Teeth\">24</Col></Line></PLCTable>";
const NAMES: &str = "TEETH,STARTS,DELAY,REAL.SPEED,ALL_FOUND,WORD.RAW,INT_AT,REAL_AT,NEXT_AT,CMD,OTHER";

fn project(machine: &str) -> Folder {
    let source = program(DATA, MAIN, INIT);
    Folder::with(&[
        (
            "technol.toml",
            b"[project]\nname = \"saw\"\nmain = \"main.plc\"\n[machine]\nfile = \"machine.toml\"\n"
                .as_slice(),
        ),
        ("main.plc", source.as_bytes()),
        ("machine.toml", machine.as_bytes()),
        ("saw.ChannelConfig", CHANNEL.as_bytes()),
        ("saw.PlcConstants", CONSTANTS.as_bytes()),
        ("saw.PlcTDef", COLUMNS.as_bytes()),
        ("saw.PlcT", ROWS.as_bytes()),
    ])
}

fn values(folder: &Folder, more: &[&str]) -> Value {
    let path = folder.path("");
    let ran = run(&[&["run", &path, "--cycles", "10", "--format", "json", "--print", NAMES], more].concat());
    assert_eq!(ran.code, Some(0), "{ran:?}");
    ran.json()["values"].clone()
}

#[test]
fn a_program_reads_the_configuration_files_of_its_project() {
    let folder = project("");
    // PLCCOMMAND goes past the number that is given.
    let expected = json!({
        "TEETH": 25, "STARTS": 1, "DELAY": 0x50, "REAL.SPEED": 2.5, "ALL_FOUND": true, "WORD.RAW": 0x1B0A,
        "INT_AT": 0, "REAL_AT": 16000, "NEXT_AT": 4, "CMD": 2, "OTHER": 1
    });
    assert_eq!(values(&folder, &[]), expected);
    // Nothing is kept unless that is asked for.
    assert_eq!(values(&folder, &[]), expected);
}

#[test]
fn the_machine_file_says_what_is_kept() {
    let folder = project("[keep]\nbackup = \"memory.bin\"\ntables = true\n");
    for n in 1..=2 {
        let found = values(&folder, &[]);
        assert_eq!((&found["TEETH"], &found["STARTS"]), (&json!(24 + n), &json!(n)));
    }
    let kept = std::fs::read(folder.path("memory.bin")).expect("the memory");
    assert_eq!((kept.len(), &kept[..3]), (10_000, [2, 0, 0].as_slice()));
    let table = std::fs::read_to_string(folder.path("saw.PlcT")).expect("the table");
    assert!(
        table.contains(
            "<Line No=\"0\"><Col ColID=\"Name\">A &amp; B</Col><Col ColID=\"Teeth\">26</Col></Line>"
        ),
        "{table}"
    );
}

#[test]
fn a_backup_file_can_be_named() {
    let folder = project("");
    let file = folder.path("other.bin");
    assert_eq!(values(&folder, &["--backup", &file])["STARTS"], 1);
    assert_eq!(values(&folder, &["--backup", &file])["STARTS"], 2);
    let unreadable = folder.path("");
    let path = folder.path("");
    run(&["run", &path, "--cycles", "1", "--backup", &unreadable])
        .failed(2, &["cannot read the backed-up memory"]);
}
