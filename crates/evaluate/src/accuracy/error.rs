use oaktwin_files::FileError;
use oaktwin_pipeline::sensor::ParameterError;

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
