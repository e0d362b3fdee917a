//! A bridge and another node in one process, over the loopback interface.

#![allow(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use std::net::Ipv4Addr;
use std::num::NonZeroU32;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver};
use std::thread;
use std::time::{Duration, Instant};

use oaktwin::catalog::Catalog;
use oaktwin::image::png;
use oaktwin::robot::{Attachment, Description};
use oaktwin::sense::SenseOptions;
use oaktwin_bridge::convert::{Encoding, nanoseconds};
use oaktwin_bridge::message::{CameraInfo, CompressedImage, Header, Image, PointCloud2, TfMessage, Time};
use oaktwin_bridge::{BridgeOptions, Delivery, DepthFilter, DeviceFrames, Event, Network, run};
use ros2_client::{Context, MessageTypeName, Node, NodeName, NodeOptions, Publisher, Subscription};
use rustdds::policy::{Durability, History, Reliability};
use rustdds::{DomainParticipant, DomainParticipantBuilder, QosPolicies, QosPolicyBuilder, Topic, TopicKind};

/// The time in which everything happens, however busy the machine is.
const PATIENCE: Duration = Duration::from_secs(120);
const WIDTH: u32 = 64;
const HEIGHT: u32 = 40;

fn qos(is_reliable: bool, durability: Durability) -> QosPolicies {
    let reliability = match is_reliable {
        true => Reliability::Reliable {
            max_blocking_time: rustdds::Duration::ZERO,
        },
        false => Reliability::BestEffort,
    };
    QosPolicyBuilder::new()
        .reliability(reliability)
        .durability(durability)
        .history(History::KeepLast { depth: 1 })
        .build()
}

/// A node that publishes depth images and listens to the bridge.
struct Peer {
    participant: DomainParticipant,
    node: Node,
    stamp: i32,
}

impl Peer {
    fn new(domain: u16) -> Self {
        let participant = DomainParticipantBuilder::new(domain)
            .with_only_networks([Ipv4Addr::LOCALHOST])
            .build()
            .unwrap();
        let context = Context::from_domain_participant(participant.clone()).unwrap();
        let name = NodeName::new("/", "peer").unwrap();
        let options = NodeOptions::new().enable_rosout(false);
        Self {
            participant,
            node: context.new_node(name, options).unwrap(),
            stamp: 0,
        }
    }

    fn topic(&self, topic: &str, (package, message): (&str, &str), qos: &QosPolicies) -> Topic {
        let kind = MessageTypeName::new(package, message).dds_msg_type();
        let topic = self
            .participant
            .create_topic(format!("rt{topic}"), kind, qos, TopicKind::NoKey);
        topic.unwrap()
    }

    fn subscription<M: 'static>(
        &mut self,
        topic: &str,
        message: (&str, &str),
        qos: &QosPolicies,
    ) -> Subscription<M> {
        let topic = self.topic(topic, message, qos);
        self.node.create_subscription(&topic, None).unwrap()
    }

    /// The next image: a plane that recedes to the right.
    fn depth(&mut self) -> Image {
        self.stamp += 1;
        let metres = (0..HEIGHT).flat_map(|_| (0..WIDTH).map(|x| 1.0 + 0.02 * x as f32));
        Image {
            header: Header {
                stamp: Time {
                    sec: self.stamp,
                    nanosec: 0,
                },
                frame_id: "sim_depth_optical".to_owned(),
            },
            height: HEIGHT,
            width: WIDTH,
            encoding: "32FC1".to_owned(),
            is_bigendian: 0,
            step: 4 * WIDTH,
            data: metres.flat_map(f32::to_le_bytes).collect(),
        }
    }
}

const IMAGE: (&str, &str) = ("sensor_msgs", "Image");
const CAMERA_INFO: (&str, &str) = ("sensor_msgs", "CameraInfo");
const COMPRESSED: (&str, &str) = ("sensor_msgs", "CompressedImage");
const POINTS: (&str, &str) = ("sensor_msgs", "PointCloud2");
const TRANSFORMS: (&str, &str) = ("tf2_msgs", "TFMessage");

fn filter() -> (DepthFilter, DeviceFrames) {
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(catalog.device("OAK-D Pro PoE").unwrap());
    let description = Description::new(catalog, &twin, &Attachment::default()).unwrap();
    let frames = DeviceFrames {
        device: description.name.clone(),
        frames: description.frames(),
        body_from_depth: description.depth_sensors[0].camera.body_from_optical,
    };
    (DepthFilter::new(twin, SenseOptions::default()).unwrap(), frames)
}

