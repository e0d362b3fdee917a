//! Parameter sweeps: one frame with many sensors, on one sheet.

mod sheet;
mod thumbnail;

use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;

use super::camera::PlacedCamera;
use super::depth_sensor::{DepthSensorError, DepthSensorOptions, depth_sensors, sensor_input};
use crate::pair::Pair;
use crate::sensor::{EngineKind, ParameterError, Scalar, Sensor, SensorOptions};
use oaktwin_base::diagnostic::fold_name;
use oaktwin_depth::Engine;
use oaktwin_image::Image;
use oaktwin_image::annotation::Frame;
use serde::{Deserialize, Serialize};
use thumbnail::Thumbnail;

/// The maximum number of values of a parameter; more images would be too small.
pub const MAX_VALUES: usize = 12;

/// A parameter with its values: `maxDistance=2,4,8`. Beside an engine's parameters there are `engine`, `preset` and `seed` of
/// [`SensorOptions`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SweepAxis {
    /// The name.
    pub name: String,
    /// The values, as the parameter accepts them.
    pub values: Vec<String>,
}

/// The values of one parameter, or all combinations of two. In files, it is the list of the axes as text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "Vec<String>", into = "Vec<String>")]
pub struct Sweep {
    columns: SweepAxis,
    rows: Option<SweepAxis>,
}

/// An invalid sweep.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SweepError {
    /// The syntax is invalid.
    #[error("invalid sweep '{0}'; write NAME=VALUE,VALUE,…, such as maxDistance=2,4,8")]
    Syntax(String),
    /// There are too many values.
    #[error("{name} has {count} values; give it at most {MAX_VALUES}")]
    TooManyValues {
        /// The parameter.
        name: String,
        /// The number of values.
        count: usize,
    },
    /// There are more than two parameters, or none.
    #[error("{0} parameters do not fit on a sheet; sweep one or two")]
    NotOneOrTwo(usize),
    /// A parameter is repeated.
    #[error("{0} is swept twice; give all its values at once")]
    Twice(String),
}

impl std::str::FromStr for SweepAxis {
    type Err = SweepError;

    fn from_str(text: &str) -> Result<Self, SweepError> {
        let wrong = || SweepError::Syntax(text.to_owned());
        let (name, values) = text.split_once('=').ok_or_else(wrong)?;
        let values: Vec<String> = values.split(',').map(|value| value.trim().to_owned()).collect();
        let name = name.trim().to_owned();
        if name.is_empty() || values.iter().any(String::is_empty) {
            return Err(wrong());
        }
        if values.len() > MAX_VALUES {
            let count = values.len();
            return Err(SweepError::TooManyValues { name, count });
        }
        Ok(Self { name, values })
    }
}

impl fmt::Display for SweepAxis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}", self.name, self.values.join(","))
    }
}

impl TryFrom<Vec<String>> for Sweep {
    type Error = SweepError;

    fn try_from(axes: Vec<String>) -> Result<Self, SweepError> {
        Self::parse(axes.iter().map(String::as_str))
    }
}

impl From<Sweep> for Vec<String> {
    fn from(sweep: Sweep) -> Self {
        let axes = std::iter::once(sweep.columns).chain(sweep.rows);
        axes.map(|axis| axis.to_string()).collect()
    }
}

impl Sweep {
    /// Creates a sweep of one parameter, whose values are the columns of the sheet, or of two, with the second's values as rows.
    ///
    /// # Errors
    /// Returns an error for none or more than two axes, or the same parameter twice.
    pub fn new(axes: Vec<SweepAxis>) -> Result<Self, SweepError> {
        let count = axes.len();
        let names: BTreeSet<String> = axes.iter().map(|axis| fold_name(&axis.name)).collect();
        if let (true, Some(axis)) = (names.len() < count, axes.last()) {
            return Err(SweepError::Twice(axis.name.clone()));
        }
        let mut axes = axes.into_iter();
        match (axes.next(), axes.next(), axes.next()) {
            (Some(columns), rows, None) => Ok(Self { columns, rows }),
            _ => Err(SweepError::NotOneOrTwo(count)),
        }
    }

    /// Parses a sweep from the texts of its axes.
    ///
    /// # Errors
    /// Returns the errors of [`Sweep::new`], or an error if a text is invalid.
    pub fn parse<'a>(axes: impl IntoIterator<Item = &'a str>) -> Result<Self, SweepError> {
        let axes: Result<Vec<SweepAxis>, SweepError> = axes.into_iter().map(str::parse).collect();
        Self::new(axes?)
    }

    /// Returns the options of each cell, row by row.
    ///
    /// # Errors
    /// Returns an error if a value is invalid.
    pub fn options(&self, base: &SensorOptions) -> Result<Vec<SensorOptions>, ParameterError> {
        let mut all = Vec::new();
        let rows = self.rows.as_ref().map_or(1, |rows| rows.values.len());
        for row in 0..rows {
            for column in &self.columns.values {
                let mut options = base.clone();
                set(&mut options, &self.columns.name, column)?;
                if let Some((axis, value)) = self
                    .rows
                    .as_ref()
                    .and_then(|axis| Some((axis, axis.values.get(row)?)))
                {
                    set(&mut options, &axis.name, value)?;
                }
                all.push(options);
            }
        }
        Ok(all)
    }
}

