//! The axes along which costs are measured.

use std::error::Error;
use std::hint::black_box;

use oaktwin_camera::{ImageSize, StereoGeometry};
use oaktwin_depth::DepthShot;
use oaktwin_depth::preset::Platform;
use oaktwin_depth::random::Stream;
use oaktwin_depth::stereo_matching::{self, RectifiedPair, StereoMatching};
use oaktwin_depth::stereo_noise::{self, StereoNoise};
use oaktwin_image::{Image, ImageView};
use oaktwin_render::{Backend, Renderer, View};
use oaktwin_testkit::process;
use oaktwin_testkit::stereo_pair::textured_pair;
use rayon::{ThreadPool, ThreadPoolBuilder};

use crate::scenes::{SIZE, balls, plane, view};
use crate::{Measurement, print};

type Measured = Result<(), Box<dyn Error>>;

/// Measures the points of an axis.
pub(crate) type Measure = fn(&Measurement) -> Measured;

/// The names of the axes and their measurements.
pub(crate) const ALL: [(&str, Measure); 6] = [
    ("triangles", triangles),
    ("pixels", pixels),
    ("instances", instances),
    ("disparities", disparities),
    ("frames", frames),
    ("threads", threads),
];

const BACKENDS: [(&str, Backend); 2] = [("rasterizer", Backend::Raster), ("ray caster", Backend::Ray)];

/// Squares along each side of a plane of a million triangles.
const MILLION: u32 = 707;

fn pool(threads: usize) -> Result<ThreadPool, Box<dyn Error>> {
    Ok(ThreadPoolBuilder::new().num_threads(threads).build()?)
}

/// Depth frames of planes of 10⁴ to 10⁷ triangles.
fn triangles(measurement: &Measurement) -> Measured {
    let pool = pool(1)?;
    for squares in [71, 224, MILLION, 2236] {
        let at = 2 * u64::from(squares).pow(2);
        for (name, backend) in BACKENDS {
            let scene = plane(squares);
            let (renderer, preparation) = pool.install(|| process::timed(|| prepared(scene, backend)));
            print(
                &format!("{name}: preparation, ms"),
                at,
                &[preparation.cpu_s * 1e3],
            );
            depth(measurement, &pool, name, at, &renderer, &view(SIZE, 0.0), backend);
        }
    }
    Ok(())
}

/// Depth frames of 1 to 10⁵ instances of one mesh.
fn instances(measurement: &Measurement) -> Measured {
    let pool = pool(1)?;
    for count in [1, 10, 100, 1000, 10_000, 100_000] {
        for (name, backend) in BACKENDS {
            let renderer = pool.install(|| prepared(balls(count), backend));
            let view = view(SIZE, 0.0);
            depth(measurement, &pool, name, count.into(), &renderer, &view, backend);
        }
    }
    Ok(())
}

/// Depth frames, the noise model and the matcher from VGA to 12 megapixels.
fn pixels(measurement: &Measurement) -> Measured {
    let pool = pool(1)?;
    let renderer = pool.install(|| prepared(plane(MILLION), Backend::Raster));
    for (width, height) in [(640, 480), (1280, 800), (1920, 1200), (2560, 1600), (4000, 3000)] {
        let size = ImageSize::new(width, height);
        let (at, view) = (u64::from(width) * u64::from(height), view(size, 0.0));
        for (name, backend) in BACKENDS {
            depth(measurement, &pool, name, at, &renderer, &view, backend);
        }
        let seen = renderer.depth(&view, Backend::Raster).0;
        let noise = Noise::new(width)?;
        measurement.frames("stereo-noise", at, || pool.install(|| noise.sense(&seen, 0)));
        let matcher = Matcher::new(size, &[])?;
        measurement.frames("stereo-matching", at, || pool.install(|| matcher.run()));
    }
    Ok(())
}

/// The matcher with each of the device's search ranges: 64 or 96 disparities, plain, farther apart beyond the first half, or
/// also on images of half the size.
fn disparities(measurement: &Measurement) -> Measured {
    let pool = pool(1)?;
    for (count, width) in [(64, "DISPARITY_64"), (96, "DISPARITY_96")] {
        for mode in ["", "enableCompanding", "extendedDisparity"] {
            let width = ("disparityWidth", width);
            let matcher = match mode {
                "" => Matcher::new(SIZE, &[width])?,
                mode => Matcher::new(SIZE, &[width, (mode, "true")])?,
            };
            let name = format!("stereo-matching {mode}");
            measurement.frames(name.trim_end(), count, || pool.install(|| matcher.run()));
        }
    }
    Ok(())
}

