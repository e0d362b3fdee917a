//! Messages of ROS 2, field by field in the order of their definitions, which CDR follows.

use serde::{Deserialize, Serialize};

/// `builtin_interfaces/Time`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Time {
    /// The seconds.
    pub sec: i32,
    /// The nanoseconds after the seconds, below 10⁹.
    pub nanosec: u32,
}

/// `std_msgs/Header`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Header {
    /// The time of the data.
    pub stamp: Time,
    /// The coordinate frame of the data.
    pub frame_id: String,
}

/// `sensor_msgs/Image`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Image {
    /// The time and the optical frame.
    pub header: Header,
    /// The number of rows.
    pub height: u32,
    /// The number of columns.
    pub width: u32,
    /// The layout of a pixel, such as `16UC1`.
    pub encoding: String,
    /// 1 if numbers of several bytes begin with the highest.
    pub is_bigendian: u8,
    /// The bytes from one row to the next.
    pub step: u32,
    /// The rows.
    #[serde(with = "serde_bytes")]
    pub data: Vec<u8>,
}

/// `sensor_msgs/RegionOfInterest`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct RegionOfInterest {
    /// The first column.
    pub x_offset: u32,
    /// The first row.
    pub y_offset: u32,
    /// The number of rows; 0 for all.
    pub height: u32,
    /// The number of columns; 0 for all.
    pub width: u32,
    /// Whether the region is one of the rectified image.
    pub do_rectify: bool,
}

/// `sensor_msgs/CameraInfo`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct CameraInfo {
    /// The time and the optical frame.
    pub header: Header,
    /// The number of rows of the image.
    pub height: u32,
    /// The number of columns of the image.
    pub width: u32,
    /// The name of the distortion model.
    pub distortion_model: String,
    /// The distortion coefficients.
    pub d: Vec<f64>,
    /// The camera matrix of the raw image, row by row.
    pub k: [f64; 9],
    /// The rotation of the rectification, row by row.
    pub r: [f64; 9],
    /// The projection matrix of the rectified image, row by row.
    pub p: [f64; 12],
    /// The columns that are combined to one; 0 and 1 both mean no binning.
    pub binning_x: u32,
    /// The rows that are combined to one.
    pub binning_y: u32,
    /// The region of the camera that the image shows.
    pub roi: RegionOfInterest,
}

/// `sensor_msgs/CompressedImage`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct CompressedImage {
    /// The time and the optical frame.
    pub header: Header,
    /// The encoding of the image and the kind of compression.
    pub format: String,
    /// The compressed image.
    #[serde(with = "serde_bytes")]
    pub data: Vec<u8>,
}

/// `sensor_msgs/PointField`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PointField {
    /// The name.
    pub name: String,
    /// The place of the field in a point, bytes.
    pub offset: u32,
    /// The type: 7 for `float32`.
    pub datatype: u8,
    /// The number of elements.
    pub count: u32,
}

/// `sensor_msgs/PointCloud2`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PointCloud2 {
    /// The time and the frame.
    pub header: Header,
    /// The number of rows.
    pub height: u32,
    /// The number of columns.
    pub width: u32,
    /// The fields of a point.
    pub fields: Vec<PointField>,
    /// Whether numbers begin with their highest byte.
    pub is_bigendian: bool,
    /// The bytes of a point.
    pub point_step: u32,
    /// The bytes of a row.
    pub row_step: u32,
    /// The points.
    #[serde(with = "serde_bytes")]
    pub data: Vec<u8>,
    /// Whether all points are valid.
    pub is_dense: bool,
}

/// `geometry_msgs/Vector3`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Vector3 {
    /// Along the first axis.
    pub x: f64,
    /// Along the second axis.
    pub y: f64,
    /// Along the third axis.
    pub z: f64,
}

/// `geometry_msgs/Quaternion`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Quaternion {
    /// The first imaginary component.
    pub x: f64,
    /// The second imaginary component.
    pub y: f64,
    /// The third imaginary component.
    pub z: f64,
    /// The real component.
    pub w: f64,
}

/// `geometry_msgs/Transform`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Transform {
    /// The position of the child's origin in the parent, metres.
    pub translation: Vector3,
    /// The rotation from the child to the parent.
    pub rotation: Quaternion,
}

/// `geometry_msgs/TransformStamped`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TransformStamped {
    /// The time and the parent.
    pub header: Header,
    /// The child.
    pub child_frame_id: String,
    /// The pose of the child in the parent.
    pub transform: Transform,
}

/// `tf2_msgs/TFMessage`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TfMessage {
    /// The transforms.
    pub transforms: Vec<TransformStamped>,
}
