mod device;
mod input;
mod text;

use oaktwin::sense::{FieldOfView, SenseOptions};
use oaktwin::sensor::depth_sensor;
use oaktwin_bridge::{BridgeOptions, DepthFilter, Network, run as bridge};

use crate::args::BridgeArgs;
use crate::context::{Context, Exit, Result};
use crate::{output, signals};

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
        frames: device::frames(context, args, &twin, &sensor.spec.prim)?,
        is_reliable: args.reliable,
        is_input_reliable: args.reliable_inputs,
        delivery: device::delivery(args, &twin, sensor)?,
    };
    let prim = sensor.spec.prim.clone();
    let filter = DepthFilter::new(twin, sense_options(args, prim)?)?;
    let mut printed = Ok(());
    signals::while_checked(|| {
        bridge(
            filter,
            &options,
            &network,
            &input::lines(args.stdin),
            |event| {
                let result = text::print(args, &event);
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
