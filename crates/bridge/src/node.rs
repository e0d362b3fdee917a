//! The node with its topics.

use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};

use oaktwin::sense::SenseOptions;
use oaktwin::sensor::SensorOptions;
use ros2_client::{Context, MessageTypeName, Node, NodeName, NodeOptions, Subscription};
use rustdds::policy::{Durability, History, Reliability, ResourceLimits};
use rustdds::{DomainParticipantBuilder, Duration, QosPolicies, QosPolicyBuilder, Topic, TopicKind};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::filter::{DepthFilter, check};
use crate::graph::{Endpoint, Graph};
use crate::message::{CameraInfo, Image};
use crate::options::{BridgeOptions, Topics};
use crate::output::TopicPublisher;
use crate::publishers::Publishers;
use crate::{BridgeError, Network, buffers, parameters};

/// The options of the sensor that were last set on the node.
pub(crate) type Wanted = Arc<Mutex<SensorOptions>>;

/// The subscriptions.
pub(crate) struct Subscriptions {
    pub(crate) depth: Subscription<Image>,
    pub(crate) info: Option<Subscription<CameraInfo>>,
    pub(crate) rgb: Option<Subscription<Image>>,
    /// What other nodes see of them.
    pub(crate) endpoints: Vec<Endpoint>,
}

/// A node and the thread that answers its services.
pub(crate) struct RosNode {
    node: Node,
    context: Context,
    spinner: Option<JoinHandle<()>>,
}

impl RosNode {
    /// Creates a node whose parameters are the options of the filter's sensor.
    pub(crate) fn new(
        options: &BridgeOptions,
        network: &Network,
        filter: &DepthFilter,
        wanted: &Wanted,
    ) -> Result<Self, BridgeError> {
        let mut participant = DomainParticipantBuilder::new(network.domain)
            .socket_receive_buffer_size(buffers::WANTED_BYTES)
            .socket_send_buffer_size(buffers::WANTED_BYTES);
        if let Some(addresses) = network.only() {
            participant = participant.with_only_networks(addresses);
        }
        let participant = participant.build().map_err(|error| failed(&error))?;
        let context = Context::from_domain_participant(participant).map_err(|error| failed(&error))?;
        let name = NodeName::new("/", &options.node).map_err(|_| BridgeError::Name(options.node.clone()))?;
        let node_options = node_options(filter, wanted);
        let mut node = context
            .new_node(name, node_options)
            .map_err(|error| failed(&error))?;
        let spinner = node.spinner().map_err(|error| failed(&error))?;
        let thread = thread::Builder::new().name("spinner".to_owned());
        let spinner = thread
            .spawn(move || {
                // It ends when the node stops it.
                let _ = futures_executor::block_on(spinner.spin());
            })
            .map_err(|error| failed(&error))?;
        Ok(Self {
            node,
            context,
            spinner: Some(spinner),
        })
    }

    /// The name of the node, which is in no namespace.
    pub(crate) fn name(&self) -> String {
        self.node.fully_qualified_name()
    }

    /// Subscribes to the inputs. A best-effort subscription matches every publisher.
    pub(crate) fn subscribe(
        &mut self,
        topics: &Topics,
        is_reliable: bool,
    ) -> Result<Subscriptions, BridgeError> {
        let qos = sensor_data(is_reliable);
        let mut endpoints = Vec::new();
        Ok(Subscriptions {
            depth: self.subscription(&topics.depth, IMAGE, &qos, &mut endpoints)?,
            info: match &topics.info {
                Some(topic) => Some(self.subscription(topic, CAMERA_INFO, &qos, &mut endpoints)?),
                None => None,
            },
            rgb: match &topics.rgb {
                Some(topic) => Some(self.subscription(topic, IMAGE, &qos, &mut endpoints)?),
                None => None,
            },
            endpoints,
        })
    }

    /// Creates the publishers of the outputs.
    pub(crate) fn publish(&mut self, topics: &Topics, is_reliable: bool) -> Result<Publishers, BridgeError> {
        let qos = sensor_data(is_reliable);
        let (info, compressed) = (&topics.rgb_info_out, &topics.compressed_out);
        Ok(Publishers {
            image: self.publisher(&topics.image_out, IMAGE, &qos)?,
            info: self.publisher(&topics.info_out, CAMERA_INFO, &qos)?,
            compressed: self.optional_publisher(compressed.as_ref(), COMPRESSED_IMAGE, &qos)?,
            points: self.optional_publisher(topics.points_out.as_ref(), POINT_CLOUD, &qos)?,
            rgb: self.optional_publisher(topics.rgb_out.as_ref(), IMAGE, &qos)?,
            rgb_info: self.optional_publisher(info.as_ref(), CAMERA_INFO, &qos)?,
            transforms: self.optional_publisher(topics.transforms_out.as_ref(), TF_MESSAGE, &latched())?,
        })
    }

