//! The thread that takes messages from the network.

use std::io;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

use ros2_client::{Gid, MessageInfo, Subscription};
use rustdds::mio1::{Events, Interest, Poll, Token};
use serde::de::DeserializeOwned;

use crate::mailbox::Mailbox;
use crate::node::Subscriptions;

/// The time after which the end is noticed.
const POLL: Duration = Duration::from_millis(100);

/// Counts the depth images that were sent, but did not arrive: gaps in the numbers of a publisher.
fn count_gap(last: &mut Option<(Gid, i64)>, lost: &AtomicU64, publisher: Gid, number: i64) {
    if let Some((before, last)) = *last
        && before == publisher
        && number > last
    {
        lost.fetch_add((number - last - 1).unsigned_abs(), Ordering::Relaxed);
    }
    *last = Some((publisher, number));
}

/// Puts arriving messages into the mailbox until `is_over`.
pub(crate) fn receive(
    mut subscriptions: Subscriptions,
    mailbox: &Mailbox,
    lost: &AtomicU64,
    is_over: &AtomicBool,
) -> io::Result<()> {
    let mut poll = Poll::new()?;
    let registry = poll.registry();
    registry.register(&mut subscriptions.depth, Token(0), Interest::READABLE)?;
    if let Some(info) = &mut subscriptions.info {
        registry.register(info, Token(1), Interest::READABLE)?;
    }
    if let Some(rgb) = &mut subscriptions.rgb {
        registry.register(rgb, Token(2), Interest::READABLE)?;
    }
    let mut events = Events::with_capacity(8);
    let mut last = None;
    while !is_over.load(Ordering::Relaxed) {
        match poll.poll(&mut events, Some(POLL)) {
            Err(error) if error.kind() != io::ErrorKind::Interrupted => return Err(error),
            _ => {}
        }
        // Events are edges, and one may be lost with an undecodable message: all are emptied.
        if let Some(info) = &subscriptions.info {
            take(info, mailbox, |info, _| mailbox.put_info(info));
        }
        if let Some(rgb) = &subscriptions.rgb {
            take(rgb, mailbox, |rgb, _| mailbox.put_rgb(rgb));
        }
        take(&subscriptions.depth, mailbox, |depth, about| {
            count_gap(&mut last, lost, about.publisher_gid(), about.sequence_number());
            mailbox.put_depth(depth);
        });
    }
    Ok(())
}

/// Takes all messages that have arrived.
fn take<M: DeserializeOwned + 'static>(
    subscription: &Subscription<M>,
    mailbox: &Mailbox,
    mut put: impl FnMut(M, MessageInfo),
) {
    loop {
        match subscription.take() {
            Ok(Some((message, about))) => put(message, about),
            Ok(None) => return,
            Err(_) => {
                mailbox.count_undecoded();
                return;
            }
        }
    }
}
