//! The scenes, and the one in which each symbol that the control reads makes a difference.

use technol_machine::{Analog, Mapping, Physical};

use crate::exempt::fits;
use crate::scene::Scene;

/// Scene and the symbols that it shows to be read; a `*` stands for any letters.
const READ: &[(&str, &str)] = &[
    ("ports", "P*OUT SETL_P* SETH_P* ERRLI_P*"),
    ("program of blocks", "STOPPI STOP_REQ STOP_EMERGENCY_REQ START_DISABLE START_SUSPEND REQ_BACKUP_MEM"),
    ("power", "PLC_MEM_BACKUP ANALOG_OUTPUT_PHYSICAL"),
    ("homing", "HOMING_START_REQ HOMING_REQ REFPOINT_DIST KR* ZPR*"),
    ("way", "MP*PI BZH08PI BZH08PI2 VAZBA* KH*0 KH*1 ZP*0 ZP*1 FEED_OVR FEED_OVR_MULTIPLIER LIMIT_FEED_REQ"),
    ("overridden way", "BZH09 BZH10"),
    ("limited way", "LIMIT_FEED HOMING SLS_REFER"),
    ("limited rapid way", "LIMIT_FEED_G00_REQ"),
    ("fast way", "LIMIT_FEED_G00"),
    ("jog", "AUTMAN_REQ REQ_EXT_CONT_AUTMAN EXT_CONT_AUTMAN* EXM_*0 EXM_*1 POS_SPACE_PLC EN_AUTMAN BZH00"),
    ("jog", "REQ_EXT_G00_AUTMAN REQ_EXT_SELECT_AUTMAN REQ_EXT_FEED_AUTMAN G95_AUTMAN"),
    ("jog", "AUTMAN_SEL AUTMAN_SELECT AUTMAN_CANCEL"),
    ("jog at a feed", "EXT_FEED_AUTMAN"),
    ("rapid jog", "REQ_EXT_FEED_G00_AUTMAN EXT_FEED_G00_AUTMAN"),
    ("panel", "MP*MAN BZH08MAN BZH08MAN2 POS_SPACE_MMM AUTMAN_WHEEL_DIS"),
    ("wheel", "KNOB_STEP REQ_ESHIFT ACT_ESHIFT SHIFT_ENABLE AUTMAN_KNOB_TOGGLE AUTMAN_SEL2"),
    ("homing of servo loops", "REF_SERV_*"),
    ("orientation", "POLOHV*"),
    (
        "spindle",
        "SPINDLE_GEAR_ACT_1 REQ_EXT_SPINDLE_GEAR REQ_MAN_SPINDLE_GEAR SPEED_OVR SPEED_OVR_MULTIPLIER",
    ),
    ("spindle by the program", "SPEED_OVR_EXT SIM_SPEED_PT OTACKY_VR"),
    ("cutting", "EXT_AKRR_*"),
    ("cutting by the program", "AKRR_*"),
    ("EtherCAT", "flEcat*"),
    ("drives", "flEdrv* wEdrv* dwEdrv* CAN_DRIVE_CMD CAN_AX_*"),
];

/// The scene that shows a symbol to be read.
pub(crate) fn of(symbol: &str) -> Option<&'static str> {
    let shows = |(_, patterns): &&(&str, &str)| patterns.split_whitespace().any(|it| fits(it, symbol));
    READ.iter().find(shows).map(|(scene, _)| *scene)
}

/// A text for each number.
fn each(numbers: std::ops::RangeInclusive<u32>, text: impl Fn(u32) -> String) -> String {
    numbers.map(text).collect()
}

/// X, Y, Z, 4 … as names of bits have them.
fn axis(number: u32) -> String {
    match number {
        1 => "X".to_owned(),
        2 => "Y".to_owned(),
        3 => "Z".to_owned(),
        other => other.to_string(),
    }
}

/// All axes with these keys.
fn axes(keys: &str) -> String {
    each(1..=16, |n| format!("[[axis]]\nnumber = {n}\n{keys}\n"))
}

/// A block that moves all axes.
fn block(keys: &str, target: f64) -> String {
    let targets: Vec<String> = (0..16).map(|n| format!("[{n}, {target}]")).collect();
    format!("[[block]]\n{keys}\naxes = [{}]\n", targets.join(", "))
}