fn options(frames: DeviceFrames) -> BridgeOptions {
    BridgeOptions {
        depth: "/camera/depth".to_owned(),
        info: None,
        rgb: None,
        out: "/oak".to_owned(),
        sensor: "stereo".to_owned(),
        node: "bridge".to_owned(),
        encoding: Encoding::Millimetres,
        points: true,
        points_step: NonZeroU32::new(2).unwrap(),
        compressed: true,
        frames: Some(frames),
        is_reliable: false,
        is_input_reliable: false,
        delivery: Delivery::default(),
    }
}

/// Tests that run at the same time have domains of their own.
fn network(number: u32) -> Network {
    Network {
        domain: u16::try_from(1 + (7 * std::process::id() + number) % 220).unwrap(),
        is_local: true,
        interface: None,
    }
}

/// Ends a bridge, also if the test fails.
struct End<'a>(&'a AtomicBool);

impl Drop for End<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// Runs a bridge while `test` publishes, listens and reads the events.
fn with_bridge(
    options: &BridgeOptions,
    filter: DepthFilter,
    network: &Network,
    test: impl FnOnce(&Receiver<Event>),
) {
    let (sender, events) = mpsc::channel();
    let is_over = AtomicBool::new(false);
    thread::scope(|scope| {
        let is_over = &is_over;
        let bridge = scope.spawn(move || {
            let (_lines, no_lines) = mpsc::channel();
            let report = |event| {
                // The test may have ended.
                let _ = sender.send(event);
            };
            run(filter, options, network, &no_lines, report, || {
                is_over.load(Ordering::Relaxed)
            })
        });
        let end = End(is_over);
        test(&events);
        drop(end);
        bridge.join().unwrap().unwrap();
    });
}

/// Repeats a step until it returns `true`.
fn until(what: &str, mut step: impl FnMut() -> bool) {
    let start = Instant::now();
    while !step() {
        assert!(start.elapsed() < PATIENCE, "{what}");
        thread::sleep(Duration::from_millis(20));
    }
}

/// Takes a message, unless one was taken before.
fn take<M: serde::de::DeserializeOwned + 'static>(taken: &mut Option<M>, from: &Subscription<M>) -> bool {
    let message = from.take().unwrap().map(|(message, _)| message);
    *taken = taken.take().or(message);
    taken.is_some()
}

fn findings(events: &Receiver<Event>) -> impl Iterator<Item = String> {
    events.try_iter().filter_map(|event| match event {
        Event::Finding(finding) => Some(finding.to_string()),
        _ => None,
    })
}

#[test]
fn everything_is_published_and_what_does_not_match_is_reported() {
    let network = network(0);
    let (filter, frames) = filter();
    with_bridge(&options(frames), filter, &network, |events| {
        let mut peer = Peer::new(network.domain);
        let plain = qos(false, Durability::Volatile);
        let reliable = qos(true, Durability::Volatile);
        let latched = qos(true, Durability::TransientLocal);
        let topic = peer.topic("/camera/depth", IMAGE, &plain);
        let images: Publisher<Image> = peer.node.create_publisher(&topic, None).unwrap();
        let topic = peer.topic("/oak/points", POINTS, &plain);
        let _rival: Publisher<PointCloud2> = peer.node.create_publisher(&topic, None).unwrap();
        let name = "/oak/stereo/image_raw/compressedDepth";
        let from_compressed = peer.subscription::<CompressedImage>(name, COMPRESSED, &plain);
        let from_image = peer.subscription::<Image>("/oak/stereo/image_raw", IMAGE, &plain);
        let from_points = peer.subscription::<PointCloud2>("/oak/points", POINTS, &plain);
        let from_transforms = peer.subscription::<TfMessage>("/tf_static", TRANSFORMS, &latched);
        let name = "/oak/stereo/camera_info";
        let _reliable = peer.subscription::<CameraInfo>(name, CAMERA_INFO, &reliable);

        let (mut image, mut compressed, mut points, mut transforms) = (None, None, None, None);
        let mut reported: Vec<String> = Vec::new();
        until("messages and findings", || {
            images.publish(peer.depth()).unwrap();
            reported.extend(findings(events));
            let has = |code: &str| reported.iter().any(|text| text.contains(code));
            let is_whole = [
                take(&mut image, &from_image),
                take(&mut compressed, &from_compressed),
                take(&mut points, &from_points),
                take(&mut transforms, &from_transforms),
                has("[incompatible-qos]: /oak/stereo/camera_info: a subscriber requires reliable delivery"),
                has("[other-publisher]: /oak/points: another node publishes"),
            ];
            is_whole == [true; 6]
        });
        let image = image.unwrap();
        assert_eq!((image.width, image.height), (WIDTH, HEIGHT));
        assert_eq!(image.header.frame_id, "sim_depth_optical");
        assert!(image.data.iter().any(|byte| *byte > 0));
        let decoded: oaktwin::image::Image<u16> = png::decode(&compressed.unwrap().data[12..]).unwrap();
        assert_eq!((decoded.width(), decoded.height()), (WIDTH, HEIGHT));
        let points = points.unwrap();
        assert_eq!((points.width, points.height), (WIDTH / 2, HEIGHT / 2));
        let root = &transforms.unwrap().transforms[0];
        assert_eq!(root.header.frame_id, "sim_depth_optical");
        assert_eq!(root.child_frame_id, "oak");
    });
}

