//! The outcome of a candidate at a point of the surface.

use std::sync::LazyLock;

use oaktwin_depth::reason;

/// The code of an outcome in the table of [`reasons`]. Outcomes are ordered: the higher, the farther a point is from being measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Outcome(pub u8);

/// A row of the table of outcomes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutcomeRow {
    /// The code.
    pub code: u8,
    /// The name in reports.
    pub name: String,
    /// The explanation.
    pub doc: String,
}

/// The outcomes that are not reasons of the sensor's pixels.
const OWN: [(Outcome, &str, &str); 7] = [
    (Outcome::MEASURED, "measured", "The sensor measures the point."),
    (
        Outcome::INACCURATE,
        "inaccurate",
        "The sensor measures the point with an error above the tolerance.",
    ),
    (
        Outcome::NOT_MEASURED,
        "not_measured",
        "The sensor sees the point, but its pixel has no value for no known reason.",
    ),
    (
        Outcome::NOT_RESOLVED,
        "not_resolved",
        "The point is visible, but the centre of its pixel shows another surface.",
    ),
    (
        Outcome::HIDDEN,
        "hidden",
        "Another surface hides the point from the camera.",
    ),
    (
        Outcome::FACES_AWAY,
        "faces_away",
        "The surface faces away from the camera, or is seen edge-on.",
    ),
    (
        Outcome::OUTSIDE_VIEW,
        "outside_view",
        "The point is outside the image, behind the camera or outside its clipping range.",
    ),
];

static REASONS: LazyLock<Vec<OutcomeRow>> = LazyLock::new(|| {
    let own = OWN.map(|(Outcome(code), name, doc)| OutcomeRow {
        code,
        name: name.to_owned(),
        doc: doc.to_owned(),
    });
    // The reasons of the sensor's pixels have their own codes.
    let of_pixels = reason::legend().into_iter().map(|(code, label)| OutcomeRow {
        code,
        name: label.name,
        doc: label.documentation,
    });
    let is_lost = |reason: &OutcomeRow| reason.code != Outcome::MEASURED.0;
    let mut reasons: Vec<OutcomeRow> = own.into_iter().chain(of_pixels.filter(is_lost)).collect();
    reasons.sort_by_key(|reason| reason.code);
    reasons
});

/// Returns the outcomes in the order of their codes; the first means that the point is measured.
#[must_use]
pub fn reasons() -> &'static [OutcomeRow] {
    &REASONS
}

impl Outcome {
    /// The sensor measures the point.
    pub const MEASURED: Self = Self(0);
    pub(super) const INACCURATE: Self = Self(126);
    /// The pixel has no value, and the engine no reason for it.
    pub(super) const NOT_MEASURED: Self = Self(127);
    pub(super) const NOT_RESOLVED: Self = Self(128);
    pub(super) const HIDDEN: Self = Self(129);
    pub(super) const FACES_AWAY: Self = Self(130);
    pub(super) const OUTSIDE_VIEW: Self = Self(131);

    /// The outcome at a pixel without a value for which the sensor has this code.
    pub(super) fn of_pixel(code: u8) -> Self {
        if (Self::MEASURED.0 + 1..Self::INACCURATE.0).contains(&code) {
            Self(code)
        } else {
            Self::NOT_MEASURED
        }
    }

    /// Whether the point is visible, measured or not.
    #[must_use]
    pub fn is_seen(self) -> bool {
        self <= Self::NOT_RESOLVED
    }

    /// The name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        let found = REASONS.binary_search_by_key(&self.0, |reason| reason.code);
        found.map_or("not_measured", |index| &REASONS[index].name)
    }
}
