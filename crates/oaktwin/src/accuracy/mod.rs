//! The twin measured as the vendor measures the camera.
//!
//! A textured board, perpendicular to the optical axis, is rendered at each distance; the sensor looks at its middle ten
//! times, without post filters and with five subpixel bits; of each image's region what is invalid and the top and bottom
//! 5 % are dropped, and the mean of the medians is held against the true distance. The vendor's figures are those of the
//! median device: so by default 200 devices are measured, each with the calibration bias of its seed, and the median of
//! their absolute errors has the verdict.
//!
//! The engine that matches has its board rendered as a pair, as its image sensors record it; a device's bias is then how much
//! farther left its right image lies than its calibration says.
//!
//! Only the part of the image that has a say in the region is rendered and sensed; what comes out is the same, but that a matcher's paths
//! begin nearer.

mod bands;
mod board;
pub(crate) mod distances;
mod eyes;
pub mod measured;
mod optics;
mod plot;
mod report;
mod stand;
#[cfg(test)]
mod tests;

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

use oaktwin_depth::measure::{Region, r_squared};
use oaktwin_depth::random::Stream;
use oaktwin_depth::stereo_noise::Subpixel;
use rayon::prelude::*;

pub use bands::{Band, Bands};
pub use distances::{FARTHEST_M, parse as parse_distances};
pub use optics::MeasuredOptics;
pub use report::{ComparedPoint, Comparison, Devices, Reading, Report, Row, Verdict};

use crate::catalog::{DepthKind, Twin, TwinDepthSensor};
use crate::dataset::figure::Figure;
use crate::diagnostic::{Finding, fold_name, nearest};
use crate::files::FileError;
use crate::sensor::{Engine, EngineKind, ParameterError, SensorOptions, calibration_error_px, sensor};
use eyes::Eyes;
use measured::Curve;
use stand::{Effort, Stand, Unit};

/// Hears how many of how many distances are done, on any thread, before each device too; to break ends the measurement.
pub type Watch<'a> = &'a (dyn Fn(u64, u64) -> ControlFlow<()> + Sync);

/// As many devices as are measured by default.
pub const DEVICES: u32 = 200;

/// As many of them where each has a pair of images to match.
pub const MATCHING_DEVICES: u32 = 25;

/// The most devices at once: each holds a table of a quarter of a megabyte.
const MAX_DEVICES: u32 = 5000;

/// As many captures as the vendor averages.
pub const CAPTURES: u32 = 10;

/// The side of the region by default, as a share of the image's.
pub const REGION: f64 = 0.05;

/// Places along the curve of a plot.
const CURVE_OF_ONE: u32 = 400;
const CURVE_OF_MANY: u32 = 200;

/// How to measure.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The depth sensor by prim or kind (`stereo`, `tof`); by default the last, the device's own.
    pub sensor: Option<String>,
    /// The engine and its settings.
    pub engine: SensorOptions,
    /// True distances, m; by default about twenty from the nearest that can be measured to the end of the bands.
    pub distances_m: Option<Vec<f64>>,
    /// How many devices, where they differ and none is chosen by its seed; by default [`DEVICES`] or
    /// [`MATCHING_DEVICES`].
    pub devices: Option<u32>,
    /// Images of each board.
    pub captures: u32,
    /// The side of the measured region as a share (0 to 1) of the image's.
    pub region: f64,
    /// A measured unit's optics.
    pub optics: MeasuredOptics,
    /// Of somebody's measurements, those nearer than this do not count, m.
    pub from_m: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            sensor: None,
            engine: SensorOptions::default(),
            distances_m: None,
            devices: None,
            captures: CAPTURES,
            region: REGION,
            optics: MeasuredOptics::default(),
            from_m: 0.0,
        }
    }
}

