//! What a ground-truth frame consists of: the outputs of Replicator's annotators as plain data.

use std::collections::BTreeMap;

use crate::{Image, RangeDepth, ZDepth};

/// Which annotation. The names are Replicator's, those of Isaac Sim 6 for what a depth sensor reports; the last one is a
/// render variable of ovrtx, named likewise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Annotator {
    /// `rgb`
    Rgb,
    /// `distance_to_image_plane`
    DistanceToImagePlane,
    /// `distance_to_camera`
    DistanceToCamera,
    /// `normals`
    Normals,
    /// `instance_id_segmentation`
    InstanceIdSegmentation,
    /// `semantic_segmentation`
    SemanticSegmentation,
    /// `bounding_box_2d_tight`
    BoundingBox2dTight,
    /// `bounding_box_2d_loose`
    BoundingBox2dLoose,
    /// `pointcloud`
    Pointcloud,
    /// `camera_params`
    CameraParams,
    /// `depth_sensor_distance`
    DepthSensorDistance,
    /// `depth_sensor_point_cloud_position`
    DepthSensorPointCloudPosition,
    /// `depth_sensor_point_cloud_color`
    DepthSensorPointCloudColor,
    /// `depth_sensor_imager`
    DepthSensorImager,
    /// `depth_sensor_output_visualization`
    DepthSensorOutputVisualization,
    /// `disparity`: the disparity of a stereo matcher; no annotator of Replicator.
    Disparity,
    /// `confidence`: the confidence of a stereo matcher; no annotator of Replicator.
    Confidence,
}

impl Annotator {
    /// All annotators of Replicator.
    pub const ALL: [Self; 15] = [
        Self::Rgb,
        Self::DistanceToImagePlane,
        Self::DistanceToCamera,
        Self::Normals,
        Self::InstanceIdSegmentation,
        Self::SemanticSegmentation,
        Self::BoundingBox2dTight,
        Self::BoundingBox2dLoose,
        Self::Pointcloud,
        Self::CameraParams,
        Self::DepthSensorDistance,
        Self::DepthSensorPointCloudPosition,
        Self::DepthSensorPointCloudColor,
        Self::DepthSensorImager,
        Self::DepthSensorOutputVisualization,
    ];

    /// Replicator's name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rgb => "rgb",
            Self::DistanceToImagePlane => "distance_to_image_plane",
            Self::DistanceToCamera => "distance_to_camera",
            Self::Normals => "normals",
            Self::InstanceIdSegmentation => "instance_id_segmentation",
            Self::SemanticSegmentation => "semantic_segmentation",
            Self::BoundingBox2dTight => "bounding_box_2d_tight",
            Self::BoundingBox2dLoose => "bounding_box_2d_loose",
            Self::Pointcloud => "pointcloud",
            Self::CameraParams => "camera_params",
            Self::DepthSensorDistance => "depth_sensor_distance",
            Self::DepthSensorPointCloudPosition => "depth_sensor_point_cloud_position",
            Self::DepthSensorPointCloudColor => "depth_sensor_point_cloud_color",
            Self::DepthSensorImager => "depth_sensor_imager",
            Self::DepthSensorOutputVisualization => "depth_sensor_output_visualization",
            Self::Disparity => "disparity",
            Self::Confidence => "confidence",
        }
    }

    /// Whether a depth sensor reports it; all else is ground truth.
    #[must_use]
    pub const fn is_of_depth_sensor(self) -> bool {
        matches!(
            self,
            Self::DepthSensorDistance
                | Self::DepthSensorPointCloudPosition
                | Self::DepthSensorPointCloudColor
                | Self::DepthSensorImager
                | Self::DepthSensorOutputVisualization
        )
    }
}

