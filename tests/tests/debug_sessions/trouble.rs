//! What can go wrong in a session, and what the user is told.

use std::io::Write as _;
use std::net::{TcpListener, TcpStream};
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use technol_dap::client::Mark;

use crate::child::{Adapter, Site};
use crate::frame::program;
use crate::lathe::Lathe;

#[test]
fn a_target_that_is_not_there_is_an_error_with_a_remedy() {
    let lathe = Lathe::copy();
    // A port that was free a moment ago.
    let free = TcpListener::bind("127.0.0.1:0").expect("a port").local_addr().expect("its number");
    let tcp = format!("tcp:{free}");
    for (target, parts) in [
        (tcp.as_str(), &[tcp.as_str(), "technol target --listen"][..]),
        ("serial:/dev/no-such-line@9600", &["/dev/no-such-line", "cable"]),
        ("tcp:127.0.0.1", &["tcp:127.0.0.1", "tcp:HOST:PORT"]),
        ("usb", &["`usb`", "serial:DEVICE@BAUD"]),
    ] {
        for command in ["launch", "attach"] {
            let mut adapter = Adapter::initialized();
            let why = adapter.refusal(command, json!({ "program": lathe.folder(), "target": target }));
            for part in parts {
                assert!(why.contains(part), "{command} {target}: `{part}` in: {why}");
            }
        }
    }
}

#[test]
fn a_session_that_could_not_start_may_try_again() {
    let lathe = Lathe::copy();
    let mut adapter = Adapter::initialized();
    let why = adapter.refusal("launch", json!({ "program": lathe.path("nowhere"), "target": "embedded" }));
    assert!(why.contains("nowhere") && why.contains("`program`"), "{why}");
    let line = lathe.line("spindle.plc", "LDR  SP_REQ_STOP ");
    lathe.edit("spindle.plc", "LDR  SP_REQ_STOP ", "LDR  SP_REQ_STOPP ");
    let launch = Site::embedded().launch(&lathe);
    let why = adapter.refusal("launch", launch.clone());
    assert!(why.contains(&format!("spindle.plc:{line}")) && why.contains("SP_REQ_STOPP"), "{why}");
    lathe.edit("spindle.plc", "SP_REQ_STOPP", "SP_REQ_STOP");
    adapter.client.request("launch", launch).expect("now it starts");
}

#[test]
fn requests_in_the_wrong_order_are_refused_with_what_is_missing() {
    let lathe = Lathe::copy();
    let mut adapter = Adapter::start();
    let early =
        ["launch", "attach", "threads", "configurationDone", "setBreakpoints", "continue", "evaluate"];
    for command in early {
        let why = adapter.refusal(command, json!({}));
        assert!(why.contains(command) && why.contains("initialize"), "{why}");
    }
    adapter.client.initialize().expect("the session is as new");
    let why = adapter.refusal("initialize", json!({ "adapterID": "technol" }));
    assert!(why.contains("twice"), "{why}");
    for command in ["threads", "configurationDone", "pause", "next", "stackTrace", "terminate"] {
        match adapter.client.request(command, json!({ "threadId": 1 })) {
            Ok(body) if command == "terminate" => assert_eq!(body, Value::Null),
            Ok(body) => panic!("{command}: {body}"),
            Err(why) => assert!(why.to_string().contains("launch"), "{why}"),
        }
    }
    let why = adapter.refusal("makeCoffee", json!({}));
    assert!(why.contains("makeCoffee"), "{why}");

    let mut adapter = Adapter::start();
    let line = lathe.line("spindle.plc", "TIM  CNT_DEAD,T_DEAD");
    let breakpoint = (lathe.path("spindle.plc"), [line]);
    adapter
        .client
        .start(Site::embedded().launch(&lathe), &[(&breakpoint.0, &breakpoint.1)])
        .expect("the program starts");
    adapter.client.event(Mark::START, "stopped").expect("a stop");
    for (command, arguments, part) in [
        ("launch", Site::embedded().launch(&lathe), "launch"),
        ("stackTrace", json!({ "threadId": 999 }), "999"),
        ("scopes", json!({ "frameId": 4711 }), "4711"),
        ("variables", json!({ "variablesReference": 4711 }), "4711"),
        ("setVariable", json!({ "variablesReference": "one" }), "setVariable"),
    ] {
        let why = adapter.refusal(command, arguments);
        assert!(why.contains(part), "{command}: {why}");
    }
    assert_eq!(adapter.client.evaluate("SP_TURNS", "watch").expect("still there"), "1 (0001h)");
}