/// Why nothing was measured.
#[derive(Debug, thiserror::Error)]
pub enum AccuracyError {
    /// A file could not be read, or is no measured curve.
    #[error(transparent)]
    File(#[from] FileError),
    /// A parameter of the sensor.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// What is no distance.
    #[error("distances: `{text}` {what}; give metres apart by commas, or FROM:TO:STEP, up to 65.535 m")]
    Distances {
        /// The part that is none.
        text: String,
        /// What is wrong with it.
        what: String,
    },
    /// A name that is no depth sensor's.
    #[error("{model}: there is no depth sensor `{name}`; {hint}")]
    Sensor {
        /// The model.
        model: String,
        /// The name.
        name: String,
        /// What there is.
        hint: String,
    },
    /// Optics that no camera has.
    #[error("{option}: {value} px is no camera's; give that of the measured unit")]
    Optics {
        /// Which.
        option: String,
        /// What was given.
        value: String,
    },
    /// Whoever watched wanted no more.
    #[error("interrupted; nothing was measured")]
    Interrupted,
    /// A number of devices or captures, or a region, that cannot be.
    #[error("{option}: {what}; {remedy}")]
    Option {
        /// Which.
        option: &'static str,
        /// What is wrong.
        what: String,
        /// What to do.
        remedy: &'static str,
    },
}

/// A twin's depth sensor, ready to be measured.
#[derive(Debug)]
pub struct Bench {
    report: Report,
    stand: Stand,
    is_absolute: bool,
    from_m: f64,
}

impl Bench {
    /// Sets a twin up. The findings are what the sensor does otherwise.
    ///
    /// # Errors
    /// An option that cannot be.
    pub fn new(twin: &Twin, options: &Options) -> Result<(Self, Vec<Finding>), AccuracyError> {
        check(options)?;
        let mut twin = twin.clone();
        let depth = depth_sensor(&twin, options.sensor.as_deref())?.clone();
        let own_width_px = twin
            .camera(depth.spec.camera)
            .map(|camera| camera.intrinsics.size.width);
        let depth = options.optics.apply(&mut twin, &depth)?;
        let (devices, units, findings) = units(&twin, &depth, options)?;
        let intrinsics = twin
            .camera(depth.spec.camera)
            .map(|camera| camera.intrinsics)
            .ok_or_else(|| AccuracyError::Sensor {
                model: twin.device.name.clone(),
                name: depth.spec.prim.clone(),
                hint: "it belongs to no camera".to_owned(),
            })?;
        let size = intrinsics.size;
        let region = Region::centred(size.width, size.height, options.region);
        let stand = Stand {
            intrinsics,
            eyes: eyes(&units, options)?,
            units,
            random: Stream::new(options.engine.seed, &depth.spec.prim),
            region,
        };
        let published = Bands::of(&twin.device, depth.spec.kind);
        let distances = match &options.distances_m {
            Some(distances) => distances.clone(),
            None => default_distances(&stand, &depth, published.as_ref()),
        };
        let kind = options
            .engine
            .engine
            .unwrap_or_else(|| EngineKind::default_for(depth.spec.kind));
        let report = Report {
            model: twin.device.name.clone(),
            sensor: depth.spec.prim.clone(),
            engine: kind.as_str(),
            carries_depth: stand.carries_depth(),
            devices,
            focal_length_px: intrinsics.fx,
            image_width_px: size.width,
            image_height_px: size.height,
            disparity_times_depth_px_m: stand.disparity_times_depth(),
            region_width_px: stand.region.columns.end - stand.region.columns.start,
            region_height_px: stand.region.rows.end - stand.region.rows.start,
            captures: options.captures,
            not_the_vendors_method: differences(&stand, options, depth.spec.kind, own_width_px),
            published,
            distances: distances.iter().map(|&z| Row::new(z, &[], None)).collect(),
            measured: None,
            is_good: false,
        };
        let bench = Self {
            report,
            stand,
            is_absolute: true,
            from_m: options.from_m,
        };
        Ok((bench, findings))
    }

    /// Measures, and lays somebody's measurements (from a file of this name) over the curve.
    ///
    /// # Errors
    /// A parameter of the sensor, or [`AccuracyError::Interrupted`].
    pub fn measure(
        mut self,
        measured: Option<(&Path, &Curve)>,
        watch: Watch<'_>,
    ) -> Result<Measurement, AccuracyError> {
        self.is_absolute = measured.is_none_or(|(_, curve)| curve.is_absolute);
        let own: Vec<f64> = self.report.distances.iter().map(|row| row.distance_m).collect();
        let theirs = measured
            .map(|(_, curve)| curve.points.as_slice())
            .unwrap_or_default();
        let theirs: Vec<f64> = theirs.iter().map(|point| point.distance_m).collect();
        let (before, all) = (own.len() as u64, (own.len() + theirs.len()) as u64);
        let captures = self.report.captures;
        let effort = |quality: bool| Effort { captures, quality };
        self.report.distances = self.rows(&own, effort(true), &|done, _| watch(done, all))?;
        let theirs = self.rows(&theirs, effort(false), &|done, _| watch(before + done, all))?;
        self.report.measured = measured.map(|(path, curve)| self.comparison(path, curve, &theirs));
        let verdicts = || self.report.distances.iter().map(|row| row.verdict);
        self.report.is_good = verdicts().all(|verdict| verdict != Verdict::Outside)
            && verdicts().any(|verdict| verdict != Verdict::NothingMeasured);
        Ok(Measurement { bench: self })
    }

