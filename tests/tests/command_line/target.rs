//! `technol target` before any debugger is there.

use crate::lathe::Lathe;
use crate::ran::{Folder, run};

const LISTEN: [&str; 2] = ["--listen", "tcp:127.0.0.1:0"];

#[test]
fn images_that_cannot_be_loaded_are_refused_with_a_remedy() {
    let lathe = Lathe::copy();
    run(&["build", &lathe.path("")]).ok();
    let image = std::fs::read(lathe.path("out/lathe.tplc")).expect("the image");
    let mut flipped = image.clone();
    flipped[image.len() / 2] ^= 1;
    let mut newer = image.clone();
    newer[4] = 0xEE;
    let folder = Folder::with(&[
        ("foreign.tplc", b"\x7FELF and so on, longer than any header"),
        ("empty.tplc", b""),
        ("short.tplc", &image[..image.len() / 2]),
        ("flipped.tplc", &flipped),
        ("newer.tplc", &newer),
        ("source.plc", b"MODULE_MAIN\n"),
    ]);
    for name in
        ["foreign.tplc", "empty.tplc", "short.tplc", "flipped.tplc", "newer.tplc", "source.plc", "none.tplc"]
    {
        let path = folder.path(name);
        let ran = run(&["target", &path, LISTEN[0], LISTEN[1]]);
        ran.failed(2, &[&path, "technol build"]);
        assert_eq!(ran.out, "", "{name}: it does not listen");
    }
}

#[test]
fn places_that_cannot_be_served_are_refused_with_a_remedy() {
    run(&["target"]).failed(2, &["--listen"]);
    run(&["target", "--listen", "tcp:127.0.0.1:0", "--serial", "/dev/x"]).failed(2, &["--serial"]);
    run(&["target", "--listen", "127.0.0.1:5700"]).failed(2, &["tcp:HOST:PORT"]);
    run(&["target", "--listen", "serial:/dev/x"]).failed(2, &["tcp:HOST:PORT"]);
    run(&["target", "--serial", "/dev/no-such-line"]).failed(2, &["/dev/no-such-line", "cable"]);
    run(&["target", LISTEN[0], LISTEN[1], "--machine", "no-machine.toml"]).failed(2, &["no-machine.toml"]);
    run(&["target", LISTEN[0], LISTEN[1], "--start"]).failed(2, &["IMAGE"]);
    let taken = std::net::TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = format!("tcp:{}", taken.local_addr().expect("its number"));
    run(&["target", "--listen", &address]).failed(2, &[&address]);
    run(&["dap", "--listen", &address]).failed(2, &[&address, "another port"]);
}
