//! Alterations that change nothing a program can notice.

/// Alterations; why.
pub(in super::super) const EXEMPT: &[(&[&str], &str)] = &[
    (
        &[
            "ANALOG: axis A as B",
            "ANALOG: axis B as C",
            "ANALOG: axis C as U",
            "ANALOG: axis U as V",
            "ANALOG: axis V as W",
            "ANALOG: axis W as X",
            "ANALOG: axis X as Y",
            "ANALOG: axis Y as Z",
            "ANALOG: axis Z as A",
        ],
        "a letter stands there for the reader, the value goes to the axis that became a spindle last",
    ),
    (&["CAN_RECV_REQ: objh number more"], "objects are told apart by bits 7 to 10, and it is one bit less"),
    (
        &["ECAT_SOE_READ: flags Byte as Word", "ECAT_SOE_WRITE: flags Byte as Word"],
        "the flags are a byte, whatever they are declared as",
    ),
    (&["DEF_OUT: type TYPE_BIT as TYPE_INT_8"], "a bit has a byte of its own and is told as 0 or 1"),
    (&["UPDATE_IN: cell next bit"], "elements are found by their byte"),
    (
        &["SHARE_BIT: SHARE_VAR", "SHARE_VAR: SHARE_BIT"],
        "the third operand, a bit or a type, tells them apart",
    ),
];
