//! The endpoints of the network, and why some of them are not connected.

use std::collections::BTreeSet;
use std::net::SocketAddr;

use oaktwin::diagnostic::{Finding, Level, Message, message, opt};
use rustdds::discovery::{DiscoveredReaderData, DiscoveredWriterData, ReaderProxy};
use rustdds::policy::{Durability, Reliability};
use rustdds::{DomainParticipant, QosPolicies};

/// The number of reports about others' endpoints that are remembered.
const MAX_REPORTS: usize = 4096;

/// A publisher or a subscription of the bridge.
#[derive(Clone, Debug)]
pub(crate) struct Endpoint {
    /// The topic as in ROS.
    pub(crate) topic: String,
    /// The type of the messages as in DDS.
    kind: String,
    qos: QosPolicies,
    guid: [u8; 16],
}

impl Endpoint {
    pub(crate) fn new(topic: &str, kind: String, qos: QosPolicies, guid: [u8; 16]) -> Self {
        Self {
            topic: topic.to_owned(),
            kind,
            qos,
            guid,
        }
    }

    /// Whether a topic of DDS is the endpoint's.
    fn is_on(&self, topic: &str) -> bool {
        topic.strip_prefix("rt") == Some(self.topic.as_str())
    }

    /// Whether an endpoint belongs to the same node.
    fn is_own(&self, guid: [u8; 16]) -> bool {
        guid[..12] == self.guid[..12]
    }
}

/// All endpoints that discovery has found, at one time.
pub(crate) struct Graph {
    readers: Vec<DiscoveredReaderData>,
    writers: Vec<DiscoveredWriterData>,
}

impl Graph {
    pub(crate) fn new(participant: &DomainParticipant) -> Self {
        Self {
            readers: participant.discovered_readers(),
            writers: participant.discovered_writers(),
        }
    }

    /// The subscribers that a publisher of the bridge reaches.
    pub(crate) fn subscribers(&self, of: &Endpoint) -> impl Iterator<Item = &DiscoveredReaderData> {
        self.readers.iter().filter(|reader| {
            let about = &reader.subscription_topic_data;
            of.is_on(about.topic_name())
                && *about.type_name() == of.kind
                && of.qos.compliance_failure_wrt(&about.qos()).is_none()
        })
    }

    /// The number of publishers of a topic, whatever they send.
    pub(crate) fn publishers(&self, topic: &str) -> usize {
        let names = self
            .writers
            .iter()
            .map(|writer| writer.publication_topic_data.topic_name());
        names
            .filter(|name| name.strip_prefix("rt") == Some(topic))
            .count()
    }

    /// The names of the published topics with messages of a type, sorted.
    pub(crate) fn topics(&self, kind: &str) -> Vec<String> {
        let topics = self.writers.iter().map(|writer| &writer.publication_topic_data);
        let names: BTreeSet<&str> = topics
            .filter(|topic| topic.type_name == kind)
            .filter_map(|topic| topic.topic_name.strip_prefix("rt"))
            .collect();
        names.into_iter().map(str::to_owned).collect()
    }
}

/// What was reported about others' endpoints.
#[derive(Debug, Default)]
pub(crate) struct Reports {
    made: BTreeSet<(&'static str, [u8; 16])>,
}

impl Reports {
    /// Reports, once for each, who does not receive what the bridge publishes, whom the bridge does not hear, and who else publishes to
    /// the same topics.
    pub(crate) fn check(
        &mut self,
        graph: &Graph,
        outputs: &[&Endpoint],
        inputs: &[&Endpoint],
    ) -> Vec<Finding> {
        let mut findings = Vec::new();
        for own in outputs {
            for reader in &graph.readers {
                let about = &reader.subscription_topic_data;
                if own.is_on(about.topic_name()) {
                    let guid = reader.reader_proxy.remote_reader_guid.to_bytes();
                    let found = mismatch(own, about.type_name(), &about.qos(), Side::Subscriber)
                        .or_else(|| multicast(own, &reader.reader_proxy));
                    self.add(guid, found, &mut findings);
                }
            }
            for writer in &graph.writers {
                let guid = writer.writer_proxy.remote_writer_guid.to_bytes();
                // Many nodes publish transforms.
                let is_shared = own.topic == crate::options::TF_STATIC;
                if own.is_on(writer.publication_topic_data.topic_name()) && !own.is_own(guid) && !is_shared {
                    self.add(guid, Some(other_publisher(own)), &mut findings);
                }
            }
        }
        for own in inputs {
            let mut count = 0;
            for writer in &graph.writers {
                let about = &writer.publication_topic_data;
                if own.is_on(about.topic_name()) {
                    count += 1;
                    let guid = writer.writer_proxy.remote_writer_guid.to_bytes();
                    let found = mismatch(own, &about.type_name, &about.qos(), Side::Publisher)
                        .or_else(|| (count > 1).then(|| several_publishers(own)));
                    self.add(guid, found, &mut findings);
                }
            }
        }
        findings
    }

