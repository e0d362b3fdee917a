//! The memory that this process may use: what a task needs is compared with it before the task begins, because an
//! allocation that fails ends the program.

#[cfg(target_os = "linux")]
mod linux;

use std::sync::atomic::{AtomicU64, Ordering};

use oaktwin_base::diagnostic::{Message, message, opt};

/// The number of bytes that is never checked.
pub const UNCHECKED: u64 = 1 << 26;

/// The user's limit; [`u64::MAX`] without one.
static LIMIT: AtomicU64 = AtomicU64::new(u64::MAX);

/// Sets the memory in bytes that this process may use in total; `None` for as much as there is.
pub fn set_limit(bytes: Option<u64>) {
    LIMIT.store(bytes.unwrap_or(u64::MAX), Ordering::Relaxed);
}

/// Returns the bytes that may still be allocated; `None` if that is unknown.
///
/// It is the minimum of the user's limit, the limits of the address space (`ulimit -v`) and of the control group, each
/// without what is in use, and of the free memory of the computer. All but the first are known on Linux only.
#[must_use]
pub fn available() -> Option<u64> {
    #[cfg(target_os = "linux")]
    let (used, found) = (linux::resident(), linux::available());
    #[cfg(not(target_os = "linux"))]
    let (used, found) = (None, None);
    let limit = LIMIT.load(Ordering::Relaxed);
    let own = (limit != u64::MAX).then(|| limit.saturating_sub(used.unwrap_or(0)));
    own.into_iter().chain(found).min()
}

/// Checks that a number of bytes may be allocated. Small numbers are not checked.
///
/// # Errors
/// Returns an error if it is more than [`available`].
pub fn check(bytes: u64) -> Result<(), Shortage> {
    if bytes <= UNCHECKED {
        return Ok(());
    }
    match available() {
        Some(available) if bytes > available => Err(Shortage {
            needed: bytes,
            available,
        }),
        _ => Ok(()),
    }
}

/// More memory is needed than there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}; {}", self.what(), self.remedy())]
pub struct Shortage {
    /// The bytes that are needed.
    pub needed: u64,
    /// The bytes that are available.
    pub available: u64,
}

impl Shortage {
    /// What is wrong.
    #[must_use]
    pub fn what(&self) -> String {
        format!(
            "{} of memory needed, {} available",
            size(self.needed),
            size(self.available)
        )
    }

    /// What to do.
    #[must_use]
    pub fn remedy(&self) -> Message {
        self.remedy_or("use a smaller input")
    }

    /// What to do, with the way to need less.
    #[must_use]
    pub fn remedy_or(&self, less: &str) -> Message {
        let limit = LIMIT.load(Ordering::Relaxed);
        if limit == u64::MAX {
            message!["free some memory, or ", less]
        } else {
            message!["raise ", opt("memory-limit"), ", or ", less]
        }
    }
}

/// Formats a number of bytes: `1.5 GiB`, rounded up.
#[must_use]
pub fn size(bytes: u64) -> String {
    let (unit, name) = match bytes {
        0..=0x3FFF_FFFF => (1 << 20, "MiB"),
        _ => (1 << 30, "GiB"),
    };
    let tenths = bytes.saturating_mul(10).div_ceil(unit);
    format!("{}.{} {name}", tenths / 10, tenths % 10)
}

/// Parses a number of bytes: `4G`, `512M`, with an optional `iB` or `B`; without a unit in bytes.
///
/// # Errors
/// Returns an error with what is expected.
pub fn parse_size(text: &str) -> Result<u64, String> {
    let wrong = || format!("'{text}' is not a size; expected a number with K, M, G or T, such as 4G");
    let plain = text.trim().trim_end_matches(['B', 'b']).trim_end_matches('i');
    let (number, unit) = match plain.char_indices().last() {
        Some((at, letter)) if letter.is_ascii_alphabetic() => {
            let power = "KMGT".find(letter.to_ascii_uppercase()).ok_or_else(wrong)?;
            (&plain[..at], 1024_f64.powi(i32::try_from(power).unwrap_or(0) + 1))
        }
        _ => (plain, 1.0),
    };
    let number: f64 = number.trim().parse().map_err(|_| wrong())?;
    let bytes = number * unit;
    if bytes >= 1.0 && bytes < 2_f64.powi(63) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in range")]
        let bytes = bytes as u64;
        Ok(bytes)
    } else {
        Err(wrong())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_read_and_written() {
        for (text, bytes) in [
            ("4G", 4 << 30),
            ("512M", 512 << 20),
            ("1.5GiB", 3 << 29),
            ("64kB", 64 << 10),
            ("7", 7),
        ] {
            assert_eq!(parse_size(text), Ok(bytes), "{text}");
        }
        for text in ["", "G", "-1G", "nan", "1e30T", "4X", "0"] {
            assert!(parse_size(text).unwrap_err().contains("such as 4G"), "{text}");
        }
        assert_eq!(size(3 << 29), "1.5 GiB");
        assert_eq!(size((100 << 20) + 1), "100.1 MiB");
        assert_eq!(size(u64::MAX), "1717986918.4 GiB");
    }

    #[test]
    fn too_much_is_a_shortage() {
        assert_eq!(check(1 << 20), Ok(()));
        #[cfg(target_os = "linux")]
        {
            assert!(available().unwrap() > 1 << 20);
            let shortage = check(1 << 60).unwrap_err();
            assert!(
                shortage
                    .to_string()
                    .starts_with("1073741824.0 GiB of memory needed, "),
                "{shortage}"
            );
        }
    }
}
