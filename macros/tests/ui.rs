//! Errors that rustc shows for a broken arm: one error for a mistake, at the attribute or the call, and nothing after
//! it.

#[test]
fn errors_are_as_recorded() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
