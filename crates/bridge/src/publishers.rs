//! The published topics.

use oaktwin::diagnostic::{Finding, Level};

use crate::graph::{Endpoint, Graph};
use crate::message::{CameraInfo, CompressedImage, Image, PointCloud2, TfMessage};
use crate::output::TopicPublisher;
use crate::process::{Outgoing, Requests};

/// The publishers.
pub(crate) struct Publishers {
    pub(crate) image: TopicPublisher<Image>,
    pub(crate) info: TopicPublisher<CameraInfo>,
    pub(crate) compressed: Option<TopicPublisher<CompressedImage>>,
    pub(crate) points: Option<TopicPublisher<PointCloud2>>,
    pub(crate) rgb: Option<TopicPublisher<Image>>,
    pub(crate) rgb_info: Option<TopicPublisher<CameraInfo>>,
    pub(crate) transforms: Option<TopicPublisher<TfMessage>>,
}

impl Publishers {
    /// What other nodes see of them.
    pub(crate) fn endpoints(&self) -> Vec<&Endpoint> {
        let optional = [
            self.compressed.as_ref().map(TopicPublisher::endpoint),
            self.points.as_ref().map(TopicPublisher::endpoint),
            self.rgb.as_ref().map(TopicPublisher::endpoint),
            self.rgb_info.as_ref().map(TopicPublisher::endpoint),
            self.transforms.as_ref().map(TopicPublisher::endpoint),
        ];
        let always = [self.image.endpoint(), self.info.endpoint()];
        always.into_iter().chain(optional.into_iter().flatten()).collect()
    }

    /// Finds the subscribers.
    pub(crate) fn find_subscribers(&mut self, graph: &Graph) {
        self.image.find_subscribers(graph);
        self.info.find_subscribers(graph);
        find_optional_subscribers(&mut self.compressed, graph);
        find_optional_subscribers(&mut self.points, graph);
        find_optional_subscribers(&mut self.rgb, graph);
        find_optional_subscribers(&mut self.rgb_info, graph);
        find_optional_subscribers(&mut self.transforms, graph);
    }

    /// The outputs that somebody subscribes to.
    pub(crate) fn requests(&self) -> Requests {
        Requests {
            compressed: has_subscribers(&self.compressed),
            points: has_subscribers(&self.points),
            rgb: has_subscribers(&self.rgb),
        }
    }

    /// Publishes a frame, the depth image last, so that what belongs to it is there when it arrives. What fails is reported, and does
    /// not keep the rest back. Returns whether the depth image was published.
    pub(crate) fn publish(&mut self, outgoing: Outgoing, findings: &mut Vec<Finding>) -> bool {
        let mut send = |sent: Result<(), Finding>| sent.map_err(|failed| findings.push(failed)).is_ok();
        send(publish(&mut self.info, outgoing.info));
        send(publish_optional(&mut self.rgb_info, outgoing.rgb_info));
        send(publish_optional(&mut self.rgb, outgoing.rgb));
        send(publish_optional(&mut self.points, outgoing.points));
        send(publish_optional(&mut self.compressed, outgoing.compressed));
        send(publish(&mut self.image, outgoing.image))
    }

    /// Publishes the frames of the device.
    pub(crate) fn publish_transforms(&mut self, message: TfMessage, findings: &mut Vec<Finding>) {
        findings.extend(publish_optional(&mut self.transforms, Some(message)).err());
    }
}

fn find_optional_subscribers<M: serde::Serialize>(output: &mut Option<TopicPublisher<M>>, graph: &Graph) {
    if let Some(output) = output {
        output.find_subscribers(graph);
    }
}

fn has_subscribers<M: serde::Serialize>(output: &Option<TopicPublisher<M>>) -> bool {
    output.as_ref().is_some_and(|output| output.subscribers() > 0)
}

fn publish_optional<M: serde::Serialize>(
    output: &mut Option<TopicPublisher<M>>,
    message: Option<M>,
) -> Result<(), Finding> {
    match (output, message) {
        (Some(output), Some(message)) => publish(output, message),
        _ => Ok(()),
    }
}

fn publish<M: serde::Serialize>(output: &mut TopicPublisher<M>, message: M) -> Result<(), Finding> {
    output.publish(message).map_err(|error| {
        Finding::new(
            "not-published",
            Level::Error,
            &output.endpoint().topic,
            format!("a message could not be published ({error})"),
            "check the network, and whether the subscribers keep up",
        )
    })
}
