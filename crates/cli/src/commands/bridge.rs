use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;
use std::sync::mpsc::{self, Receiver};
use std::thread;

use oaktwin::camera::RigidTransform;
use oaktwin::catalog::{Twin, TwinDepthSensor};
use oaktwin::robot::{Attachment, Description, RobotError};
use oaktwin::sense::{FieldOfView, SenseOptions};
use oaktwin::sensor::{depth_sensor, latency, sensor};
use oaktwin_bridge::{
    BridgeOptions, Delivery, DeviceFrames, Event, Filter, Network, Started, Status, run as bridge,
};

use crate::args::BridgeArgs;
use crate::context::{Context, Exit, Result};
use crate::{output, signals};

/// The longest line of standard input, bytes.
const MAX_LINE: u64 = 1 << 16;

pub(crate) fn run(context: &Context, args: &BridgeArgs) -> Result<Exit> {
    args.threads.apply();
    let (mut network, findings) = Network::from_environment()?;
    if let Some(address) = args.interface {
        network = network.on(address)?;
    }
    for finding in findings {
        output::say(&finding.to_string());
    }
    let (twin, findings) = context.twin(&args.model, &args.unit)?;
    if let Some(path) = &args.unit.calibration {
        output::say_findings(path, &findings);
    }
    let sensor = depth_sensor(&twin, args.sensor.as_deref())?;
    let options = BridgeOptions {
        depth: args.depth.clone(),
        info: args.info.clone(),
        rgb: args.rgb.clone(),
        out: args.out.clone(),
        sensor: sensor.spec.kind.as_str().to_owned(),
        node: args.node.clone(),
        encoding: args.encoding,
        points: args.points,
        points_step: args.points_step,
        compressed: args.compressed,
        frames: frames(context, args, &twin, &sensor.spec.prim)?,
        is_reliable: args.reliable,
        is_input_reliable: args.reliable_inputs,
        delivery: delivery(args, &twin, sensor)?,
    };
    let prim = sensor.spec.prim.clone();
    let filter = Filter::new(twin, sense_options(args, prim)?)?;
    let mut printed = Ok(());
    signals::while_checked(|| {
        bridge(
            filter,
            &options,
            &network,
            &lines(args.stdin),
            |event| {
                let result = print(args, &event);
                if printed.is_ok() {
                    printed = result;
                }
            },
            signals::is_received,
        )
    })?;
    printed?;
    Ok(Exit::Interrupted)
}

/// Returns the lines of standard input, which a thread reads until its end, or no lines.
fn lines(is_read: bool) -> Receiver<String> {
    // A program that writes faster than the bridge takes waits.
    let (sender, receiver) = mpsc::sync_channel(16);
    if is_read {
        thread::spawn(move || {
            let mut input = BufReader::new(io::stdin());
            loop {
                let mut line = Vec::new();
                let read = input.by_ref().take(MAX_LINE).read_until(b'\n', &mut line);
                if !matches!(read, Ok(1..)) {
                    return;
                }
                let text = String::from_utf8_lossy(&line).trim().to_owned();
                if !text.is_empty() && sender.send(text).is_err() {
                    return;
                }
            }
        });
    }
    receiver
}

/// Returns the frames of the device, if they are to be published.
fn frames(context: &Context, args: &BridgeArgs, twin: &Twin, depth: &str) -> Result<Option<DeviceFrames>> {
    let Some(name) = &args.tf else {
        return Ok(None);
    };
    let attachment = Attachment {
        name: name.clone(),
        ..Attachment::default()
    };
    let description = Description::new(&context.catalog, twin, &attachment).map_err(|error| match error {
        RobotError::Name { name, problem, .. } => RobotError::Name {
            option: "tf",
            name,
            problem,
        },
        other @ RobotError::NotFinite { .. } => other,
    })?;
    let sensor = twin.depth_sensors.iter().find(|sensor| sensor.spec.prim == depth);
    let camera = sensor.and_then(|sensor| twin.depth_camera(sensor));
    Ok(Some(DeviceFrames {
        device: name.clone(),
        frames: description.frames(),
        body_from_depth: camera.map_or(RigidTransform::IDENTITY, |camera| camera.body_from_camera),
    }))
}

/// Returns when frames are published.
fn delivery(args: &BridgeArgs, twin: &Twin, depth: &TwinDepthSensor) -> Result<Delivery> {
    let options = args.engine.options()?;
    let mut delivery = Delivery {
        jitter_s: args.jitter.unwrap_or(0.0),
        drop: args.drop,
        seed: options.seed,
        ..Delivery::default()
    };
    match args.latency.as_deref() {
        Some("catalog") => {
            let (made, _) = sensor(twin, depth, &options)?;
            let latency = latency(twin, depth, made.engine().as_ref(), None).ok_or_else(|| {
                format!(
                    "--latency: the catalog has no latency of {} {}; measure it with fit --latency, and give seconds",
                    twin.device.name, depth.spec.prim
                )
            })?;
            delivery.latency_s = (1e-3 * latency.ms.0, 1e-3 * latency.ms.1);
            delivery.jitter_s = args.jitter.unwrap_or(1e-3 * latency.largest_jitter_ms());
        }
        Some(text) => delivery.latency_s = Delivery::parse_latency(text)?,
        None => {}
    }
    delivery.check()?;
    Ok(delivery)
}

fn sense_options(args: &BridgeArgs, prim: String) -> Result<SenseOptions> {
    Ok(SenseOptions {
        sensor: args.engine.options()?,
        depth_sensor: Some(prim),
        input_kind: Some(args.input_kind),
        field_of_view: FieldOfView::given(args.fx, args.hfov),
        resample: args.resample,
        lens: args.unit.lens,
        ..SenseOptions::default()
    })
}

fn print(args: &BridgeArgs, event: &Event) -> Result<()> {
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