pub(crate) fn all() -> Vec<Scene> {
    let mut all = vec![ports(), power(), blocks(), continuous()];
    all.extend(ways());
    all.extend(jogs());
    all.extend(homings());
    all.extend(spindles());
    all.extend([ethercat(), drives(), cables()]);
    all
}

fn ports() -> Scene {
    Scene {
        machine: each(0..=95, |n| {
            format!("[[fault]]\nname = 's{n}'\noutput = 'P{n}OUT.0'\nshorted = true\nactive = true\n")
        }),
        script: format!("1: {}", each(0..=95, |n| format!("P{n}OUT=15 "))),
        also: |simulation, cycle| simulation.inputs_mut().fill(if cycle % 2 == 0 { 0x5A } else { 0xA5 }),
        ..Scene::new("ports", 5)
    }
}

fn power() -> Scene {
    Scene {
        machine: "[[ramp]]\nsource = 'ANALOG_OUTPUT_PHYSICAL[1]'\nhigh = 10\nrise-per-s = 1000\n\
                  value = 'ANALOG_INPUT_PHYSICAL[2]'\n"
            .to_owned(),
        init: "MAP_AOUT BELT,'belt',2.5".to_owned(),
        script: "1: REAL.(ANALOG_OUTPUT_PHYSICAL+8)=5.0 REQ_BACKUP_MEM=1".to_owned(),
        before: |simulation| {
            let mut data = simulation.control().data().clone();
            data.backup = vec![7; 10_000];
            let analog = Analog { channel: 3, scale: 1.0, offset: 0.0, min: -10.0, max: 10.0 };
            let physical = Physical::AnalogOutput(analog);
            data.wiring.points.push(Mapping {
                id: b"belt".to_vec(),
                physical,
                connected: true,
                default: 0.0,
            });
            simulation.control_mut().set_data(data);
        },
        ..Scene::new("power", 5)
    }
}

/// A program with all its functions, stopped and started again.
fn blocks() -> Scene {
    let first = "at-cycle = 1\nm = [0, 3, 41, 91, 7, 50, 10, 48, 6, 92, 93, 94, 95, 96]\nt = 12345678\nh = 17\ns = 1000\n\
                 rapid = true\nfeed = 600\nfeed-max = 900\nspeed = 500.0\ncutting-speed = 50.0\nspeed-limit = 900.0\n\
                 length-mm = 5.0\nscale = 2.0\ndwell = 0.1\nintegers = [1, 2, 3, 4, 5]\nreals = [1.0, 2.0, 3.0, 4.0, 5.0]\n\
                 flags = ['backward', 'selected', 'approach', 'without-technology', 'rev-feed', 'continuous', \
                 'const-cut-speed', 'thread']";
    let others = "[[block]]\nm = [4, 42, 8, 51, 11, 60]\nmotion-ms = 20\n\
                  [[block]]\nm = [19, 43, 1]\nmotion-ms = 100\n\
                  [[block]]\nm = [44, 2]\nmode = 'reference'\nmotion-ms = 20\n\
                  [[block]]\nat-cycle = 74\nm = [30]\nmode = 'central-annulment'\nmotion-ms = 20\n";
    let groups = [4, 10, 11, 12, 13, 14];
    let groups =
        each(0..=5, |n| format!("[[m-function]]\nnumber = {}\ngroup = {}\n", 91 + n, groups[n as usize]));
    Scene {
        machine: format!(
            "[control]\nconditional-stop = true\n{groups}{}{others}[[spindle]]\nport = 1\ngear = [{{ max-speed = 1000 }}]\n",
            block(first, 30.0)
        ),
        script:
            "0: START_SUSPEND=1\n4: STOP_REQ=1\n12: go\n20: STOP_EMERGENCY_REQ=1\n30: go\n50: go\n60: go\n\
                 70: REQ_BACKUP_MEM=1"
                .to_owned(),
        ..Scene::new("program of blocks", 80)
    }
}

fn continuous() -> Scene {
    let block = |first: &str| format!("[[block]]\n{first}motion-ms = 60\nflags = ['continuous']\n");
    Scene { machine: block("at-cycle = 1\n") + &block(""), ..Scene::new("continuous run", 12) }
}

