use super::*;
use crate::BatchEngine as _;
use crate::preset::Platform;
use crate::random::Stream;
use crate::stereo_noise::sense::{Job, Scratch};
use oaktwin_simd::Level;
use proptest::prelude::*;

/// Every loop in it.
fn everything(width_px: u32) -> Parameters {
    Parameters {
        bias_px: -0.22,
        edge_dilation_px: 2.0,
        dropout: 0.02,
        dot_contrast: 0.5,
        disparity_shift_px: 2,
        invalid_edge_px: 5,
        ..Parameters::new(Platform::Rvc2, STEREO, width_px)
    }
}

fn picture(width: u32, height: u32) -> Image<[u8; 4]> {
    let pixels = (0..width * height).map(|i| {
        let level = (i.wrapping_mul(2_654_435_761) >> 24) as u8 / if i % width < width / 2 { 32 } else { 64 };
        [level, level, level / 2, 255]
    });
    Image::new(width, height, pixels.collect()).unwrap()
}

#[test]
fn all_instruction_sets_give_the_same_bytes() {
    for (width, height, of) in [(1280, 90, 1280), (106, 60, 1280), (257, 33, 640), (3, 70, 640)] {
        let (depth, rgb) = (room(width, height), picture(width, height));
        for p in [Parameters::new(Platform::Rvc2, STEREO, of), everything(of)] {
            let sensor = sensor(p);
            let shot = shot(&depth, 2).with_rgb((&rgb).into()).unwrap();
            let expected = sensor.disparity(&shot, &random());
            assert!(width < 100 || expected.pixels().iter().filter(|&&fixed| fixed > 0).count() > 100);
            for level in Level::available() {
                let mut out = vec![0; depth.pixels().len()];
                let job = Job::new(&sensor, &shot, &random()).at(level);
                job.rows(&mut Scratch::default(), 0, &mut out, |fixed, _, out| {
                    out.copy_from_slice(fixed);
                });
                assert!(out == expected.pixels(), "{level:?}");
            }
        }
    }
}

#[test]
fn threads_do_not_matter() {
    let depth = room(640, 300);
    let sensor = sensor(everything(640));
    let all: Vec<Image<u16>> = [1, 2, 8]
        .iter()
        .map(|&threads| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| sensor.disparity(&shot(&depth, 1), &random()))
        })
        .collect();
    assert!(all[0] == all[1] && all[0] == all[2]);
}

#[test]
fn depth_is_of_the_disparities() {
    for p in [Parameters::new(Platform::Rvc2, STEREO, 1280), everything(640)] {
        let (sensor, depth) = (sensor(p), room(700, 80));
        let shot = shot(&depth, 4);
        let disparity = sensor.disparity(&shot, &random());
        let distance = sensor.sense(&shot, &random());
        assert!(distance == sensor.depth(&disparity, 1.0));
        // Filters may work on finer units.
        assert!(distance == sensor.depth(&disparity.map(|&fixed| fixed * 2), 2.0));
        for (&z, &fixed) in distance.0.pixels().iter().zip(disparity.pixels()) {
            assert_eq!(z > 0.0, fixed > 0);
            let millimetres = f64::from(z) * 1000.0;
            assert!((millimetres - millimetres.round()).abs() < 1e-2);
        }
    }
}

#[test]
fn a_batch_is_its_images_one_by_one() {
    let (width, height, count) = (106u32, 70u32, 9u32);
    let images: Vec<Image<f32>> = (0..count)
        .map(|item| room(width, height).map(|&z| z + 0.1 * item as f32))
        .collect();
    let depth: Vec<f32> = images.iter().flat_map(|image| image.pixels().to_vec()).collect();
    let (shape, pixels) = ([9, 70, 106], 7420);
    for p in [Parameters::new(Platform::Rvc2, STEREO, 1280), everything(640)] {
        let sensor = sensor(p);
        let batch = |threads| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            let mut out = vec![-1.0; depth.len()];
            let sensed = pool.install(|| sensor.sense_batch(&depth, shape, 11, 5, &random(), &mut out));
            sensed.unwrap();
            out
        };
        let out = batch(1);
        // Sixteen threads share images.
        assert!([2, 8, 16].iter().all(|&threads| out == batch(threads)));
        // In any order.
        for item in (0..count).rev() {
            let mut shot = shot(&images[item as usize], 11);
            shot.item = 5 + item;
            let alone = sensor.sense(&shot, &random());
            assert!(out[item as usize * pixels..][..pixels] == *alone.0.pixels());
        }
    }
    // Items have their own noise.
    let sensor = sensor(Parameters::new(Platform::Rvc2, STEREO, 1280));
    let (flat, mut out) = (vec![3.0; 2 * pixels], vec![0.0; 2 * pixels]);
    sensor
        .sense_batch(&flat, [2, 70, 106], 0, 0, &random(), &mut out)
        .unwrap();
    assert_ne!(out[..pixels], out[pixels..]);
}

