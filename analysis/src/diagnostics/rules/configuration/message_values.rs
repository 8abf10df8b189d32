//! T0922 message-values.

use crate::diagnostics::{Rule, Severity};

/// T0922 message-values.
pub static MESSAGE_VALUES: Rule = Rule {
    code: "T0922",
    name: "message-values",
    severity: Severity::Warning,
    explanation: "The instruction hands over another number of values than the text of the message shows with `%d` and \
        `%X`. par1 fills the first of them, par2 the second, par3 the third.",
    why: "A missing value is shown as something accidental, one too many is not shown at all.",
    wrong: concat!(
        "        ESET 7\n",
        ";=== machine.PlcErrors\n",
        "<PlcErrors>\n",
        "  <PlcError No=\"7\" Type=\"Err\" Validity=\"Transient\"><Text>Tool %d is worn</Text></PlcError>\n",
        "</PlcErrors>\n",
    ),
    right: concat!(
        "        ESET 7,-,-,LARGE\n",
        ";=== machine.PlcErrors\n",
        "<PlcErrors>\n",
        "  <PlcError No=\"7\" Type=\"Err\" Validity=\"Transient\"><Text>Tool %d is worn</Text></PlcError>\n",
        "</PlcErrors>\n",
    ),
    chapter: "14.4",
    ..Rule::BASE
};