#[test]
fn malformed_messages_do_not_end_the_session() {
    let lathe = Lathe::copy();
    let mut adapter = Adapter::initialized();
    for (bytes, told) in [
        (&b"Content-Length: 5\r\n\r\n{\"a\":"[..], "not valid JSON"),
        (b"Content-Length: 2\r\n\r\n\xFF\xFE", "not valid JSON"),
        (b"GET / HTTP/1.1\r\n\r\n", "Content-Length"),
        (b"Content-Length: many\r\n\r\n", "Content-Length"),
        (b"Content-Length: 9\r\n\r\n[1,2,3,4]", "command"),
        (b"Content-Length: 4\r\n\r\nnull", "command"),
    ] {
        let mark = adapter.client.mark();
        adapter.client.send_raw(bytes).expect("the adapter reads");
        let output = adapter.client.event(mark, "output").unwrap_or_else(|e| panic!("{told}: {e}"));
        let text = output["output"].as_str().expect("a text");
        assert!(text.contains("ignored") && text.contains(told), "{told}: {text}");
    }
    adapter.client.request("launch", Site::embedded().launch(&lathe)).expect("the session is as it was");
}

#[test]
fn a_target_that_dies_ends_the_session_within_seconds() {
    let lathe = Lathe::copy();
    for site in [Some(Site::tcp(&lathe)), Site::serial(&lathe)].into_iter().flatten() {
        let mut site = site;
        let mut adapter = Adapter::start();
        adapter.client.start(site.launch(&lathe), &[]).expect("the program starts");
        let mark = adapter.client.mark();
        let start = Instant::now();
        site.target.as_mut().expect("a process").kill();
        adapter.client.event(mark, "terminated").expect("the session ends");
        assert!(start.elapsed() < Duration::from_secs(20), "{}: {:?}", site.address, start.elapsed());
        let output = adapter.client.event_where(mark, "output", |b| {
            b["output"].as_str().is_some_and(|text| text.contains("the link to the target is lost"))
        });
        output.expect("the reason is told");
        let why = adapter.refusal("evaluate", json!({ "expression": "CYCLES" }));
        assert!(why.contains("ended"), "{why}");
        adapter.client.disconnect(json!({})).expect("the adapter answers to the end");
        assert_eq!(adapter.exit_code(), Some(0));
    }
}

#[test]
fn an_editor_that_goes_away_takes_the_adapter_with_it() {
    let lathe = Lathe::copy();
    let mut adapter = Adapter::start();
    adapter.client.start(Site::embedded().launch(&lathe), &[]).expect("the program starts");
    adapter.client = technol_dap::client::Client::new(std::io::empty(), std::io::sink());
    let code = adapter.exit_code();
    // 2 when it was just about to tell the editor something.
    assert!([Some(0), Some(2)].contains(&code), "{code:?}");
}

#[test]
fn a_fault_of_the_program_stops_at_its_line_and_leaves_everything_readable() {
    let folder = tempfile::tempdir().expect("a folder");
    let data = "VALUE: DS 2\nZERO: DS 2";
    let main = "MECH_BEGIN WORKER\n LOD VALUE\n EX\n DIVB ZERO\n STO VALUE\nMECH_END WORKER";
    let source = program(data, main, " LOD CNST.77\n STO VALUE\n FL 1,WORKER");
    let path = folder.path().join("divide.plc");
    std::fs::write(&path, &source).expect("written");
    let line = source.lines().position(|l| l.contains("DIVB")).expect("the division") + 1;

    let mut adapter = Adapter::start();
    let launch = json!({ "program": path, "target": "embedded", "clock": "virtual" });
    adapter.client.start(launch, &[]).expect("the program starts");
    let stop = adapter.client.event(Mark::START, "stopped").expect("a stop");
    assert_eq!((&stop["reason"], &stop["text"]), (&json!("exception"), &json!("division by zero")));
    let thread = stop["threadId"].as_i64().expect("a thread");
    let frame = adapter.client.top_frame(thread).expect("a frame");
    assert_eq!((&frame["name"], &frame["line"]), (&json!("WORKER"), &json!(line)));
    let info = adapter.client.request("exceptionInfo", json!({ "threadId": thread })).expect("the reason");
    let text = info["description"].as_str().expect("a text");
    assert!(text.contains(&format!("divide.plc:{line}")) && text.contains("WORKER"), "{text}");
    assert_eq!(adapter.client.evaluate("VALUE", "watch").expect("readable"), "77 (004Dh)");
    let why = adapter.refusal("continue", json!({ "threadId": thread }));
    assert!(why.contains("fault") && why.contains("restart"), "{why}");
}

/// The line that faults (one of these), what is said, the lines of the mechanism and those behind it.
const MISUSES: &[(&str, &str, &str)] = &[
    (" DIVB ZERO", "division by zero", "LOD VALUE / DIVB ZERO"),
    (" BIN", "BCD", "LOD CNST.0FFh / BIN"),
    (" EQ CNST.0| JL1 AGAIN| LOD ZERO", "endless loop", "AGAIN: / LOD ZERO / EQ CNST.0 / JL1 AGAIN"),
    // The index leads out of memory.
    (
        " STO BYTE.VALUE[BX]",
        "outside PLC memory",
        "LOD CNST.8000h / MOV BX,CX / RL 8 / MOV EBX,80000000h / STO BYTE.VALUE[BX]",
    ),
    // It leads into the cells in which a mechanism keeps where it is: the next pass finds nonsense there.
    (
        "MECH_BEGIN WORKER",
        "continuation",
        "EX // MOV EBX,0 / LOOP: / LOD CNST.0FFh / STO BYTE.ZERO[BX] / INC EBX / CMP EBX,20 / JB LOOP",
    ),
];

