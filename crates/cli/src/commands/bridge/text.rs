//! What the bridge reports, as text or as JSON.

use std::path::Path;

use oaktwin_bridge::{Event, Started, Status};

use crate::args::BridgeArgs;
use crate::context::Result;
use crate::output;

pub(super) fn print(args: &BridgeArgs, event: &Event) -> Result<()> {
    if args.json {
        return output::print_json_line(event);
    }
    match event {
        Event::Started(started) => output::say(&connected(args, started)),
        Event::Finding(finding) => {
            output::say_findings(Path::new(&args.model), std::slice::from_ref(finding));
        }
        Event::Status(status) => output::say(&line(status)),
        Event::Stopped(status) => output::print(&format!("{}\n", line(status)))?,
    }
    Ok(())
}

fn connected(args: &BridgeArgs, started: &Started) -> String {
    let topics = &started.topics;
    let inputs: Vec<&str> = topics.subscribed().map(String::as_str).collect();
    let outputs: Vec<&str> = topics.published().map(String::as_str).collect();
    let range = if started.localhost {
        ", this machine only"
    } else {
        ""
    };
    format!(
        "{}: {} → {} (node {}, domain {}{range})\nPress Ctrl-C to stop.",
        args.model,
        inputs.join(", "),
        outputs.join(", "),
        started.node,
        started.domain
    )
}

/// Describes the state in a line, with what went wrong only where it did.
fn line(status: &Status) -> String {
    let mut line = format!(
        "{:.0} s: {} received, {} published, {} dropped",
        status.seconds, status.received, status.published, status.dropped
    );
    for (count, what) in [
        (status.lost, "lost in the network"),
        (status.incomplete, "incomplete"),
        (status.rejected, "rejected"),
        (status.undelivered, "lost by --drop"),
    ] {
        if count > 0 {
            line += &format!(", {count} {what}");
        }
    }
    if let Some(latency) = &status.latency_ms {
        line += &format!(
            "; latency {:.1} ms (median), {:.1} ms (95 %), {:.1} ms (longest)",
            latency.median, latency.p95, latency.longest
        );
    }
    line + &match status.subscribers {
        1 => "; 1 subscriber".to_owned(),
        count => format!("; {count} subscribers"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_bridge::Percentiles;

    #[test]
    fn the_state_names_what_went_wrong_only() {
        let status = Status {
            seconds: 60.2,
            received: 1800,
            published: 1799,
            dropped: 1,
            subscribers: 1,
            latency_ms: Some(Percentiles {
                median: 4.2,
                p95: 6.0,
                longest: 20.0,
            }),
            ..Status::default()
        };
        assert_eq!(
            line(&status),
            "60 s: 1800 received, 1799 published, 1 dropped; latency 4.2 ms (median), 6.0 ms (95 %), 20.0 ms (longest); \
             1 subscriber"
        );
        let empty = Status {
            rejected: 3,
            ..Status::default()
        };
        assert_eq!(
            line(&empty),
            "0 s: 0 received, 0 published, 0 dropped, 3 rejected; 0 subscribers"
        );
    }
}
