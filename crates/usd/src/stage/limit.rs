use oaktwin_base::diagnostic::{Message, message, opt};

/// The name of the option that raises the limits of a scene.
const OPTION: &str = "scene-limit";

/// A factor on the limits of what one stage may compose, which keep a small file from filling the memory: 1 by default.
///
/// A stage may compose 250 000 sites, and 16 more for each prim in its layers, where a prim is composed of one site for
/// each place that its opinions come from. It may visit a million prims, and 100 more for each prim in its layers, and
/// draw a million instances, and one more for each ten bytes of its layers. The limits are counts, so that a file gives
/// the same result on every machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneLimit(f64);

impl SceneLimit {
    /// Creates a limit; `None` unless the factor is finite and positive.
    #[must_use]
    pub fn new(factor: f64) -> Option<Self> {
        (factor.is_finite() && factor > 0.0).then_some(Self(factor))
    }

    /// Returns the factor.
    #[must_use]
    pub const fn factor(self) -> f64 {
        self.0
    }

    /// Returns `count` times the factor.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "the factor is positive, and counts are far below 2^53"
    )]
    pub(super) fn times(self, count: u64) -> u64 {
        (count as f64 * self.0) as u64
    }

    /// Returns the remedy of an error about a limit.
    pub(super) fn remedy(self) -> Message {
        message![
            "remove repeated references and instancers, or raise ",
            opt(OPTION),
            format!(" from {}", self.0)
        ]
    }
}

impl Default for SceneLimit {
    fn default() -> Self {
        Self(1.0)
    }
}
