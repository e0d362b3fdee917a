//! Runs the program in a temporary folder.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Output, Stdio};
use std::thread::{self, JoinHandle, sleep};
use std::time::{Duration, Instant};

/// The calibration that ships with the project.
pub(crate) const EXAMPLE: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../calibration/fixtures/example-oak-d-pro-poe.json"
);

pub(crate) struct Program {
    folder: tempfile::TempDir,
}

/// The result of a run, with the folder's path removed.
pub(crate) struct Ended {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Program {
    pub(crate) fn new() -> Self {
        Self {
            folder: tempfile::tempdir().unwrap(),
        }
    }

    pub(crate) fn folder(&self) -> &Path {
        self.folder.path()
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub(crate) fn put(&self, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
        let path = self.path(name);
        fs::write(&path, bytes).unwrap();
        path
    }

    pub(crate) fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_oaktwin"));
        command
            .args(arguments)
            .current_dir(self.folder())
            .stdin(Stdio::null());
        command
    }

    pub(crate) fn run(&self, arguments: &[&str]) -> Ended {
        self.ended(&self.command(arguments).output().unwrap())
    }

    /// Runs the program with a limit on the size of files.
    #[cfg(target_os = "linux")]
    pub(crate) fn run_with_small_files(&self, arguments: &[&str]) -> Ended {
        let script = "ulimit -f 1; exec \"$0\" \"$@\"";
        let mut command = Command::new("bash");
        command
            .args(["-c", script, env!("CARGO_BIN_EXE_oaktwin")])
            .args(arguments);
        self.ended(&command.current_dir(self.folder()).output().unwrap())
    }

    /// Runs a command that must succeed and returns its standard output.
    pub(crate) fn good(&self, arguments: &[&str]) -> String {
        let ended = self.run(arguments);
        assert_eq!(ended.code, 0, "{arguments:?}: {}{}", ended.stdout, ended.stderr);
        ended.stdout
    }

    /// Runs a command that must be rejected: one line on standard error, no standard output and no new files. Returns
    /// standard error.
    pub(crate) fn refused(&self, arguments: &[&str]) -> String {
        let before = self.names();
        let ended = self.run(arguments);
        assert_eq!(ended.code, 2, "{arguments:?}: {}{}", ended.stdout, ended.stderr);
        assert_eq!(ended.stdout, "", "{arguments:?}");
        assert!(
            ended.stderr.starts_with("error: "),
            "{arguments:?}: {}",
            ended.stderr
        );
        assert_eq!(
            ended.stderr.trim_end().lines().count(),
            1,
            "{arguments:?}: {}",
            ended.stderr
        );
        assert_eq!(self.names(), before, "{arguments:?} left something behind");
        ended.stderr
    }

    /// Runs the program, interrupts it as soon as `is_time` holds, and returns how it ended.
    #[cfg(unix)]
    pub(crate) fn interrupted(&self, arguments: &[&str], is_time: impl Fn(&Self) -> bool) -> Ended {
        self.signalled(&["INT"], arguments, is_time)
    }

    /// Runs the program, sends it signals as soon as `is_time` holds, and returns how it ended.
    #[cfg(unix)]
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

    /// Returns the paths of all files and folders below the folder.
    pub(crate) fn names(&self) -> Vec<String> {
        fn walk(folder: &Path, root: &Path, names: &mut Vec<String>) {
            for entry in fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                names.push(path.strip_prefix(root).unwrap().display().to_string());
                if path.is_dir() && !path.is_symlink() {
                    walk(&path, root, names);
                }
            }
        }
        let mut names = Vec::new();
        walk(self.folder(), self.folder(), &mut names);
        names.sort();
        names
    }

    fn ended(&self, output: &Output) -> Ended {
        let folder = self.folder().display().to_string();
        let fixtures = EXAMPLE.rsplit_once('/').unwrap().0;
        let text = |bytes: &[u8]| {
            String::from_utf8(bytes.to_vec())
                .unwrap()
                .replace(&folder, "[FOLDER]")
                .replace(fixtures, "[FIXTURES]")
        };
        Ended {
            code: code(output.status),
            stdout: text(&output.stdout),
            stderr: text(&output.stderr),
        }
    }
}

/// Returns the exit code, negative for the number of the signal that ended the program.
fn code(status: ExitStatus) -> i32 {
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        return -signal;
    }
    status.code().unwrap_or(i32::MIN)
}

/// Reads a stream to its end in a thread.
#[cfg(unix)]
fn read_all(mut from: impl Read + Send + 'static) -> JoinHandle<Vec<u8>> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        from.read_to_end(&mut bytes).unwrap();
        bytes
    })
}

/// A process that is killed when the test ends, however it ends.
#[cfg(unix)]
struct Running(Child);

#[cfg(unix)]
impl Running {
    fn wait_until(&mut self, mut is_done: impl FnMut(&mut Child) -> bool) {
        let deadline = Instant::now() + Duration::from_secs(120);
        while !is_done(&mut self.0) {
            assert!(Instant::now() < deadline, "the program hangs");
            sleep(Duration::from_millis(5));
        }
    }
}

#[cfg(unix)]
impl Drop for Running {
    fn drop(&mut self) {
        // Fails if it has ended, which is as good.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}
