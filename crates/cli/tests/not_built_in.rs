//! Commands that a build leaves out say how to get them.

#![cfg(not(feature = "full"))]

use std::process::Command;

#[test]
fn a_command_that_is_left_out_says_how_to_get_it() {
    for arguments in [
        &["studio", "--port", "1"][..],
        &["bridge"],
        &["generate", "--help"],
    ] {
        let done = Command::new(env!("CARGO_BIN_EXE_oaktwin"))
            .args(arguments)
            .output()
            .unwrap();
        let message = String::from_utf8(done.stderr).unwrap();
        let command = arguments[0];
        assert_eq!(done.status.code(), Some(2), "{message}");
        assert_eq!(
            message,
            format!(
                "error: this build does not include `oaktwin {command}`; run `cargo install --locked oaktwin-cli --features \
                 {command}`, or in a checkout `cargo run --release --features {command} -- {command} …`\n"
            )
        );
    }
}
