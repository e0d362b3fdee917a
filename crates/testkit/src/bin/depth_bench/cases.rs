//! The benchmark cases.

use oaktwin_depth::preset::Platform;
use std::error::Error;
use std::sync::Arc;

use oaktwin_camera::StereoGeometry;
use oaktwin_depth::filter::{self, Chain};
use oaktwin_depth::random::{NoiseStage, Stream};
use oaktwin_depth::single_view::{Assumptions, Parameters, SingleView, Wanted};
use oaktwin_depth::stereo_noise::{self, StereoNoise};
use oaktwin_depth::time_of_flight::{self, TimeOfFlight};
use oaktwin_depth::{BatchEngine as _, DepthShot};
use oaktwin_image::{Image, millimetres};

/// Processes one frame, given its number.
type FrameTask<'a> = Box<dyn FnMut(u64) -> Result<(), Box<dyn Error>> + Send + 'a>;

/// A benchmark case.
pub(crate) struct Case<'a> {
    pub(crate) name: String,
    /// Pixels per frame.
    pub(crate) pixels: usize,
    /// The minimum number of bytes read and written per frame.
    pub(crate) bytes: usize,
    pub(crate) work: FrameTask<'a>,
}

/// The filters, as text, with typical preset values.
const FILTERS: [&str; 9] = [
    "median:kernel=3x3",
    "median:kernel=5x5",
    "median:kernel=7x7",
    "spatial:alpha=0.5,delta=20,holeFillingRadius=2,numIterations=1",
    "temporal:alpha=0.4,delta=20,persistencyMode=VALID_2_IN_LAST_4",
    "speckle:speckleRange=50,differenceThreshold=2",
    "decimation:decimationFactor=2,decimationMode=PIXEL_SKIPPING",
    "decimation:decimationFactor=2,decimationMode=NON_ZERO_MEDIAN",
    "threshold:minRange=600,maxRange=12000",
];

/// A batch of a reinforcement-learning environment: images, rows, columns.
const BATCH: [usize; 3] = [4096, 60, 106];

/// The parameters of the `OAK-D Pro` spec sheet.
fn sheet() -> Parameters {
    Parameters {
        baseline_mm: 75.0,
        focal_length_px: 805.0,
        max_disparity_px: 95.0,
        min_distance_m: 0.6,
        max_distance_m: 12.0,
        noise_mean_px: 0.25,
        noise_sigma_px: 0.2,
        noise_downscale_factor_px: 2.0,
        confidence_threshold: 0.8,
        ..Parameters::isaac_5_1()
    }
}

/// All cases, for a depth image and its colour image.
pub(crate) fn all<'a>(
    depth: &'a Image<f32>,
    rgb: &'a Image<[u8; 4]>,
) -> Result<Vec<Case<'a>>, Box<dyn Error>> {
    let random = Stream::new(7, "Camera_pseudo_depth");
    let (small, _) = crate::room::ray_cast(106, 60);
    let batch: Arc<[f32]> = small
        .pixels()
        .iter()
        .copied()
        .cycle()
        .take(BATCH.iter().product())
        .collect();
    let stereo = StereoGeometry {
        focal_length_px: 805.0,
        baseline_m: 0.075,
    };
    let engine = StereoNoise::new(stereo_noise::Parameters::new(
        Platform::Rvc2,
        stereo,
        depth.width(),
    ))?;
    let mut cases = single_view_cases(depth, rgb, &batch, random)?;
    cases.extend(stereo_noise_cases(depth, batch, &engine, random));
    cases.push(time_of_flight_case(random)?);
    // The filters process several frames of the sensor's own noise.
    let frames: Vec<Image<u16>> = (0..4)
        .map(|frame| {
            let mut shot = DepthShot::new(depth.into());
            shot.frame = frame;
            millimetres::from_metres(&engine.sense(&shot, &random).0)
        })
        .collect();
    for text in FILTERS {
        cases.push(filter_case(text, frames.clone())?);
    }
    Ok(cases)
}

fn shape(image: &Image<f32>) -> [usize; 3] {
    [1, image.height() as usize, image.width() as usize]
}

