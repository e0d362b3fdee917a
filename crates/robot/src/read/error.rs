use std::path::PathBuf;

use oaktwin_base::diagnostic::Message;
use oaktwin_files::FileError;
use oaktwin_files::xml::XmlError;
use oaktwin_usd::stage::StageError;

/// A robot's file that cannot be read or used.
#[derive(Debug, thiserror::Error)]
pub enum RobotFileError {
    /// The file cannot be opened.
    #[error(transparent)]
    File(#[from] FileError),
    /// A mistake in a file: `FILE: PLACE: what is wrong; what to do`.
    #[error(transparent)]
    At(#[from] XmlError),
    /// The file is not a valid USD stage.
    #[error(transparent)]
    Stage(#[from] StageError),
    /// A number that is so large that poses would not be finite.
    #[error("{}: {place}: {value:e} is too large; write metres or radians up to 1e9", .path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// The link or joint.
        place: String,
        /// The number.
        value: f64,
    },
    /// An argument that does not fit the robot.
    #[error("{0}")]
    Option(Message),
}
