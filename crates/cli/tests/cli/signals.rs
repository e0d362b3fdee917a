//! Runs the program and sends it signals.

#![cfg(unix)]

use std::io::Read;
use std::process::{Child, Command, Output, Stdio};
use std::thread::{self, JoinHandle, sleep};
use std::time::{Duration, Instant};

use super::program::{Ended, Program};

impl Program {
    /// Runs the program, interrupts it as soon as `is_time` holds, and returns how it ended.
    pub(crate) fn interrupted(&self, arguments: &[&str], is_time: impl Fn(&Self) -> bool) -> Ended {
        self.signalled(&["INT"], arguments, is_time)
    }

    /// Runs the program, sends it signals as soon as `is_time` holds, and returns how it ended.
    pub(crate) fn signalled(
        &self,
        signals: &[&str],
        arguments: &[&str],
        is_time: impl Fn(&Self) -> bool,
    ) -> Ended {
        let mut command = self.command(arguments);
        let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
        let mut running = Running(child.unwrap());
        // Read meanwhile: a program that fills a pipe waits, and ends before it has written everything.
        let stdout = read_all(running.0.stdout.take().unwrap());
        let stderr = read_all(running.0.stderr.take().unwrap());
        running.wait_until(|child| {
            assert_eq!(child.try_wait().unwrap(), None, "ended before it was interrupted");
            is_time(self)
        });
        let id = running.0.id().to_string();
        for signal in signals {
            let kill = Command::new("kill").args(["-s", signal, &id]).status();
            assert!(kill.unwrap().success());
        }
        running.wait_until(|child| child.try_wait().unwrap().is_some());
        let status = running.0.wait().unwrap();
        self.ended(&Output {
            status,
            stdout: stdout.join().unwrap(),
            stderr: stderr.join().unwrap(),
        })
    }
}

/// Reads a stream to its end in a thread.
fn read_all(mut from: impl Read + Send + 'static) -> JoinHandle<Vec<u8>> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        from.read_to_end(&mut bytes).unwrap();
        bytes
    })
}

/// A process that is killed when the test ends, however it ends.
struct Running(Child);

impl Running {
    fn wait_until(&mut self, mut is_done: impl FnMut(&mut Child) -> bool) {
        let deadline = Instant::now() + Duration::from_secs(120);
        while !is_done(&mut self.0) {
            assert!(Instant::now() < deadline, "the program hangs");
            sleep(Duration::from_millis(5));
        }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // Fails if it has ended, which is as good.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}