fn single_view_cases<'a>(
    depth: &'a Image<f32>,
    rgb: &'a Image<[u8; 4]>,
    batch: &Arc<[f32]>,
    random: Stream,
) -> Result<Vec<Case<'a>>, Box<dyn Error>> {
    let pixels = depth.pixels().len();
    let mut cases = Vec::new();
    let fine = Parameters {
        noise_downscale_factor_px: 1.0,
        ..sheet()
    };
    for (name, parameters) in [("single_view", sheet()), ("single_view, jitter by pixel", fine)] {
        let engine = SingleView::new(parameters, Assumptions::default())?;
        let mut out = vec![0.0; pixels];
        cases.push(Case {
            name: name.to_owned(),
            pixels,
            bytes: 8 * pixels,
            work: Box::new(move |frame| {
                Ok(engine.sense_batch(depth.pixels(), shape(depth), frame, 0, &random, &mut out)?)
            }),
        });
    }
    let engine = SingleView::new(sheet(), Assumptions::default())?;
    let (items, mut out) = (batch.clone(), vec![0.0; batch.len()]);
    cases.push(Case {
        name: "single_view, 4096 × 60 × 106".to_owned(),
        pixels: batch.len(),
        bytes: 8 * batch.len(),
        work: Box::new(move |frame| Ok(engine.sense_batch(&items, BATCH, frame, 0, &random, &mut out)?)),
    });
    let engine = SingleView::new(sheet(), Assumptions::default())?;
    cases.push(Case {
        name: "single_view, with a colour image".to_owned(),
        pixels,
        bytes: 12 * pixels,
        work: Box::new(move |frame| {
            let mut shot = DepthShot::new(depth.into()).with_rgb(rgb.into())?;
            shot.frame = frame;
            std::hint::black_box(engine.sense(&shot, &random, Wanted::default()));
            Ok(())
        }),
    });
    Ok(cases)
}

fn stereo_noise_cases<'a>(
    depth: &'a Image<f32>,
    batch: Arc<[f32]>,
    engine: &StereoNoise,
    random: Stream,
) -> [Case<'a>; 3] {
    let (pixels, batch_pixels) = (depth.pixels().len(), batch.len());
    let mut out = vec![0.0; pixels];
    let sensor = engine.clone();
    let single = Case {
        name: "stereo_noise".to_owned(),
        pixels,
        bytes: 8 * pixels,
        work: Box::new(move |frame| {
            Ok(sensor.sense_batch(depth.pixels(), shape(depth), frame, 0, &random, &mut out)?)
        }),
    };
    let noise = random.plane(NoiseStage::Exposure, 0, 0);
    let mut white = vec![0.0; batch_pixels];
    for (row, depths) in (0..).zip(white.chunks_exact_mut(BATCH[2])) {
        noise.uniforms(row, depths);
        depths.iter_mut().for_each(|z| *z = 0.5 + 7.5 * *z);
    }
    let mut out = vec![0.0; batch_pixels];
    let sensor = engine.clone();
    let worst = Case {
        name: "stereo_noise, 4096 × 60 × 106, white noise".to_owned(),
        pixels: batch_pixels,
        bytes: 8 * batch_pixels,
        work: Box::new(move |frame| Ok(sensor.sense_batch(&white, BATCH, frame, 0, &random, &mut out)?)),
    };
    let mut out = vec![0.0; batch_pixels];
    let sensor = engine.clone();
    let many = Case {
        name: "stereo_noise, 4096 × 60 × 106".to_owned(),
        pixels: batch_pixels,
        bytes: 8 * batch_pixels,
        work: Box::new(move |frame| Ok(sensor.sense_batch(&batch, BATCH, frame, 0, &random, &mut out)?)),
    };
    [single, many, worst]
}

/// Time of flight at the camera's 640 × 480.
fn time_of_flight_case(random: Stream) -> Result<Case<'static>, Box<dyn Error>> {
    let (far, _) = crate::room::ray_cast(640, 480);
    let pixels = far.pixels().len();
    let mut out = vec![0.0; pixels];
    let sensor = TimeOfFlight::new(time_of_flight::Parameters::new(402.0, 640))?;
    Ok(Case {
        name: "time_of_flight, 640 × 480".to_owned(),
        pixels,
        bytes: 8 * pixels,
        work: Box::new(move |frame| {
            Ok(sensor.sense_batch(far.pixels(), shape(&far), frame, 0, &random, &mut out)?)
        }),
    })
}

fn filter_case(text: &str, frames: Vec<Image<u16>>) -> Result<Case<'static>, Box<dyn Error>> {
    let mut chain = Chain::new(vec![filter::parse(text)?]);
    let pixels = frames.first().map_or(0, |frame| frame.pixels().len());
    Ok(Case {
        name: text.to_owned(),
        pixels,
        bytes: 4 * pixels,
        work: Box::new(move |frame| {
            #[expect(clippy::cast_possible_truncation, reason = "an index into four")]
            let image = frames[frame as usize % frames.len()].clone();
            std::hint::black_box(chain.run(image));
            Ok(())
        }),
    })
}
