//! The rules, one file each in the folder of its group, and their registry.
//!
//! `wrong` and `right` of a [`Rule`] are parts of a program; a test completes and checks them:
//! - Lines without a module stand in MODULE_MAIN of a complete program, whose DATA declares START, DOOR, LIMIT, READY,
//!   FAULT, MOTOR, PUMP, LAMP, VALVE and M0 to M7 (bits), SMALL (BYTE), MIDDLE (WORD), LARGE (DWORD), RATIO (8 bytes),
//!   TABLE (30 bytes) and the constant TEN.
//! - When a DATA or MODULE_ section is among the lines, each section replaces the one of its name, and what stands between
//!   them goes before DATA.
//! - `;=== name.ext` begins a further file of the project; `;=== main.plc` a main file that is complete as it is.

pub mod allow;
pub mod build;
pub mod configuration;
pub mod declarations;
pub mod equations;
pub mod lints;
pub mod macros;
pub mod memory;
pub mod names;
pub mod operands;
pub mod project;
pub mod sequences;
pub mod structure;
pub mod syntax;

mod page;

use super::Rule;

/// Every rule, in order of codes.
pub static RULES: &[&Rule] = &[
    &project::MANIFEST_SYNTAX,
    &project::UNKNOWN_KEY,
    &project::WRONG_VALUE,
    &project::MISSING_FILE,
    &project::TOO_MANY_FILES,
    &project::OUTSIDE_FILE,
    &project::DUPLICATE_FILE,
    &project::UNKNOWN_LINT,
    &project::MISSING_INCLUDE,
    &project::CYCLIC_INCLUDE,
    &project::INCLUDED_CODE,
    &project::INCLUDED_TWICE,
    &project::UNDECODABLE,
    &project::MACHINE_FILE,
    &syntax::UNEXPECTED_CHARACTER,
    &syntax::TYPOGRAPHIC_QUOTE,
    &syntax::UNCLOSED_TEXT,
    &syntax::BAD_NUMBER,
    &syntax::UNBALANCED_BRACKET,
    &syntax::EXPECTED_OPERAND,
    &syntax::EXPECTED_COMMA,
    &syntax::EXPECTED_OPERATION,
    &syntax::EXPECTED_COLON,
    &syntax::TOO_COMPLEX,
    &syntax::UNKNOWN_INSTRUCTION,
    &syntax::MISSPELLED_PREFIX,
    &declarations::DUPLICATE_NAME,
    &declarations::LONG_NAME,
    &declarations::NAME_LIKE_INSTRUCTION,
    &declarations::CONFLICTING_CONSTANT,
    &declarations::NOT_CONSTANT,
    &declarations::CIRCULAR_CONSTANT,
    &declarations::TOO_MANY_BITS,
    &declarations::BAD_LENGTH,
    &declarations::TEXT_TOO_LONG,
    &declarations::MISSING_NAME,
    &declarations::BAD_DECLARATION,
    &declarations::HIDES_SYSTEM_SYMBOL,
    &names::UNKNOWN_SYMBOL,
    &names::UNKNOWN_LABEL,
    &names::DUPLICATE_LABEL,
    &names::WRONG_SYMBOL,
    &memory::ARRAY_OF_BITS,
    &memory::STRUCTURE_FORM,
    &memory::MEMBER_FORM,
    &operands::OPERAND_COUNT,
    &operands::OPERAND_KIND,
    &operands::UNTYPED_AREA,
    &operands::PREFIX_NOT_ALLOWED,
    &operands::SIGN_NOT_ALLOWED,
    &operands::CONSTANT_TOO_LARGE,
    &operands::NUMBER_OUT_OF_RANGE,
    &operands::DIVISION_BY_ZERO,
    &operands::REAL_NOT_ALLOWED,
    &operands::ACCESS_PAST_CELL,
    &operands::ACCESS_OUTSIDE_DATA,
    &operands::DIFFERENT_TYPES,
    &operands::PREFIX_COVERS_TIME,
    &operands::CONSTANT_DESTINATION,
    &operands::NEVER_EQUAL,
    &operands::STALE_DIVIDEND,
    &memory::BAD_IDENTIFIER,
    &memory::INDEX_OUTSIDE_ARRAY,
    &memory::NO_ALTERNATIVE,
    &memory::BLOCK_ACCESS,
    &memory::TEXT_CUT,
    &memory::COPY_SIZE,
    &memory::JUMP_WITH_OPEN_EQUATION,
    &equations::POP_WITHOUT_PUSH,
    &equations::VALUE_LEFT_ON_STACK,
    &equations::STACK_TOO_DEEP,
    &equations::LOST_EQUATION,
    &equations::OPEN_EQUATION,
    &structure::MISSING_MODULE,
    &structure::FORBIDDEN_MODULE,
    &structure::REPEATED_MODULE,
    &structure::DATA_NOT_FIRST,
    &structure::STOP_MISPLACED,
    &structure::UNCLOSED_BLOCK,
    &structure::UNEXPECTED_END,
    &structure::WRONG_PLACE,
    &structure::NESTED_BLOCK,
    &sequences::WAIT_OUTSIDE_SEQUENCE,
    &sequences::ENDLESS_LOOP,
    &sequences::BUSY_LOOP,
    &sequences::RECURSION,
    &sequences::RASTER_END,
    &sequences::NESTED_RASTER,
    &sequences::TIMER_OUTSIDE_RASTER,
    &build::NOT_EXECUTABLE,
    &build::TOO_LARGE,
    &build::NOT_TRANSLATABLE,
    &configuration::BROKEN_CONFIGURATION,
    &configuration::DOCUMENT_TYPE,
    &configuration::UNKNOWN_ELEMENT,
    &configuration::UNKNOWN_ATTRIBUTE,
    &configuration::WRONG_CONFIGURATION_VALUE,
    &configuration::MISSING_ATTRIBUTE,
    &configuration::DUPLICATE_IDENTIFIER,
    &configuration::MESSAGE_TEXT,
    &configuration::TABLE_COUNT,
    &configuration::UNKNOWN_IDENTIFIER,
    &configuration::IDENTIFIER_TYPE,
    &configuration::CONSTANT_TOO_WIDE,
    &configuration::UNUSED_IDENTIFIER,
    &configuration::IDENTIFIER_FORM,
    &configuration::UNKNOWN_MESSAGE,
    &configuration::MESSAGE_VALUES,
    &configuration::MESSAGE_VALIDITY,
    &configuration::MESSAGE_STAYS,
    &configuration::UNKNOWN_TABLE,
    &configuration::UNKNOWN_COLUMN,
    &configuration::TABLE_VALUE,
    &configuration::COLUMN_TYPE,
    &configuration::UNKNOWN_COMMAND,
    &configuration::COMMAND_IGNORED,
    &configuration::UNKNOWN_COMMAND_CODE,
    &configuration::UNKNOWN_LOGICAL_ELEMENT,
    &configuration::CONNECTION_DIRECTION,
    &configuration::CONVERSION_WITHOUT_EFFECT,
    &configuration::NOT_CONNECTED,
    &configuration::UNKNOWN_PORT,
    &macros::MACRO_ARGUMENTS,
    &macros::MACRO_REDEFINED,
    &macros::MACRO_USED_BEFORE,
    &macros::MACRO_RECURSION,
    &macros::MACRO_TOO_LARGE,
    &macros::MACRO_NESTED,
    &macros::UNKNOWN_PARAMETER,
    &macros::MISSING_TMAC,
    &macros::MACRO_DATA,
    &macros::MACRO_BITS,
    &macros::T_LOCAL_PLACE,
    &macros::MACRO_FLAGS,
    &macros::MACRO_FLAG_ORDER,
    &macros::MACRO_FLAG_MISMATCH,
    &macros::MACRO_BRACKETS,
    &macros::MISSING_T_LOCAL,
    &macros::UNUSED_T_LOCAL,
    &macros::MACRO_HIDDEN,
    &macros::APPENDED_UNKNOWN,
    &macros::MACRO_STRUCTURE,
    &macros::DUPLICATE_PARAMETER,
    &macros::PARAMETER_BYPASSED,
    &allow::UNUSED_ALLOW,
    &allow::UNKNOWN_ALLOW,
    &allow::ALLOW_FIXED,
    &allow::BAD_ALLOW,
    &lints::RECORD_OF_ONE_BYTE,
    &lints::RESULT_NOT_AWAITED,
    &lints::JUMP_DECIDED_BY_WAIT,
    &lints::ERROR_NOT_TESTED,
    &lints::AXIS_LEFT_OUT,
    &lints::PORT_IN_A_CELL,
    &lints::STATE_WITHOUT_TARGET,
    &lints::RAMP_RUNS_ONCE,
    &lints::BUFFER_TOO_SHORT,
    &lints::REGULATOR_IN_CLOSED_LOOP,
    &lints::POSITIONING_INCOMPLETE,
    &lints::ANALOG_WITHOUT_PORT,
    &lints::SIMULATED_SPINDLE_SWITCHED,
    &lints::TWO_WRITERS,
    &lints::NEVER_WRITTEN,
    &lints::NEVER_READ,
    &lints::UNUSED_VARIABLE,
    &lints::MECHANISM_NEVER_STARTED,
    &lints::ENDLESS_WAIT,
    &lints::MOTION_BLOCK_WAIT,
    &lints::TIMEOUT_WITHOUT_PATH,
    &lints::UNREACHABLE_CODE,
    &lints::UNUSED_LABEL,
    &lints::UNUSED_CONSTANT,
    &lints::UNUSED_PROCEDURE,
    &lints::UNUSED_MACRO,
    &lints::OVERLAPPING_OVERLAYS,
    &lints::COUNTER_TOO_NARROW,
    &lints::READ_ONLY_CELL,
    &lints::DEBUG_LEFT_ON,
    &lints::TIMER_NEVER_ENDS,
    &lints::ALWAYS_THE_SAME,
    &lints::BCD_RANGE,
    &lints::OVERLAY_ELSEWHERE,
    &lints::NUMBER_TEXT_SIZE,
    &lints::STALE_REAL,
    &lints::SECOND_NAME,
];

