//! The system's limit on receive buffers.

use oaktwin::diagnostic::{Finding, Level};

/// The receive buffer that is requested, which the system reduces to its limit. Images of 4 MB arrived whole with it.
pub(crate) const WANTED_BYTES: usize = 64 << 20;
/// The setting of Linux.
const SETTING: &str = "net.core.rmem_max";
const FILE: &str = "/proc/sys/net/core/rmem_max";

/// Returns the system's limit, if it is known.
pub(crate) fn limit() -> Option<u64> {
    std::fs::read_to_string(FILE).ok()?.trim().parse().ok()
}

/// Reports a limit at which images are lost: an image arrives as a burst of datagrams, and what does not fit into the buffer is
/// dropped by the system. Without the size of an image, two images of 1280×800 in 16UC1 shall fit.
pub(crate) fn check(limit: Option<u64>, image_bytes: Option<u64>) -> Option<Finding> {
    let limit = limit?;
    let needed = 2 * image_bytes.unwrap_or(1280 * 800 * 2);
    if limit >= needed {
        return None;
    }
    let what = match image_bytes {
        Some(bytes) => {
            format!("receive buffers are limited to {limit} bytes, less than two images of {bytes} bytes")
        }
        None => format!("receive buffers are limited to {limit} bytes"),
    };
    Some(Finding::new(
        "receive-buffer",
        Level::Warning,
        SETTING,
        format!("{what}: large images are lost"),
        format!(
            "run `sudo sysctl -w {SETTING}={WANTED_BYTES}` and start the bridge and its subscribers again"
        ),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_buffers_are_reported_with_the_setting() {
        let stock = check(Some(212_992), None).unwrap().to_string();
        assert!(
            stock.contains("sudo sysctl -w net.core.rmem_max=67108864"),
            "{stock}"
        );
        assert!(check(Some(4 << 20), None).is_none() && check(None, None).is_none());
        let metres = 1280 * 800 * 4;
        assert!(check(Some(4 << 20), Some(metres)).is_some());
        assert!(check(Some(8 << 20), Some(metres)).is_none());
    }
}
