//! Engines of depth sensors.

use std::sync::Arc;

use oaktwin_depth::engines::{ENGINES, STEREO_MATCHING};
use oaktwin_depth::filter::{Chain, parse};
use oaktwin_depth::parameters::{Platform, Scalar};
use oaktwin_depth::random::Stream;
use oaktwin_depth::stereo_matching::RectifiedPair;
use oaktwin_depth::{
    Capture, CaptureLayer, DepthShot, Engine, EngineInput, EngineKind, Input, ReasonCodes, Sensor, Setup,
};
use oaktwin_image::annotation::Annotator;
use oaktwin_image::{Image, ImageView};

use crate::random::Random;

pub(crate) fn depth(bytes: &[u8]) {
    let mut random = Random::new(bytes);
    let kinds: Vec<&'static EngineKind> = ENGINES
        .iter()
        .copied()
        .filter(|kind| kind.input == EngineInput::Depth)
        .collect();
    let kind = random.pick(&kinds);
    let Some(engine) = engine(kind, &mut random) else {
        return;
    };
    let filters = filters(&mut random);
    let (width, height) = (1 + random.up_to(47), 1 + random.up_to(31));
    let has_colors = random.up_to(1) == 1;
    let colors = random.image(width, height, |random| [random.byte(), 90, 30, 255]);
    let depth = random.image(width, height, Random::depth);
    let mut shot = DepthShot::new((&depth).into());
    if has_colors {
        shot = shot
            .with_rgb((&colors).into())
            .unwrap_or_else(|error| panic!("{error}"));
    }
    shot.frame = u64::from(random.byte());
    measure(&engine, &filters, shot.into(), is_repeated(bytes));
}

pub(crate) fn stereo(bytes: &[u8]) {
    let mut random = Random::new(bytes);
    let Some(engine) = engine(&STEREO_MATCHING, &mut random) else {
        return;
    };
    let filters = filters(&mut random);
    let (width, height) = (1 + random.up_to(47), 1 + random.up_to(31));
    let shift = random.up_to(8) as usize;
    let is_deep = random.up_to(1) == 1;
    let left = random.image(width, height, |random| u16::from(random.byte()));
    let mut right = left.clone();
    for row in right.pixels_mut().chunks_exact_mut(width as usize) {
        row.rotate_left(shift % width as usize);
    }
    let changed = random.up_to(31) as usize;
    for at in 0..changed.min(right.pixels().len()) {
        right.pixels_mut()[at * 7 % (width * height) as usize] = u16::from(random.byte());
    }
    let narrow = |image: &Image<u16>| image.map(|&value| u8::try_from(value).unwrap_or(u8::MAX));
    let (left8, right8) = (narrow(&left), narrow(&right));
    let pair = if is_deep {
        RectifiedPair::new(ImageView::from(&left), ImageView::from(&right))
    } else {
        RectifiedPair::new(ImageView::from(&left8), ImageView::from(&right8))
    };
    measure(
        &engine,
        &filters,
        pair.unwrap_or_else(|error| panic!("{error}")).into(),
        is_repeated(bytes),
    );
}

/// Creates an engine with drawn parameters; `None` if they are invalid.
fn engine(kind: &'static EngineKind, random: &mut Random<'_>) -> Option<Arc<dyn Engine>> {
    let width = random.pick(&[640, 1280, 48]);
    let focal = random.pick(&[450.0, 800.0, 30.0]);
    let baseline = random.pick(&[0.075, 0.02, 0.0]);
    let mut setup = Setup::new(focal, width, baseline);
    setup.platform = random.pick(Platform::ALL);
    setup.extended_disparity = random.up_to(1) == 1;
    setup.device_seed = (random.up_to(1) == 1).then_some(7);
    let names = (kind.parameters)();
    for _ in 0..random.up_to(4) {
        let value = match random.up_to(2) {
            0 => random.up_to(300).into(),
            1 => random.number().into(),
            _ => Scalar::of(random.pick(&["true", "false", "0.5", "0.01", "5"])),
        };
        setup.parameters.push((random.pick(&names).to_owned(), value));
    }
    kind.create(&setup).ok()
}

