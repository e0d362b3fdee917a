//! What engines are made of, from a twin, a render product or a stereo pair.

use oaktwin_base::diagnostic::{Finding, Level, fold_name, message, opt};
use oaktwin_camera::{ImageSize, Intrinsics, StereoGeometry, Usd};
use oaktwin_catalog::{Twin, TwinDepthSensor};
use oaktwin_depth::preset::Platform;
use oaktwin_depth::{EngineKind, ParameterError, PresetConfig, Setup, single_view};

use super::options::models;
use super::parameters::{platform_of, stereo_pair};
use super::{ENGINES, STEREO_NOISE, SensorOptions, preset, single_view_parameters};

/// The largest relative difference between the focal lengths of the images and of the twin, at the same width, at which
/// they count as the same: the rounding of single precision, in which USD holds its cameras.
const SAME_FOCAL_LENGTH: f64 = 1e-5;

/// Where the geometry of a sensor comes from.
pub(super) enum GeometrySource<'a> {
    /// A depth sensor of a twin.
    Twin {
        twin: &'a Twin,
        sensor: &'a TwinDepthSensor,
        /// The images' intrinsics, if their field of view differs from the camera's.
        own: Option<Intrinsics>,
    },
    /// NVIDIA's attributes of a render product.
    Product(&'a single_view::Parameters),
    /// A rectified stereo pair.
    Pair {
        platform: Platform,
        stereo: StereoGeometry,
        width_px: u32,
    },
}

impl<'a> GeometrySource<'a> {
    pub(super) fn twin(twin: &'a Twin, sensor: &'a TwinDepthSensor, options: &SensorOptions) -> Self {
        let own = twin.depth_camera(sensor).and_then(|camera| {
            let (image, own) = (options.image?, camera.intrinsics);
            let at_own_width = image.fx * f64::from(own.size.width) / f64::from(image.size.width);
            // NaN counts as different.
            let is_same = (at_own_width - own.fx).abs() <= SAME_FOCAL_LENGTH * own.fx;
            (!is_same).then_some(image)
        });
        Self::Twin { twin, sensor, own }
    }

    /// Returns the processor that computes depth, if it is known.
    pub(super) fn platform(&self, setup: &Setup) -> Option<Platform> {
        let own = match self {
            Self::Twin { twin, .. } => twin.platform(),
            Self::Product(_) => None,
            Self::Pair { platform, .. } => Some(*platform),
        };
        let given = setup
            .parameters
            .iter()
            .rev()
            .find(|(name, _)| fold_name(name) == "platform");
        given
            .and_then(|(_, value)| Platform::from_name(&value.to_string()))
            .or(own)
    }
}

/// Collects what an engine is made of.
pub(super) fn setup(
    kind: &EngineKind,
    source: &GeometrySource<'_>,
    options: &SensorOptions,
    findings: &mut Vec<Finding>,
) -> Result<Setup, ParameterError> {
    let mut setup = match *source {
        GeometrySource::Twin { twin, sensor, own } => of_twin(kind, twin, sensor, own, options, findings)?,
        GeometrySource::Product(attributes) => {
            if kind.models.is_some() {
                attributes.check()?;
            }
            let baseline_m = attributes.baseline_mm.abs() / 1000.0;
            Setup {
                attributes: *attributes,
                ..Setup::new(attributes.focal_length_px, width_px(attributes), baseline_m)
            }
        }
        GeometrySource::Pair {
            platform,
            stereo,
            width_px,
        } => {
            let preset = options.preset.as_deref();
            Setup {
                platform,
                preset: preset.map(|name| preset::of_stereo(platform, name)).transpose()?,
                ..Setup::new(stereo.focal_length_px, width_px, stereo.baseline_m)
            }
        }
    };
    let preset_extends = setup
        .preset
        .as_ref()
        .is_some_and(PresetConfig::extended_disparity);
    setup.extended_disparity = options.extended_disparity || preset_extends;
    if let GeometrySource::Twin { sensor, own, .. } = source {
        setup.attributes = single_view_parameters(
            sensor,
            setup.extended_disparity,
            options.isaac.unwrap_or_default(),
        );
        if let Some(image) = own {
            setup.attributes.focal_length_px =
                image.fx * setup.attributes.sensor_size_px / f64::from(image.size.width);
        }
    }
    setup.device_seed = options.device_seed;
    setup.parameters.clone_from(&options.parameters);
    if let (GeometrySource::Twin { sensor, .. }, Some(image)) = (source, options.image)
        && *kind == STEREO_NOISE
    {
        findings.extend(smaller_than_mode(image.size, &setup, &sensor.spec.prim));
    }
    Ok(setup)
}

