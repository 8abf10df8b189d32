//! Configuration files and the image: nothing of them goes into it.

use super::{built, project, refused, shown, source};

const DATA: &str = "PRESSED: DS 1\n";
const BROKEN: &str = "<PlcErrors><PlcError No=\"1\"</PlcErrors>";
const WRONG: &str = "<PlcErrors><PlcError No=\"1\" Type=\"Nothing\" Validity=\"Transient\"/></PlcErrors>";

fn program() -> String {
    source(DATA, "        LOD PRESSED\n        ESET 1\n")
}

#[test]
fn errors_in_configuration_files_hinder_no_build_and_change_nothing_in_it() {
    let program = program();
    let alone = built(&project(&[("main.plc", &program)])).image.program;
    for (file, code) in [(BROKEN, "T0901"), (WRONG, "T0904")] {
        let analysis = project(&[("main.plc", &program), ("a.PlcErrors", file)]);
        assert!(built(&analysis).image.program == alone, "{file}");
        let errors = analysis.configuration_errors().expect("nothing cancels it");
        let codes: Vec<_> = errors.iter().map(|(path, d)| (path.as_str(), d.code)).collect();
        assert_eq!(codes, [("a.PlcErrors", code)], "{file}");
    }
}

#[test]
fn errors_of_the_program_refuse_the_build_and_come_without_those_of_configuration_files() {
    let program = source(DATA, "        LDR NOWHERE\n");
    let errors = refused(&project(&[("main.plc", &program), ("a.PlcErrors", BROKEN)]));
    assert!(!errors.is_empty() && errors.iter().all(|(file, _)| file == "main.plc"), "{}", shown(&errors));
}
