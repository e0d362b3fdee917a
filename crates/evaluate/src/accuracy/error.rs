use oaktwin_files::FileError;
use oaktwin_pipeline::sensor::ParameterError;

/// The reason why nothing was measured.
#[derive(Debug, thiserror::Error)]
pub enum AccuracyError {
    /// A file cannot be read or is not a measured curve.
    #[error(transparent)]
    File(#[from] FileError),
    /// A parameter of the sensor is invalid.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// A distance is invalid.
    #[error("distances: `{text}` {what}; give comma-separated metres or FROM:TO:STEP, up to 65.535 m")]
    Distances {
        /// The invalid item.
        text: String,
        /// The problem.
        what: String,
    },
    /// The sensor measures no distance of a depth image.
    #[error(
        "distances: the range of the sensor, {nearest_m:?} to {farthest_m:?} m, {what}; check its baseline, focal length and disparities"
    )]
    Range {
        /// The nearest measurable distance, m.
        nearest_m: f64,
        /// The farthest one, m.
        farthest_m: f64,
        /// The problem.
        what: &'static str,
    },
    /// The depth sensor does not exist.
    #[error("{model}: there is no depth sensor `{name}`; {hint}")]
    Sensor {
        /// The name of the model.
        model: String,
        /// The requested name.
        name: String,
        /// The available sensors.
        hint: String,
    },
    /// The optics are out of range.
    #[error("{option}: {value} px is out of range; give the value of the measured unit")]
    Optics {
        /// The name of the option.
        option: String,
        /// The invalid value.
        value: String,
    },
    /// The measurement was interrupted.
    #[error("interrupted; nothing was measured")]
    Interrupted,
    /// A number of devices or captures, or a region, is out of range.
    #[error("{option}: {what}; {remedy}")]
    Option {
        /// The name of the option.
        option: &'static str,
        /// The problem.
        what: String,
        /// The remedy.
        remedy: &'static str,
    },
}
