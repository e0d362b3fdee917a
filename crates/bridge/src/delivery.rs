//! The delivery of frames: when what was measured reaches the subscribers, and what is lost on the way.

use std::collections::VecDeque;
use std::fmt::Display;
use std::time::{Duration, Instant};

use oaktwin::catalog::Latency;
use oaktwin::depth::random::{NoiseStage, Numbers, Stream};
use oaktwin::diagnostic::{message, opt};

use crate::BridgeError;

/// The largest number of frames on their way.
const MAX_WAITING: usize = 256;
/// The longest delay, s.
const MAX_DELAY_S: f64 = 60.0;
/// The name of the random stream. Cameras have streams of other names.
const NAME: &str = "delivery";

/// How frames reach the subscribers. Delays count from the arrival of the exact depth, whose stamp, the middle of the exposure, stays.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Delivery {
    /// The shortest and the longest delay, s; one between them is drawn for the run.
    pub latency_s: (f64, f64),
    /// The largest additional delay of a single frame, s, uniformly distributed from 0.
    pub jitter_s: f64,
    /// The probability that a frame is lost.
    pub drop: f64,
    /// The seed of what is drawn.
    pub seed: u64,
}

impl Delivery {
    /// Returns how the frames of a device of the catalog reach their subscribers.
    #[must_use]
    pub fn of(latency: &Latency) -> Self {
        Self {
            latency_s: (1e-3 * latency.ms.0, 1e-3 * latency.ms.1),
            jitter_s: 1e-3 * latency.largest_jitter_ms(),
            ..Self::default()
        }
    }

    /// Reads a latency, `SECONDS` or `LOW,HIGH`.
    ///
    /// # Errors
    /// Returns an error for anything else.
    pub fn parse_latency(text: &str) -> Result<(f64, f64), BridgeError> {
        let numbers: Option<Vec<f64>> = text.split(',').map(|part| part.trim().parse().ok()).collect();
        match numbers.as_deref() {
            Some([latency]) => Ok((*latency, *latency)),
            Some([low, high]) => Ok((*low, *high)),
            _ => Err(invalid(
                "latency",
                text,
                "give seconds, as in 0.05, or LOW,HIGH, as in 0.02,0.06",
            )),
        }
    }

    /// Checks the numbers.
    ///
    /// # Errors
    /// Returns an error for a number out of range.
    pub fn check(&self) -> Result<(), BridgeError> {
        let (low, high) = self.latency_s;
        let bounds = 0.0..=MAX_DELAY_S;
        for (name, value) in [("latency", low), ("latency", high), ("jitter", self.jitter_s)] {
            if !bounds.contains(&value) {
                return Err(invalid(
                    name,
                    value,
                    &format!("give seconds from 0 to {MAX_DELAY_S}"),
                ));
            }
        }
        if low > high {
            return Err(invalid("latency", format!("{low},{high}"), "give LOW,HIGH"));
        }
        match (0.0..1.0).contains(&self.drop) {
            true => Ok(()),
            false => Err(invalid("drop", self.drop, "give a probability from 0 to below 1")),
        }
    }

    /// Whether the frame with a stamp, in nanoseconds, is lost.
    #[must_use]
    pub fn loses(&self, stamp_ns: u64) -> bool {
        self.numbers(stamp_ns, 0).uniform() < self.drop
    }

    fn numbers(&self, frame: u64, purpose: u32) -> Numbers {
        // A plane knows 32 bits of the frame's number.
        let upper = (frame >> 32) as u32;
        let plane = Stream::new(self.seed, NAME).plane(NoiseStage::Delivery, frame, upper ^ purpose);
        Numbers::new(plane)
    }
}

fn invalid(name: &'static str, value: impl Display, remedy: &str) -> BridgeError {
    BridgeError::Delivery(message![
        opt(name),
        format!(" {value}: is out of range; {remedy}")
    ])
}

/// The frames that are on their way.
#[derive(Debug)]
pub(crate) struct Underway<T> {
    delivery: Delivery,
    /// The latency of this run.
    latency: Duration,
    waiting: VecDeque<(Instant, T)>,
    /// The frames that were lost.
    pub(crate) lost: u64,
}

impl<T> Underway<T> {
    pub(crate) fn new(delivery: Delivery) -> Self {
        let (low, high) = delivery.latency_s;
        // No stamp has a time before 1970.
        let drawn = delivery.numbers(u64::MAX, 1 << 31).uniform();
        Self {
            delivery,
            latency: Duration::from_secs_f64(low + drawn * (high - low)),
            waiting: VecDeque::new(),
            lost: 0,
        }
    }

    /// Returns the delay of the frame with a stamp in nanoseconds; `None` if it is lost.
    pub(crate) fn delay(&self, stamp_ns: u64) -> Option<Duration> {
        if self.delivery.loses(stamp_ns) {
            return None;
        }
        let later = self.delivery.numbers(stamp_ns, 1 << 30).uniform();
        Some(self.latency + Duration::from_secs_f64(later * self.delivery.jitter_s))
    }

    /// Sends a frame that arrived at a time on its way. None overtakes another.
    pub(crate) fn send(&mut self, stamp_ns: u64, at: Instant, frame: T) {
        let Some(delay) = self.delay(stamp_ns).filter(|_| self.waiting.len() < MAX_WAITING) else {
            self.lost += 1;
            return;
        };
        let last = self.waiting.back().map_or(at, |(last, _)| *last);
        self.waiting.push_back((last.max(at + delay), frame));
    }

    /// Takes the next frame that has arrived by now.
    pub(crate) fn take(&mut self, now: Instant) -> Option<T> {
        let (due, _) = self.waiting.front()?;
        if *due > now {
            return None;
        }
        self.waiting.pop_front().map(|(_, frame)| frame)
    }