fn ways() -> Vec<Scene> {
    let feed = block("at-cycle = 1\nfeed = 6000", 20.0);
    let slow = "feed-slow = 100";
    let limits = "limit-plus = 10\nlimit-minus = -10\nlimit-zone = 2\nfeed-slow = 600";
    let there_and_back = "[[block]]\nat-cycle = 1\nfeed = 6000\naxes = [[0, 20.0], [1, -20.0]]\n[[block]]\nfeed = 6000\naxes = [[2, 5.0]]\n";
    vec![
        Scene {
            machine: format!("{}{feed}", axes(slow)),
            script: "0: LIMIT_FEED=100\n8: KHX0=1\n9: KHX0=0\n12: VAZBA_Y=0".to_owned(),
            ..Scene::new("way", 30)
        },
        Scene {
            machine: feed.clone(),
            script: "0: FEED_OVR=1 WORD.BZH09=515".to_owned(),
            ..Scene::new("overridden way", 20)
        },
        Scene {
            machine: format!("{}{there_and_back}", axes(limits)),
            script: "0: FEED_OVR=1 WORD.BZH09=515 HOMING=65535 SLS_REFER=65535 LIMIT_FEED_REQ=1 LIMIT_FEED=2000000".to_owned(),
            ..Scene::new("limited way", 60)
        },
        Scene {
            machine: block("at-cycle = 1\nfeed = 6000", 20.0),
            script: "5: STOP_REQ=1\n15: AUTMAN_REQ=1 REQ_EXT_CONT_AUTMAN=1 EXM_X0=1\n18: EXM_X0=0".to_owned(),
            ..Scene::new("stopped way", 24)
        },
        Scene {
            machine: block("at-cycle = 1\nrapid = true", 20.0),
            script: "0: LIMIT_FEED_G00=2000000".to_owned(),
            ..Scene::new("limited rapid way", 20)
        },
        Scene {
            machine: block("at-cycle = 1\nrapid = true", 20.0),
            script: "0: LIMIT_FEED_G00=2000000 LIMIT_FEED_G00_REQ=1".to_owned(),
            ..Scene::new("fast way", 20)
        },
    ]
}

fn jogs() -> Vec<Scene> {
    let external = "1: AUTMAN_REQ=1 REQ_EXT_CONT_AUTMAN=1";
    let all = |sign: &str| each(1..=6, |n| format!("EXM_{}{sign}=1 ", axis(n)));
    let none = |sign: &str| each(1..=6, |n| format!("EXM_{}{sign}=0 ", axis(n)));
    let there_and_back = format!("3: {}\n8: {}\n10: {}", all("0"), none("0"), all("1"));
    let spindle = "[[spindle]]\nport = 1\ngear = [{ max-speed = 1000 }]\n";
    let keys = each(1..=16, |n| {
        format!(
            "[[key]]\nname = 'p{n}'\npanel = {{ jog = {n} }}\n[[key]]\nname = 'm{n}'\npanel = {{ jog = -{n} }}\n"
        )
    });
    let wheel = "[[key]]\nname = 'select'\npanel = { select-axis = 1 }\n[[key]]\nname = 'wheel'\npanel = { wheel = 5 }\n\
                 [[key]]\nname = 'rapid'\npanel = 'jog-rapid'\n[[key]]\nname = 'step'\npanel = { wheel-step = 50 }\n\
                 [[key]]\nname = 'mode'\npanel = 'shift-mode'\n[[key]]\nname = 'active'\npanel = 'shift-active'\n";
    let select = each(2..=6, |n| format!("[[key]]\nname = 's{n}'\npanel = {{ select-axis = {n} }}\n"));
    let others = each(2..=6, |n| format!("{}: +s{n} +wheel\n{}: -wheel\n", 20 + 3 * n, 21 + 3 * n));
    vec![
        Scene {
            machine: spindle.to_owned(),
            main: "ANALOG_PORT 1 / ANALOG 30000".to_owned(),
            script: format!(
                "{external}\n{there_and_back}\n14: REQ_EXT_SELECT_AUTMAN=1\n16: AUTMAN_REQ=0\n17: AUTMAN_SELECT=1\n19: AUTMAN_CANCEL=1"
            ),
            ..Scene::new("jog", 24)
        },
        Scene {
            script: format!("{external} REQ_EXT_FEED_AUTMAN=1 EXT_FEED_AUTMAN=700\n{there_and_back}"),
            ..Scene::new("jog at a feed", 12)
        },
        Scene {
            script: format!(
                "{external} REQ_EXT_G00_AUTMAN=1 REQ_EXT_FEED_G00_AUTMAN=1 EXT_FEED_G00_AUTMAN=700\n{there_and_back}"
            ),
            ..Scene::new("rapid jog", 12)
        },
        Scene {
            machine: format!("{}{keys}{wheel}", axes("jog-enable = 'manual'")),
            script: format!(
                "1: AUTMAN_REQ=1 BZH08MAN=63 BZH08MAN2=1023 KNOB_STEP=100\n2: {} +rapid\n6: {} {}\n9: {}\n12: +wheel",
                each(1..=16, |n| format!("+p{n} ")),
                each(1..=16, |n| format!("-p{n} ")),
                each(1..=16, |n| format!("+m{n} ")),
                each(1..=16, |n| format!("-m{n} ")),
            ),
            ..Scene::new("panel", 18)
        },
        Scene {
            machine: format!("{wheel}{select}"),
            script: format!(
                "1: AUTMAN_REQ=1 KNOB_STEP=100\n2: +select\n3: +wheel\n8: -wheel -select\n10: AUTMAN_REQ=0 REQ_ESHIFT=1 ACT_ESHIFT=1\n\
                     11: +wheel\n16: ACT_ESHIFT=0\n18: +select\n19: -wheel\n20: ACT_ESHIFT=1\n21: +wheel\n23: -wheel\n{others}\
                     42: +step +mode +active"
            ),
            ..Scene::new("wheel", 45)
        },
    ]
}

