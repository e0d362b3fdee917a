#![no_main]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| oaktwin_fuzz::run(oaktwin_fuzz::check::dae, bytes));
