#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| denhart_fuzz::inverse::run(data));
