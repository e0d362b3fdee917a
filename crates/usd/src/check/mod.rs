//! The linter behind `oaktwin check`: reports a USD file's cameras and depth sensors as Isaac Sim's renderer and as
//! OpenUSD interpret them, and problems with them.
//!
//! Each module contains the rules of one topic. [`RULES`] lists every code with its default level; a finding's level is
//! lower if the file has the value that the catalog's source ships.

mod attributes;
mod catalog;
mod depth;
mod lens;
mod offsets;
mod optics;
mod product;
mod report;
mod rule;
mod scene;
mod schema;
mod stage;
mod units;

use std::path::Path;

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_catalog::{Catalog, Twin};

use crate::stage::{SceneLimit, Stage, StageError, open};

pub use report::{CheckReport, LensReport, PinholeReport, UsdCameraReport, UsdDepthReport};
pub use rule::Rule;
pub use scene::ResolutionSource;

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

/// Options of a check.
#[derive(Clone, Copy, Debug)]
pub struct CheckOptions<'a> {
    /// The catalog whose devices are recognised by the names of their prims or of the file.
    pub catalog: &'a Catalog,
    /// The model that every camera of the file is checked against; recognised if `None`.
    pub model: Option<&'a Twin>,
    /// The factor on the limits of what the stage may compose.
    pub limit: SceneLimit,
}

impl Default for CheckOptions<'static> {
    fn default() -> Self {
        Self {
            catalog: Catalog::builtin(),
            model: None,
            limit: SceneLimit::default(),
        }
    }
}

/// Opens a USD file and checks its cameras and depth sensors.
///
/// # Errors
/// Returns an error if the file cannot be read as USD, as [`open`] does. Problems in its content are findings.
pub fn check(path: impl AsRef<Path>, options: &CheckOptions<'_>) -> Result<CheckReport, StageError> {
    Ok(check_stage(&open(path, options.limit)?, options))
}

/// Checks an open stage.
#[must_use]
pub fn check_stage(stage: &Stage, options: &CheckOptions<'_>) -> CheckReport {
    let twins = options.catalog.nominals();
    let scene = scene::CheckedScene::new(stage, &twins, options.model);
    let mut findings = stage.findings.clone();
    stage::rules(stage, &mut findings);
    for camera in &scene.cameras {
        attributes::camera_rules(camera, &mut findings);
        if optics::rules(camera, &mut findings) {
            units::rules(camera, &mut findings);
            offsets::rules(camera, &mut findings);
        }
        lens::rules(camera, &mut findings);
        catalog::camera_rules(&scene, camera, &mut findings);
    }
    for product in &stage.products {
        product::rules(product, &mut findings);
    }
    schema::rules(&scene, &mut findings);
    for sensor in &scene.depth_sensors {
        attributes::depth_rules(sensor, &mut findings);
        depth::rules(&scene, sensor, &mut findings);
        catalog::depth_rules(sensor, &mut findings);
    }
    catalog::scene_rules(&scene, options.model, &mut findings);
    findings.sort_by(|a, b| order(a).cmp(&order(b)));
    report::report(&scene, findings)
}

/// Returns the sort key of a finding: errors first, then by place and code, so that reports can be compared.
fn order(finding: &Finding) -> (u8, &str, &str, &str) {
    let level = match finding.level {
        Level::Error => 0,
        Level::Warning => 1,
        Level::Note => 2,
    };
    (level, &finding.place, finding.code, &finding.message)
}

/// Formats a number with the shortest digits that identify its `float`, as files do.
#[expect(
    clippy::cast_possible_truncation,
    reason = "the attributes are floats; rounding to one is intended"
)]
fn num(value: f64) -> String {
    (value as f32).to_string()
}

/// Whether two numbers are equal up to the last digits of a `float`.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * a.abs().max(b.abs())
}

/// Formats a suggested number with at most four decimals, as in the sheet.
fn brief(value: f64) -> String {
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