/// Says that images with the size of a smaller mode have the errors of the larger one.
fn smaller_than_mode(size: ImageSize, setup: &Setup, prim: &str) -> Option<Finding> {
    let mode = match (size.width, size.height) {
        (640, 400) => "400P",
        (640, 480) => "480P",
        _ => return None,
    };
    (size.width < setup.width_px && !setup.sets("width")).then(|| {
        Finding::new(
            "mode",
            Level::Note,
            prim,
            message![
                format!(
                    "{size} images have the errors of the matcher's mode with {} px in a row; ",
                    setup.width_px
                ),
                opt("param").with("width=640"),
                format!(" simulates {mode}")
            ],
            "",
        )
    })
}

fn of_twin(
    kind: &EngineKind,
    twin: &Twin,
    sensor: &TwinDepthSensor,
    own: Option<Intrinsics>,
    options: &SensorOptions,
    findings: &mut Vec<Finding>,
) -> Result<Setup, ParameterError> {
    let camera = twin.depth_camera(sensor).map(|camera| camera.intrinsics);
    if let (Some(image), Some(camera)) = (own, camera) {
        findings.push(own_focal_length(&image, &camera, &sensor.spec.prim));
    }
    let preset = preset::of_sensor(twin, sensor.spec.kind, options)?;
    let geometry = match sensor.spec.pair() {
        Some(pair) => stereo_pair(twin, pair).map(|(stereo, width_px)| {
            let focal_length_px = own.map_or(stereo.focal_length_px, |image| {
                image.fx * f64::from(width_px) / f64::from(image.size.width)
            });
            Setup::new(focal_length_px, width_px, stereo.baseline_m)
        }),
        None => camera.map(|camera| {
            let image = options.image.unwrap_or(camera);
            let fx = if own.is_some() {
                image.fx
            } else {
                camera.fx * (f64::from(image.size.width) / f64::from(camera.size.width))
            };
            let centre = image.principal_point::<Usd>();
            Setup {
                principal_point_px: Some([centre.x, centre.y]),
                ..Setup::new(fx, image.size.width, 0.0)
            }
        }),
    };
    let suits = |kind: &EngineKind| models(kind, sensor.spec.kind);
    if !suits(kind) || (kind.models.is_some() && geometry.is_none()) {
        let suitable = ENGINES.iter().filter(|kind| suits(kind)).map(|kind| &*kind.name);
        return Err(ParameterError {
            name: "engine".to_owned(),
            what: format!(
                "{kind} does not model {}, a {} sensor",
                sensor.spec.prim, sensor.spec.kind
            ),
            remedy: format!(
                "use {}, or choose another sensor",
                suitable.collect::<Vec<_>>().join(", ")
            ),
        });
    }
    Ok(Setup {
        platform: platform_of(twin),
        preset,
        ..geometry.unwrap_or_else(|| Setup::new(0.0, 0, 0.0))
    })
}

fn own_focal_length(image: &Intrinsics, own: &Intrinsics, prim: &str) -> Finding {
    let width = own.size.width;
    let at_own_width = image.fx * f64::from(width) / f64::from(image.size.width);
    Finding::new(
        "own-focal-length",
        Level::Note,
        prim,
        format!(
            "the images' focal length of {at_own_width:.2} px at a width of {width} px is used instead of the model's \
             {:.2} px",
            own.fx
        ),
        "",
    )
}

/// The width of the simulated sensor, px.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the cast saturates, and widths out of range are rejected"
)]
fn width_px(product: &single_view::Parameters) -> u32 {
    product.sensor_size_px.round() as u32
}
