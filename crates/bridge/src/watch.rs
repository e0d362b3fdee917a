//! Reports of what is missing or late.

use std::time::{Duration, Instant};

use oaktwin::diagnostic::{Finding, Level, suggest};

use crate::mailbox::Lacking;
use crate::options::Topics;

/// The time after which a missing topic is reported.
const PATIENCE: Duration = Duration::from_secs(5);
/// The time without images that is reported as silence.
const SILENCE: Duration = Duration::from_secs(2);

/// The state of the inputs.
pub(crate) struct Inputs<'a> {
    pub(crate) topics: &'a Topics,
    /// The time of the last depth image.
    pub(crate) last_depth: Option<Instant>,
    /// The number of depth images.
    pub(crate) received: u64,
    /// The number of depth images that the network lost.
    pub(crate) lost: u64,
    /// What a waiting depth image lacks.
    pub(crate) lacking: Option<Lacking>,
    /// The number of publishers of the depth topic.
    pub(crate) publishers: usize,
    /// The names of the topics with images in the network.
    pub(crate) images: &'a [String],
}

/// What was reported about the inputs.
#[derive(Debug)]
pub(crate) struct Watch {
    started: Instant,
    is_missing: bool,
    is_silent: bool,
    lacking: Option<(Lacking, Instant)>,
    is_lack_reported: bool,
    is_loss_reported: bool,
}

impl Watch {
    pub(crate) fn new(started: Instant) -> Self {
        Self {
            started,
            is_missing: false,
            is_silent: false,
            lacking: None,
            is_lack_reported: false,
            is_loss_reported: false,
        }
    }

    /// Returns what is newly missing, late or back.
    pub(crate) fn check(&mut self, now: Instant, inputs: &Inputs<'_>) -> Vec<Finding> {
        let mut findings = Vec::new();
        match inputs.last_depth {
            None => findings.extend(self.missing(now, inputs)),
            Some(last) => findings.extend(self.silence(now, last, &inputs.topics.depth)),
        }
        findings.extend(self.lack(now, inputs));
        if !self.is_loss_reported && inputs.lost * 100 > inputs.received + inputs.lost && inputs.lost > 30 {
            self.is_loss_reported = true;
            findings.push(Finding::new(
                "lost-images",
                Level::Warning,
                &inputs.topics.depth,
                format!(
                    "{} of {} images arrived incomplete",
                    inputs.lost,
                    inputs.received + inputs.lost
                ),
                "enlarge the receive buffers, publish 16UC1, or smaller images",
            ));
        }
        findings
    }

    fn missing(&mut self, now: Instant, inputs: &Inputs<'_>) -> Option<Finding> {
        if self.is_missing || now.duration_since(self.started) < PATIENCE {
            return None;
        }
        self.is_missing = true;
        let (topic, seconds) = (&inputs.topics.depth, PATIENCE.as_secs());
        Some(if inputs.publishers > 0 {
            Finding::new(
                "no-images",
                Level::Warning,
                topic,
                format!("has a publisher, but no image arrived in {seconds} s"),
                "check that it publishes sensor_msgs/Image, that the simulation runs, and the receive buffers",
            )
        } else {
            let others = inputs.images.iter().map(String::as_str);
            let remedy = match inputs.images.is_empty() {
                true => {
                    "no images are published at all: check ROS_DOMAIN_ID and the middleware (DDS)".to_owned()
                }
                false => suggest(topic, others),
            };
            Finding::new(
                "no-publisher",
                Level::Warning,
                topic,
                format!("has no publisher after {seconds} s"),
                remedy,
            )
        })
    }

    fn silence(&mut self, now: Instant, last: Instant, topic: &str) -> Option<Finding> {
        let is_silent = now.saturating_duration_since(last) >= SILENCE;
        let was_silent = std::mem::replace(&mut self.is_silent, is_silent);
        match (was_silent, is_silent) {
            (false, true) => Some(Finding::new(
                "silence",
                Level::Warning,
                topic,
                format!("no image for {} s", SILENCE.as_secs()),
                "check that the simulation runs",
            )),
            (true, false) => Some(Finding::new(
                "images-again",
                Level::Note,
                topic,
                "images arrive again",
                "",
            )),
            _ => None,
        }
    }

