//! The outcome of a candidate at a point of the surface.

/// The code of an outcome: an index into [`REASONS`]. Outcomes are ordered: the higher, the farther a point is from being
/// measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Outcome(pub u8);

/// A row of the table of outcomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reason {
    /// The name in reports.
    pub name: &'static str,
    /// The explanation.
    pub doc: &'static str,
}

/// The outcomes by code; 0 is a measured point.
pub const REASONS: &[Reason] = &[
    Reason {
        name: "measured",
        doc: "The sensor measures the point.",
    },
    Reason {
        name: "not_measured",
        doc: "The sensor sees the point, but its pixel has no value.",
    },
    Reason {
        name: "not_resolved",
        doc: "The point is visible, but the centre of its pixel shows another surface.",
    },
    Reason {
        name: "occluded",
        doc: "Another surface hides the point.",
    },
    Reason {
        name: "faces_away",
        doc: "The surface faces away from the camera, or is seen edge-on.",
    },
    Reason {
        name: "outside_view",
        doc: "The point is outside the image, behind the camera or outside its clipping range.",
    },
];

impl Outcome {
    /// The sensor measures the point.
    pub const MEASURED: Self = Self(0);
    pub(super) const NOT_MEASURED: Self = Self(1);
    pub(super) const NOT_RESOLVED: Self = Self(2);
    pub(super) const OCCLUDED: Self = Self(3);
    pub(super) const FACES_AWAY: Self = Self(4);
    pub(super) const OUTSIDE_VIEW: Self = Self(5);

    /// Whether the point is visible, measured or not.
    #[must_use]
    pub fn is_seen(self) -> bool {
        self <= Self::NOT_RESOLVED
    }

    /// The row of the table.
    #[must_use]
    pub fn reason(self) -> &'static Reason {
        &REASONS[usize::from(self.0).min(REASONS.len() - 1)]
    }
}