    fn rows(&self, distances: &[f64], effort: Effort, watch: Watch<'_>) -> Result<Vec<Row>, AccuracyError> {
        let done = AtomicU64::new(0);
        distances
            .par_iter()
            .map(|&distance_m| {
                let of = distances.len() as u64;
                let wants_more = || watch(done.load(Ordering::Relaxed), of).is_continue();
                let units = self.stand.measure(distance_m, effort, &wants_more)?;
                if watch(done.fetch_add(1, Ordering::Relaxed) + 1, of).is_break() {
                    return Err(AccuracyError::Interrupted);
                }
                let row = Row::new(distance_m, &units, self.report.published.as_ref());
                Ok(row.with_single_view(self.stand.jitter_times_depth(), self.report.carries_depth))
            })
            .collect()
    }

    fn comparison(&self, path: &Path, curve: &Curve, rows: &[Row]) -> Comparison {
        let points: Vec<ComparedPoint> = curve
            .points
            .iter()
            .zip(rows)
            .map(|(point, row)| ComparedPoint {
                distance_m: point.distance_m,
                measured_error_percent: point.error_percent,
                twin_error_percent: row
                    .reading
                    .error_percent
                    .map(|error| if curve.is_absolute { error.abs() } else { error }),
            })
            .collect();
        let far = || points.iter().filter(|point| point.distance_m >= self.from_m);
        let pairs: Vec<[f64; 2]> = far()
            .filter_map(|point| Some([point.measured_error_percent, point.twin_error_percent?]))
            .collect();
        let squares = pairs.iter().map(|[a, b]| (a - b).powi(2)).sum::<f64>();
        Comparison {
            file: path.display().to_string(),
            is_absolute: curve.is_absolute,
            from_m: self.from_m,
            r_squared: r_squared(&pairs),
            rms_difference_percent: (!pairs.is_empty()).then(|| (squares / pairs.len() as f64).sqrt()),
            compared_points: pairs.len(),
            points_not_measured_by_the_twin: far().count() - pairs.len(),
            points,
        }
    }
}

/// What was measured, and the means to measure between.
#[derive(Debug)]
pub struct Measurement {
    bench: Bench,
}

impl Measurement {
    /// The numbers.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.bench.report
    }

    /// The error over distance as a figure. The curve is measured anew at many places; of many devices by one capture of
    /// each instead of several, whose noise the median over the devices averages out.
    ///
    /// # Errors
    /// A parameter of the sensor, or [`AccuracyError::Interrupted`].
    pub fn figure(&self, watch: Watch<'_>) -> Result<Figure, AccuracyError> {
        let report = &self.bench.report;
        let points = report.measured.iter().flat_map(|measured| &measured.points);
        let places =
            (report.distances.iter().map(|row| row.distance_m)).chain(points.map(|point| point.distance_m));
        let (near, far) = places.fold((f64::INFINITY, 0.0f64), |(a, b), z| (a.min(z), b.max(z)));
        let many = matches!(report.devices, Devices::Population { .. });
        let count = if many { CURVE_OF_MANY } else { CURVE_OF_ONE };
        let step = (far - near) / f64::from(count);
        let mut distances: Vec<f64> = (0..=count).map(|i| near + step * f64::from(i)).collect();
        distances.dedup();
        let effort = Effort {
            captures: if many { 1 } else { report.captures },
            quality: false,
        };
        let rows = if near.is_finite() {
            self.bench.rows(&distances, effort, watch)?
        } else {
            Vec::new()
        };
        Ok(plot::figure(report, &rows, self.bench.is_absolute))
    }
}

fn check(options: &Options) -> Result<(), AccuracyError> {
    let wrong = |option, what: String, remedy| Err(AccuracyError::Option { option, what, remedy });
    if options.captures == 0 || options.captures > 1000 {
        return wrong(
            "captures",
            format!("{} cannot be averaged", options.captures),
            "give 1 to 1000",
        );
    }
    if options
        .devices
        .is_some_and(|count| count == 0 || count > MAX_DEVICES)
    {
        return wrong(
            "devices",
            "there must be some, and not too many".to_owned(),
            "give 1 to 5000",
        );
    }
    if !(options.region > 0.0 && options.region <= 1.0) {
        return wrong(
            "region",
            format!("{} is no share of an image", options.region),
            "give a share above 0, up to 1",
        );
    }
    if !(options.from_m >= 0.0 && options.from_m.is_finite()) {
        return wrong(
            "from",
            format!("{} is no distance", options.from_m),
            "give metres",
        );
    }
    if let Some(distances) = &options.distances_m {
        for &distance in distances {
            distances::check(distance).map_err(|what| AccuracyError::Distances {
                text: distance.to_string(),
                what: what.to_owned(),
            })?;
        }
    }
    Ok(())
}