/// Sequences of 1 to 1000 frames of a moving camera, rendered and measured.
fn frames(_: &Measurement) -> Measured {
    let renderer = prepared(plane(MILLION), Backend::Raster);
    let noise = Noise::new(SIZE.width)?;
    let frame = |number: u32| {
        let seen = renderer
            .depth(&view(SIZE, f64::from(number) * 0.01), Backend::Raster)
            .0;
        noise.sense(&seen, number.into());
    };
    frame(0);
    for count in [1u32, 10, 100, 1000] {
        let ((), time) = process::timed(|| (0..count).for_each(frame));
        let per_frame = time.cpu_s * 1e3 / f64::from(count);
        print(
            "rasterizer and stereo-noise, ms per frame",
            count.into(),
            &[per_frame],
        );
        #[expect(clippy::cast_precision_loss, reason = "megabytes")]
        let megabytes = process::resident_bytes() as f64 / 1e6;
        print("memory afterwards, MB", count.into(), &[megabytes]);
    }
    Ok(())
}

/// Everything on one thread, two, and so on in powers of two, up to one for each processor.
fn threads(measurement: &Measurement) -> Measured {
    let renderer = prepared(plane(MILLION), Backend::Raster);
    let seen = renderer.depth(&view(SIZE, 0.0), Backend::Raster).0;
    let noise = Noise::new(SIZE.width)?;
    let matcher = Matcher::new(SIZE, &[])?;
    let available = std::thread::available_parallelism()?.get();
    let counts = std::iter::successors(Some(1), |count| Some(2 * count));
    for count in counts.take_while(|count| *count <= available) {
        let (pool, at) = (pool(count)?, count as u64);
        for (name, backend) in BACKENDS {
            let view = view(SIZE, 0.0);
            measurement.elapsed(name, at, || {
                black_box(pool.install(|| renderer.depth(&view, backend)));
            });
        }
        measurement.elapsed("stereo-noise", at, || pool.install(|| noise.sense(&seen, 0)));
        measurement.elapsed("stereo-matching", at, || pool.install(|| matcher.run()));
    }
    Ok(())
}

/// Returns the renderer of a scene with a backend's data, which are made for the first frame.
fn prepared(scene: oaktwin_scene::Scene, backend: Backend) -> Renderer {
    let renderer = Renderer::new(scene);
    black_box(renderer.depth(&view(ImageSize::new(1, 1), 0.0), backend));
    renderer
}

fn depth(
    measurement: &Measurement,
    pool: &ThreadPool,
    name: &str,
    at: u64,
    renderer: &Renderer,
    view: &View,
    backend: Backend,
) {
    measurement.frames(name, at, || {
        black_box(pool.install(|| renderer.depth(view, backend)));
    });
}

/// An OAK-D Pro's pair at 1280 px, scaled with the width.
fn stereo(width: u32) -> StereoGeometry {
    StereoGeometry {
        focal_length_px: 0.629 * f64::from(width),
        baseline_m: 0.075,
    }
}

/// The noise model.
struct Noise {
    engine: StereoNoise,
    random: Stream,
}

impl Noise {
    fn new(width: u32) -> Result<Self, Box<dyn Error>> {
        Ok(Self {
            engine: StereoNoise::new(stereo_noise::Parameters::new(
                Platform::Rvc2,
                stereo(width),
                width,
            ))?,
            random: Stream::new(7, "Camera_pseudo_depth"),
        })
    }

    fn sense(&self, depth: &Image<f32>, frame: u64) {
        let mut shot = DepthShot::new(depth.into());
        shot.frame = frame;
        black_box(self.engine.sense(&shot, &self.random));
    }
}

/// The matcher and a pair of images.
struct Matcher {
    engine: StereoMatching,
    images: [Image<u8>; 2],
}

impl Matcher {
    fn new(size: ImageSize, settings: &[(&str, &str)]) -> Result<Self, Box<dyn Error>> {
        let mut parameters = stereo_matching::Parameters::new(Platform::Rvc2, stereo(size.width), size.width);
        for (name, value) in settings {
            parameters.set(name, *value)?;
        }
        Ok(Self {
            engine: StereoMatching::new(parameters)?,
            images: textured_pair(size)?,
        })
    }

    fn run(&self) {
        let [left, right] = self.images.each_ref().map(ImageView::from);
        if let Ok(pair) = RectifiedPair::new(left, right) {
            black_box(self.engine.disparity(&pair));
        }
    }
}
