//! Uses that have no effect of their own at run time, so that no test fails when their lines are left out.

/// Uses; why; the test that shows what they mean.
pub(super) const EXEMPT: &[(&[&str], &str, &str)] = &[
    (&["NOP", "CLI", "STI"], "by definition they do nothing", "assembler::some_instructions_do_nothing"),
    (&["CHECK"], "the compiler looks at the stack, the program does not", "bits::a_check_changes_nothing"),
    (&["STOP"], "the end of the source text", "modules::a_comment_may_follow_stop"),
    (
        &["DEBUG", "ON"],
        "says where a line takes a break-point",
        "modules::lines_know_whether_they_are_in_a_debug_region",
    ),
    (
        &["CONTROL_T_MACRO"],
        "says which of two meanings the lines behind it have",
        "macros::a_call_does_what_its_lines_do",
    ),
    (
        &["T_INCLUDE"],
        "what it brings is defined in another file",
        "macros::what_an_included_file_defines_is_used",
    ),
    (&["EDEF mode: =0"], "neither edge means anything", "messages::every_pair_of_edges"),
];