    /// Returns the time until the next frame arrives, at most `longest`.
    pub(crate) fn wait(&self, now: Instant, longest: Duration) -> Duration {
        let due = self
            .waiting
            .front()
            .map(|(due, _)| due.saturating_duration_since(now));
        due.map_or(longest, |due| due.min(longest))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DELIVERY: Delivery = Delivery {
        latency_s: (0.02, 0.06),
        jitter_s: 0.01,
        drop: 0.25,
        seed: 3,
    };

    fn milliseconds(count: u64) -> Duration {
        Duration::from_millis(count)
    }

    #[test]
    fn delays_are_functions_of_seed_and_stamp() {
        let underway = Underway::<()>::new(DELIVERY);
        let stamps: Vec<u64> = (0..4000).map(|number| (1 << 60) + number * 33_333_333).collect();
        let delays: Vec<Option<Duration>> = stamps.iter().map(|stamp| underway.delay(*stamp)).collect();
        // In another order, by another run.
        let again = Underway::<()>::new(DELIVERY);
        for (stamp, delay) in stamps.iter().zip(&delays).rev() {
            assert_eq!(again.delay(*stamp), *delay);
        }
        let lost = delays.iter().filter(|delay| delay.is_none()).count();
        assert!((900..1100).contains(&lost), "{lost}");
        let known: Vec<f64> = delays.iter().flatten().map(Duration::as_secs_f64).collect();
        let (least, most) = known.iter().fold((f64::MAX, 0.0_f64), |(least, most), &s| {
            (least.min(s), most.max(s))
        });
        assert!(
            (0.02..0.06).contains(&least) && most < least + 0.01,
            "{least} {most}"
        );
        assert!(most - least > 0.0098);
        let mean = known.iter().sum::<f64>() / known.len() as f64;
        assert!((mean - least - 0.005).abs() < 3e-4);
        let other = Underway::<()>::new(Delivery { seed: 4, ..DELIVERY });
        assert_ne!(other.latency, underway.latency);
    }

    #[test]
    fn frames_arrive_in_their_order_and_not_before_their_time() {
        let mut underway = Underway::new(Delivery {
            drop: 0.0,
            jitter_s: 0.05,
            ..DELIVERY
        });
        let start = Instant::now();
        for frame in 0..20 {
            underway.send(frame, start + milliseconds(5 * frame), frame);
        }
        let mut taken = Vec::new();
        for now in 0..300 {
            let now = start + milliseconds(now);
            while let Some(frame) = underway.take(now) {
                assert!(now >= start + milliseconds(5 * frame + 20));
                taken.push(frame);
            }
        }
        assert_eq!(taken, (0..20).collect::<Vec<u64>>());
        assert_eq!(underway.wait(start, milliseconds(50)), milliseconds(50));
        let mut even = Underway::new(Delivery {
            latency_s: (0.02, 0.02),
            ..Delivery::default()
        });
        even.send(0, start, 0);
        assert_eq!(even.wait(start, milliseconds(50)), milliseconds(20));
        assert_eq!(even.wait(start, milliseconds(10)), milliseconds(10));
        assert_eq!(
            even.wait(start + milliseconds(30), milliseconds(50)),
            Duration::ZERO
        );
        assert_eq!(underway.lost, 0);
    }

    #[test]
    fn without_delay_frames_arrive_at_once() {
        let mut underway = Underway::new(Delivery::default());
        let now = Instant::now();
        underway.send(7, now, 'a');
        assert_eq!(underway.wait(now, milliseconds(50)), Duration::ZERO);
        assert_eq!((underway.take(now), underway.take(now)), (Some('a'), None));
    }

    #[test]
    fn the_frames_on_their_way_are_bounded() {
        let mut underway = Underway::new(Delivery {
            latency_s: (60.0, 60.0),
            ..Delivery::default()
        });
        let now = Instant::now();
        for frame in 0..300 {
            underway.send(frame, now, frame);
        }
        assert_eq!(
            (underway.waiting.len(), underway.lost),
            (MAX_WAITING, 300 - MAX_WAITING as u64)
        );
    }

    #[test]
    fn numbers_out_of_range_are_errors() {
        assert_eq!(Delivery::parse_latency("0.05").unwrap(), (0.05, 0.05));
        assert_eq!(Delivery::parse_latency("0.02, 0.06").unwrap(), (0.02, 0.06));
        for text in ["", "fast", "1,2,3", "1,"] {
            let error = Delivery::parse_latency(text).unwrap_err().to_string();
            assert!(error.contains("give seconds, as in 0.05, or LOW,HIGH"), "{error}");
        }
        let check = |delivery: Delivery| delivery.check().map_err(|error| error.to_string());
        assert_eq!(check(DELIVERY), Ok(()));
        for (delivery, message) in [
            (
                Delivery {
                    latency_s: (-0.1, 0.1),
                    ..DELIVERY
                },
                "-0.1: is out of range; give seconds from 0 to 60",
            ),
            (
                Delivery {
                    latency_s: (0.1, f64::NAN),
                    ..DELIVERY
                },
                "NaN: is out of range",
            ),
            (
                Delivery {
                    latency_s: (0.2, 0.1),
                    ..DELIVERY
                },
                "0.2,0.1: is out of range; give LOW,HIGH",
            ),
            (
                Delivery {
                    jitter_s: 61.0,
                    ..DELIVERY
                },
                "61: is out of range",
            ),
            (
                Delivery {
                    drop: 1.0,
                    ..DELIVERY
                },
                "1: is out of range; give a probability",
            ),
        ] {
            let error = check(delivery).unwrap_err();
            assert!(error.contains(message), "{error}");
        }
    }
}
