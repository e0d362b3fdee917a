//! The queue between the network and the filter: one frame, of which the newest replaces the one that waits.

use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use crate::message::{CameraInfo, Image, Time};

/// A depth image with what belongs to it.
#[derive(Debug)]
pub(crate) struct Arrived {
    /// The depth image.
    pub(crate) depth: Image,
    /// The colour image of the same stamp.
    pub(crate) rgb: Option<Image>,
    /// The newest camera info, if it changed since the last frame.
    pub(crate) new_info: Option<CameraInfo>,
    /// The time at which the depth image arrived.
    pub(crate) at: Instant,
}

/// What happened in a mailbox since it was created.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct MailCount {
    /// The depth images that arrived.
    pub(crate) received: u64,
    /// The depth images that a newer one replaced before they were filtered.
    pub(crate) dropped: u64,
    /// The dropped images for which no colour image or camera info had arrived.
    pub(crate) incomplete: u64,
    /// The messages that could not be decoded.
    pub(crate) undecoded: u64,
}

#[derive(Debug, Default)]
struct Slots {
    depth: Option<(Image, Instant)>,
    rgb: Option<Image>,
    info: Option<CameraInfo>,
    is_info_new: bool,
    count: MailCount,
    last: Option<Instant>,
}

/// A queue of one frame.
#[derive(Debug)]
pub(crate) struct Mailbox {
    slots: Mutex<Slots>,
    changed: Condvar,
    needs_info: bool,
    needs_rgb: bool,
}

impl Mailbox {
    /// Creates an empty mailbox. A frame is complete with the newest camera info and the colour image of the same stamp, if it
    /// needs them.
    pub(crate) fn new(needs_info: bool, needs_rgb: bool) -> Self {
        Self {
            slots: Mutex::default(),
            changed: Condvar::new(),
            needs_info,
            needs_rgb,
        }
    }

    fn slots(&self) -> MutexGuard<'_, Slots> {
        self.slots.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Puts a depth image into the mailbox, in place of one that waits.
    pub(crate) fn put_depth(&self, depth: Image) {
        let mut slots = self.slots();
        let now = Instant::now();
        slots.count.received += 1;
        slots.last = Some(now);
        if slots.depth.replace((depth, now)).is_some() {
            slots.count.dropped += 1;
            if self.needs_info && slots.info.is_none() || self.needs_rgb {
                slots.count.incomplete += 1;
            }
        }
        drop(slots);
        self.changed.notify_one();
    }

    /// Puts a colour image into the mailbox, in place of the last one.
    pub(crate) fn put_rgb(&self, rgb: Image) {
        self.slots().rgb = Some(rgb);
        self.changed.notify_one();
    }

    /// Puts camera info into the mailbox, in place of the last one.
    pub(crate) fn put_info(&self, mut info: CameraInfo) {
        // Drivers publish the same camera with each image.
        info.header = Default::default();
        let mut slots = self.slots();
        if slots.info.as_ref() != Some(&info) {
            slots.info = Some(info);
            slots.is_info_new = true;
        }
        drop(slots);
        self.changed.notify_one();
    }

    /// Counts a message that could not be decoded.
    pub(crate) fn count_undecoded(&self) {
        self.slots().count.undecoded += 1;
    }

    /// Returns what happened so far.
    pub(crate) fn count(&self) -> MailCount {
        self.slots().count
    }

    /// Returns the time of the last depth image.
    pub(crate) fn last(&self) -> Option<Instant> {
        self.slots().last
    }

    /// Whether a depth image waits for a colour image or camera info.
    pub(crate) fn lacks(&self) -> Option<Lacking> {
        let slots = self.slots();
        slots.depth.as_ref()?;
        if self.needs_info && slots.info.is_none() {
            return Some(Lacking::Info);
        }
        (self.needs_rgb && slots.rgb.is_none()).then_some(Lacking::Rgb)
    }

    /// Takes the next complete frame, and waits up to `timeout` for it.
    pub(crate) fn take(&self, timeout: Duration) -> Option<Arrived> {
        let end = Instant::now() + timeout;
        let mut slots = self.slots();
        loop {
            if let Some(arrived) = self.complete(&mut slots) {
                return Some(arrived);
            }
            let rest = end.checked_duration_since(Instant::now())?;
            let waited = self.changed.wait_timeout(slots, rest);
            slots = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
    }

    fn complete(&self, slots: &mut Slots) -> Option<Arrived> {
        let stamp = slots.depth.as_ref()?.0.header.stamp;
        if self.needs_info && slots.info.is_none() {
            return None;
        }
        let is_of = |rgb: &Image, stamp: Time| rgb.header.stamp == stamp;
        if self.needs_rgb && !slots.rgb.as_ref().is_some_and(|rgb| is_of(rgb, stamp)) {
            return None;
        }
        let (depth, at) = slots.depth.take()?;
        let rgb = if self.needs_rgb { slots.rgb.take() } else { None };
        let new_info = match std::mem::take(&mut slots.is_info_new) {
            true => slots.info.clone(),
            false => None,
        };
        Some(Arrived {
            depth,
            rgb,
            new_info,
            at,
        })
    }
}

/// What a depth image waits for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lacking {
    /// Camera info.
    Info,
    /// A colour image.
    Rgb,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::Header;

    fn image(sec: i32) -> Image {
        Image {
            header: Header {
                stamp: Time { sec, nanosec: 0 },
                ..Header::default()
            },
            ..Image::default()
        }
    }

    const NOW: Duration = Duration::ZERO;

    #[test]
    fn the_newest_frame_replaces_the_one_that_waits() {
        let mailbox = Mailbox::new(false, false);
        assert!(mailbox.take(NOW).is_none());
        for sec in 1..=3 {
            mailbox.put_depth(image(sec));
        }
        assert_eq!(mailbox.take(NOW).unwrap().depth, image(3));
        assert!(mailbox.take(NOW).is_none());
        let expected = MailCount {
            received: 3,
            dropped: 2,
            ..MailCount::default()
        };
        assert_eq!(mailbox.count(), expected);
    }

    #[test]
    fn a_frame_waits_for_its_camera_info_and_its_colours() {
        let mailbox = Mailbox::new(true, true);
        mailbox.put_depth(image(1));
        assert_eq!(mailbox.lacks(), Some(Lacking::Info));
        mailbox.put_info(CameraInfo::default());
        assert_eq!(mailbox.lacks(), Some(Lacking::Rgb));
        mailbox.put_rgb(image(2));
        assert!(mailbox.take(NOW).is_none(), "the colours of another frame");
        mailbox.put_depth(image(2));
        let arrived = mailbox.take(NOW).unwrap();
        assert_eq!((arrived.depth, arrived.rgb), (image(2), Some(image(2))));
        assert!(arrived.new_info.is_some());
        assert_eq!((mailbox.count().dropped, mailbox.count().incomplete), (1, 1));
        // The same camera again.
        mailbox.put_info(CameraInfo {
            header: image(3).header,
            ..CameraInfo::default()
        });
        mailbox.put_depth(image(3));
        mailbox.put_rgb(image(3));
        assert!(mailbox.take(NOW).unwrap().new_info.is_none());
    }

    #[test]
    fn a_waiting_filter_is_woken() {
        let mailbox = Mailbox::new(false, false);
        std::thread::scope(|scope| {
            scope.spawn(|| mailbox.put_depth(image(1)));
            assert!(mailbox.take(Duration::from_secs(60)).is_some());
        });
    }
}
