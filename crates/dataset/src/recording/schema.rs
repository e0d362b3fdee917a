//! The definitions of ROS 2 messages in a recording, in the format "ros2msg": fields, followed by the fields of nested types.

/// A message type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Schema {
    Image,
    CameraInfo,
    PointCloud2,
    Imu,
    Tf,
}

/// A type and its fields, without constants, which readers do not need.
struct Definition {
    name: &'static str,
    fields: &'static [&'static str],
}

const TIME: Definition = Definition {
    name: "builtin_interfaces/Time",
    fields: &["int32 sec", "uint32 nanosec"],
};
const HEADER: Definition = Definition {
    name: "std_msgs/Header",
    fields: &["builtin_interfaces/Time stamp", "string frame_id"],
};
const REGION: Definition = Definition {
    name: "sensor_msgs/RegionOfInterest",
    fields: &[
        "uint32 x_offset",
        "uint32 y_offset",
        "uint32 height",
        "uint32 width",
        "bool do_rectify",
    ],
};
const POINT_FIELD: Definition = Definition {
    name: "sensor_msgs/PointField",
    fields: &["string name", "uint32 offset", "uint8 datatype", "uint32 count"],
};
const VECTOR: Definition = Definition {
    name: "geometry_msgs/Vector3",
    fields: &["float64 x", "float64 y", "float64 z"],
};
const QUATERNION: Definition = Definition {
    name: "geometry_msgs/Quaternion",
    fields: &["float64 x", "float64 y", "float64 z", "float64 w"],
};
const TRANSFORM: Definition = Definition {
    name: "geometry_msgs/Transform",
    fields: &[
        "geometry_msgs/Vector3 translation",
        "geometry_msgs/Quaternion rotation",
    ],
};
const TRANSFORM_STAMPED: Definition = Definition {
    name: "geometry_msgs/TransformStamped",
    fields: &[
        "std_msgs/Header header",
        "string child_frame_id",
        "geometry_msgs/Transform transform",
    ],
};

impl Schema {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Image => "sensor_msgs/msg/Image",
            Self::CameraInfo => "sensor_msgs/msg/CameraInfo",
            Self::PointCloud2 => "sensor_msgs/msg/PointCloud2",
            Self::Imu => "sensor_msgs/msg/Imu",
            Self::Tf => "tf2_msgs/msg/TFMessage",
        }
    }

    /// Returns the message's fields and its nested types.
    fn definition(self) -> (&'static [&'static str], &'static [Definition]) {
        match self {
            Self::Image => (
                &[
                    "std_msgs/Header header",
                    "uint32 height",
                    "uint32 width",
                    "string encoding",
                    "uint8 is_bigendian",
                    "uint32 step",
                    "uint8[] data",
                ],
                &[HEADER, TIME],
            ),
            Self::CameraInfo => (
                &[
                    "std_msgs/Header header",
                    "uint32 height",
                    "uint32 width",
                    "string distortion_model",
                    "float64[] d",
                    "float64[9] k",
                    "float64[9] r",
                    "float64[12] p",
                    "uint32 binning_x",
                    "uint32 binning_y",
                    "sensor_msgs/RegionOfInterest roi",
                ],
                &[HEADER, TIME, REGION],
            ),
            Self::PointCloud2 => (
                &[
                    "std_msgs/Header header",
                    "uint32 height",
                    "uint32 width",
                    "sensor_msgs/PointField[] fields",
                    "bool is_bigendian",
                    "uint32 point_step",
                    "uint32 row_step",
                    "uint8[] data",
                    "bool is_dense",
                ],
                &[HEADER, TIME, POINT_FIELD],
            ),
            Self::Imu => (
                &[
                    "std_msgs/Header header",
                    "geometry_msgs/Quaternion orientation",
                    "float64[9] orientation_covariance",
                    "geometry_msgs/Vector3 angular_velocity",
                    "float64[9] angular_velocity_covariance",
                    "geometry_msgs/Vector3 linear_acceleration",
                    "float64[9] linear_acceleration_covariance",
                ],
                &[HEADER, TIME, QUATERNION, VECTOR],
            ),
            Self::Tf => (
                &["geometry_msgs/TransformStamped[] transforms"],
                &[TRANSFORM_STAMPED, HEADER, TIME, TRANSFORM, VECTOR, QUATERNION],
            ),
        }
    }

    /// Returns the definition; nested types follow after lines of 80 equals signs.
    pub(super) fn text(self) -> String {
        let (fields, below) = self.definition();
        let mut text = fields.join("\n") + "\n";
        for Definition { name, fields } in below {
            text += &format!("{}\nMSG: {name}\n{}\n", "=".repeat(80), fields.join("\n"));
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_types_are_defined() {
        for schema in [
            Schema::Image,
            Schema::CameraInfo,
            Schema::PointCloud2,
            Schema::Imu,
            Schema::Tf,
        ] {
            let text = schema.text();
            for line in text.lines().filter(|line| !line.starts_with('=')) {
                let Some((kind, _)) = line.split_once(' ') else {
                    panic!("{line}")
                };
                let kind = kind.trim_end_matches("[]");
                let is_defined = !kind.contains('/') || text.contains(&format!("MSG: {kind}\n"));
                assert!(is_defined, "{}: {kind}", schema.name());
            }
        }
    }
}