    fn lack(&mut self, now: Instant, inputs: &Inputs<'_>) -> Option<Finding> {
        let Some(lacking) = inputs.lacking else {
            self.lacking = None;
            self.is_lack_reported = false;
            return None;
        };
        let since = match self.lacking {
            Some((before, since)) if before == lacking => since,
            _ => now,
        };
        self.lacking = Some((lacking, since));
        if self.is_lack_reported || now.duration_since(since) < SILENCE {
            return None;
        }
        self.is_lack_reported = true;
        let (code, topic, what) = match lacking {
            Lacking::Info => ("no-camera-info", &inputs.topics.info, "no camera info arrived"),
            Lacking::Rgb => (
                "no-colour-images",
                &inputs.topics.rgb,
                "no colour image of a depth image's stamp arrived",
            ),
        };
        Some(Finding::new(
            code,
            Level::Warning,
            topic.as_deref().unwrap_or_default(),
            format!("{what}; depth images wait"),
            "check the topic's name and publisher",
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn topics() -> Topics {
        Topics {
            depth: "/camera/depth".to_owned(),
            info: Some("/camera/camera_info".to_owned()),
            rgb: None,
            image_out: "/oak/stereo/image_raw".to_owned(),
            info_out: "/oak/stereo/camera_info".to_owned(),
            compressed_out: None,
            points_out: None,
            rgb_out: None,
            rgb_info_out: None,
            transforms_out: None,
        }
    }

    fn inputs<'a>(topics: &'a Topics, images: &'a [String]) -> Inputs<'a> {
        Inputs {
            topics,
            last_depth: None,
            received: 0,
            lost: 0,
            lacking: None,
            publishers: 0,
            images,
        }
    }

    fn texts(findings: &[Finding]) -> Vec<String> {
        findings.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn a_missing_topic_is_reported_once_with_near_names() {
        let (topics, start) = (topics(), Instant::now());
        let mut watch = Watch::new(start);
        let images = ["/camera/dept".to_owned()];
        let at = |seconds| start + Duration::from_secs(seconds);
        assert!(watch.check(at(4), &inputs(&topics, &images)).is_empty());
        let found = texts(&watch.check(at(5), &inputs(&topics, &images)));
        assert_eq!(
            found,
            [
                "warning[no-publisher]: /camera/depth: has no publisher after 5 s; did you mean '/camera/dept'?"
            ]
        );
        assert!(watch.check(at(6), &inputs(&topics, &images)).is_empty());
    }

    #[test]
    fn silence_and_its_end_are_reported() {
        let (topics, start) = (topics(), Instant::now());
        let mut watch = Watch::new(start);
        let mut check = |now: u64, last: u64| {
            let at = |ms| start + Duration::from_millis(ms);
            let state = Inputs {
                last_depth: Some(at(last)),
                ..inputs(&topics, &[])
            };
            let codes = watch
                .check(at(now), &state)
                .into_iter()
                .map(|finding| finding.code);
            codes.collect::<Vec<_>>()
        };
        assert!(check(1000, 900).is_empty());
        assert_eq!(check(2900, 900), ["silence"]);
        assert!(check(3500, 900).is_empty());
        assert_eq!(check(4000, 3990), ["images-again"]);
    }

    #[test]
    fn lost_images_and_missing_camera_info_are_reported() {
        let (topics, start) = (topics(), Instant::now());
        let mut watch = Watch::new(start);
        let mut check = |seconds: u64| {
            let now = start + Duration::from_secs(seconds);
            let state = Inputs {
                last_depth: Some(now),
                received: 60,
                lost: 60,
                lacking: Some(Lacking::Info),
                ..inputs(&topics, &[])
            };
            texts(&watch.check(now, &state))
        };
        let lost = check(0);
        assert!(
            lost[0].contains("/camera/depth: 60 of 120 images arrived incomplete"),
            "{lost:?}"
        );
        let lacking = check(2);
        assert!(
            lacking[0].contains("/camera/camera_info: no camera info arrived"),
            "{lacking:?}"
        );
    }
}