/// The depth sensor by prim or kind; by default the last, the device's own.
pub(crate) fn depth_sensor<'a>(
    twin: &'a Twin,
    name: Option<&str>,
) -> Result<&'a TwinDepthSensor, AccuracyError> {
    let sensors = &twin.depth_sensors;
    let found = match name {
        None => sensors.last(),
        Some(name) => {
            let wanted = fold_name(name);
            sensors.iter().find(|sensor| {
                [sensor.spec.prim.as_str(), sensor.spec.kind.as_str()]
                    .iter()
                    .any(|name| fold_name(name) == wanted)
            })
        }
    };
    found.ok_or_else(|| {
        let names = || {
            sensors
                .iter()
                .flat_map(|sensor| [sensor.spec.kind.as_str(), sensor.spec.prim.as_str()])
        };
        let near = nearest(name.unwrap_or_default(), names());
        AccuracyError::Sensor {
            model: twin.device.name.clone(),
            name: name.unwrap_or_default().to_owned(),
            hint: if near.is_empty() {
                format!("there are {}", names().collect::<Vec<_>>().join(", "))
            } else {
                format!("did you mean {}?", near.join(" or "))
            },
        }
    })
}

/// The devices that are measured: many only where they differ.
fn units(
    twin: &Twin,
    depth: &TwinDepthSensor,
    options: &Options,
) -> Result<(Devices, Vec<Unit>, Vec<Finding>), AccuracyError> {
    let unit = |device_seed: Option<u64>| {
        let options = SensorOptions {
            device_seed,
            ..options.engine.clone()
        };
        let (sensor, findings) = sensor(twin, depth, &options)?;
        let bias_px = match sensor.engine() {
            Engine::StereoMatching(_) => calibration_error_px(&options)?,
            _ => 0.0,
        };
        let unit = Unit {
            engine: sensor.engine().clone(),
            filters: sensor.filters().clone(),
            bias_px,
        };
        Ok::<_, ParameterError>((unit, findings))
    };
    let (plain, findings) = unit(None)?;
    let devices = match (options.engine.device_seed, options.devices) {
        _ if unit(Some(0))?.0 == unit(Some(1))?.0 => Devices::AsGiven,
        (Some(device_seed), _) => Devices::One { device_seed },
        (None, Some(1)) => Devices::One { device_seed: 0 },
        (None, count) => Devices::Population {
            count: count.unwrap_or(match plain.engine {
                Engine::StereoMatching(_) => MATCHING_DEVICES,
                _ => DEVICES,
            }),
        },
    };
    let units = match devices {
        Devices::AsGiven => vec![plain],
        Devices::One { device_seed } => vec![unit(Some(device_seed))?.0],
        Devices::Population { count } => {
            let seeds = 0..u64::from(count);
            seeds
                .map(|seed| Ok(unit(Some(seed))?.0))
                .collect::<Result<_, ParameterError>>()?
        }
    };
    Ok((devices, units, findings))
}

/// What takes the pictures of engines that match them.
fn eyes(units: &[Unit], options: &Options) -> Result<Option<Eyes>, ParameterError> {
    match units.first().map(|unit| &unit.engine) {
        Some(Engine::StereoMatching(engine)) => {
            Eyes::new(engine.parameters().stereo.baseline_m, options.engine.seed).map(Some)
        }
        _ => Ok(None),
    }
}

fn default_distances(stand: &Stand, depth: &TwinDepthSensor, published: Option<&Bands>) -> Vec<f64> {
    let begin = published.and_then(|bands| bands.bands.iter().map(|band| band.from_m).reduce(f64::min));
    let near = stand.nearest_m().max(begin.unwrap_or(0.0));
    let far = published
        .and_then(Bands::end_m)
        .unwrap_or(depth.spec.max_distance_m);
    distances::between(near, far)
}

/// What is not as the vendor measures.
fn differences(stand: &Stand, options: &Options, kind: DepthKind, own_width_px: Option<u32>) -> Vec<String> {
    let mut differences = Vec::new();
    let Some(unit) = stand.units.first() else {
        return differences;
    };
    if !unit.filters.is_empty() {
        differences.push("post filters are on".to_owned());
    }
    match &unit.engine {
        Engine::StereoNoise(engine) => {
            let bits = engine.parameters().subpixel;
            if bits != Subpixel::Bits5 {
                differences.push(format!("{} subpixel bits instead of 5", bits.bits()));
            }
        }
        Engine::StereoMatching(engine) => {
            let bits = engine.parameters().subpixel;
            if bits != Subpixel::Bits5 {
                differences.push(format!("{} subpixel bits instead of 5", bits.bits()));
            }
        }
        Engine::SingleView(_) if kind == DepthKind::Stereo => {
            differences.push("Isaac Sim's sensor has no subpixel bits".to_owned());
        }
        Engine::SingleView(_) | Engine::TimeOfFlight(_) => {}
    }
    let width = stand.intrinsics.size.width;
    if let Some(own) = own_width_px.filter(|own| *own > width) {
        differences.push(format!("images of {width} px instead of {own}"));
    }
    if options.captures != CAPTURES {
        differences.push(format!("{} captures instead of {CAPTURES}", options.captures));
    }
    differences
}
