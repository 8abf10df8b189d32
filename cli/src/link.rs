//! `technol link`: is this cable fit, and what was said over it. `technol devices`: what cables there are.

use std::time::{Duration, Instant};

use technol_target::{Device, devices};
use technol_wire::message::{Request, Response, feature};

use crate::arguments::{DevicesArguments, Format, LinkCommand, LinkTestArguments};
use crate::exit::{self, Failure, Outcome};
use crate::out::say;
use crate::remote::Remote;
use crate::target::read_image;

/// Questions that measure the round trip.
const ROUND_TRIPS: usize = 40;
/// Bytes of an echo that measures how much the line carries; together at most one frame short of what a
/// request may have.
const MOST_ECHO: usize = 4000;

/// Tests a link, or tells what was recorded on one.
pub(crate) fn link(command: &LinkCommand) -> Outcome {
    match command {
        LinkCommand::Test(arguments) => test(arguments),
        LinkCommand::Log { file, program } => {
            let image = program.as_deref().map(read_image).transpose()?;
            let debug = image.as_ref().and_then(|image| image.debug.as_ref());
            if let (Some(program), None) = (program, debug) {
                return Err(Failure::usage(format!(
                    "{}: it has no debug information; name the image that `technol build` made",
                    program.display()
                )));
            }
            let text = std::fs::read_to_string(file)
                .map_err(|e| Failure::usage(format!("{}: {e}", file.display())))?;
            let text = technol_target::text_of_recording(&text, debug)
                .map_err(|e| Failure::usage(format!("{}: {e}", file.display())))?;
            for line in text.lines() {
                say!("{line}");
            }
            Ok(exit::OK)
        }
    }
}

/// What was measured.
#[derive(Clone, Debug, Default, PartialEq)]
struct Measured {
    /// Round trips of a short question, ascending, in microseconds.
    round_trips: Vec<u64>,
    /// Bytes a second, there and back one after the other.
    throughput: f64,
    /// What the line would carry, if it is bounded.
    line: Option<u32>,
    /// Frames there and back.
    frames: u32,
    damaged_here: u32,
    damaged_there: u32,
    /// Requests that were sent again.
    repeated: u32,
    /// Echoes that came back as something else. This must not happen.
    wrong: u32,
}

fn test(arguments: &LinkTestArguments) -> Outcome {
    let mut remote = Remote::connect(&arguments.target, arguments.token_file.as_deref())?;
    let measured = measure(&mut remote, Duration::from_secs(u64::from(arguments.seconds)))?;
    let (lines, fit) = verdict(&measured);
    for line in lines {
        say!("{line}");
    }
    Ok(if fit { exit::OK } else { exit::ERRORS })
}

fn measure(remote: &mut Remote, time: Duration) -> Result<Measured, Failure> {
    let mut measured = Measured { line: remote.line, ..Measured::default() };
    for _ in 0..ROUND_TRIPS {
        let began = Instant::now();
        remote.ask(Request::Status)?;
        measured.round_trips.push(began.elapsed().as_micros() as u64);
    }
    measured.round_trips.sort_unstable();
    if !remote.can(feature::ECHO) {
        return Err(Failure::usage("the target is too old for this test; use programs of one release"));
    }
    let len = MOST_ECHO.min(usize::from(remote.most()));
    let frames = len.div_ceil(usize::from(remote.payload().max(2)) - 1) as u32 * 2;
    let (began, mut bytes, mut first) = (Instant::now(), 0, None);
    while began.elapsed() < time || bytes == 0 {
        let sent: Vec<u8> = (0..len).map(|n| (n * 31 + bytes) as u8).collect();
        let Response::Echo { bytes: back, damaged } = remote.ask(Request::Echo { bytes: sent.clone() })?
        else {
            return Err(Failure::usage("the target gave an answer that does not fit the question"));
        };
        measured.wrong += u32::from(back != sent);
        // The target counts since its link was opened; what was before this test does not concern it.
        measured.damaged_there = damaged - *first.get_or_insert(damaged);
        measured.frames += frames;
        bytes += len * 2;
    }
    measured.throughput = bytes as f64 / began.elapsed().as_secs_f64();
    (measured.damaged_here, measured.repeated) = remote.trouble();
    Ok(measured)
}

/// What to say about it, and whether the cable is fit.
fn verdict(m: &Measured) -> (Vec<String>, bool) {
    let ms = |at: usize| m.round_trips.get(at).map_or(0.0, |us| *us as f64 / 1000.0);
    let (median, longest) = (ms(m.round_trips.len() / 2), ms(m.round_trips.len().saturating_sub(1)));
    let share = m.line.map_or_else(String::new, |line| {
        format!(", {:.0} % of the line", m.throughput * 100.0 / f64::from(line))
    });
    let mut lines = vec![
        format!("round trip   {median:.1} ms (shortest {:.1}, longest {longest:.1})", ms(0)),
        format!("throughput   {:.0} bytes/s{share}", m.throughput),
        format!(
            "errors       {} of {} frames damaged on the way here, {} on the way there, {} requests sent again",
            m.damaged_here, m.frames, m.damaged_there, m.repeated
        ),
    ];
    let damaged = f64::from(m.damaged_here + m.damaged_there) / f64::from(m.frames.max(1));
    let slow_adapter = m.line.is_some() && ms(0) > 10.0;
    let (text, fit) = if m.wrong > 0 {
        (
            "NOT FIT: bytes came back wrong although their checksums were right; check the memory of this computer and the target",
            false,
        )
    } else if damaged > 0.02 {
        (
            "NOT FIT: too many frames are damaged; use a shorter or shielded cable, keep it away from converters, ground one end, or take a lower baud rate",
            false,
        )
    } else if damaged > 0.0 || m.repeated > 0 {
        ("fit, with some noise: what is damaged is sent again, so it only costs time", true)
    } else if slow_adapter {
        (
            "fit, but slow to answer: the adapter collects bytes before it hands them over (`technol devices` tells its latency)",
            true,
        )
    } else {
        ("fit", true)
    };
    lines.push(text.to_owned());
    (lines, fit)
}