/// Sets the parameter of an axis.
fn set(options: &mut SensorOptions, name: &str, value: &str) -> Result<(), ParameterError> {
    let wrong = |remedy: &str| ParameterError {
        name: name.to_owned(),
        what: format!("invalid value '{value}'"),
        remedy: remedy.to_owned(),
    };
    match fold_name(name).as_str() {
        "engine" => options.engine = Some(EngineKind::parse(value)?.into()),
        "preset" => options.preset = Some(value.to_owned()),
        "seed" => options.seed = value.parse().map_err(|_| wrong("give a whole number"))?,
        _ => options.parameters.push((name.to_owned(), Scalar::of(value))),
    }
    Ok(())
}

/// The sensors of a sweep, for each camera and each cell of its sheet.
#[derive(Clone, Debug)]
pub struct SweptSensors {
    sweep: Sweep,
    /// The sensors by cell, then by camera.
    sensors: Vec<Vec<Option<Sensor>>>,
}

impl SweptSensors {
    /// Creates the sensors of these cameras.
    ///
    /// # Errors
    /// Returns the errors of [`depth_sensors`].
    pub fn new(
        sweep: Sweep,
        cameras: &[PlacedCamera],
        options: &DepthSensorOptions<'_>,
    ) -> Result<Self, DepthSensorError> {
        let mut sensors = Vec::new();
        let swept = sweep.options(options.sensor).map_err(|error| DepthSensorError {
            place: "sweep".to_owned(),
            error,
        })?;
        for own in swept {
            let options = DepthSensorOptions {
                sensor: &own,
                ..*options
            };
            sensors.push(depth_sensors(cameras, &options)?.0);
        }
        Ok(Self { sweep, sensors })
    }

    /// The engines of this camera's sensors.
    pub(super) fn engines(&self, camera: usize) -> impl Iterator<Item = Arc<dyn Engine>> {
        let own = self
            .sensors
            .iter()
            .filter_map(move |sensors| sensors.get(camera)?.as_ref());
        own.map(|sensor| Arc::clone(sensor.engine()))
    }

    /// Whether this camera has a depth sensor.
    pub(super) fn has(&self, camera: usize) -> bool {
        let first = self.sensors.first().and_then(|sensors| sensors.get(camera));
        first.is_some_and(Option::is_some)
    }

    /// The sheet of a camera's frame; `None` if the camera has no depth sensor.
    ///
    /// # Errors
    /// Returns an error if a sensor cannot measure the frame.
    pub(super) fn sheet(
        &mut self,
        camera: usize,
        frame: &Frame,
        number: u64,
        pair: Option<&Pair>,
    ) -> Result<Option<Image<[u8; 3]>>, ParameterError> {
        let Some(depth) = &frame.distance_to_image_plane else {
            return Ok(None);
        };
        let width = depth.0.width();
        let factor = sheet::factor(&self.sweep, width);
        let mut cells = Vec::new();
        for sensors in &mut self.sensors {
            let Some(sensor) = sensors.get_mut(camera).and_then(Option::as_mut) else {
                return Ok(None);
            };
            let captured = sensor.capture(sensor_input(sensor, frame, number, pair)?, &[])?;
            cells.push(Thumbnail::new(&captured.distance, factor));
        }
        Ok(Some(sheet::sheet(&self.sweep, frame, factor, &cells)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sensor::STEREO_NOISE;

    fn sweep(texts: &[&str]) -> Result<Sweep, SweepError> {
        Sweep::parse(texts.iter().copied())
    }

    #[test]
    fn parses_sweeps() {
        let two = sweep(&["maxDistance = 2, 4", "confidenceThreshold=0.5"]).unwrap();
        let options = two.options(&SensorOptions::default()).unwrap();
        let set: Vec<Vec<(&str, String)>> = options
            .iter()
            .map(|one| {
                let parameters = one.parameters.iter();
                parameters
                    .map(|(name, value)| (name.as_str(), value.to_string()))
                    .collect()
            })
            .collect();
        assert_eq!(
            set,
            [
                [("maxDistance", "2"), ("confidenceThreshold", "0.5")],
                [("maxDistance", "4"), ("confidenceThreshold", "0.5")],
            ]
            .map(|cell| cell.map(|(name, value)| (name, value.to_owned())))
        );
        let engines = sweep(&["engine=single-view,stereo_noise", "seed=7"]).unwrap();
        let options = engines.options(&SensorOptions::default()).unwrap();
        assert_eq!(options[1].engine, Some((&STEREO_NOISE).into()));
        assert_eq!((options[0].seed, options[0].parameters.len()), (7, 0));
        for wrong in ["engine=stereo", "seed=-1"] {
            assert!(
                sweep(&[wrong])
                    .unwrap()
                    .options(&SensorOptions::default())
                    .is_err()
            );
        }
    }

    #[test]
    fn rejects_invalid_sweeps() {
        for (texts, part) in [
            (
                &["maxDistance"][..],
                "invalid sweep 'maxDistance'; write NAME=VALUE",
            ),
            (&["=1"], "invalid sweep"),
            (&["a=1,,2"], "invalid sweep"),
            (&["a="], "invalid sweep"),
            (&["a=1,2,3,4,5,6,7,8,9,10,11,12,13"], "a has 13 values"),
            (&["a=1", "a=2"], "a is swept twice"),
            (&["a=1", "b=1", "c=1"], "3 parameters"),
            (&[], "0 parameters"),
        ] {
            let error = sweep(texts).unwrap_err().to_string();
            assert!(error.contains(part), "{error}");
        }
    }
}
