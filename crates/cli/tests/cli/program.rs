//! Runs the program in a temporary folder.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Output, Stdio};

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
        self.ended(&self.command_with_small_files(arguments).output().unwrap())
    }

    /// The command of a program whose files may have 1 KiB.
    #[cfg(target_os = "linux")]
    pub(crate) fn command_with_small_files(&self, arguments: &[&str]) -> Command {
        let script = "ulimit -f 1; exec \"$0\" \"$@\"";
        let mut command = Command::new("bash");
        command
            .args(["-c", script, env!("CARGO_BIN_EXE_oaktwin")])
            .args(arguments)
            .current_dir(self.folder());
        command
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

    /// Returns the paths of all files and folders below the folder.
    pub(crate) fn names(&self) -> Vec<String> {
        fn walk(folder: &Path, root: &Path, names: &mut Vec<String>) {
            for entry in fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                names.push(with_slashes(
                    &path.strip_prefix(root).unwrap().display().to_string(),
                ));
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

    pub(crate) fn ended(&self, output: &Output) -> Ended {
        let folder = with_slashes(&self.folder().display().to_string());
        let fixtures = with_slashes(EXAMPLE.rsplit_once('/').unwrap().0);
        let text = |bytes: &[u8]| {
            with_slashes(std::str::from_utf8(bytes).unwrap())
                .replace(&folder, "[FOLDER]")
                .replace(&fixtures, "[FIXTURES]")
        };
        Ended {
            code: code(output.status),
            stdout: text(&output.stdout),
            stderr: text(&output.stderr),
        }
    }
}

/// Replaces the backslashes in paths by slashes on Windows, also in JSON. A backslash before a quotation mark is kept, because it
/// escapes the mark.
fn with_slashes(text: &str) -> String {
    if !cfg!(windows) {
        return text.to_owned();
    }
    let text = text.replace("\\\\", "/").replace("\\\"", "\0");
    text.replace('\\', "/").replace('\0', "\\\"")
}

/// Returns the exit code, negative for the number of the signal that ended the program.
fn code(status: ExitStatus) -> i32 {
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        return -signal;
    }
    status.code().unwrap_or(i32::MIN)
}
