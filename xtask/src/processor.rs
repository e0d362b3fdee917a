//! The processor time of the commands that a thread ran.

use std::cell::Cell;
use std::io;
use std::process::{Child, ExitStatus};
use std::time::Duration;

thread_local! {
    static USED: Cell<Duration> = const { Cell::new(Duration::ZERO) };
}

/// Returns the processor time of all commands that this thread waited for. Zero where it is unknown: outside Linux.
pub(crate) fn used() -> Duration {
    USED.get()
}

/// Waits for a command, and adds its processor time and its children's.
pub(crate) fn wait(mut child: Child) -> io::Result<ExitStatus> {
    #[cfg(target_os = "linux")]
    USED.set(USED.get() + linux::time_at_exit(child.id()));
    child.wait()
}

#[cfg(target_os = "linux")]
mod linux {
    use std::time::Duration;

    use rustix::process::{Pid, WaitId, WaitIdOptions, waitid};

    /// Returns the processor time of a process once it has ended, and leaves it to be waited for.
    pub(super) fn time_at_exit(process: u32) -> Duration {
        let pid = i32::try_from(process).ok().and_then(Pid::from_raw);
        let ended = pid.map(|pid| waitid(WaitId::Pid(pid), WaitIdOptions::EXITED | WaitIdOptions::NOWAIT));
        let stat = std::fs::read_to_string(format!("/proc/{process}/stat"));
        match (ended, stat) {
            (Some(Ok(_)), Ok(stat)) => parse(&stat).unwrap_or_default(),
            _ => Duration::ZERO,
        }
    }

    /// Reads fields 14 to 17 of `/proc/PID/stat`, as in `proc_pid_stat(5)`: its own time and its children's, in ticks.
    pub(super) fn parse(stat: &str) -> Option<Duration> {
        // The name, which may contain anything, ends with the last parenthesis.
        let (_, fields) = stat.rsplit_once(')')?;
        let times: Option<Vec<u64>> = fields
            .split_whitespace()
            .skip(11)
            .take(4)
            .map(|ticks| ticks.parse().ok())
            .collect();
        let ticks: u64 = times.filter(|times| times.len() == 4)?.iter().sum();
        Some(Duration::from_millis(
            ticks * 1000 / rustix::param::clock_ticks_per_second(),
        ))
    }
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;
    use std::process::Command;

    #[test]
    fn counts_the_time_of_children() {
        let stat = "7 (a) b) S 1 1 1 0 -1 4194304 100 0 0 0 50 25 300 125 20 0 1 0 5 0 0";
        assert_eq!(linux::parse(stat), Some(Duration::from_secs(5)));
        assert_eq!(linux::parse("7 (a) Z 1"), None);
        let before = used();
        let busy = "i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done";
        let child = Command::new("sh")
            .args(["-c", &format!("sh -c '{busy}'")])
            .spawn()
            .unwrap();
        assert!(wait(child).unwrap().success());
        assert!(used() > before, "a child's child has used the processor");
    }
}