/// The annotations of one camera at one moment: those that were asked for. All images have the camera's size.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// sRGB and coverage (255, or 0 for a miss).
    pub rgb: Option<Image<[u8; 4]>>,
    /// Metres along the optical axis, `+inf` for a miss.
    pub distance_to_image_plane: Option<ZDepth>,
    /// Metres from the optical centre, `+inf` for a miss.
    pub distance_to_camera: Option<RangeDepth>,
    /// Unit normals in the world's axes; 0 for a miss.
    pub normals: Option<Image<[f32; 3]>>,
    /// One id for each prim that is seen.
    pub instance_id_segmentation: Option<Segmentation>,
    /// One id for each set of semantic labels that is seen.
    pub semantic_segmentation: Option<SemanticSegmentation>,
    /// Boxes around what is seen of each labelled thing.
    pub bounding_box_2d_tight: Option<Boxes2d>,
    /// Boxes around the whole of each labelled thing in the image, whatever hides it.
    pub bounding_box_2d_loose: Option<Boxes2d>,
    /// Where each pixel's ray ends.
    pub pointcloud: Option<PointCloud>,
    /// What the depth sensor measured: metres along the optical axis, 0 where nothing was.
    pub depth_sensor_distance: Option<ZDepth>,
    /// The point that each measurement is of, in the camera's frame with USD's axes (x right, y up, z backward), metres,
    /// and 1; all 0 where nothing was measured.
    pub depth_sensor_point_cloud_position: Option<Image<[f32; 4]>>,
    /// The colour of that point, sRGB; all 0 where nothing was measured.
    pub depth_sensor_point_cloud_color: Option<Image<[u8; 4]>>,
    /// What the sensor's imager sees: luminance of the colour image, 0 to 1.
    pub depth_sensor_imager: Option<Image<f32>>,
    /// The view that `rgbDepthOutputMode` chooses, sRGB.
    pub depth_sensor_output_visualization: Option<Image<[u8; 4]>>,
}

/// An image of ids and the prim paths behind them. 0 is the background; ids are given in the order of the scene, so
/// that every camera and frame of a scene agrees on them.
#[derive(Clone, Debug, PartialEq)]
pub struct Segmentation {
    /// An id for each pixel.
    pub ids: Image<u32>,
    /// The prim path behind each id that occurs.
    pub prim_paths: BTreeMap<u32, String>,
}

/// Semantic labels: `class` → `chair`. A taxonomy with several labels holds them sorted, joined by commas, as
/// Replicator writes them.
pub type Labels = BTreeMap<String, String>;

/// An image of ids and the labels behind them. 0 is the background, 1 what carries no label.
#[derive(Clone, Debug, PartialEq)]
pub struct SemanticSegmentation {
    /// An id for each pixel.
    pub ids: Image<u32>,
    /// The labels behind each id that occurs: `{"class": "BACKGROUND"}` for 0, `{"class": "UNLABELLED"}` for 1.
    pub labels: BTreeMap<u32, Labels>,
}

/// Bounding boxes in an image.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Boxes2d {
    /// The boxes, in the order of the scene.
    pub boxes: Vec<Box2d>,
    /// The prim of each box.
    pub prim_paths: Vec<String>,
    /// The labels behind each semantic id.
    pub labels: BTreeMap<u32, Labels>,
}

/// One bounding box, px; both ends are inside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Box2d {
    /// Into [`Boxes2d::labels`].
    pub semantic_id: u32,
    /// Its first column.
    pub x_min: i32,
    /// Its first row.
    pub y_min: i32,
    /// Its last column.
    pub x_max: i32,
    /// Its last row.
    pub y_max: i32,
    /// The part of it that something else hides, 0 to 1; NaN where it is not known.
    pub occlusion_ratio: f32,
}

/// A point for each pixel whose ray ends on something, row by row. Vectors are as long as `points` or empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointCloud {
    /// In the world, scene units.
    pub points: Vec<[f32; 3]>,
    /// Unit normals in the world's axes.
    pub normals: Vec<[f32; 3]>,
    /// sRGB and 255.
    pub rgb: Vec<[u8; 4]>,
    /// Semantic ids.
    pub semantic: Vec<u32>,
    /// Instance ids.
    pub instance: Vec<u32>,
}
