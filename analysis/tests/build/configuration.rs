//! Configuration files and the image: nothing of them goes into it.

use technol_analysis::Analysis;

use super::{built, project, refused, shown, source};

const DATA: &str = "PRESSED: DS 1\n";
const BROKEN: &str = "<PlcErrors><PlcError No=\"1\"</PlcErrors>";
const SOUND: &str = "<PlcErrors><PlcError No=\"1\" Type=\"Err\" Validity=\"Transient\"><Text>Oil</Text></PlcError></PlcErrors>";
const WRONG: &str = "<PlcErrors><PlcError No=\"1\" Type=\"Nothing\" Validity=\"Transient\"><Text>Oil</Text></PlcError></PlcErrors>";

fn with_messages(program: &str, messages: &str) -> Analysis {
    let manifest = "[project]\nname = \"m\"\nconfiguration = [\"a.PlcErrors\"]\n";
    project(&[("technol.toml", manifest), ("main.plc", program), ("a.PlcErrors", messages)])
}

#[test]
fn errors_in_configuration_files_hinder_no_build_and_change_nothing_in_it() {
    let program = source(DATA, "        LOD PRESSED\n        ESET 1\n");
    let sound = with_messages(&program, SOUND);
    assert_eq!(sound.configuration_errors().expect("nothing cancels it"), []);
    let image = built(&sound).image.program;
    for (file, code) in [(BROKEN, "T0901"), (WRONG, "T0905")] {
        let analysis = with_messages(&program, file);
        assert!(built(&analysis).image.program == image, "{file}");
        let errors = analysis.configuration_errors().expect("nothing cancels it");
        let codes: Vec<_> = errors.iter().map(|(path, d)| (path.as_str(), d.code)).collect();
        assert_eq!(codes, [("a.PlcErrors", code)], "{file}");
    }
}

#[test]
fn errors_of_the_program_refuse_the_build_and_come_without_those_of_configuration_files() {
    let program = source(DATA, "        LDR NOWHERE\n");
    let errors = refused(&with_messages(&program, BROKEN));
    assert!(!errors.is_empty() && errors.iter().all(|(file, _)| file == "main.plc"), "{}", shown(&errors));
}
