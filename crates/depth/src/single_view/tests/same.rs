use oaktwin_simd::{self as simd, Level};
use proptest::prelude::*;

use super::*;
use crate::random::NoiseStage;

fn bits(image: &Image<f32>) -> Vec<u32> {
    image.pixels().iter().map(|z| z.to_bits()).collect()
}

fn bumpy(width: u32, height: u32) -> Image<f32> {
    image(width, height, |x, y| {
        let wave = ((x * 13 + y * 7) % 40) as f32;
        if wave > 37.0 {
            f32::INFINITY
        } else {
            0.7 + wave * 0.05 + (x / 30) as f32 * 0.2
        }
    })
}

#[test]
fn does_not_depend_on_threads() {
    let depth = bumpy(333, 400);
    let rgb = image(333, 400, |x, y| [(x * y) as u8, x as u8, y as u8, 255]);
    let shot = DepthShot::new((&depth).into()).with_rgb((&rgb).into()).unwrap();
    let wanted = Wanted {
        colors: true,
        view: true,
        ..Wanted::default()
    };
    let mut parameters = oak_d_pro();
    parameters.set("rgbDepthOutputMode", "6").unwrap();
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| sensor(parameters).sense(&shot, &Stream::new(1, "left"), wanted))
    };
    let one = on(1);
    assert!(one.distance.0.pixels().iter().filter(|&&z| z > 0.0).count() > 1000);
    assert_eq!(one, on(2));
    assert_eq!(one, on(8));
}

#[test]
fn does_not_depend_on_instructions() {
    let depth = bumpy(333, 20);
    let plan = plan::SingleViewPlan::new(&oak_d_pro(), &Assumptions::default(), 333, 20);
    let random = Stream::new(1, "left").plane(NoiseStage::Jitter, 0, 0);
    struct Rows<'a>(
        &'a plan::SingleViewPlan,
        &'a Image<f32>,
        &'a crate::random::RandomPlane,
    );
    impl simd::Kernel for Rows<'_> {
        type Output = Vec<u64>;
        #[inline(always)]
        fn run(self) -> Vec<u64> {
            let (mut row, mut landed) = (warp::RowBuffers::default(), vec![0u64; 333]);
            row.reset(self.0);
            let mut all = Vec::new();
            for (y, depth) in self.1.rows().enumerate() {
                row.warp(self.0, self.2, y, depth, &[], &mut landed);
                all.extend_from_slice(&landed);
            }
            all
        }
    }
    let baseline = simd::run_at(Level::BASELINE, Rows(&plan, &depth, &random));
    for level in Level::available() {
        assert_eq!(
            simd::run_at(level, Rows(&plan, &depth, &random)),
            baseline,
            "{level:?}"
        );
    }
}

#[test]
fn batches_match_single_images() {
    let (sensor, stream) = (sensor(oak_d_pro()), Stream::new(4, "env"));
    let items: Vec<Image<f32>> = (0..20)
        .map(|i| {
            image(106, 60, |x, y| {
                1.0 + ((x + i * 9) % 50) as f32 * 0.03 + y as f32 * 0.01
            })
        })
        .collect();
    let depth: Vec<f32> = items.iter().flat_map(|item| item.pixels().to_vec()).collect();
    let mut all = vec![0.0; depth.len()];
    sensor
        .sense_batch(&depth, [20, 60, 106], 3, 100, &stream, &mut all)
        .unwrap();
    for (i, item) in (0u32..).zip(&items) {
        let mut shot = DepthShot::new(item.into());
        (shot.frame, shot.item) = (3, 100 + i);
        let one = sensor.sense(&shot, &stream, Wanted::default());
        let at = i as usize * 6360;
        assert_eq!(one.distance.0.pixels(), &all[at..at + 6360]);
    }
    // The same batch in two halves, the second one first.
    let mut halves = vec![0.0; depth.len()];
    let (first, second) = halves.split_at_mut(10 * 6360);
    sensor
        .sense_batch(&depth[10 * 6360..], [10, 60, 106], 3, 110, &stream, second)
        .unwrap();
    sensor
        .sense_batch(&depth[..10 * 6360], [10, 60, 106], 3, 100, &stream, first)
        .unwrap();
    assert_eq!(all, halves);
}

#[test]
fn accepts_empty_batches_and_rejects_wrong_lengths() {
    let (sensor, stream) = (sensor(oak_d_pro()), Stream::new(4, "env"));
    for shape in [[0, 60, 106], [3, 0, 5], [3, 5, 0]] {
        sensor.sense_batch(&[], shape, 0, 0, &stream, &mut []).unwrap();
    }
    let error = sensor.sense_batch(&[1.0; 5], [1, 2, 3], 0, 0, &stream, &mut [0.0; 6]);
    assert_eq!(
        error.unwrap_err().to_string(),
        "the depth of a batch of shape [1, 2, 3] has 5 numbers; give a C-contiguous array of that shape"
    );
    let overflow = [usize::MAX, usize::MAX, 2];
    assert!(sensor.sense_batch(&[], overflow, 0, 0, &stream, &mut []).is_err());
}

#[test]
fn accepts_empty_and_tiny_images() {
    for (width, height) in [(0, 0), (0, 7), (7, 0), (1, 1), (1, 9), (2, 1), (9, 1)] {
        let depth = image(width, height, |_, _| 5.0);
        let seen = distance(oak_d_pro(), &depth, 0);
        assert_eq!((seen.width(), seen.height()), (width, height));
        // A disparity below half a pixel moves nothing.
        assert_eq!(bits(&distance(quiet(), &depth, 0)), bits(&depth));
    }
}

proptest! {
    #[test]
    fn reports_only_depths_of_the_same_row(
        depth in proptest::collection::vec(prop_oneof![any::<f32>(), 0.5f32..13.0], 3 * 70),
        baseline in prop_oneof![-200.0..-0.1, 0.1..200.0],
        sigma in 0.0..5.0,
        frame: u64,
    ) {
        let depth = Image::new(70, 3, depth).unwrap();
        let parameters = Parameters { baseline_mm: baseline, noise_sigma_px: sigma, ..oak_d_pro() };
        let seen = distance(parameters, &depth, frame);
        for (seen, row) in seen.rows().zip(depth.rows()) {
            for &z in seen.iter().filter(|&&z| z != 0.0) {
                prop_assert!((0.6..=12.0).contains(&z) && row.contains(&z), "{z}");
            }
        }
    }
}
