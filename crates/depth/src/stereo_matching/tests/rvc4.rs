use oaktwin_image::Image;

use super::{STEREO, image, pair, step};
use crate::preset::Platform;
use crate::stereo_matching::{Matched, Parameters, StereoMatching};

/// RVC4's defaults with some parameters changed.
fn rvc4(settings: &[(&str, &str)]) -> Parameters {
    let mut p = Parameters::new(Platform::Rvc4, STEREO, 1280);
    for (name, value) in settings {
        p.set(name, *value).unwrap();
    }
    p
}

fn matched(p: Parameters, images: &[Image<u8>; 2]) -> Matched {
    StereoMatching::new(p).unwrap().disparity(&pair(images))
}

/// A wall of disparity 10 whose middle columns have no texture, only noise that differs between the images.
fn bald(from: f64, to: f64) -> [Image<u8>; 2] {
    let texture_at = |seed: u64, moved: f64| {
        let textured = image(400, 64, |x, _| (0, x + moved));
        let noise = image(400, 64, |x, _| (seed, 7.0 * x));
        let pixels = textured.pixels().iter().zip(noise.pixels()).enumerate();
        let pixels = pixels.map(|(i, (&textured, &noise))| {
            let x = (i % 400) as f64 + moved;
            if x >= from && x < to {
                100 + noise % 4
            } else {
                textured
            }
        });
        Image::new(400, 64, pixels.collect()).unwrap()
    };
    [texture_at(5, 0.0), texture_at(6, 10.0)]
}

/// The sums of a blank wall with noise are flat: its superpixels have a low confidence, so its pixels are invalidated.
#[test]
fn invalidates_textureless_superpixels() {
    let images = bald(0.0, 1000.0);
    let kept = |matched: &Matched| {
        let pixels = matched.disparity.pixels();
        pixels.iter().filter(|&&d| d > 0).count() as f64 / pixels.len() as f64
    };
    let plain = rvc4(&[
        ("holeFilling.enable", "false"),
        ("adaptiveMedianFilter.enable", "false"),
    ]);
    let (with, without) = (kept(&matched(rvc4(&[]), &images)), kept(&matched(plain, &images)));
    println!("kept {with:.3}, without holes {without:.3}");
    assert!(with < 0.1 && with < without / 4.0, "{with} {without}");
}

/// A hole narrower than half of a superpixel takes the disparity around it.
#[test]
fn fills_small_holes() {
    let images = bald(203.0, 205.0);
    let all = [
        ("flatnessConfidenceThreshold", "7"),
        ("holeFilling.highConfidenceThreshold", "150"),
        ("holeFilling.fillConfidenceThreshold", "255"),
        ("holeFilling.minValidDisparity", "3"),
        ("adaptiveMedianFilter.enable", "false"),
    ];
    let filled = matched(rvc4(&all), &images);
    let near = filled.disparity.pixels().chunks(400).skip(8).take(48);
    let near: Vec<f64> = near
        .flat_map(|row| &row[150..260])
        .map(|&d| f64::from(d) / 32.0)
        .collect();
    assert!(near.iter().all(|d| (d - 10.0).abs() < 0.5), "{near:?}");
}

#[test]
fn confidence_is_the_weighted_mean() {
    let images = step(400, 40, 10.0, 40.0, 150.0, 250.0);
    let of = |settings: &[(&str, &str)]| matched(rvc4(settings), &images).confidence;
    let weights = |o, m, f| {
        [
            ("occlusionConfidenceWeight", o),
            ("motionVectorConfidenceWeight", m),
            ("flatnessConfidenceWeight", f),
        ]
    };
    let [occlusion, motion, flatness] = [
        of(&weights("32", "0", "0")),
        of(&weights("0", "32", "0")),
        of(&weights("0", "0", "32")),
    ];
    let all = of(&[]);
    let alone = occlusion
        .pixels()
        .iter()
        .zip(motion.pixels())
        .zip(flatness.pixels());
    for (((&o, &m), &f), &all) in alone.zip(all.pixels()) {
        assert!(o == 0 || o == 255);
        let mean = (20 * u32::from(o) + 4 * u32::from(m) + 8 * u32::from(f)) >> 5;
        assert_eq!(u32::from(all), mean);
    }
    assert_eq!(of(&[("flatnessOverride", "true")]), flatness);
    // The area behind the step is occluded in the right image.
    let hidden = |row: usize| (115..145).map(move |x| row * 400 + x);
    let is_hidden = (10..30)
        .flat_map(hidden)
        .filter(|&at| occlusion.pixels()[at] == 0);
    assert!(is_hidden.count() > 400);
    // A larger scale of the variance lowers the confidence more.
    let steady = |threshold| {
        let alone = weights("0", "32", "0");
        of(&[
            alone.as_slice(),
            &[("motionVectorConfidenceThreshold", threshold)],
        ]
        .concat())
    };
    let (least, most) = (steady("0"), steady("3"));
    let pixels = least.pixels().iter().zip(most.pixels());
    assert!(pixels.clone().all(|(least, most)| least >= most));
    assert!(pixels.clone().any(|(least, most)| least > most));
}

#[test]
fn rvc4_parameters_have_no_effect_on_rvc2() {
    let images = step(333, 41, 7.3, 30.6, 120.0, 200.0);
    let plain = matched(super::parameters(), &images);
    let set = super::changed(&[
        ("occlusionConfidenceWeight", "0"),
        ("flatnessOverride", "true"),
        ("flatnessConfidenceThreshold", "7"),
        ("holeFilling.fillConfidenceThreshold", "255"),
        ("adaptiveMedianFilter.confidenceThreshold", "255"),
    ]);
    assert_eq!(matched(set, &images), plain);
}
