mod report;

use std::path::Path;

use oaktwin::calibration::Raw;
use oaktwin::catalog::{Device, Twin, UnknownModel};
use oaktwin::depth::preset::Platform;
use oaktwin::depth::rectify::RectifyOptions;
use oaktwin::diagnostic::{Finding, suggest};
use oaktwin::render;
use oaktwin::sense::FieldOfView;
use oaktwin::sensor::stereo_cameras;
use oaktwin::stereo::{self, PairOf, StereoOptions, StereoOutput};
use oaktwin::unit;

use crate::args::StereoArgs;
use crate::context::{Context, Exit, Result};
use crate::progress;
use oaktwin::usd::asset::LensChoice;
use report::StereoReport;

pub(crate) fn run(context: &Context, args: &StereoArgs) -> Result<Exit> {
    let unit = twin(context, args)?;
    let of = pair_of(args, unit.as_ref().map(|(twin, _)| twin))?;
    let pairs = stereo::pairs(&args.left, &args.right)?;
    args.threads.apply();
    let options = StereoOptions {
        sensor: args.settings.options()?,
        outputs: outputs(args)?,
        extras: args.outputs.extras(),
        ply: args.outputs.ply,
        align: args.align.to()?,
    };
    let matched = progress::watched(|watch| stereo::stereo(&pairs, &of, &options, &args.output, watch));
    let Some(matched) = matched? else {
        return Ok(Exit::Success);
    };
    let exit = match (matched.is_interrupted, matched.has_warnings()) {
        (true, _) => Exit::Interrupted,
        (false, true) => Exit::Findings,
        (false, false) => Exit::Success,
    };
    StereoReport::new(args, unit, matched).print(args)?;
    Ok(exit)
}

/// The outputs that are named, or chosen by their old flags.
fn outputs(args: &StereoArgs) -> Result<Vec<StereoOutput>> {
    let flags = [
        (args.disparity, StereoOutput::Disparity),
        (args.confidence, StereoOutput::Confidence),
        (args.rectified_images, StereoOutput::Rectified),
    ];
    let mut outputs: Vec<StereoOutput> = flags
        .into_iter()
        .filter_map(|(is_given, output)| is_given.then_some(output))
        .collect();
    for name in &args.outputs.annotators {
        let name = name.trim();
        let known = StereoOutput::NAMES.iter().find(|(known, _)| *known == name);
        let Some((_, output)) = known else {
            let hint = suggest(name, StereoOutput::NAMES.map(|(name, _)| name));
            return Err(format!("--annotators: unknown annotator '{name}'; {hint}").into());
        };
        outputs.push(*output);
    }
    Ok(outputs)
}

/// The device or the rig, if the options determine one, and the findings about its calibration.
fn twin(context: &Context, args: &StereoArgs) -> Result<Option<(Twin, Vec<Finding>)>> {
    let model = match (&args.model, &args.unit.calibration) {
        (Some(model), _) => model.clone(),
        (None, None) if args.unit.lens == LensChoice::Fisheye => {
            return Err("--lens requires --model".into());
        }
        (None, None) => return Ok(None),
        (None, Some(file)) => {
            let (raw, calibration, _) = unit::read_calibration(file)?;
            let board = &calibration.board;
            let known = context
                .catalog
                .device_of_unit(&board.product_name, &board.board_name);
            match known {
                Ok(device) if args.pair.is_none() => device.id.clone(),
                known => return rig(args, file, &raw, known).map(Some),
            }
        }
    };
    let (twin, findings) = context.twin(&model, &args.unit)?;
    if let Some(file) = &args.unit.calibration {
        stereo::check_calibration(file, &findings)?;
    }
    Ok(Some((twin, findings)))
}

/// The rig with a calibration, which is of no model, or whose pair is named.
fn rig(
    args: &StereoArgs,
    file: &Path,
    raw: &Raw,
    known: std::result::Result<&Device, UnknownModel>,
) -> Result<(Twin, Vec<Finding>)> {
    let pair = match args.pair.as_deref() {
        Some([left, right]) => Some((*left, *right)),
        _ => None,
    };
    let (twin, findings) = unit::rig_of_raw(raw, file, pair, args.platform, known, args.unit.force)?;
    render::check_lens(&twin, args.unit.lens)?;
    Ok((twin, findings))
}

fn pair_of<'a>(args: &StereoArgs, twin: Option<&'a Twin>) -> Result<PairOf<'a>> {
    let platform = args.platform;
    let Some(twin) = twin else {
        let field_of_view = FieldOfView::given(args.fx, args.hfov);
        let (Some(baseline_m), true) = (args.baseline, field_of_view != FieldOfView::Known) else {
            return Err(
                "the cameras are unknown; set --calibration FILE, --model MODEL, or --fx F (or --hfov D) and --baseline METRES \
                        of a rectified pair"
                    .into(),
            );
        };
        return Ok(PairOf::Rectified {
            field_of_view,
            baseline_m,
            platform: platform.unwrap_or(Platform::Rvc2),
        });
    };
    let by_default = args.unit.calibration.is_some() || args.unit.lens == LensChoice::Fisheye;
    let is_raw = args.raw || args.rectify.is_some() || (by_default && !args.rectified);
    Ok(PairOf::Twin {
        twin,
        cameras: stereo_cameras(twin, args.sensor.as_deref())?,
        lens: args.unit.lens,
        is_raw,
        rectify: args.rectify.map(|method| {
            let own = platform.or_else(|| twin.platform());
            RectifyOptions {
                method,
                ..RectifyOptions::of(own.unwrap_or(Platform::Rvc4))
            }
        }),
        platform,
    })
}
