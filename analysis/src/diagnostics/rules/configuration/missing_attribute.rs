//! T0906 missing-attribute.

use crate::diagnostics::{Rule, Severity};

/// T0906 missing-attribute.
pub static MISSING_ATTRIBUTE: Rule = Rule {
    code: "T0906",
    name: "missing-attribute",
    severity: Severity::Error,
    explanation: "An element of a configuration file lacks an attribute or an element without which it means nothing, \
        for instance the identifier of an input or the text of a message. Add it.",
    why: "The control has nothing to find the element by.",
    wrong: concat!(
        "        ESET 7\n",
        ";=== machine.PlcErrors\n",
        "<PlcErrors>\n",
        "  <PlcError No=\"7\" Type=\"Err\"><Text>Pressure lost</Text></PlcError>\n",
        "</PlcErrors>\n",
    ),
    right: concat!(
        "        ESET 7\n",
        ";=== machine.PlcErrors\n",
        "<PlcErrors>\n",
        "  <PlcError No=\"7\" Type=\"Err\" Validity=\"Transient\"><Text>Pressure lost</Text></PlcError>\n",
        "</PlcErrors>\n",
    ),
    chapter: "14.4",
    ..Rule::BASE
};