    fn add(&mut self, guid: [u8; 16], found: Option<Finding>, findings: &mut Vec<Finding>) {
        if let Some(found) = found
            && self.made.len() < MAX_REPORTS
            && self.made.insert((found.code, guid))
        {
            findings.push(found);
        }
    }
}

/// What another node has on a topic of the bridge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Publisher,
    Subscriber,
}

/// Reports why another node's endpoint is not connected to the bridge's.
fn mismatch(own: &Endpoint, kind: &str, theirs: &QosPolicies, side: Side) -> Option<Finding> {
    let warning = |code, what: String, remedy: Message| {
        Some(Finding::new(code, Level::Warning, &own.topic, what, remedy))
    };
    if kind != own.kind {
        let (own, kind) = (ros_type(&own.kind), ros_type(kind));
        return match side {
            Side::Subscriber => warning(
                "wrong-type",
                format!("a subscriber expects {kind}, but the bridge publishes {own}: it receives nothing"),
                message!["subscribe to ", own],
            ),
            Side::Publisher => warning(
                "wrong-type",
                format!("a publisher sends {kind}, but the bridge expects {own}: nothing arrives"),
                message!["publish ", own, ", or choose another topic"],
            ),
        };
    }
    let (offered, requested) = match side {
        Side::Subscriber => (&own.qos, theirs),
        Side::Publisher => (theirs, &own.qos),
    };
    offered.compliance_failure_wrt(requested)?;
    let what = settings(offered, requested);
    match side {
        Side::Subscriber => warning(
            "incompatible-qos",
            format!(
                "a subscriber requires {}, but the bridge offers {}: it receives nothing",
                what.requested, what.offered
            ),
            match what.is_reliability {
                true => message![
                    "subscribe best-effort (the profile of sensor data), or start the bridge with ",
                    opt("reliable")
                ],
                false => "subscribe with the profile of sensor data (best-effort, volatile)".into(),
            },
        ),
        Side::Publisher => warning(
            "incompatible-qos",
            format!(
                "a publisher offers {}, but the bridge requires {}: nothing arrives",
                what.offered, what.requested
            ),
            message!["publish reliably, or leave out ", opt("reliable-inputs")],
        ),
    }
}

/// The settings that do not match.
struct Settings {
    offered: String,
    requested: String,
    is_reliability: bool,
}

/// Names the settings of which the requested one is more than the offered one.
fn settings(offered: &QosPolicies, requested: &QosPolicies) -> Settings {
    let is_reliable = |qos: &QosPolicies| matches!(qos.reliability(), Some(Reliability::Reliable { .. }));
    let durability = |qos: &QosPolicies| qos.durability().unwrap_or(Durability::Volatile);
    let (mut offers, mut requests) = (Vec::new(), Vec::new());
    let is_reliability = is_reliable(requested) && !is_reliable(offered);
    if is_reliability {
        offers.push("best-effort delivery".to_owned());
        requests.push("reliable delivery".to_owned());
    }
    if durability(requested) > durability(offered) {
        let name = |qos| match durability(qos) {
            Durability::Volatile => "volatile",
            Durability::TransientLocal => "transient local",
            Durability::Transient => "transient",
            Durability::Persistent => "persistent",
        };
        offers.push(format!("durability {}", name(offered)));
        requests.push(format!("durability {}", name(requested)));
    }
    if requests.is_empty() {
        // ROS sets neither by default.
        offers.push(format!("{:?} and {:?}", offered.deadline(), offered.liveliness()));
        requests.push(format!(
            "{:?} and {:?}",
            requested.deadline(),
            requested.liveliness()
        ));
    }
    Settings {
        offered: offers.join(" and "),
        requested: requests.join(" and "),
        is_reliability,
    }
}

/// Reports a subscriber to which the DDS library sends by multicast. The library prefers the multicast address of a reader to all but a
/// loopback address, and it sends what is reliable; best-effort messages are sent by [`crate::unicast`].
fn multicast(own: &Endpoint, reader: &ReaderProxy) -> Option<Finding> {
    let is_large = own.topic != crate::options::TF_STATIC;
    let is_loopback = |address: SocketAddr| address.ip().is_loopback();
    let is_multicast = |address: SocketAddr| address.ip().is_multicast();
    let has_loopback = (reader.unicast_locator_list.iter()).any(|one| is_loopback((*one).into()));
    let has_multicast = (reader.multicast_locator_list.iter()).any(|one| is_multicast((*one).into()));
    (own.qos.is_reliable() && is_large && has_multicast && !has_loopback).then(|| {
        Finding::new(
            "multicast",
            Level::Warning,
            &own.topic,
            "reliable messages go to a subscriber's multicast address: every machine in the network receives them",
            message![
                "leave out ",
                opt("reliable"),
                ", or let the subscriber announce no multicast address (Cyclone DDS: AllowMulticast spdp)"
            ],
        )
    })
}