/// The rule with `code`, in any case.
#[must_use]
pub fn rule(code: &str) -> Option<&'static Rule> {
    RULES.iter().copied().find(|rule| rule.code.eq_ignore_ascii_case(code))
}

/// The page of a rule in Markdown, by code or name; what `technol explain T0301` shows.
#[must_use]
pub fn explain(code_or_name: &str) -> Option<String> {
    find(code_or_name).map(page::markdown)
}

/// The rule with a code or a name, in any case.
#[must_use]
pub fn find(code_or_name: &str) -> Option<&'static Rule> {
    rule(code_or_name)
        .or_else(|| RULES.iter().copied().find(|rule| rule.name.eq_ignore_ascii_case(code_or_name)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_and_names_are_unique_and_ascending() {
        for pair in RULES.windows(2) {
            assert!(pair[0].code < pair[1].code, "{} before {}", pair[0].code, pair[1].code);
            assert_ne!(pair[0].name, pair[1].name);
        }
    }

    #[test]
    fn every_rule_has_a_page() {
        for rule in RULES {
            let page = explain(rule.code).expect("a page");
            assert!(page.contains(rule.name) && rule.explanation.len() > 60, "{}", rule.code);
            assert!(page.contains("## Why") && page.contains("## Right"), "{}", rule.code);
            assert_eq!(explain(rule.name), Some(page));
        }
        assert_eq!(explain("T9999"), None);
    }
}
