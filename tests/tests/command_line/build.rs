//! `technol build`.

use std::path::Path;

use crate::frame::program;
use crate::lathe::Lathe;
use crate::ran::{Folder, run};

fn is_up_to_date(arguments: &[&str]) -> bool {
    let out = run(&[&["build"], arguments].concat()).ok();
    let current = out.contains("up to date");
    assert_eq!(!current, out.contains("operations"), "it says what it did: {out}");
    current
}

#[test]
fn nothing_is_built_when_nothing_changed() {
    let lathe = Lathe::copy();
    let folder = lathe.path("");
    assert!(!is_up_to_date(&[&folder]), "the first time");
    let image = std::fs::read(lathe.path("out/lathe.tplc")).expect("the image");
    assert!(is_up_to_date(&[&folder]));
    assert!(is_up_to_date(&[&lathe.path("technol.toml")]), "the same project by another name");
    assert!(!is_up_to_date(&[&folder, "--force"]));
    let again = std::fs::read(lathe.path("out/lathe.tplc")).expect("the image");
    assert_eq!(image, again, "the same sources give the same image");

    lathe.edit("include/lathe.inc", "EQUI T_DEAD,15", "EQUI T_DEAD,16");
    assert!(!is_up_to_date(&[&folder]), "an included file has changed");
    assert!(is_up_to_date(&[&folder]));
    assert_ne!(image, std::fs::read(lathe.path("out/lathe.tplc")).expect("the image"));
    lathe.edit("technol.toml", "everywhere = true", "everywhere = false");
    assert!(!is_up_to_date(&[&folder]), "the manifest has changed what is built");
}

#[test]
fn what_is_damaged_is_built_again() {
    let lathe = Lathe::copy();
    let folder = lathe.path("");
    assert!(!is_up_to_date(&[&folder]));
    let image = std::fs::read(lathe.path("out/lathe.tplc")).expect("the image");
    let mut flipped = image.clone();
    flipped[image.len() / 2] ^= 1;
    let damages: [(&str, &[u8]); 6] = [
        ("lathe.tplc", b""),
        ("lathe.tplc", b"something else"),
        ("lathe.tplc", &image[..image.len() - 7]),
        ("lathe.tplc", &flipped),
        ("lathe.stamp", b""),
        ("lathe.stamp", b"\xFF\xFE\n"),
    ];
    for (file, content) in damages {
        std::fs::write(lathe.path("out").clone() + "/" + file, content).expect("written");
        assert!(!is_up_to_date(&[&folder]), "{file} with {} bytes", content.len());
        assert_eq!(std::fs::read(lathe.path("out/lathe.tplc")).expect("the image"), image);
        assert!(is_up_to_date(&[&folder]), "{file} is as it should be");
    }
    std::fs::remove_file(lathe.path("out/lathe.tplc")).expect("removed");
    assert!(!is_up_to_date(&[&folder]), "the image is gone");
}

#[test]
fn the_listing_has_every_source_line_with_address_and_code() {
    let lathe = Lathe::copy();
    let folder = lathe.path("");
    assert!(!is_up_to_date(&[&folder]));
    assert!(!Path::new(&lathe.path("out/lathe.LS1")).exists(), "only when asked for");
    assert!(!is_up_to_date(&[&folder, "--listing"]), "the listing is missing");
    assert!(is_up_to_date(&[&folder, "--listing"]));
    let listing = std::fs::read_to_string(lathe.path("out/lathe.LS1")).expect("the listing");
    let dead_time = lathe.line("spindle.plc", "TIM  CNT_DEAD,T_DEAD");
    let line = listing.lines().find(|l| l.contains("TIM  CNT_DEAD,T_DEAD")).expect("the source line");
    let mut words = line.split_whitespace();
    assert_eq!(words.next(), Some(dead_time.to_string().as_str()), "{line}");
    let address = words.next().expect("an address");
    assert!(address.chars().all(|c| c.is_ascii_hexdigit()), "{line}");
    for file in ["main.plc", "spindle.plc", "turret.plc", "panel.plc"] {
        let source = std::fs::read_to_string(lathe.path(file)).expect("a source");
        for line in source.lines().filter(|l| !l.trim().is_empty()) {
            assert!(listing.contains(line.trim()), "{file}: `{line}` is listed");
        }
    }
}

#[test]
fn the_results_go_where_they_are_wanted() {
    let lathe = Lathe::copy();
    let elsewhere = lathe.path("some/where");
    assert!(!is_up_to_date(&[&lathe.path(""), "--out", &elsewhere, "--listing"]));
    for file in ["lathe.tplc", "lathe.LS1"] {
        assert!(Path::new(&elsewhere).join(file).is_file(), "{file}");
    }
    assert!(!Path::new(&lathe.path("out")).exists());

    let lone = Folder::lone(&program("", " NOP", ""));
    assert!(!is_up_to_date(&[&lone.path("plc.plc")]));
    assert!(Path::new(&lone.path("out/plc.tplc")).is_file(), "a lone file is a project of its own");

    // A file where a folder is wanted.
    lone.write("taken", b"");
    let ran = run(&["build", &lone.path("plc.plc"), "--out", &lone.path("taken")]);
    ran.failed(2, &["taken", "--out"]);
}

#[test]
fn a_project_with_errors_is_not_built() {
    let folder = Folder::lone(&program("", " LDR NOBODY\n JL0 L\nL:", ""));
    let ran = run(&["build", &folder.path("plc.plc")]);
    ran.failed(1, &["plc.plc:5:6", "T0301", "NOBODY", "not built: 1 error"]);
    assert!(!Path::new(&folder.path("out/plc.tplc")).exists());
    run(&["build", &folder.path("nowhere.plc")]).failed(2, &["nowhere.plc"]);
}

#[test]
fn a_listing_of_an_older_image_is_not_taken_for_current() {
    let lathe = Lathe::copy();
    let folder = lathe.folder().to_string_lossy().into_owned();
    run(&["build", &folder, "--listing"]).ok();
    lathe.edit("panel.plc", "TIM  -,50", "TIM  -,51");
    run(&["build", &folder]).ok();
    let out = run(&["build", &folder, "--listing"]).ok();
    assert!(!out.contains("up to date"), "{out}");
    let listing = std::fs::read_to_string(lathe.path("out/lathe.LS1")).expect("a listing");
    assert!(listing.contains("TIM  -,51"));
}
