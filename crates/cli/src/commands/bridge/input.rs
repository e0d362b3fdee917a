//! Standard input, which steers the bridge.

use std::io::{self, BufRead, BufReader, Read};
use std::sync::mpsc::{self, Receiver};
use std::thread;

/// The longest line of standard input, bytes.
const MAX_LINE: u64 = 1 << 16;

/// Returns the lines of standard input, which a thread reads until its end, or no lines.
pub(super) fn lines(is_read: bool) -> Receiver<String> {
    // A program that writes faster than the bridge takes waits.
    let (sender, receiver) = mpsc::sync_channel(16);
    if is_read {
        thread::spawn(move || {
            let mut input = BufReader::new(io::stdin());
            loop {
                let mut line = Vec::new();
                let read = input.by_ref().take(MAX_LINE).read_until(b'\n', &mut line);
                if !matches!(read, Ok(1..)) {
                    return;
                }
                let text = String::from_utf8_lossy(&line).trim().to_owned();
                if !text.is_empty() && sender.send(text).is_err() {
                    return;
                }
            }
        });
    }
    receiver
}