#[test]
fn reliable_delivery_is_offered_and_required_on_request() {
    let network = network(1);
    let (filter, frames) = filter();
    let options = BridgeOptions {
        is_reliable: true,
        is_input_reliable: true,
        ..options(frames)
    };
    with_bridge(&options, filter, &network, |events| {
        let mut peer = Peer::new(network.domain);
        let plain = qos(false, Durability::Volatile);
        let reliable = qos(true, Durability::Volatile);
        let topic = peer.topic("/camera/depth", IMAGE, &plain);
        let best_effort: Publisher<Image> = peer.node.create_publisher(&topic, None).unwrap();
        let measured = peer.subscription::<Image>("/oak/stereo/image_raw", IMAGE, &reliable);
        let mut reported: Vec<String> = Vec::new();
        until("a finding about the publisher", || {
            best_effort.publish(peer.depth()).unwrap();
            reported.extend(findings(events));
            let expected = "[incompatible-qos]: /camera/depth: a publisher offers best-effort delivery";
            reported.iter().any(|text| text.contains(expected))
        });
        assert!(measured.take().unwrap().is_none());
        let topic = peer.topic("/camera/depth", IMAGE, &reliable);
        let images: Publisher<Image> = peer.node.create_publisher(&topic, None).unwrap();
        until("an image", || {
            // An image may be refused while the one before it is on its way.
            let _ = images.publish(peer.depth());
            measured.take().unwrap().is_some()
        });
    });
}

#[test]
fn late_frames_keep_their_stamps_and_the_same_ones_are_lost() {
    let network = network(2);
    let (filter, frames) = filter();
    let options = BridgeOptions {
        delivery: Delivery {
            latency_s: (0.01, 0.05),
            jitter_s: 0.01,
            drop: 0.5,
            seed: 8,
        },
        ..options(frames)
    };
    let loses = |stamp| options.delivery.loses(nanoseconds(stamp).unwrap());
    with_bridge(&options, filter, &network, |_| {
        let mut peer = Peer::new(network.domain);
        let plain = qos(false, Durability::Volatile);
        let topic = peer.topic("/camera/depth", IMAGE, &plain);
        let images: Publisher<Image> = peer.node.create_publisher(&topic, None).unwrap();
        let measured = peer.subscription::<Image>("/oak/stereo/image_raw", IMAGE, &plain);
        let (mut sent, mut seen) = (Vec::new(), Vec::new());
        until("five images", || {
            let image = peer.depth();
            sent.push(image.header.stamp);
            let _ = images.publish(image);
            while let Some((message, _)) = measured.take().unwrap() {
                seen.push(message.header.stamp);
            }
            seen.len() >= 5
        });
        assert!(
            seen.iter().all(|stamp| sent.contains(stamp) && !loses(*stamp)),
            "{seen:?}"
        );
        let first = sent.iter().position(|stamp| *stamp == seen[0]).unwrap();
        assert!(sent[first..].iter().any(|stamp| loses(*stamp)), "{sent:?}");
        assert!(seen.windows(2).all(|pair| pair[0].sec < pair[1].sec), "{seen:?}");
    });
}
