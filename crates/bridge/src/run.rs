use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::Receiver;
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use oaktwin::diagnostic::{Finding, Level};

use crate::delivery::Underway;
use crate::event::{Event, Started, Status};
use crate::filter::DepthFilter;
use crate::graph::{Endpoint, Reports};
use crate::mailbox::{Arrived, Mailbox};
use crate::message::Header;
use crate::node::{IMAGE, RosNode, Wanted, dds_type, lock};
use crate::options::{BridgeOptions, Topics};
use crate::process::{Outgoing, Processor};
use crate::publishers::Publishers;
use crate::receive::receive;
use crate::statistics::Latencies;
use crate::transforms::DeviceFrames;
use crate::watch::{Inputs, Watch};
use crate::{BridgeError, Network, buffers, convert};

/// The time after which the end, new parameters and missing topics are noticed.
const TICK: Duration = Duration::from_millis(50);
/// The time between two looks at the graph.
const LOOK: Duration = Duration::from_millis(500);
/// The time between two reports of the state.
const STATUS: Duration = Duration::from_secs(10);
/// The time before the same finding is reported again.
const REPEAT: Duration = Duration::from_secs(30);
/// The number of kinds of findings whose times are remembered.
const MAX_KINDS: usize = 256;

/// Runs the bridge until `is_over`, and returns its final state, which is also reported. Each of `lines` sets a parameter of
/// the sensor, `NAME=VALUE`.
///
/// # Errors
/// Returns an error if a topic or an option is invalid, or the node cannot be created.
pub fn run(
    filter: DepthFilter,
    options: &BridgeOptions,
    network: &Network,
    lines: &Receiver<String>,
    report: impl FnMut(Event),
    is_over: impl Fn() -> bool,
) -> Result<Status, BridgeError> {
    let topics = options.topics()?;
    options.delivery.check()?;
    let wanted: Wanted = Arc::new(Mutex::new(filter.options().sensor.clone()));
    let mut node = RosNode::new(options, network, &filter, &wanted)?;
    let publishers = node.publish(&topics, options.is_reliable)?;
    let subscriptions = node.subscribe(&topics, options.is_input_reliable)?;
    let mailbox = Mailbox::new(topics.info.is_some(), topics.rgb.is_some());
    let (lost, is_receiver_over) = (AtomicU64::new(0), AtomicBool::new(false));
    let mut reporter = Reporter {
        report,
        last: BTreeMap::new(),
    };
    (reporter.report)(Event::Started(Started {
        node: node.name(),
        domain: network.domain,
        localhost: network.is_local,
        topics: topics.clone(),
    }));
    reporter.findings(buffers::check(buffers::limit(), None));
    let started = Instant::now();
    let mut bridge = Bridge {
        processor: Processor::new(filter, options, topics.clone()),
        publishers,
        inputs: subscriptions.endpoints.clone(),
        reports: Reports::default(),
        node: &node,
        topics: &topics,
        mailbox: &mailbox,
        lost: &lost,
        latencies: Latencies::default(),
        underway: Underway::new(options.delivery),
        status: Status::default(),
        watch: Watch::new(started),
        started,
        frames: options.frames.as_ref(),
        placed: None,
    };
    thread::scope(|scope| {
        let thread = thread::Builder::new().name("receiver".to_owned());
        let receiver = thread
            .spawn_scoped(scope, || {
                receive(subscriptions, &mailbox, &lost, &is_receiver_over)
            })
            .map_err(|error| BridgeError::Node(error.to_string()))?;
        let (mut looked, mut reported) = (started, started);
        while !is_over() && !receiver.is_finished() {
            let arrived = mailbox.take(bridge.underway.wait(Instant::now(), TICK));
            // What was set while a frame was awaited counts for it.
            reporter.findings(lines.try_iter().filter_map(|line| set(&node, &line)));
            bridge.set(&wanted, &mut reporter);
            if let Some(arrived) = arrived {
                bridge.frame(arrived, &mut reporter);
            }
            bridge.deliver(&mut reporter);
            let now = Instant::now();
            if now.duration_since(looked) >= LOOK {
                looked = now;
                bridge.inspect_graph(now, &mut reporter);
            }
            if now.duration_since(reported) >= STATUS {
                reported = now;
                (reporter.report)(Event::Status(bridge.status()));
            }
        }
        let status = bridge.status();
        (reporter.report)(Event::Stopped(status.clone()));
        is_receiver_over.store(true, Ordering::Relaxed);
        match receiver.join() {
            Ok(Ok(())) => Ok(status),
            Ok(Err(error)) => Err(BridgeError::Node(error.to_string())),
            Err(_) => Err(BridgeError::Node("the receiver stopped".to_owned())),
        }
    })
}

/// Sets a parameter, and returns why that failed.
fn set(node: &RosNode, line: &str) -> Option<Finding> {
    let error = node.set(line).err()?;
    Some(Finding::new(
        "parameter",
        Level::Error,
        "standard input",
        error,
        "",
    ))
}

