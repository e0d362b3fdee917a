//! What Linux reports.

use std::fs;
use std::path::{Path, PathBuf};

use rustix::process::{Resource, getrlimit};

/// Returns the bytes that this process has in memory.
pub(crate) fn resident() -> Option<u64> {
    pages(1)
}

/// Returns the bytes that may still be allocated, as far as Linux knows.
pub(crate) fn available() -> Option<u64> {
    [address_space(), control_group(), free()]
        .into_iter()
        .flatten()
        .min()
}

/// The address space that `ulimit -v` leaves.
fn address_space() -> Option<u64> {
    let limit = getrlimit(Resource::As).current?;
    Some(limit.saturating_sub(pages(0)?))
}

/// A column of `statm`: 0 is the address space, 1 the resident set.
fn pages(column: usize) -> Option<u64> {
    let text = fs::read_to_string("/proc/self/statm").ok()?;
    let pages: u64 = text.split(' ').nth(column)?.parse().ok()?;
    pages.checked_mul(rustix::param::page_size() as u64)
}

/// The memory of the computer that is free, or can be freed.
fn free() -> Option<u64> {
    let text = fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kib: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    kib.checked_mul(1024)
}

/// What the control groups of this process leave: its own and those above it, of version 2 or 1.
fn control_group() -> Option<u64> {
    let groups = fs::read_to_string("/proc/self/cgroup").ok()?;
    let root = Path::new("/sys/fs/cgroup");
    let left = groups.lines().filter_map(|line| {
        let (controllers, path) = line.split_once(':')?.1.split_once(':')?;
        let path = path.trim_start_matches('/');
        match controllers {
            "" => least_left(root, path, ["memory.max", "memory.current"]),
            _ if controllers.split(',').any(|name| name == "memory") => {
                let names = ["memory.limit_in_bytes", "memory.usage_in_bytes"];
                least_left(&root.join("memory"), path, names)
            }
            _ => None,
        }
    });
    left.min()
}

/// The minimum of what the groups from `path` up to the root leave.
fn least_left(root: &Path, path: &str, names: [&str; 2]) -> Option<u64> {
    let own: PathBuf = root.join(path);
    let groups = own.ancestors().take_while(|group| group.starts_with(root));
    groups.filter_map(|group| left(group, names)).min()
}

fn left(group: &Path, [limit, usage]: [&str; 2]) -> Option<u64> {
    let read = |name: &str| fs::read_to_string(group.join(name)).ok();
    let number = |name: &str| read(name)?.trim().parse::<u64>().ok();
    // A group without a limit has the text `max` instead of a number.
    let limit = number(limit)?;
    // Cached files count as usage, but give way.
    let cached = read("memory.stat").and_then(|text| {
        let mut lines = text.lines();
        let line = lines.find_map(|line| line.strip_prefix("inactive_file "))?;
        line.trim().parse::<u64>().ok()
    });
    let used = number(usage)?.saturating_sub(cached.unwrap_or(0));
    Some(limit.saturating_sub(used))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_leave_their_limit_without_the_usage() {
        let folder = std::env::temp_dir().join(format!("oaktwin-memory-{}", std::process::id()));
        let group = folder.join("a/b");
        fs::create_dir_all(&group).unwrap();
        let put = |name: &str, text: &str| fs::write(folder.join(name), text).unwrap();
        put("a/memory.max", "1000\n");
        put("a/memory.current", "700\n");
        put("a/memory.stat", "anon 500\ninactive_file 150\n");
        put("a/b/memory.max", "max\n");
        put("a/b/memory.current", "600\n");
        let names = ["memory.max", "memory.current"];
        assert_eq!(least_left(&folder, "a/b", names), Some(450));
        put("a/b/memory.max", "620\n");
        assert_eq!(least_left(&folder, "a/b", names), Some(20));
        assert_eq!(least_left(&folder, "none", names), None);
        fs::remove_dir_all(&folder).unwrap();
    }
}
