//! Digital twins of Luxonis OAK depth cameras: one door to all of oaktwin's crates.

pub mod files;
pub mod report;
pub mod unit;

pub use oaktwin_calibration as calibration;
pub use oaktwin_camera as camera;
pub use oaktwin_catalog as catalog;
pub use oaktwin_diagnostic as diagnostic;
pub use oaktwin_usd as usd;
