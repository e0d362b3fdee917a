use crate::align::AlignTo;
use crate::input::InputKind;
use crate::sensor::SensorOptions;
use oaktwin_camera::Camera;
use oaktwin_dataset::{CloudAxes, Extras};
use oaktwin_image::annotation::Annotator;
use oaktwin_usd::asset::LensChoice;

/// The field of view of the depth images.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a run has only one")]
pub enum FieldOfView {
    /// The field of view in a folder's `camera_params`, or else the model's.
    #[default]
    Known,
    /// A focal length in pixels of the images.
    FocalLength(f64),
    /// A horizontal field of view in degrees.
    Degrees(f64),
    /// A camera with the images' size.
    Camera(Camera),
}

impl FieldOfView {
    /// Returns a focal length in pixels or, without it, a horizontal field of view in degrees, if one of them is given.
    #[must_use]
    pub fn given(fx: Option<f64>, hfov_deg: Option<f64>) -> Self {
        match (fx, hfov_deg) {
            (Some(fx), _) => Self::FocalLength(fx),
            (None, Some(hfov)) => Self::Degrees(hfov),
            (None, None) => Self::Known,
        }
    }
}

/// The options of [`sense`](super::sense).
#[derive(Clone, Debug, PartialEq)]
pub struct SenseOptions {
    /// The engine and its settings; the image and the name are set for each input.
    pub sensor: SensorOptions,
    /// The depth sensor by kind (`stereo`, `tof`) or prim; by default time of flight if the device has it.
    pub depth_sensor: Option<String>,
    /// The kind of depth, if the files' names do not tell.
    pub input_kind: Option<InputKind>,
    /// The metres per integer depth unit.
    pub depth_scale: f64,
    /// The field of view of the images.
    pub field_of_view: FieldOfView,
    /// Whether images of another size or field of view are resampled to the model's, by the nearest sample.
    pub resample: bool,
    /// Whether the images of a batch are successive frames, not simultaneous ones.
    pub is_sequence: bool,
    /// The lens of the left and right cameras of the wide models.
    pub lens: LensChoice,
    /// The camera that depth is also aligned to.
    pub align: Option<AlignTo>,
    /// The depth sensor annotators to write; the distance is always written.
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
            depth_sensor: None,
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

/// The camera of images.
#[derive(Clone, Copy, Debug)]
pub(super) struct ImageCamera {
    pub(super) camera: Camera,
    /// Whether it is the model's own camera at its own size.
    pub(super) is_models: bool,
}