fn homings() -> Vec<Scene> {
    let fast = "ref-speed = 6000\nref-speed-low = 1200\nslow-down-switch = true\npulse-distance = 1\n";
    let bits = |name: &str, value: u8| each(1..=16, |n| format!("{name}{}={value} ", axis(n)));
    let servos = each(1..=16, |n| {
        format!(
            "[[axis]]\nnumber = {n}\nref-method = 12\nref-speed = 6000\nref-speed-low = 1200\nservos = [{n}]\n"
        )
    });
    let loops = |value: u8| each(1..=16, |n| format!("REF_SERV_{n}={value} "));
    let keys =
        "[[key]]\nname = 'home'\npanel = { home = 3 }\n[[key]]\nname = 'group'\npanel = 'home-group'\n";
    let plc = "[[axis]]\nnumber = 3\nref-method = 1\n";
    vec![
        Scene {
            machine: axes(fast),
            script: format!(
                "1: HOMING_START_REQ=65535\n8: {}\n10: {}\n60: HOMING_REQ=65535",
                bits("ZPR", 1),
                bits("KR", 1)
            ),
            ..Scene::new("homing", 66)
        },
        Scene {
            machine: servos,
            script: format!("1: HOMING_START_REQ=65535\n8: {}\n20: {}", loops(1), loops(0)),
            ..Scene::new("homing of servo loops", 40)
        },
        Scene {
            machine: format!("{plc}{keys}"),
            script: "1: +home\n3: +group".to_owned(),
            ..Scene::new("homing by the program", 5)
        },
        Scene {
            init: each(1..=16, |n| format!("AX_SPI {n} / SPI_AX -,-,-,-,{n} / ")),
            script: format!("30: {}", bits("KR", 1)),
            ..Scene::new("orientation", 100)
        },
    ]
}

const GEARS: &str = "gear = [{ max-speed = 800 }, { max-speed = 1600 }]\n";

