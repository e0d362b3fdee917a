use oaktwin_simd::Level;

use super::*;
use crate::BatchEngine as _;
use crate::time_of_flight::sense::{Job, Scratch};

/// Every loop in it.
fn everything() -> Parameters {
    Parameters {
        enable_fppn_correction: false,
        enable_wiggle_correction: false,
        enable_burst_mode: true,
        multipath: 1.0,
        radial_velocity_m_s: -0.5,
        principal_point_px: Some([300.0, 260.0]),
        confidence_threshold: 3.0,
        ..Parameters::new(457.0, 640)
    }
}

fn plain() -> Parameters {
    Parameters::new(457.0, 640)
}

fn picture(width: u32, height: u32) -> Image<[u8; 4]> {
    let pixels = (0..width * height).map(|i| {
        let level = (i.wrapping_mul(2_654_435_761) >> 24) as u8;
        [level, level / 2, level, 255]
    });
    Image::new(width, height, pixels.collect()).unwrap()
}

#[test]
fn all_instruction_sets_give_the_same_bytes() {
    for (width, height) in [(640, 60), (106, 60), (257, 33), (3, 70), (1, 5), (5, 1), (1, 1)] {
        let (depth, rgb) = (room(width, height), picture(width, height));
        for p in [plain(), everything()] {
            let sensor = sensor(p);
            let shot = shot(&depth, 2).with_rgb((&rgb).into()).unwrap();
            let expected = sensor.output(&shot, &random());
            for level in Level::available() {
                let mut rows = Vec::new();
                let job = Job::new(&sensor, &shot, &random()).at(level);
                job.rows(&mut Scratch::default(), 0, height as usize, |row| {
                    let (mut metres, mut others) = (vec![0.0; width as usize], Vec::new());
                    row.metres(&mut metres);
                    others.extend_from_slice(row.amplitude);
                    others.extend_from_slice(row.confidence);
                    rows.push((metres, others));
                });
                let metres: Vec<f32> = rows.iter().flat_map(|row| row.0.clone()).collect();
                assert!(metres == expected.distance.0.pixels(), "{level:?}");
                for (y, (_, others)) in rows.iter().enumerate() {
                    let row = y * width as usize..(y + 1) * width as usize;
                    let of = [
                        &expected.amplitude.pixels()[row.clone()],
                        &expected.confidence.pixels()[row],
                    ];
                    assert_eq!(*others, of.concat(), "{level:?}");
                }
            }
        }
    }
}

#[test]
fn threads_and_outputs_do_not_matter() {
    let depth = room(320, 300);
    let sensor = sensor(everything());
    let all: Vec<ZDepth> = [1, 2, 8]
        .iter()
        .map(|&threads| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| sensor.sense(&shot(&depth, 1), &random()))
        })
        .collect();
    assert!(all[0] == all[1] && all[0] == all[2]);
    assert!(all[0] == sensor.output(&shot(&depth, 1), &random()).distance);
    let measured = all[0].0.pixels().iter().filter(|&&z| z > 0.0).count();
    assert!(measured > 50_000);
}

#[test]
fn a_batch_is_its_images_one_by_one() {
    let images: Vec<Image<f32>> = (0..9u8)
        .map(|item| room(106, 70).map(|&z| z + 0.1 * f32::from(item)))
        .collect();
    let depth: Vec<f32> = images.iter().flat_map(|image| image.pixels().to_vec()).collect();
    for p in [plain(), everything()] {
        let sensor = sensor(p);
        let batch = |threads| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            let mut out = vec![-1.0; depth.len()];
            let sensed =
                pool.install(|| sensor.sense_batch(&depth, [9, 70, 106], 11, 5, &random(), &mut out));
            sensed.unwrap();
            out
        };
        let out = batch(1);
        assert!([2, 16].iter().all(|&threads| out == batch(threads)));
        for (item, image) in (0..9u32).zip(&images) {
            let mut shot = shot(image, 11);
            shot.item = 5 + item;
            let alone = sensor.sense(&shot, &random());
            assert!(out[item as usize * 7420..][..7420] == *alone.0.pixels());
        }
    }
}

#[test]
fn what_is_no_surface_is_not_measured() {
    let depth = room(200, 100);
    let found = sense(plain(), &depth);
    for (&z, &found) in depth.pixels().iter().zip(found.0.pixels()) {
        if !(z > 0.0 && z <= 1e4) {
            assert_eq!(found, 0.0, "{z}");
        }
        let millimetres = f64::from(found) * 1000.0;
        assert!((millimetres - millimetres.round()).abs() < 1e-3 && found < 7.6);
    }
}
