use std::net::Ipv4Addr;

use oaktwin::diagnostic::Message;
use oaktwin::sense::SenseError;

/// An error that ends the bridge.
#[derive(Debug, thiserror::Error)]
pub enum BridgeError {
    /// An environment variable of ROS is invalid.
    #[error("{name}: unsupported value '{value}'; {remedy}")]
    Environment {
        /// The variable.
        name: &'static str,
        /// Its value.
        value: String,
        /// What to do.
        remedy: String,
    },
    /// No interface has the address.
    #[error("{0}: is not an IPv4 address of this machine; choose one that `ip address` lists")]
    Interface(Ipv4Addr),
    /// The name of a topic or namespace is invalid.
    #[error(
        "{0}: is not a ROS name; use letters, digits and underscores between slashes, such as /camera/depth/image_raw"
    )]
    Name(String),
    /// Two topics have the same name.
    #[error("{0}: the bridge would subscribe to what it publishes; choose another name")]
    Loop(String),
    /// A number of the delivery is invalid.
    #[error("{0}")]
    Delivery(Message),
    /// An option of the sensor is invalid.
    #[error(transparent)]
    Sense(#[from] SenseError),
    /// The node cannot be created.
    #[error(
        "the ROS 2 node cannot be created ({0}); check the network, ROS_DOMAIN_ID and that UDP ports from 7400 are free"
    )]
    Node(String),
}
