//! One frame: from messages to messages.

use std::num::NonZeroU32;

use oaktwin::camera::{Camera, ImageSize};
use oaktwin::diagnostic::{Finding, Level};

use crate::buffers;
use crate::convert::{self, Encoding, Frames, MessageError};
use crate::filter::{DepthFilter, FilterInput};
use crate::mailbox::Arrived;
use crate::message::{CameraInfo, CompressedImage, Header, Image, PointCloud2};
use crate::options::{BridgeOptions, Topics};

/// The messages of a frame.
pub(crate) struct Outgoing {
    pub(crate) image: Image,
    pub(crate) info: CameraInfo,
    pub(crate) compressed: Option<CompressedImage>,
    pub(crate) points: Option<PointCloud2>,
    pub(crate) rgb: Option<Image>,
    pub(crate) rgb_info: Option<CameraInfo>,
}

/// The outputs that take time to make, and whether anybody subscribes to them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Requests {
    pub(crate) compressed: bool,
    pub(crate) points: bool,
    pub(crate) rgb: bool,
}

/// Filters the frames of a topic.
pub(crate) struct Processor {
    topics: Topics,
    encoding: Encoding,
    points_step: NonZeroU32,
    filter: DepthFilter,
    frames: Frames,
    /// The newest camera info, and what it says.
    info: Option<CameraInfo>,
    camera: Option<Result<Camera, MessageError>>,
    size: Option<ImageSize>,
}

impl Processor {
    pub(crate) fn new(filter: DepthFilter, options: &BridgeOptions, topics: Topics) -> Self {
        Self {
            topics,
            encoding: options.encoding,
            points_step: options.points_step,
            filter,
            frames: Frames::default(),
            info: None,
            camera: None,
            size: None,
        }
    }

    pub(crate) fn filter(&mut self) -> &mut DepthFilter {
        &mut self.filter
    }

    /// Filters a frame, and makes what is requested of it. Returns `None` if the frame cannot be used.
    pub(crate) fn frame(
        &mut self,
        mut arrived: Arrived,
        requests: Requests,
        findings: &mut Vec<Finding>,
    ) -> Option<Outgoing> {
        if let Some(info) = arrived.new_info.take() {
            self.camera = Some(convert::camera(&info));
            self.info = Some(info);
        }
        let header = arrived.depth.header.clone();
        let outgoing = self
            .input(&arrived, findings)
            .and_then(|input| self.measure(input, header, arrived.rgb, requests, findings));
        outgoing.map_err(|error| findings.push(error)).ok()
    }

    /// Converts the messages of a frame.
    fn input(&mut self, arrived: &Arrived, findings: &mut Vec<Finding>) -> Result<FilterInput, Finding> {
        let message = &arrived.depth;
        let depth_topic = self.topics.depth.as_str();
        let info_topic = self.topics.info.as_deref().unwrap_or_default();
        let rgb_topic = self.topics.rgb.as_deref().unwrap_or_default();
        let depth = convert::depth(message).map_err(|error| invalid(depth_topic, error))?;
        let camera = self.camera.clone().transpose();
        let camera = camera.map_err(|error| invalid(info_topic, error))?;
        let size = ImageSize::new(message.width, message.height);
        if let Some(camera) = camera.filter(|camera| camera.intrinsics.size != size) {
            let own = camera.intrinsics.size;
            return Err(Finding::new(
                "camera-info-size",
                Level::Error,
                info_topic,
                format!("describes images of {own}, but the depth image is {size}"),
                "publish the camera info of the depth image",
            ));
        }
        let rgb = arrived.rgb.as_ref().map(convert::color).transpose();
        let rgb = rgb.map_err(|error| invalid(rgb_topic, error))?;
        let stamped = self.frames.next(message.header.stamp);
        let stamped = stamped.map_err(|error| invalid(depth_topic, error))?;
        if stamped.is_repeated {
            findings.push(Finding::new(
                "same-stamp",
                Level::Warning,
                depth_topic,
                "successive images have the same stamp; their noise follows the order of arrival",
                "publish a stamp for each image",
            ));
        }
        if stamped.is_earlier {
            self.filter.reset();
            findings.push(Finding::new(
                "time-went-back",
                Level::Note,
                depth_topic,
                "the stamp is earlier than the previous image's; the filters are reset",
                "",
            ));
        }
        self.note_size(size, message.data.len() as u64, findings);
        Ok(FilterInput {
            depth,
            camera,
            rgb,
            frame: stamped.number,
        })
    }

    /// Measures a frame and converts the result to messages.
    fn measure(
        &mut self,
        input: FilterInput,
        header: Header,
        rgb: Option<Image>,
        requests: Requests,
        findings: &mut Vec<Finding>,
    ) -> Result<Outgoing, Finding> {
        let mut output = self.filter.apply(input).map_err(|error| {
            let (place, what) = (&self.topics.depth, error.to_string());
            Finding::new("not-measured", Level::Error, place, what, "")
        })?;
        findings.append(&mut output.findings);
        let distance = &output.measured.distance;
        let image = convert::depth_message(header.clone(), distance, self.encoding);
        let info = convert::camera_info(header.clone(), &output.camera.camera.intrinsics);
        let compressed = match requests.compressed {
            true => convert::compressed_depth(header.clone(), distance).ok(),
            false => None,
        };
        // Colour images have the same camera and lens as the depth image.
        let rgb_info = rgb.as_ref().map(|rgb| match &self.info {
            Some(info) => CameraInfo {
                header: rgb.header.clone(),
                ..info.clone()
            },
            None => convert::camera_info(rgb.header.clone(), &output.input_camera.intrinsics),
        });
        let points = requests
            .points
            .then(|| output.point_cloud(header, self.points_step));
        Ok(Outgoing {
            image,
            info,
            compressed,
            points,
            rgb: rgb.filter(|_| requests.rgb),
            rgb_info,
        })
    }

    /// Reports the size of the images where it changes.
    fn note_size(&mut self, size: ImageSize, bytes: u64, findings: &mut Vec<Finding>) {
        if let Some(before) = self.size.replace(size) {
            if before != size {
                findings.push(Finding::new(
                    "size-changed",
                    Level::Note,
                    &self.topics.depth,
                    format!("images are {size} instead of {before}; the filters are reset"),
                    "",
                ));
            }
            if before == size {
                return;
            }
        }
        findings.extend(buffers::check(buffers::limit(), Some(bytes)));
    }
}

fn invalid(topic: &str, error: MessageError) -> Finding {
    let what = format!("{}: {}", error.field, error.what);
    Finding::new("invalid-message", Level::Error, topic, what, error.remedy)
}

#[cfg(test)]
mod tests;
