use std::num::NonZeroU32;

use ros2_client::Name;
use serde::Serialize;

use crate::BridgeError;
use crate::convert::Encoding;
use crate::delivery::Delivery;
use crate::transforms::DeviceFrames;

/// The topic of transforms that do not change, which all nodes share.
pub(crate) const TF_STATIC: &str = "/tf_static";

/// The options of a bridge.
#[derive(Clone, Debug, PartialEq)]
pub struct BridgeOptions {
    /// The topic of the exact depth.
    pub depth: String,
    /// The topic of its camera info; without it, the field of view is from the filter's options, else the model's.
    pub info: Option<String>,
    /// The topic of the colour images of the same camera and stamps.
    pub rgb: Option<String>,
    /// The namespace of the published topics.
    pub out: String,
    /// The name of the sensor within the namespace: `stereo`, or `tof`.
    pub sensor: String,
    /// The name of the node, which is in no namespace.
    pub node: String,
    /// The encoding of measured depth.
    pub encoding: Encoding,
    /// Whether point clouds are published.
    pub points: bool,
    /// The distance of the pixels that become points, in both directions.
    pub points_step: NonZeroU32,
    /// Whether compressed depth is published.
    pub compressed: bool,
    /// The frames of the device, if they are published as transforms.
    pub frames: Option<DeviceFrames>,
    /// Whether reliable delivery is offered to subscribers.
    pub is_reliable: bool,
    /// Whether subscriptions require reliable delivery.
    pub is_input_reliable: bool,
    /// When frames reach the subscribers.
    pub delivery: Delivery,
}

/// The topics of a bridge, whole names.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Topics {
    /// The exact depth.
    pub depth: String,
    /// Its camera info.
    pub info: Option<String>,
    /// The colour images.
    pub rgb: Option<String>,
    /// The measured depth.
    pub image_out: String,
    /// The camera info of the measured depth.
    pub info_out: String,
    /// The measured depth, compressed.
    pub compressed_out: Option<String>,
    /// The point cloud of the measured depth.
    pub points_out: Option<String>,
    /// The colour images.
    pub rgb_out: Option<String>,
    /// The camera info of the colour images.
    pub rgb_info_out: Option<String>,
    /// The frames of the device.
    pub transforms_out: Option<String>,
}

impl BridgeOptions {
    /// Returns the names of the topics: the vendor driver's, below the namespace.
    ///
    /// # Errors
    /// Returns an error if a name is invalid, or if a published topic is also subscribed to.
    pub fn topics(&self) -> Result<Topics, BridgeError> {
        let (out, sensor) = (self.out.trim_end_matches('/'), &self.sensor);
        let optional = |topic: &Option<String>| topic.as_deref().map(whole).transpose();
        let given = |is_given: bool, topic: String| is_given.then(|| whole(&topic)).transpose();
        let topics = Topics {
            depth: whole(&self.depth)?,
            info: optional(&self.info)?,
            rgb: optional(&self.rgb)?,
            image_out: whole(&format!("{out}/{sensor}/image_raw"))?,
            info_out: whole(&format!("{out}/{sensor}/camera_info"))?,
            compressed_out: given(
                self.compressed,
                format!("{out}/{sensor}/image_raw/compressedDepth"),
            )?,
            points_out: given(self.points, format!("{out}/points"))?,
            rgb_out: given(self.rgb.is_some(), format!("{out}/rgb/image_raw"))?,
            rgb_info_out: given(self.rgb.is_some(), format!("{out}/rgb/camera_info"))?,
            transforms_out: given(self.frames.is_some(), TF_STATIC.to_owned())?,
        };
        match topics.both() {
            Some(both) => Err(BridgeError::Loop(both.clone())),
            None => Ok(topics),
        }
    }
}

impl Topics {
    /// Returns a topic that is both subscribed to and published.
    fn both(&self) -> Option<&String> {
        self.published()
            .find(|out| self.subscribed().any(|input| input == *out))
    }

    /// The topics to which the bridge subscribes.
    pub fn subscribed(&self) -> impl Iterator<Item = &String> {
        let inputs = [Some(&self.depth), self.info.as_ref(), self.rgb.as_ref()];
        inputs.into_iter().flatten()
    }

    /// The topics that the bridge publishes.
    pub fn published(&self) -> impl Iterator<Item = &String> {
        let outputs = [
            Some(&self.image_out),
            Some(&self.info_out),
            self.compressed_out.as_ref(),
            self.points_out.as_ref(),
            self.rgb_out.as_ref(),
            self.rgb_info_out.as_ref(),
            self.transforms_out.as_ref(),
        ];
        outputs.into_iter().flatten()
    }
}

/// Returns a valid absolute name; a relative one is below the root.
fn whole(name: &str) -> Result<String, BridgeError> {
    let absolute = format!("/{}", name.strip_prefix('/').unwrap_or(name));
    match Name::parse(&absolute) {
        Ok(_) => Ok(absolute),
        Err(_) => Err(BridgeError::Name(name.chars().take(80).collect())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn options(depth: &str, out: &str) -> BridgeOptions {
        BridgeOptions {
            depth: depth.to_owned(),
            info: Some("/camera/camera_info".to_owned()),
            rgb: None,
            out: out.to_owned(),
            sensor: "stereo".to_owned(),
            node: "oaktwin_bridge".to_owned(),
            encoding: Encoding::default(),
            points: true,
            points_step: NonZeroU32::MIN,
            compressed: true,
            frames: None,
            is_reliable: false,
            is_input_reliable: false,
            delivery: Delivery::default(),
        }
    }

    #[test]
    fn topics_are_those_of_the_vendors_driver() {
        for out in ["/oak", "oak", "/oak/"] {
            let topics = options("camera/depth/image_raw", out).topics().unwrap();
            assert_eq!(topics.depth, "/camera/depth/image_raw");
            assert_eq!(topics.image_out, "/oak/stereo/image_raw");
            assert_eq!(topics.info_out, "/oak/stereo/camera_info");
            assert_eq!(topics.points_out.as_deref(), Some("/oak/points"));
            let compressed = "/oak/stereo/image_raw/compressedDepth";
            assert_eq!(topics.compressed_out.as_deref(), Some(compressed));
            assert_eq!((topics.rgb_out, topics.transforms_out), (None, None));
        }
    }

    #[test]
    fn invalid_names_and_loops_are_rejected() {
        for depth in ["", "/", "/a//b", "/a b", "/1a", "/a/"] {
            let error = options(depth, "/oak").topics().unwrap_err().to_string();
            assert!(error.contains("is not a ROS name"), "{depth:?}: {error}");
        }
        let error = options("/oak/stereo/image_raw", "/oak").topics().unwrap_err();
        assert!(
            error.to_string().starts_with("/oak/stereo/image_raw: "),
            "{error}"
        );
    }
}
