//! The rules, one file per group, and their registry.

pub mod build;
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
];

/// The rule with `code`, in any case.
#[must_use]
pub fn rule(code: &str) -> Option<&'static Rule> {
    RULES.iter().copied().find(|rule| rule.code.eq_ignore_ascii_case(code))
}

/// The page of a rule in Markdown, by code or name; what `technol explain T0301` shows.
#[must_use]
pub fn explain(code_or_name: &str) -> Option<String> {
    let rule = rule(code_or_name)
        .or_else(|| RULES.iter().copied().find(|rule| rule.name.eq_ignore_ascii_case(code_or_name)))?;
    let severity = rule.severity.name();
    let setting = if rule.fixed {
        String::from("It cannot be lowered: such a program cannot be built.")
    } else {
        format!(
            "`[lints] {} = \"off\"` in technol.toml (or `hint`, `warning`, `error`) changes it.",
            rule.code
        )
    };
    Some(format!("# {} {}\n\n{severity}. {setting}\n\n{}\n", rule.code, rule.name, rule.explanation))
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
            assert_eq!(explain(rule.name), Some(page));
        }
        assert_eq!(explain("T9999"), None);
    }
}