#[test]
fn whatever_a_program_misuses_is_told_with_file_line_and_mechanism_and_the_target_lives_on() {
    for (faulty, said, lines) in MISUSES {
        let folder = tempfile::tempdir().expect("a folder");
        let indented = |lines: &str| lines.split(" / ").map(indented).collect::<Vec<_>>().join("\n");
        let (within, behind) = lines.split_once(" // ").unwrap_or((lines, "NOP"));
        let main =
            format!("MECH_BEGIN WORKER\n EX\n{}\nMECH_END WORKER\n{}", indented(within), indented(behind));
        let source = program("VALUE: DS 2\nZERO: DS 2", &main, " LOD CNST.77\n STO VALUE\n FL 1,WORKER");
        let path = folder.path().join("misuse.plc");
        std::fs::write(&path, &source).expect("written");
        let places = source.lines().zip(1..).filter(|(line, _)| faulty.split('|').any(|one| one == *line));
        let places: Vec<String> = places.map(|(_, n)| format!("misuse.plc:{n}")).collect();

        let mut adapter = Adapter::start();
        let launch = json!({ "program": path, "target": "embedded", "clock": "virtual" });
        adapter.client.start(launch, &[]).unwrap_or_else(|e| panic!("{said}: {e}"));
        let mut mark = Mark::START;
        // The second time after a restart: it is the same fault, in the same target.
        for _ in 0..2 {
            let stop = adapter.client.event(mark, "stopped").unwrap_or_else(|e| panic!("{said}: {e}"));
            assert_eq!(stop["reason"], "exception", "{said}: {stop}");
            let thread = stop["threadId"].as_i64().expect("a thread");
            let info =
                adapter.client.request("exceptionInfo", json!({ "threadId": thread })).expect("the reason");
            let text = info["description"].as_str().expect("a text");
            assert!(text.contains(said) && text.contains("WORKER"), "{said}: {text}");
            assert!(places.iter().any(|place| text.contains(place.as_str())), "{places:?}: {text}");
            let value = adapter.client.evaluate("VALUE", "watch").expect("readable");
            assert!(value.starts_with("77 ") || *said == "continuation", "{said}: {value}");
            mark = adapter.client.mark();
            adapter.client.request("restart", json!({})).unwrap_or_else(|e| panic!("{said}: {e}"));
        }
    }
}

/// Labels and mechanisms stand in the first column, instructions behind it.
fn indented(line: &str) -> String {
    if line.ends_with(':') { line.to_owned() } else { format!(" {line}") }
}

#[test]
fn a_server_that_is_no_target_is_recognised_within_seconds() {
    let lathe = Lathe::copy();
    for greeting in [&b""[..], b"HTTP/1.1 400 Bad Request\r\n\r\n", &[0x7E; 5000]] {
        let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
        let target = format!("tcp:{}", listener.local_addr().expect("its number"));
        // Accepts, says what it says, and keeps the line open until the adapter goes.
        std::thread::spawn(move || {
            let mut open = Vec::new();
            while let Ok((mut stream, _)) = listener.accept() {
                // The adapter may have gone already.
                let _ = stream.write_all(greeting);
                open.push(stream);
            }
        });
        let mut adapter = Adapter::initialized();
        let start = Instant::now();
        let why = adapter.refusal("attach", json!({ "program": lathe.folder(), "target": target }));
        assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
        assert!(why.contains("check"), "a remedy: {why}");
        adapter.client.disconnect(json!({})).expect("the adapter goes on");
    }
}

#[test]
fn a_target_survives_noise_on_its_line() {
    let lathe = Lathe::copy();
    let mut site = Site::tcp(&lathe);
    let address = site.address.strip_prefix("tcp:").expect("a TCP address").to_owned();
    let long = vec![0x7E; 70_000];
    for noise in [&b"GET / HTTP/1.1\r\n\r\n"[..], &[0; 4096], &[0xFF; 4096], &long, b""] {
        let mut stream = TcpStream::connect(&address).expect("the target listens");
        // The target may hang up in the middle of it.
        let _ = stream.write_all(noise);
        drop(stream);
    }
    let line = lathe.line("spindle.plc", "TIM  CNT_DEAD,T_DEAD");
    let mut adapter = Adapter::start();
    let place = (lathe.path("spindle.plc"), [line]);
    adapter.client.start(site.launch(&lathe), &[(&place.0, &place.1)]).expect("the program starts");
    adapter.client.event(Mark::START, "stopped").expect("a stop");
    assert!(site.target.as_mut().expect("a process").is_running());
}