#[test]
fn a_batch_that_does_not_fit() {
    let sensor = sensor(Parameters::new(Platform::Rvc2, STEREO, 1280));
    let mut out = [1.0; 11];
    let error = sensor
        .sense_batch(&[2.0; 12], [1, 3, 4], 0, 0, &random(), &mut out)
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "the result of a batch of shape [1, 3, 4] has 11 numbers; give a C-contiguous array of that shape"
    );
    assert_eq!(out, [1.0; 11]);
    let overflow = [usize::MAX, usize::MAX, 2];
    assert!(
        sensor
            .sense_batch(&[], overflow, 0, 0, &random(), &mut [])
            .is_err()
    );
    for empty in [[0, 3, 4], [3, 0, 4], [3, 4, 0]] {
        sensor.sense_batch(&[], empty, 0, 0, &random(), &mut []).unwrap();
    }
}

#[test]
fn no_frame_depends_on_an_earlier_one() {
    let (first, second) = (room(320, 100), room(320, 100).map(|&z| 1.1 * z));
    let sensor = sensor(everything(640));
    let after = {
        let _ = sensor.sense(&shot(&first, 0), &random());
        sensor.sense(&shot(&second, 1), &random())
    };
    assert!(after == sensor.sense(&shot(&second, 1), &random()));
    assert!(after != sensor.sense(&shot(&second, 2), &random()));
    assert!(after != sensor.sense(&shot(&second, 1), &Stream::new(8, "camera")));
    assert!(after != sensor.sense(&shot(&second, 1), &Stream::new(7, "other")));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Blocks and running bounds against every pair of pixels.
    #[test]
    fn shadows_are_those_of_every_pair(
        disparities in proptest::collection::vec(
            prop_oneof![3 => 0.0..90.0f32, 1 => Just(0.0f32), 6 => Just(20.0f32), 4 => Just(61.5f32)],
            1..40,
        ),
        runs in proptest::collection::vec(1usize..40, 40),
        scale in prop_oneof![Just(1.0f32), 0.05..1.5f32],
    ) {
        let row: Vec<f32> =
            disparities.iter().zip(&runs).flat_map(|(&d, &run)| std::iter::repeat_n(d, run)).collect();
        let width = row.len();
        let mut shadow = crate::stereo_noise::shadow::Shadow::default();
        let stride = width.next_multiple_of(16) + 16;
        let mut padded = row.clone();
        padded.resize(stride, 0.0);
        let columns: Vec<f32> = (0..stride).map(|x| x as f32).collect();
        let place = |x: usize| x as f32 - padded[x] * scale;
        let mut expected = vec![false; stride];
        for x in 0..stride {
            let passed = (x + 1..stride).any(|other| place(other) <= place(x));
            let covered = (x + 1..stride).any(|other| {
                let cell = place(other).floor();
                let next = place((other + 1).min(stride - 1));
                let wide = next - place(other) <= 2.0 && next.floor() - cell == 2.0;
                let there = place(x).floor();
                (there == cell || (wide && there == cell + 1.0))
                    && padded[other] * scale >= padded[x] * scale + 1.0
            });
            expected[x] = passed && covered && place(x) >= 0.0;
        }
        for level in Level::available() {
            let mut found = vec![false; stride];
            let mut hidden = Vec::new();
            let rows = crate::stereo_noise::shadow::Rows {
                columns: &columns,
                disparities: &padded,
                stride,
                image_px: scale,
            };
            shadow.find(level, rows, 1.0, &mut hidden);
            for x in hidden {
                found[x] = true;
            }
            prop_assert_eq!(&found, &expected, "{:?}", level);
        }
    }
}
