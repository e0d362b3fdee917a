use std::fmt;
use std::path::PathBuf;

use oaktwin_base::parameter::choice;
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DVec3;
use oaktwin_image::annotation::Frame;
use oaktwin_image::{CodecError, Image};

use crate::{CameraParams, FrameCamera, Object, StereoImages};

/// One camera's frame on its way to the writers.
#[derive(Debug)]
pub struct Shot {
    /// The annotations to write.
    pub frame: Frame,
    /// Images beside the annotations.
    pub layers: Vec<ShotLayer>,
    /// The camera's parameters, if they are to be written.
    pub camera_params: Option<CameraParams>,
    /// The parameters of the camera that the depth sensor's outputs are images of, if they are to be written.
    pub sensor_params: Option<CameraParams>,
    /// The camera and its pose, for layouts that describe them.
    pub view: Option<FrameCamera>,
    /// The camera that the depth sensor's outputs are images of, and its pose.
    pub sensor_view: Option<FrameCamera>,
    /// The objects whose poses layouts describe.
    pub objects: Vec<Object>,
    /// The stereo pair, for layouts that have one.
    pub stereo: Option<StereoImages>,
    /// The number of the sequence that the frame belongs to: frames of one scene.
    pub sequence: u64,
    /// The time within the sequence, nanoseconds.
    pub time_ns: u64,
    /// The biases of the gyroscope, rad/s, and of the accelerometer, m/s², at this time, if there is an inertial sensor.
    pub imu_biases: Option<[DVec3; 2]>,
    /// The index of the camera.
    pub camera: usize,
    /// The frame number, from 0.
    pub number: u64,
    /// The pose of the camera's mount: the device's body, or the camera itself. Metres.
    pub world_from_mount: RigidTransform,
    /// The render product's name, if each of several cameras has its own folder. Characters other than letters,
    /// digits, `_`, `-` and `.` become `_`.
    pub render_product: Option<String>,
    /// The input that the frame was made from, for writers that name their files after it.
    pub input: InputName,
}

impl Shot {
    /// Creates the shot of a single camera.
    #[must_use]
    pub fn new(frame: Frame, number: u64) -> Self {
        Self {
            frame,
            layers: Vec::new(),
            camera_params: None,
            sensor_params: None,
            view: None,
            sensor_view: None,
            objects: Vec::new(),
            stereo: None,
            sequence: 0,
            time_ns: 0,
            imu_biases: None,
            camera: 0,
            number,
            world_from_mount: RigidTransform::IDENTITY,
            render_product: None,
            input: InputName::default(),
        }
    }
}

/// The name and place of the outputs of an input file: `FOLDER/[ANNOTATOR/]PREFIX NAME SUFFIX.EXT`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct InputName {
    /// The folder of the outputs.
    pub folder: PathBuf,
    /// Whether each annotator has its own folder.
    pub by_annotator: bool,
    /// The text before the name of an output.
    pub prefix: String,
    /// The text after the name of an output.
    pub suffix: String,
    /// The number of images, if the input is a batch; its arrays get a leading axis.
    pub batch: Option<usize>,
    /// The index of the image in the batch.
    pub item: usize,
}

impl InputName {
    /// The path of an output.
    #[must_use]
    pub fn path(&self, annotator: &str, name: &str, extension: &str) -> PathBuf {
        self.file(
            annotator,
            &format!("{}{name}{}.{extension}", self.prefix, self.suffix),
        )
    }

    /// The path of an output of one image of the input.
    pub(crate) fn item_path(&self, annotator: &str, name: &str, extension: &str) -> PathBuf {
        let item = self
            .batch
            .map(|_| format!("_{:04}", self.item))
            .unwrap_or_default();
        let file = format!("{}{name}{}{item}.{extension}", self.prefix, self.suffix);
        self.file(annotator, &file)
    }

    fn file(&self, annotator: &str, file: &str) -> PathBuf {
        match self.by_annotator {
            true => self.folder.join(annotator).join(file),
            false => self.folder.join(file),
        }
    }
}

/// An image beside a frame's annotations.
#[derive(Debug)]
pub struct ShotLayer {
    /// The folder, where annotators have folders.
    pub folder: &'static str,
    /// The name of its files.
    pub name: String,
    /// The image.
    pub data: LayerData,
}

/// The image of a [`ShotLayer`], which also determines the file format.
pub enum LayerData {
    /// Depth in metres, 0 where nothing was measured: NPY and the [extras](crate::Extras) of depth.
    Depth(Image<f32>),
    /// NPY of `float32`.
    Float(Image<f32>),
    /// NPY of `uint8`.
    Byte(Image<u8>),
    /// An image with its PNG encoder.
    Png(Box<dyn Fn() -> Result<Vec<u8>, CodecError> + Send + Sync>),
    /// A point cloud: PLY.
    Cloud {
        /// The points in the camera's frame with USD's axes, metres, and 1; all 0 where nothing was measured.
        positions: Image<[f32; 4]>,
        /// The colours of the points, sRGB.
        colors: Option<Image<[u8; 4]>>,
        /// The axes in the file.
        axes: CloudAxes,
    },
}

choice! {
    /// The axes of a point cloud in a file.
    CloudAxes {
        /// `OpenCV`'s camera: x right, y down, z forward.
        Optical = "optical",
        /// ROS's body, at the camera: x forward, y left, z up.
        Ros = "ros",
    }
}

impl CloudAxes {
    pub(crate) fn convert_usd(self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        match self {
            Self::Optical => [x, -y, -z],
            Self::Ros => [-z, -x, y],
        }
    }
}

impl fmt::Debug for LayerData {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Depth(_) => "Depth",
            Self::Float(_) => "Float",
            Self::Byte(_) => "Byte",
            Self::Png(_) => "Png",
            Self::Cloud { .. } => "Cloud",
        })
    }
}
