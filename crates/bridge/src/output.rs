//! A published topic.

use std::net::SocketAddr;

use ros2_client::Publisher;
use rustdds::QosPolicies;
use serde::Serialize;

use crate::graph::{Endpoint, Graph};
use crate::unicast::UnicastSender;

/// The publisher of a topic and its subscribers.
pub(crate) struct TopicPublisher<M: Serialize> {
    endpoint: Endpoint,
    publisher: Publisher<M>,
    /// The sender of best-effort messages; reliable ones are sent by the DDS library, which repeats what was lost.
    sender: Option<UnicastSender>,
    subscribers: usize,
}

impl<M: Serialize> TopicPublisher<M> {
    pub(crate) fn new(
        topic: &str,
        kind: String,
        qos: QosPolicies,
        publisher: Publisher<M>,
    ) -> std::io::Result<Self> {
        let writer = publisher.guid().to_bytes();
        let sender = match qos.is_reliable() {
            true => None,
            false => Some(UnicastSender::new(writer)?),
        };
        Ok(Self {
            endpoint: Endpoint::new(topic, kind, qos, writer),
            publisher,
            sender,
            subscribers: 0,
        })
    }

    /// What other nodes see of the publisher.
    pub(crate) fn endpoint(&self) -> &Endpoint {
        &self.endpoint
    }

    /// The number of subscribers that receive the messages.
    pub(crate) fn subscribers(&self) -> usize {
        self.subscribers
    }

    /// Finds the subscribers.
    pub(crate) fn find_subscribers(&mut self, graph: &Graph) {
        let readers: Vec<_> = graph.subscribers(&self.endpoint).collect();
        self.subscribers = readers.len();
        if let Some(sender) = &mut self.sender {
            let addresses = readers.iter().map(|reader| {
                let announced = reader.reader_proxy.unicast_locator_list.iter();
                announced
                    .filter(|locator| locator.is_udp())
                    .map(|locator| SocketAddr::from(*locator))
                    .collect()
            });
            sender.set_readers(addresses);
        }
    }

    /// Sends a message to the subscribers.
    pub(crate) fn publish(&mut self, message: M) -> Result<(), String> {
        match &mut self.sender {
            Some(sender) => sender.send(&message),
            None => self.publisher.publish(message).map_err(|error| {
                let error = format!("{error}");
                error.chars().take(200).collect()
            }),
        }
    }
}
