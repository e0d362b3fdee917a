use oaktwin_diagnostic::{Finding, Level, Message};
use serde::Serialize;

use super::{attributes, catalog, depth, lens, offsets, optics, product, schema, stage, units};

/// A rule of `check`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Rule {
    /// The code of the rule's findings.
    pub code: &'static str,
    /// The default level of its findings.
    pub level: Level,
    /// The problem that the rule reports.
    pub what: &'static str,
    /// The remedy; empty for notes.
    pub remedy: &'static str,
}

/// All rules, grouped by topic.
pub const RULES: &[Rule] = &[
    stage::NO_CAMERA,
    stage::COMPOSITION,
    stage::PACKAGE_LAYOUT,
    stage::UP_AXIS,
    stage::STAGE_UNITS,
    stage::DEFAULT_PRIM,
    attributes::CAMERA_TYPE,
    optics::CAMERA_VALUE,
    optics::UNAUTHORED_OPTICS,
    optics::ANIMATED_OPTICS,
    optics::NOT_PERSPECTIVE,
    optics::NON_SQUARE_PIXELS,
    optics::VERTICAL_APERTURE,
    optics::DEPTH_OF_FIELD,
    optics::CLIPPING_RANGE,
    units::UNITS_SLIP,
    units::IMPLAUSIBLE_FOV,
    offsets::APERTURE_OFFSET,
    offsets::OFFSET_CONVENTION,
    lens::LENS_MODEL,
    lens::LENS_VALUE,
    lens::LENS_FOCAL_LENGTH,
    lens::LEGACY_DISTORTION,
    lens::PROJECTION_TYPE,
    product::PRODUCT_CAMERA,
    product::PRODUCT_RESOLUTION,
    schema::SCHEMA_MISSING,
    schema::SCHEMA_WRONG_PRIM,
    schema::SCHEMA_CONFLICT,
    schema::OVRTX_SCHEMA,
    attributes::DEPTH_ATTRIBUTE_UNKNOWN,
    attributes::OUTLIER_REMOVAL_RANGE,
    attributes::DEPTH_ATTRIBUTE_TYPE,
    attributes::OUTLIER_REMOVAL_TYPE,
    depth::DEPTH_VALUE,
    depth::CONFIDENCE_THRESHOLD,
    depth::NOISE_MEAN_ZERO,
    depth::FOCAL_LENGTH_PIXEL,
    depth::SENSOR_SIZE_PIXEL,
    depth::DISTANCE_RANGE,
    depth::MIN_DISTANCE,
    depth::CLIPPED_RANGE,
    depth::TOF_AS_STEREO,
    catalog::CATALOG_VALUE,
    catalog::CATALOG_MISSING,
];

impl Rule {
    /// Creates a finding at the rule's level.
    pub(super) fn at(&self, place: &str, message: impl Into<Message>) -> Finding {
        Finding::new(self.code, self.level, place, message, self.remedy)
    }

    /// Creates a note.
    pub(super) fn note(&self, place: &str, message: impl Into<Message>) -> Finding {
        Finding::new(self.code, Level::Note, place, message, "")
    }

    /// Creates a finding at the rule's level, or a note if the file has the value that its source ships.
    pub(super) fn at_or_note(&self, as_shipped: bool, place: &str, message: impl Into<Message>) -> Finding {
        if as_shipped {
            self.note(place, message)
        } else {
            self.at(place, message)
        }
    }

    /// Creates a finding with a specific remedy.
    pub(super) fn with_remedy(
        &self,
        place: &str,
        message: impl Into<Message>,
        remedy: impl Into<Message>,
    ) -> Finding {
        Finding::new(self.code, self.level, place, message, remedy)
    }
}