fn other_publisher(own: &Endpoint) -> Finding {
    Finding::new(
        "other-publisher",
        Level::Warning,
        &own.topic,
        "another node publishes to this topic, too: subscribers receive the messages of both",
        message![
            "stop the other node, or choose another namespace with ",
            opt("out"),
            "; a node that crashed counts until its lease ends"
        ],
    )
}

fn several_publishers(own: &Endpoint) -> Finding {
    Finding::new(
        "several-publishers",
        Level::Warning,
        &own.topic,
        "several nodes publish to this topic: the bridge takes their messages for one stream",
        "stop all but one; a node that crashed counts until its lease ends",
    )
}

/// Returns the name of a type as in ROS: `sensor_msgs/Image` for `sensor_msgs::msg::dds_::Image_`.
fn ros_type(dds: &str) -> String {
    match (dds.split_once("::"), dds.rsplit_once("::")) {
        (Some((package, _)), Some((_, name))) => format!("{package}/{}", name.trim_end_matches('_')),
        _ => dds.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rustdds::{Duration, QosPolicyBuilder};

    fn qos(is_reliable: bool, durability: Durability) -> QosPolicies {
        let reliability = match is_reliable {
            true => Reliability::Reliable {
                max_blocking_time: Duration::ZERO,
            },
            false => Reliability::BestEffort,
        };
        QosPolicyBuilder::new()
            .reliability(reliability)
            .durability(durability)
            .build()
    }

    const IMAGE: &str = "sensor_msgs::msg::dds_::Image_";

    fn text(own: QosPolicies, theirs: &QosPolicies, kind: &str, side: Side) -> Option<String> {
        let own = Endpoint::new("/oak/stereo/image_raw", IMAGE.to_owned(), own, [0; 16]);
        mismatch(&own, kind, theirs, side).map(|finding| finding.to_string())
    }

    #[test]
    fn incompatible_settings_are_named_with_a_remedy() {
        let (volatile, late) = (Durability::Volatile, Durability::TransientLocal);
        let found = text(
            qos(false, volatile),
            &qos(true, volatile),
            IMAGE,
            Side::Subscriber,
        );
        assert_eq!(
            found.unwrap(),
            "warning[incompatible-qos]: /oak/stereo/image_raw: a subscriber requires reliable delivery, but the bridge offers \
             best-effort delivery: it receives nothing; subscribe best-effort (the profile of sensor data), or start the bridge \
             with 'reliable'"
        );
        let found = text(qos(false, volatile), &qos(true, late), IMAGE, Side::Subscriber);
        let both = "reliable delivery and durability transient local";
        assert!(found.unwrap().contains(both));
        let found = text(qos(true, volatile), &qos(false, volatile), IMAGE, Side::Publisher);
        assert_eq!(
            found.unwrap(),
            "warning[incompatible-qos]: /oak/stereo/image_raw: a publisher offers best-effort delivery, but the bridge requires \
             reliable delivery: nothing arrives; publish reliably, or leave out 'reliable-inputs'"
        );
    }

    #[test]
    fn compatible_endpoints_are_not_reported() {
        let volatile = Durability::Volatile;
        for (own, theirs, side) in [
            (false, false, Side::Subscriber),
            (true, false, Side::Subscriber),
            (true, true, Side::Subscriber),
            (false, true, Side::Publisher),
            (false, false, Side::Publisher),
        ] {
            let found = text(qos(own, volatile), &qos(theirs, volatile), IMAGE, side);
            assert_eq!(found, None, "{own} {theirs} {side:?}");
        }
    }

    #[test]
    fn reliable_messages_to_a_multicast_address_are_reported() {
        let address = |ip: [u8; 4]| SocketAddr::from((ip, 7411)).into();
        let reader = |unicast: [u8; 4]| {
            let guid = rustdds::GUID::from_bytes([7; 16]);
            ReaderProxy::new(
                guid,
                false,
                vec![address(unicast)],
                vec![address([239, 255, 0, 1])],
            )
        };
        let own = |topic, is_reliable| {
            let qos = qos(is_reliable, Durability::Volatile);
            Endpoint::new(topic, IMAGE.to_owned(), qos, [0; 16])
        };
        let (lan, loopback) = (reader([192, 168, 1, 20]), reader([127, 0, 0, 1]));
        let found = multicast(&own("/oak/points", true), &lan).unwrap();
        assert_eq!((found.code, found.place.as_str()), ("multicast", "/oak/points"));
        assert_eq!(multicast(&own("/oak/points", true), &loopback), None);
        assert_eq!(multicast(&own("/oak/points", false), &lan), None);
        assert_eq!(multicast(&own("/tf_static", true), &lan), None);
    }

    #[test]
    fn wrong_types_are_named_as_in_ros() {
        let plain = qos(false, Durability::Volatile);
        let kind = "sensor_msgs::msg::dds_::CompressedImage_";
        let found = text(plain.clone(), &plain, kind, Side::Subscriber).unwrap();
        assert!(found.starts_with("warning[wrong-type]"), "{found}");
        assert!(
            found.contains("expects sensor_msgs/CompressedImage, but the bridge publishes sensor_msgs/Image"),
            "{found}"
        );
    }
}
