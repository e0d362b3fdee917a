//! What the page knows before any scene: models, engines, filters and their parameters.

use oaktwin::accuracy::Bands;
use oaktwin::camera::{RigidTransform, StereoDrift};
use oaktwin::catalog::{Catalog, DepthKind, Twin, TwinCamera, TwinDepthSensor};
use oaktwin::depth::filter;
use oaktwin::depth::parameters::{Choice, DefaultSource, Group, Kind, Listing, group};
use oaktwin::depth::preset::{Platform, Preset, TIME_OF_FLIGHT_PRESETS};
use oaktwin::robot;
use oaktwin::sensor::{ENGINES, EngineInput, EngineKind, Technology, default_engine, depth_sensor};
use serde::Serialize;

use crate::protocol::Band;
use crate::reasons::{self, Reason};

/// What the server knows before any scene.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Catalog"))]
#[serde(rename_all = "camelCase")]
pub(crate) struct CatalogInfo {
    version: &'static str,
    /// The scene that is shown first.
    scene: String,
    /// The model that is shown first.
    model: String,
    models: Vec<Model>,
    engines: Vec<Engine>,
    /// The filters that can be chosen, with the parameters of each.
    filters: Vec<FilterInfo>,
    /// The ways in which a stereo pair can have changed since its calibration; each is 0 by default.
    drift: Vec<Parameter>,
    /// The formats of robots and simulators, each with one line about it.
    robot_formats: Vec<RobotFormat>,
    /// The reasons why a pixel has no value, sorted by code; codes have gaps. Code 0 is a measured pixel.
    reasons: Vec<Reason>,
    /// What can become of a point of a surface, sorted by code: code 0 is a measured one; the reasons, and others such as "hidden".
    outcomes: Vec<Reason>,
    /// The largest file that can be dropped, bytes.
    max_upload_bytes: u64,
}

#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
struct Model {
    /// The name, which is its id: "OAK4-D".
    name: String,
    maker: String,
    /// "RVC2", "RVC4".
    generation: String,
    /// In the body frame.
    body: Body,
    cameras: Vec<Camera>,
    /// Whether it has a dot projector.
    has_projector: bool,
    /// Whether its left and right cameras have a fisheye description besides the pinhole one.
    has_fisheye: bool,
    /// Empty for a model without depth.
    depth_sensors: Vec<DepthSensor>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
struct Body {
    /// Along x, y and z, metres.
    #[cfg_attr(test, ts(type = "Vec3"))]
    size: [f64; 3],
    #[cfg_attr(test, ts(type = "Vec3"))]
    centre: [f64; 3],
}

/// A camera of a device at its used resolution.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
struct Camera {
    /// "rgb", "left", "right", "tof".
    role: &'static str,
    #[serde(flatten)]
    view: ViewInfo,
}

#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "CameraView"))]
#[serde(rename_all = "camelCase")]
struct ViewInfo {
    resolution: [u32; 2],
    hfov_deg: f64,
    vfov_deg: f64,
    /// Row-major 3 × 4: from the optical frame (x right, y down, z forward) to the body frame.
    body_from_camera: Vec<f64>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
struct DepthSensor {
    /// `depth_stereo` or `depth_tof`; the prim if the device has several of the kind.
    id: String,
    #[cfg_attr(test, ts(type = "\"stereo\" | \"tof\""))]
    kind: &'static str,
    #[serde(flatten)]
    view: ViewInfo,
    /// The distances of the range shells; null where the maker publishes none.
    #[cfg_attr(test, ts(type = "number | null"))]
    minimum_m: f64,
    #[cfg_attr(test, ts(type = "[number, number] | null"))]
    ideal_m: [f64; 2],
    #[cfg_attr(test, ts(type = "number | null"))]
    maximum_m: f64,
    #[cfg_attr(test, ts(type = "number | null"))]
    baseline_m: f64,
    /// The names of the engines that model it, the default first.
    engines: Vec<&'static str>,
    /// The names of DepthAI's presets for it.
    presets: Vec<&'static str>,
    /// The accuracy bands that the maker publishes.
    bands: Vec<Band>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
struct Engine {
    /// "stereo-noise".
    name: &'static str,
    help: &'static str,
    /// Whether it needs the images of both cameras, which take longer to render.
    is_matcher: bool,
    parameters: Vec<Parameter>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Filter"))]
struct FilterInfo {
    name: &'static str,
    parameters: Vec<Parameter>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
struct RobotFormat {
    name: &'static str,
    help: &'static str,
}

#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
struct Parameter {
    name: &'static str,
    /// The heading to show it under.
    group: &'static str,
    #[cfg_attr(test, ts(type = "\"number\" | \"integer\" | \"boolean\" | \"string\""))]
    r#type: &'static str,
    unit: Option<&'static str>,
    minimum: Option<f64>,
    maximum: Option<f64>,
    /// The range that devices or experiments usually have, for a slider; null if it is the whole range.
    typical: Option<(f64, f64)>,
    /// The step from the minimum to the next valid number; null if every number is valid.
    step: Option<f64>,
    /// The values of a `string` parameter, if they are enumerated.
    choices: Option<&'static [&'static str]>,
    /// The default as text. The effective default of a model may differ: `FrameHeader.parameters`.
    default: String,
    documentation: &'static str,
    /// Where the default comes from: "DepthAI", "estimate", "camera", …
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
            is_estimate: about.source == DefaultSource::Estimate,
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
