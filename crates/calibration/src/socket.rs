use std::fmt;

use oaktwin_base::diagnostic::fold_name;
use serde::{Serialize, Serializer};

/// A camera socket of the board, as numbered by `DepthAI`: 0 is `CAM_A`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Socket(pub u8);

impl Socket {
    /// `CAM_A`, the centre camera.
    pub const CAM_A: Self = Self(0);
    /// `CAM_B`, the left one of the stereo pair.
    pub const CAM_B: Self = Self(1);
    /// `CAM_C`, the right one of the stereo pair.
    pub const CAM_C: Self = Self(2);
    /// `CAM_J`, the last socket in `DepthAI`.
    pub const LAST: Self = Self(9);

    /// Returns the socket of a number in a file; −1 and 255, which firmware writes for it, mean "none".
    pub(crate) fn from_file(number: i64) -> Result<Option<Self>, String> {
        match number {
            -1 | 255 => Ok(None),
            _ => u8::try_from(number)
                .ok()
                .map(Self)
                .filter(|socket| *socket <= Self::LAST)
                .map(Some)
                .ok_or_else(|| format!("{number} is not a camera socket")),
        }
    }

    /// Returns the socket of a name from `CAM_A` to `CAM_J`, ignoring case and underscores.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        let folded = fold_name(name);
        let [letter] = folded.strip_prefix("cam")?.as_bytes() else {
            return None;
        };
        let number = letter.checked_sub(b'a')?;
        Some(Self(number)).filter(|socket| *socket <= Self::LAST)
    }

    /// Returns the number in files.
    #[must_use]
    pub const fn number(self) -> i32 {
        self.0 as i32
    }
}

impl fmt::Display for Socket {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "CAM_{}", char::from(b'A'.saturating_add(self.0)))
    }
}

impl Serialize for Socket {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