fn filters(random: &mut Random<'_>) -> Chain {
    let texts = [
        "speckle",
        "spatial",
        "decimation:factor=3",
        "median",
        "threshold:min=300,max=9000",
    ];
    let count = random.up_to(2);
    Chain::new(
        (0..count)
            .filter_map(|_| parse(random.pick(&texts)).ok())
            .collect(),
    )
}

/// Whether to measure twice: one input in four, since that takes twice the time.
fn is_repeated(bytes: &[u8]) -> bool {
    bytes.len().is_multiple_of(4)
}

/// Measures, and checks the result.
fn measure(engine: &Arc<dyn Engine>, filters: &Chain, input: Input<'_>, is_repeated: bool) {
    let outputs = engine.outputs().to_vec();
    let (width, height) = match &input {
        Input::Depth(shot) => (shot.depth().width(), shot.depth().height()),
        Input::Pair(pair) => (pair.width(), pair.height()),
    };
    let _ = engine.inspect(&input);
    let mut once = Sensor::new(Arc::clone(engine), filters.clone(), Stream::new(3, "/Camera"));
    let mut again = once.clone();
    let Ok(first) = once.capture(input, &outputs) else {
        return;
    };
    if is_repeated {
        let second = again.capture(input, &outputs);
        let is_same = second.is_ok_and(|second| bits(&first) == bits(&second));
        assert!(is_same, "{engine:?}: other bytes the second time");
    }
    let image = &first.distance.0;
    assert_eq!((image.width(), image.height()), filters.size(width, height));
    let strange = image.pixels().iter().find(|z| !(z.is_finite() && **z >= 0.0));
    assert!(strange.is_none(), "{engine:?}: measured {strange:?}");
    let codes: Option<&ReasonCodes> = first.extra(Annotator::DepthSensorReason);
    let pixels = codes
        .iter()
        .flat_map(|codes| image.pixels().iter().zip(codes.0.pixels()));
    for (z, code) in pixels {
        assert_eq!(*z > 0.0, *code == 0, "{engine:?}: the reason of {z} is {code}");
    }
}

/// The bits of all images, so that NaN equals itself.
fn bits(capture: &Capture) -> Vec<u32> {
    let mut bits: Vec<u32> = capture.distance.0.pixels().iter().map(|z| z.to_bits()).collect();
    for (_, layer) in &capture.extras {
        match layer {
            CaptureLayer::Bytes(image) => bits.extend(image.pixels().iter().map(|&byte| u32::from(byte))),
            CaptureLayer::Levels(image) => bits.extend(image.pixels().iter().map(|&level| u32::from(level))),
            CaptureLayer::Floats(image) => bits.extend(image.pixels().iter().map(|value| value.to_bits())),
            CaptureLayer::Colors(image) => {
                bits.extend(image.pixels().iter().map(|&color| u32::from_le_bytes(color)));
            }
            CaptureLayer::Points(image) => {
                bits.extend(image.pixels().iter().flatten().map(|value| value.to_bits()));
            }
            CaptureLayer::Reasons(codes) => bits.extend(codes.0.pixels().iter().map(|&code| u32::from(code))),
            CaptureLayer::Disparity(disparity) => {
                bits.push(disparity.shift_px);
                bits.extend(disparity.step_px.to_bits().to_le_bytes().map(u32::from));
                bits.extend(disparity.fixed.pixels().iter().map(|&fixed| u32::from(fixed)));
            }
        }
    }
    bits
}

pub(crate) fn depth_seeds() -> Vec<Vec<u8>> {
    // From the end, as lengths are: the engine comes first.
    (0..12u8)
        .map(|engine| {
            [
                &[engine][..],
                &(0..150u8).map(|at| at.wrapping_mul(engine)).collect::<Vec<_>>(),
            ]
            .concat()
        })
        .collect()
}

pub(crate) fn stereo_seeds() -> Vec<Vec<u8>> {
    depth_seeds()
}