/// Reports findings, each kind at most every [`REPEAT`].
struct Reporter<R> {
    report: R,
    last: BTreeMap<(&'static str, String), Instant>,
}

impl<R: FnMut(Event)> Reporter<R> {
    fn findings(&mut self, findings: impl IntoIterator<Item = Finding>) {
        for finding in findings {
            let now = Instant::now();
            let kind = (finding.code, finding.place.clone());
            // Each change of a parameter has an answer.
            let is_answer = finding.code.starts_with("parameter");
            let is_new = match self.last.get(&kind) {
                _ if is_answer => true,
                Some(last) => now.duration_since(*last) >= REPEAT,
                None => self.last.len() < MAX_KINDS,
            };
            if is_new {
                if !is_answer {
                    self.last.insert(kind, now);
                }
                (self.report)(Event::Finding(finding));
            }
        }
    }
}

struct Bridge<'a> {
    processor: Processor,
    publishers: Publishers,
    inputs: Vec<Endpoint>,
    reports: Reports,
    node: &'a RosNode,
    topics: &'a Topics,
    mailbox: &'a Mailbox,
    lost: &'a AtomicU64,
    latencies: Latencies,
    /// The measured frames that have not been published, with the times at which their depth arrived.
    underway: Underway<(Instant, Outgoing)>,
    status: Status,
    watch: Watch,
    started: Instant,
    /// The frames of the device, and the frame of the images that carries them.
    frames: Option<&'a DeviceFrames>,
    placed: Option<String>,
}

impl Bridge<'_> {
    /// Takes over the parameters that were set on the node.
    fn set(&mut self, wanted: &Wanted, reporter: &mut Reporter<impl FnMut(Event)>) {
        let filter = self.processor.filter();
        let wanted = lock(wanted);
        if wanted == filter.options().sensor {
            return;
        }
        reporter.findings([match filter.set_sensor(wanted) {
            Ok(()) => Finding::new(
                "parameters",
                Level::Note,
                self.node.name(),
                "the sensor has new parameters; the filters are reset",
                "",
            ),
            Err(error) => Finding::new(
                "parameters",
                Level::Error,
                self.node.name(),
                error.to_string(),
                "",
            ),
        }]);
    }

    /// Filters a frame and sends it on its way.
    fn frame(&mut self, arrived: Arrived, reporter: &mut Reporter<impl FnMut(Event)>) {
        let at = arrived.at;
        let mut findings = Vec::new();
        let header = arrived.depth.header.clone();
        let requests = self.publishers.requests();
        match self.processor.frame(arrived, requests, &mut findings) {
            Some(outgoing) => {
                self.place(&header, &mut findings);
                // The stamp of a measured frame is valid.
                let stamp_ns = convert::nanoseconds(header.stamp).unwrap_or_default();
                self.underway.send(stamp_ns, at, (at, outgoing));
            }
            None => self.status.rejected += 1,
        }
        reporter.findings(findings);
    }

    /// Publishes the frames that have arrived.
    fn deliver(&mut self, reporter: &mut Reporter<impl FnMut(Event)>) {
        let mut findings = Vec::new();
        while let Some((at, outgoing)) = self.underway.take(Instant::now()) {
            if self.publishers.publish(outgoing, &mut findings) {
                self.status.published += 1;
                self.latencies.add(at.elapsed());
            } else {
                self.status.rejected += 1;
            }
        }
        reporter.findings(findings);
    }

    /// Publishes the frames of the device, if they are not known to be carried by the frame of the images.
    fn place(&mut self, header: &Header, findings: &mut Vec<Finding>) {
        if let Some(frames) = self.frames
            && self.placed.as_ref() != Some(&header.frame_id)
        {
            let message = frames.message(&header.frame_id, header.stamp);
            self.publishers.publish_transforms(message, findings);
            self.placed = Some(header.frame_id.clone());
        }
    }

    /// Inspects the graph: who publishes, who subscribes, what is missing.
    fn inspect_graph(&mut self, now: Instant, reporter: &mut Reporter<impl FnMut(Event)>) {
        let graph = self.node.graph();
        self.publishers.find_subscribers(&graph);
        let inputs: Vec<_> = self.inputs.iter().collect();
        reporter.findings(self.reports.check(&graph, &self.publishers.endpoints(), &inputs));
        let last_depth = self.mailbox.last();
        let (publishers, images) = match last_depth {
            None => (
                graph.publishers(&self.topics.depth),
                graph.topics(&dds_type(IMAGE)),
            ),
            Some(_) => (1, Vec::new()),
        };
        // The bridge's own output must not be suggested as an input.
        let images: Vec<String> = images
            .into_iter()
            .filter(|name| !self.topics.published().any(|own| own == name))
            .collect();
        let inputs = Inputs {
            topics: self.topics,
            last_depth,
            received: self.mailbox.count().received,
            lost: self.lost.load(Ordering::Relaxed),
            lacking: self.mailbox.lacks(),
            publishers,
            images: &images,
        };
        reporter.findings(self.watch.check(now, &inputs));
    }

    fn status(&self) -> Status {
        let count = self.mailbox.count();
        Status {
            seconds: self.started.elapsed().as_secs_f64(),
            received: count.received,
            dropped: count.dropped,
            lost: self.lost.load(Ordering::Relaxed),
            incomplete: count.incomplete,
            rejected: self.status.rejected + count.undecoded,
            undelivered: self.underway.lost,
            subscribers: self.publishers.image.subscribers() as u64,
            latency_ms: self.latencies.percentiles(),
            ..self.status.clone()
        }
    }
}