fn spindles() -> Vec<Scene> {
    let analog = "ANALOG_PORT 1 / ANALOG VYSOVERS / ANALOG_PORT 2 / ANALOG 20000";
    let speed = "[[block]]\nat-cycle = 1\nm = [40]\nspeed = 600.0\n[[block]]\nat-cycle = 20\nspeed = 1500.0\n[[block]]\nat-cycle = 30\nm = [3]\n";
    let cut = "[[block]]\nat-cycle = 1\nspeed = 600.0\ncutting-speed = 60.0\nspeed-limit = 1200.0\nfeed = 6000\n\
               flags = ['const-cut-speed']\naxes = [[0, 30.0]]\n[[block]]\nat-cycle = 45\nspeed = 500.0\n";
    let two = |keys: &str| {
        format!("[[spindle]]\nport = 1\n{keys}{GEARS}[[spindle]]\nnumber = 2\nport = 2\n{GEARS}")
    };
    let given = "EXT_AKRR_SMAX=1 EXT_AKRR_DIST=1 EXT_AKRR_VCORR=1 EXT_AKRR_P=1 EXT_AKRR_U=1 EXT_AKRR_R=1 EXT_AKRR_V=1";
    let values = "AKRR_V=50000 AKRR_SMAX=900000 AKRR_DIST=8000 AKRR_VCORR=1000 AKRR_P=1900000 AKRR_U=30000 AKRR_R=160000";
    vec![
        Scene {
            machine: format!("{}{speed}", two("")),
            main: analog.to_owned(),
            script: "0: SPEED_OVR_EXT=800\n18: REQ_EXT_SPINDLE_GEAR=1 REQ_MAN_SPINDLE_GEAR=1".to_owned(),
            ..Scene::new("spindle", 40)
        },
        Scene {
            machine: format!("{}{speed}", two("encoder = false\n")),
            main: analog.to_owned(),
            script: "0: SPEED_OVR=1 SPEED_OVR_EXT=800 SIM_SPEED_PT=1234".to_owned(),
            ..Scene::new("spindle by the program", 30)
        },
        Scene {
            machine: format!("{}{cut}", two("")),
            main: analog.to_owned(),
            script: format!(
                "0: {values}\n30: AUTMAN_REQ=1 REQ_EXT_CONT_AUTMAN=1 POS_SPACE_PLC=5 EXM_X0=1\n35: EXM_X0=0"
            ),
            ..Scene::new("cutting", 60)
        },
        Scene {
            machine: format!("{}{cut}", two("")),
            main: analog.to_owned(),
            script: format!("0: {values} {given}"),
            ..Scene::new("cutting by the program", 60)
        },
    ]
}

fn ethercat() -> Scene {
    Scene {
        machine: "[ethercat-master]\nstart-by-program = true\n[[ethercat]]\nname = 'Valves'\n".to_owned(),
        script: "2: flEcatStartCyclicOperation=1\n12: flEcatSafeOperationalReq=1\n20: flEcatPreOperationalReq=1\n\
                 28: flEcatInitReq=1\n36: flEcatBootStrapReq=1\n42: flEcatInitReq=1\n50: flEcatOperationalReq=1"
            .to_owned(),
        ..Scene::new("EtherCAT", 64)
    }
}

fn drives() -> Scene {
    let drive = |n: u32| {
        format!(
            "[[ethercat]]\nname = 'D{n}'\ndrive = true\nservo = {n}\n[[can-drive]]\naxis = {}\n[[fault]]\nname = 'f{n}'\nslave = 'D{n}'\nerror = 7\n",
            n + 1
        )
    };
    let all = |name: &str| each(0..=15, |n| format!("fl{name}{n}=1 "));
    let commands = each(0..=15, |n| format!("WORD.(CAN_DRIVE_CMD+{})=1 ", 2 * n));
    Scene {
        machine: each(0..=15, drive),
        main: "LDR GO / JL0 L / CAN_AX_SEND 2 / FL 0,GO / L:".to_owned(),
        script: format!(
            "1: {} {commands} GO=1\n5: {}\n10: {}\n16: {}\n22: {}\n28: {}\n36: {}\n42: {}\n48: {}\n54: {}",
            all("EdrvInit"),
            all("EdrvOn"),
            all("EdrvEnable"),
            each(0..=15, |n| format!("DWRD.(SERVO_POSITION+{})=77 ", 4 * n)),
            each(0..=15, |n| format!("fault=f{n} ")),
            each(0..=15, |n| format!("mended=f{n} flEdrvErase{n}=1 ")),
            all("EdrvOn"),
            all("EdrvEnable"),
            all("EdrvDisable"),
            all("EdrvDone"),
        ),
        ..Scene::new("drives", 70)
    }
}

/// Units of the control on the CAN bus: in error, and behind a cable that is cut.
fn cables() -> Scene {
    Scene {
        machine: format!(
            "{}[[fault]]\nname = 'cut'\ncan = 2\ncut = true\n",
            each(1..=3, |n| format!("[[can-unit]]\ncan = 2\ngroup = {n}\nboard = 3\n"))
        ),
        script: "5: fault=cut".to_owned(),
        before: |simulation| {
            for group in 1..=3 {
                simulation.control_mut().can_unit_mut(1, group, 5).set("ERROR", 8);
            }
        },
        ..Scene::new("cables", 10)
    }
}