/// Lists the serial devices.
pub(crate) fn list_devices(arguments: &DevicesArguments) -> u8 {
    let found = devices();
    match arguments.format {
        Format::Json => say!("{}", serde_json::Value::from(found.iter().map(as_json).collect::<Vec<_>>())),
        Format::Human if found.is_empty() => say!("no serial device was found; is the cable plugged in?"),
        Format::Human => found.iter().flat_map(described).for_each(|line| say!("{line}")),
    }
    exit::OK
}

fn described(device: &Device) -> Vec<String> {
    let Some(usb) = &device.usb else { return vec![device.port.clone()] };
    let names: Vec<&str> = [&usb.maker, &usb.product].into_iter().flatten().map(String::as_str).collect();
    let mut lines = vec![format!("{}  {}", device.port, names.join(" ")).trim_end().to_owned()];
    lines.push(format!("    wherever it is plugged in: serial:{usb}"));
    if usb.serial.is_none() {
        lines.push(
            "    it has no number of its own: another one of this make would be taken for it".to_owned(),
        );
    }
    if let Some(ms) = device.latency_ms.filter(|ms| *ms > 1) {
        lines.push(format!(
            "    collects bytes for {ms} ms; 1 ms is set when it is opened, if this user may write /sys/bus/usb-serial/devices/*/latency_timer"
        ));
    }
    lines
}

fn as_json(device: &Device) -> serde_json::Value {
    serde_json::json!({
        "port": device.port,
        "identity": device.usb.as_ref().map(ToString::to_string),
        "vid": device.usb.as_ref().map(|u| u.vid),
        "pid": device.usb.as_ref().map(|u| u.pid),
        "serial": device.usb.as_ref().and_then(|u| u.serial.clone()),
        "maker": device.usb.as_ref().and_then(|u| u.maker.clone()),
        "product": device.usb.as_ref().and_then(|u| u.product.clone()),
        "latencyMs": device.latency_ms,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use technol_target::Usb;

    fn good() -> Measured {
        Measured {
            round_trips: vec![2_000, 2_500, 9_000],
            throughput: 10_000.0,
            line: Some(11_520),
            frames: 1000,
            ..Measured::default()
        }
    }

    #[test]
    fn the_verdict_follows_from_what_was_measured() {
        let table = [
            (good(), "fit", true),
            (Measured { damaged_here: 3, ..good() }, "fit, with some noise", true),
            (Measured { repeated: 1, ..good() }, "fit, with some noise", true),
            (Measured { damaged_here: 10, damaged_there: 11, ..good() }, "NOT FIT: too many frames", false),
            (Measured { wrong: 1, ..good() }, "NOT FIT: bytes came back wrong", false),
            (Measured { round_trips: vec![16_000], ..good() }, "fit, but slow to answer", true),
            (Measured { round_trips: vec![16_000], line: None, ..good() }, "fit", true),
        ];
        for (measured, text, fit) in table {
            let (lines, is_fit) = verdict(&measured);
            let last = lines.last().unwrap();
            assert!(last.starts_with(text) && (text != "fit" || last == "fit"), "{measured:?}: {last}");
            assert_eq!(is_fit, fit, "{measured:?}");
        }
    }

    #[test]
    fn numbers_are_told_as_measured() {
        let lines = verdict(&Measured { damaged_here: 3, damaged_there: 2, repeated: 1, ..good() }).0;
        assert_eq!(lines[0], "round trip   2.5 ms (shortest 2.0, longest 9.0)");
        assert_eq!(lines[1], "throughput   10000 bytes/s, 87 % of the line");
        assert_eq!(
            lines[2],
            "errors       3 of 1000 frames damaged on the way here, 2 on the way there, 1 requests sent again"
        );
    }

    #[test]
    fn a_device_is_told_with_its_names_and_how_to_ask_for_it() {
        let usb = |serial: Option<&str>| Usb {
            vid: 0x0403,
            pid: 0x6001,
            serial: serial.map(str::to_owned),
            maker: Some("FTDI".into()),
            product: Some("FT232R USB UART".into()),
        };
        let device = |usb, latency_ms| Device { port: "/dev/ttyUSB0".into(), usb, latency_ms };
        assert_eq!(described(&device(None, None)), ["/dev/ttyUSB0"]);
        assert_eq!(
            described(&device(Some(usb(Some("A5"))), Some(1))),
            ["/dev/ttyUSB0  FTDI FT232R USB UART", "    wherever it is plugged in: serial:usb:0403:6001:A5"]
        );
        let lines = described(&device(Some(usb(None)), Some(16)));
        assert!(lines[2].contains("no number of its own") && lines[3].contains("for 16 ms"), "{lines:?}");
        let json = as_json(&device(Some(usb(Some("A5"))), Some(1)));
        assert_eq!((&json["identity"], &json["latencyMs"]), (&"usb:0403:6001:A5".into(), &1.into()));
    }
}
