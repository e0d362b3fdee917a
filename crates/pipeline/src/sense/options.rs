use crate::input::InputKind;
use crate::sensor::SensorOptions;
use oaktwin_camera::{Camera, ImageSize};
use oaktwin_catalog::{DepthKind, Role};
use oaktwin_dataset::{CloudAxes, Extras};
use oaktwin_depth::align::Fill;
use oaktwin_image::annotation::Annotator;
use oaktwin_usd::asset::LensChoice;

/// The field of view of the depth images.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FieldOfView {
    /// What a folder's `camera_params` say, else the model's.
    #[default]
    Known,
    /// A focal length at the images' width, px.
    FocalLength(f64),
    /// A horizontal angle, degrees.
    Degrees(f64),
    /// That of their camera, with its principal point; it has their size.
    Camera(Camera),
}

/// Into which camera the depth is reprojected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AlignTo {
    /// The camera.
    pub camera: Role,
    /// The size of its image, by `DepthAI`'s rule; by default the camera's own.
    pub size: Option<ImageSize>,
    /// Which pixels a sample goes into.
    pub fill: Fill,
}

/// What a sensor is to do with depth images.
#[derive(Clone, Debug, PartialEq)]
pub struct SenseOptions {
    /// The engine and its settings; the image and the name are filled in.
    pub sensor: SensorOptions,
    /// Which of a device's depth sensors; by default time of flight where it has it.
    pub kind: Option<DepthKind>,
    /// What the numbers are, where the files' names do not say it.
    pub input_kind: Option<InputKind>,
    /// Metres to a unit of whole numbers.
    pub depth_scale: f64,
    /// The images' field of view.
    pub field_of_view: FieldOfView,
    /// Whether images of another size or field of view become the model's, by the nearest sample.
    pub resample: bool,
    /// Whether the images of a batch are one after the other in time, instead of side by side.
    pub is_sequence: bool,
    /// The lens of the left and right cameras of the wide models.
    pub lens: LensChoice,
    /// Into another camera too.
    pub align: Option<AlignTo>,
    /// What of the depth sensor's annotators; the distance is always there.
    pub annotators: Vec<Annotator>,
    /// The additional files of each depth image.
    pub extras: Extras,
    /// The axes of the point cloud that is also written, as PLY.
    pub cloud: Option<CloudAxes>,
}

impl Default for SenseOptions {
    fn default() -> Self {
        Self {
            sensor: SensorOptions::default(),
            kind: None,
            input_kind: None,
            depth_scale: 0.001,
            field_of_view: FieldOfView::default(),
            resample: false,
            is_sequence: false,
            lens: LensChoice::default(),
            align: None,
            annotators: Vec::new(),
            extras: Extras::default(),
            cloud: None,
        }
    }
}

/// The camera that images were taken with, and whether anybody said so.
#[derive(Clone, Copy, Debug)]
pub(super) struct ImageCamera {
    pub(super) camera: Camera,
    /// Whether it is the model's own, at its own size.
    pub(super) is_models: bool,
}
