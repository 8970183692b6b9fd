#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| denhart_fuzz::arm_file::run(data));
