//! `technol fmt --encoding`.

use std::fs;
use std::path::Path;

use crate::ran::run;

const TEXT: &str = "; příliš žluťoučký kůň\r\nDATA\r\n\t;zůstane  tak \nDATA_END";

fn write(path: &Path, text: &str, cp852: bool) {
    let encoding = if cp852 {
        technol_analysis::project::Encoding::Cp852
    } else {
        technol_analysis::project::Encoding::Windows1250
    };
    fs::write(path, technol_analysis::project::encode(text, encoding).expect("Czech fits")).expect("written");
}

#[test]
fn a_file_goes_through_all_encodings_and_comes_back_byte_for_byte() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.plc");
    fs::write(&path, TEXT).expect("written");
    let name = path.to_str().expect("plain");
    for encoding in ["windows-1250", "cp852", "utf-8"] {
        assert!(run(&["fmt", "--encoding", encoding, name]).ok().contains(encoding));
        assert!(run(&["fmt", "--encoding", encoding, "--check", name]).ok().contains("already"));
    }
    assert_eq!(fs::read(&path).expect("read"), TEXT.as_bytes());
}

#[test]
fn a_project_is_converted_with_its_manifest() {
    let folder = tempfile::tempdir().expect("a folder");
    let manifest = "[project]\nname = \"p\"\nmain = \"a.plc\"\nencoding = \"cp852\" # old\n";
    fs::write(folder.path().join("technol.toml"), manifest).expect("written");
    write(&folder.path().join("a.plc"), TEXT, true);
    let root = folder.path().to_str().expect("plain");
    run(&["fmt", "--encoding", "utf-8", "--check", root]).failed(1, &[]);
    run(&["fmt", "--encoding", "utf-8", root]).ok();
    assert_eq!(fs::read_to_string(folder.path().join("a.plc")).expect("UTF-8"), TEXT);
    let now = fs::read_to_string(folder.path().join("technol.toml")).expect("read");
    assert_eq!(now, manifest.replace("cp852", "utf-8"));
}

#[test]
fn configuration_files_of_a_project_are_converted_too() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("technol.toml"), "[project]\nname = \"p\"\nmain = \"a.plc\"\n")
        .expect("written");
    fs::write(folder.path().join("a.plc"), "DATA\nDATA_END\n").expect("written");
    let errors = folder.path().join("p.PlcErrors");
    let text =
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<PlcErrors><!-- porucha v\u{159}etene --></PlcErrors>\n";
    fs::write(&errors, text).expect("written");
    run(&["fmt", "--encoding", "windows-1250", folder.path().to_str().expect("plain")]).ok();
    let bytes = fs::read(&errors).expect("read");
    let (now, wanted) = (String::from_utf8_lossy(&bytes), "encoding=\"windows-1250\"?>");
    assert!(now.contains(wanted) && bytes.contains(&0xF8), "{now}");
}

#[test]
fn what_does_not_fit_is_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let (good, bad) = (folder.path().join("good.plc"), folder.path().join("bad.plc"));
    write(&good, TEXT, false);
    fs::write(&bad, "\n; 漢\n").expect("written");
    let before = fs::read(&good).expect("read");
    let names = [good.to_str().expect("plain"), bad.to_str().expect("plain")];
    run(&["fmt", "--encoding", "cp852", names[0], names[1]]).failed(2, &["bad.plc:2", "漢"]);
    assert_eq!(fs::read(&good).expect("read"), before);
    run(&["fmt", "--encoding", "utf-8", "--from", "utf-8", names[0]]).failed(2, &["good.plc:1", "--from"]);
    run(&["fmt", names[0]]).failed(2, &["--encoding"]);
    run(&["fmt", "--encoding", "utf-8", "nowhere.plc"]).failed(2, &["nowhere.plc"]);
}
