//! A process of Python that makes frames.

use std::env;
use std::io::{BufRead, BufReader, Read, Write};
use std::ops::Range;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use serde::Deserialize;

use crate::context::Result;

/// The variable with the Python interpreter.
const PYTHON: &str = "OAKTWIN_PYTHON";

/// Windows' flag for a process that gets no Ctrl-C from the terminal.
#[cfg(windows)]
const NEW_PROCESS_GROUP: u32 = 0x200;

/// The maximum delay of Ctrl-C.
const POLL: Duration = Duration::from_millis(50);

/// A line from the Python process.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum ProcessLine {
    /// A batch of frames is complete.
    Done(u64, u64),
    /// Nothing more follows.
    Error(String),
}

/// The Python process, which ends Ray's tasks and itself when its standard input is closed.
pub(super) struct Python {
    name: String,
    pub(super) process: Child,
    lines: Receiver<String>,
    messages: Option<JoinHandle<String>>,
}

impl Python {
    /// Starts the process with its request.
    pub(super) fn start(request: &str) -> Result<Self> {
        let usual = if cfg!(windows) { "python" } else { "python3" };
        let name = env::var(PYTHON).unwrap_or_else(|_| usual.to_owned());
        let mut command = Command::new(&name);
        // Not with -m: the functions of a main module do not exist in Ray's workers.
        command.args(["-c", "import oaktwin._ray as ray; raise SystemExit(ray.main())"]);
        command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        // Ctrl-C in a terminal is for this process, which then closes the other's input.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        #[cfg(windows)]
        std::os::windows::process::CommandExt::creation_flags(&mut command, NEW_PROCESS_GROUP);
        let mut process = command.spawn().map_err(|error| {
            format!("{name} cannot be run ({error}); name a Python with oaktwin[ray] in {PYTHON}")
        })?;
        if let Some(input) = &mut process.stdin {
            // A process that ended already is reported with its messages.
            let _ = input.write_all(request.as_bytes());
        }
        let (sender, lines) = mpsc::channel();
        if let Some(output) = process.stdout.take() {
            thread::spawn(move || {
                let lines = BufReader::new(output).lines();
                lines
                    .map_while(std::result::Result::ok)
                    .try_for_each(|line| sender.send(line))
            });
        }
        let messages = process.stderr.take().map(|mut errors| {
            thread::spawn(move || {
                let mut text = Vec::new();
                let _ = errors.read_to_end(&mut text);
                String::from_utf8_lossy(&text).into_owned()
            })
        });
        Ok(Self {
            name,
            process,
            lines,
            messages,
        })
    }

    /// Returns the next batch that is complete; `None` if there is none yet.
    pub(super) fn next(&mut self) -> Result<Option<Range<u64>>> {
        let line = match self.lines.recv_timeout(POLL) {
            Ok(line) => line,
            Err(RecvTimeoutError::Timeout) => return Ok(None),
            Err(RecvTimeoutError::Disconnected) => return Err(self.ended().into()),
        };
        match serde_json::from_str(&line) {
            Ok(ProcessLine::Done(first, end)) => Ok(Some(first..end)),
            Ok(ProcessLine::Error(text)) => Err(text.into()),
            Err(_) => Ok(None),
        }
    }

    /// Describes the end of a process that did not report an error.
    fn ended(&mut self) -> String {
        let status = self.process.wait().map(|status| status.to_string());
        let messages = self.messages.take().and_then(|thread| thread.join().ok());
        let messages = messages.unwrap_or_default();
        let last = messages.lines().rev().find(|line| !line.trim().is_empty());
        format!(
            "{}: ended before the frames were complete ({}): {}; install oaktwin[ray] there, or name another Python in {PYTHON}; \
             then resume with --resume",
            self.name,
            status.unwrap_or_default(),
            last.unwrap_or("no message").trim(),
        )
    }
}
