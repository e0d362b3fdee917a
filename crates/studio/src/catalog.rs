//! What the page knows before any scene: models, engines, filters and their parameters.

use oaktwin::accuracy::Bands;
use oaktwin::camera::{RigidTransform, StereoDrift};
use oaktwin::catalog::{Catalog, DepthKind, Twin, TwinCamera, TwinDepthSensor};
use oaktwin::depth::filter;
use oaktwin::depth::parameters::{Choice, Group, Kind, Listing, Source, group};
use oaktwin::depth::preset::{Platform, Preset, TIME_OF_FLIGHT_PRESETS};
use oaktwin::robot;
use oaktwin::sensor::{ENGINES, EngineInput, EngineKind, Technology, default_engine, depth_sensor};
use serde::Serialize;

use crate::protocol::Band;
use crate::reasons::{self, Reason};

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct CatalogInfo {
    version: &'static str,
    scene: String,
    model: String,
    models: Vec<Model>,
    engines: Vec<Engine>,
    filters: Vec<FilterInfo>,
    drift: Vec<Parameter>,
    robot_formats: Vec<RobotFormat>,
    reasons: Vec<Reason>,
    outcomes: Vec<Reason>,
    max_upload_bytes: u64,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Model {
    name: String,
    maker: String,
    generation: String,
    body: Body,
    cameras: Vec<Camera>,
    has_projector: bool,
    has_fisheye: bool,
    depth_sensors: Vec<DepthSensor>,
}

#[derive(Debug, Serialize)]
struct Body {
    /// Along x, y and z, metres.
    size: [f64; 3],
    centre: [f64; 3],
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Camera {
    role: &'static str,
    #[serde(flatten)]
    view: ViewInfo,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct ViewInfo {
    resolution: [u32; 2],
    hfov_deg: f64,
    vfov_deg: f64,
    body_from_camera: Vec<f64>,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct DepthSensor {
    id: String,
    kind: &'static str,
    #[serde(flatten)]
    view: ViewInfo,
    minimum_m: f64,
    ideal_m: [f64; 2],
    maximum_m: f64,
    baseline_m: f64,
    engines: Vec<&'static str>,
    presets: Vec<&'static str>,
    bands: Vec<Band>,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Engine {
    name: &'static str,
    help: &'static str,
    is_matcher: bool,
    parameters: Vec<Parameter>,
}

#[derive(Debug, Serialize)]
struct FilterInfo {
    name: &'static str,
    parameters: Vec<Parameter>,
}

#[derive(Debug, Serialize)]
struct RobotFormat {
    name: &'static str,
    help: &'static str,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct Parameter {
    name: &'static str,
    group: &'static str,
    r#type: &'static str,
    unit: Option<&'static str>,
    minimum: Option<f64>,
    maximum: Option<f64>,
    /// The range of a slider.
    typical: Option<(f64, f64)>,
    step: Option<f64>,
    choices: Option<&'static [&'static str]>,
    default: String,
    documentation: &'static str,
    source: String,
    is_estimate: bool,
}

impl CatalogInfo {
    pub(crate) fn new(catalog: &Catalog, scene: &str, model: &str, max_upload_bytes: u64) -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION"),
            scene: scene.to_owned(),
            model: model.to_owned(),
            models: catalog.nominals().iter().map(Model::new).collect(),
            engines: ENGINES.iter().map(|kind| Engine::new(kind)).collect(),
            filters: filter::NAMES.iter().map(|name| FilterInfo::new(name)).collect(),
            drift: (Group::list_of::<StereoDrift>(Platform::default()).iter())
                .map(Parameter::new)
                .collect(),
            robot_formats: (robot::Format::NAMES.iter().zip(robot::Format::ABOUT))
                .map(|(name, about)| RobotFormat {
                    name,
                    help: about.trim(),
                })
                .collect(),
            reasons: reasons::all(),
            outcomes: reasons::of_surfaces(),
            max_upload_bytes,
        }
    }
}

impl Model {
    fn new(twin: &Twin) -> Self {
        let device = &twin.device;
        let [width, height, depth] = device.body.dimensions_mm.map(|mm| mm * 1e-3);
        let [x, y, z] = device.body.front_mm.map(|mm| mm * 1e-3);
        Self {
            name: device.name.clone(),
            maker: device.manufacturer.clone(),
            generation: device.generation.clone(),
            body: Body {
                size: [depth, width, height],
                centre: [x - depth / 2.0, y, z],
            },
            cameras: twin.cameras.iter().map(Camera::new).collect(),
            has_projector: device.projector.is_some(),
            has_fisheye: twin
                .cameras
                .iter()
                .any(|camera| camera.nominal_fisheye().is_some()),
            depth_sensors: depth_sensors(twin)
                .into_iter()
                .filter_map(|sensor| DepthSensor::new(twin, sensor))
                .collect(),
        }
    }
}

impl Camera {
    fn new(camera: &TwinCamera) -> Self {
        Self {
            role: camera.spec.role.as_str(),
            view: ViewInfo::new(camera),
        }
    }
}

impl ViewInfo {
    fn new(camera: &TwinCamera) -> Self {
        let intrinsics = &camera.intrinsics;
        let rows = rows(&camera.body_from_camera);
        Self {
            resolution: [intrinsics.size.width, intrinsics.size.height],
            hfov_deg: intrinsics.hfov().to_degrees(),
            vfov_deg: intrinsics.vfov().to_degrees(),
            body_from_camera: rows,
        }
    }
}

/// The upper three rows of a transform.
fn rows(transform: &RigidTransform) -> Vec<f64> {
    transform.rows().into_iter().take(3).flatten().collect()
}

/// Returns the name of a depth sensor among the cameras of an OAK: its prim if there are several of its kind.
fn sensor_id(twin: &Twin, sensor: &TwinDepthSensor) -> String {
    let kind = sensor.spec.kind;
    let own = twin.depth_sensors.iter().filter(|other| other.spec.kind == kind);
    if own.count() > 1 {
        sensor.spec.prim.clone()
    } else {
        format!("depth_{kind}")
    }
}

/// Returns the depth sensors of an OAK, the one that the library chooses by default first.
fn depth_sensors(twin: &Twin) -> Vec<&TwinDepthSensor> {
    let mut sensors: Vec<&TwinDepthSensor> = twin.depth_sensors.iter().collect();
    if let Ok(default) = depth_sensor(twin, None) {
        sensors.sort_by_key(|sensor| !std::ptr::eq(*sensor, default));
    }
    sensors
}

impl DepthSensor {
    fn new(twin: &Twin, sensor: &TwinDepthSensor) -> Option<Self> {
        let camera = twin.depth_camera(sensor)?;
        let spec = &sensor.spec;
        let (technology, presets) = match spec.kind {
            DepthKind::Stereo => {
                let platform = twin.platform();
                (
                    Technology::Stereo,
                    platform.map_or_else(Vec::new, Preset::names_on),
                )
            }
            DepthKind::Tof => (Technology::TimeOfFlight, TIME_OF_FLIGHT_PRESETS.to_vec()),
        };
        let suits = |kind: &EngineKind| kind.models.is_none_or(|models| models == technology);
        let mut engines: Vec<&str> = (ENGINES.iter().filter(|kind| suits(kind)))
            .map(|kind| &*kind.name)
            .collect();
        let default = &default_engine(spec.kind).name;
        engines.sort_by_key(|name| name != default);
        let (from, to) = spec.ideal_range_m;
        Some(Self {
            id: sensor_id(twin, sensor),
            kind: spec.kind.as_str(),
            view: ViewInfo::new(&camera),
            minimum_m: spec.min_distance_m,
            ideal_m: [from, to],
            maximum_m: spec.max_distance_m,
            baseline_m: spec.baseline_mm * 1e-3,
            engines,
            presets,
            bands: bands(Bands::of(&twin.device, spec).as_ref()),
        })
    }
}

/// Returns published bands for the page.
pub(crate) fn bands(published: Option<&Bands>) -> Vec<Band> {
    let bands = published.iter().flat_map(|bands| &bands.bands);
    bands
        .flat_map(oaktwin::accuracy::Band::steps)
        .map(|band| Band {
            from_m: band.from_m,
            to_m: band.to_m,
            percent: band.error_percent,
        })
        .collect()
}

impl Engine {
    fn new(kind: &'static EngineKind) -> Self {
        Self {
            name: &kind.name,
            help: &kind.help,
            is_matcher: kind.input == EngineInput::Pair,
            parameters: listings(&kind.name).iter().map(Parameter::new).collect(),
        }
    }
}

impl FilterInfo {
    fn new(name: &'static str) -> Self {
        let all = listings("filters");
        let own = all
            .iter()
            .filter(|row| row.table.strip_suffix(" filter") == Some(name));
        Self {
            name,
            parameters: own.map(Parameter::new).collect(),
        }
    }
}

/// The parameters of a group with the defaults of the most common platform.
fn listings(name: &str) -> Vec<Listing> {
    group(name).map_or_else(
        |_| Vec::new(),
        |group| group.list_common_first(Platform::default()),
    )
}

impl Parameter {
    fn new(listing: &Listing) -> Self {
        let about = &listing.about;
        let finite = |limit: f64| (limit.abs() < f64::MAX).then_some(limit);
        let (r#type, choices) = match about.kind {
            Kind::Choice(names) => ("string", Some(names)),
            kind => (kind.name(), None),
        };
        Self {
            name: about.name,
            group: listing.heading(),
            r#type,
            unit: (!about.unit.is_empty()).then_some(about.unit),
            minimum: finite(about.min),
            maximum: finite(about.max),
            typical: about.typical,
            step: (about.step > 0.0).then_some(about.step),
            choices,
            default: listing.default.clone(),
            documentation: about.doc,
            source: about.source.to_string(),
            is_estimate: about.source == Source::Estimate,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sliders_stay_in_the_valid_range_and_on_its_steps() {
        let engines = ENGINES.iter().map(|kind| &*kind.name);
        for listing in engines.chain(["filters", "drift"]).flat_map(listings) {
            let about = &listing.about;
            let Some((from, to)) = about.typical else {
                continue;
            };
            assert!(from < to && about.accepts(from), "{}: {from}", about.name);
            assert!(about.accepts(to), "{}: {to}", about.name);
        }
    }
}