    fn subscription<M: DeserializeOwned + 'static>(
        &mut self,
        name: &str,
        message: RosType,
        qos: &QosPolicies,
        endpoints: &mut Vec<Endpoint>,
    ) -> Result<Subscription<M>, BridgeError> {
        let topic = self.topic(name, message, qos)?;
        let subscription = self.node.create_subscription(&topic, None);
        let subscription = subscription.map_err(|error| failed(&error))?;
        let (kind, guid) = (dds_type(message), subscription.guid().to_bytes());
        endpoints.push(Endpoint::new(name, kind, qos.clone(), guid));
        Ok(subscription)
    }

    fn publisher<M: Serialize>(
        &mut self,
        name: &str,
        message: RosType,
        qos: &QosPolicies,
    ) -> Result<TopicPublisher<M>, BridgeError> {
        let topic = self.topic(name, message, qos)?;
        let publisher = self.node.create_publisher(&topic, None);
        let publisher = publisher.map_err(|error| failed(&error))?;
        let output = TopicPublisher::new(name, dds_type(message), qos.clone(), publisher);
        output.map_err(|error| failed(&error))
    }

    fn optional_publisher<M: Serialize>(
        &mut self,
        name: Option<&String>,
        message: RosType,
        qos: &QosPolicies,
    ) -> Result<Option<TopicPublisher<M>>, BridgeError> {
        name.map(|name| self.publisher(name, message, qos)).transpose()
    }

    fn topic(&self, topic: &str, message: RosType, qos: &QosPolicies) -> Result<Topic, BridgeError> {
        // The topics of the node have no limit of samples.
        let participant = self.context.domain_participant();
        let kind = dds_type(message);
        let topic = participant.create_topic(format!("rt{topic}"), kind, qos, TopicKind::NoKey);
        topic.map_err(|error| failed(&error))
    }

    /// Sets a parameter, as its service does.
    pub(crate) fn set(&self, line: &str) -> Result<(), String> {
        let (name, value) = parameters::parse(line)?;
        self.node.set_parameter(name, value)
    }

    /// The endpoints of the network.
    pub(crate) fn graph(&self) -> Graph {
        Graph::new(&self.context.domain_participant())
    }
}

impl Drop for RosNode {
    fn drop(&mut self) {
        self.node.stop_spinner();
        if let Some(spinner) = self.spinner.take() {
            let _ = spinner.join();
        }
    }
}

/// The number of messages of a topic that the DDS library keeps.
const MAX_SAMPLES: i32 = 4;

/// Returns the profile of sensors: only the newest image, because late images are of no use, and few in memory.
fn sensor_data(is_reliable: bool) -> QosPolicies {
    let reliability = match is_reliable {
        true => Reliability::Reliable {
            max_blocking_time: Duration::ZERO,
        },
        false => Reliability::BestEffort,
    };
    QosPolicyBuilder::new()
        .reliability(reliability)
        .durability(Durability::Volatile)
        .history(History::KeepLast { depth: 1 })
        .resource_limits(ResourceLimits {
            max_samples: MAX_SAMPLES,
            max_instances: 1,
            max_samples_per_instance: MAX_SAMPLES,
        })
        .build()
}

/// Returns the profile of transforms that do not change: a late subscriber receives them, too.
fn latched() -> QosPolicies {
    QosPolicyBuilder::new()
        .reliability(Reliability::Reliable {
            max_blocking_time: Duration::ZERO,
        })
        .durability(Durability::TransientLocal)
        .history(History::KeepLast { depth: 1 })
        .build()
}

/// The package and the name of a message.
pub(crate) type RosType = (&'static str, &'static str);

pub(crate) const IMAGE: RosType = ("sensor_msgs", "Image");
const CAMERA_INFO: RosType = ("sensor_msgs", "CameraInfo");
const COMPRESSED_IMAGE: RosType = ("sensor_msgs", "CompressedImage");
const POINT_CLOUD: RosType = ("sensor_msgs", "PointCloud2");
const TF_MESSAGE: RosType = ("tf2_msgs", "TFMessage");

/// Returns the name of a message in DDS.
pub(crate) fn dds_type((package, name): RosType) -> String {
    MessageTypeName::new(package, name).dds_msg_type()
}

/// Declares the sensor's options as parameters. A value is checked before it is set.
fn node_options(filter: &DepthFilter, wanted: &Wanted) -> NodeOptions {
    let mut node = NodeOptions::new().enable_rosout(false);
    for option in parameters::offered() {
        node = node.declare_parameter(option.name, parameters::value(option, &filter.options().sensor));
    }
    let (twin, options) = (filter.twin().clone(), filter.options().clone());
    let current = Arc::clone(wanted);
    let validate = move |name: &str, value: &ros2_client::ParameterValue| {
        let before = lock(&current);
        let Some(new) = parameters::with(&before, name, value) else {
            return Ok(());
        };
        let new = SenseOptions {
            sensor: new?,
            ..options.clone()
        };
        check(&twin, &new).map_err(|error| error.to_string())
    };
    let current = Arc::clone(wanted);
    let set = move |name: &str, value: &ros2_client::ParameterValue| {
        let before = lock(&current);
        if let Some(new) = parameters::with(&before, name, value) {
            *current.lock().unwrap_or_else(PoisonError::into_inner) = new?;
        }
        Ok(())
    };
    node.parameter_validator(Box::new(validate))
        .parameter_set_action(Box::new(set))
}

/// Returns the options that were last set.
pub(crate) fn lock(wanted: &Wanted) -> SensorOptions {
    wanted.lock().unwrap_or_else(PoisonError::into_inner).clone()
}

fn failed(error: &impl std::fmt::Debug) -> BridgeError {
    BridgeError::Node(format!("{error:?}"))
}
