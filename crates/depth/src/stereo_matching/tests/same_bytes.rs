use oaktwin_simd::Level;

use super::{changed, pair, step};
use crate::stereo_matching::StereoMatching;

const SETTINGS: [&[(&str, &str)]; 10] = [
    &[],
    &[("paths", "8"), ("subpixelInterpolation", "PARABOLA")],
    &[("subpixelInterpolation", "PARABOLA_5")],
    &[("penaltyShift", "0"), ("paths", "5"), ("divisionFactor", "3")],
    &[
        ("kernelSize", "KERNEL_7x9"),
        ("kernelMask", "0xFFFFFFFFFFFFFFFF"),
        ("paths", "8"),
    ],
    &[
        ("enableCompanding", "true"),
        ("kernelSize", "KERNEL_7x7"),
        ("alpha", "9"),
    ],
    &[
        ("platform", "RVC4"),
        ("enableMeanMode", "false"),
        ("extendedDisparity", "true"),
    ],
    &[
        ("disparityWidth", "DISPARITY_64"),
        ("paths", "3"),
        ("blockRows", "1"),
    ],
    &[
        ("platform", "RVC4"),
        ("holeFilling.fillConfidenceThreshold", "251"),
        ("holeFilling.minValidDisparity", "3"),
        ("adaptiveMedianFilter.confidenceThreshold", "255"),
        ("confidenceThreshold", "0"),
    ],
    &[
        ("platform", "RVC4"),
        ("leftRightCheck", "false"),
        ("holeFilling.invalidateDisparities", "false"),
        ("subpixelFractionalBits", "3"),
    ],
];

#[test]
fn does_not_depend_on_instructions_or_threads() {
    let images = step(333, 41, 7.3, 30.6, 120.0, 200.0);
    let pair = pair(&images);
    for settings in SETTINGS {
        let engine = StereoMatching::new(changed(settings)).unwrap();
        let first = engine.disparity(&pair);
        assert!(first.disparity.pixels().iter().any(|&d| d > 0), "{settings:?}");
        for level in Level::available() {
            assert!(
                engine.disparity_at(level, &pair, false).matched == first,
                "{settings:?} {level:?}"
            );
        }
        for threads in [1, 2, 5] {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            let again = pool.install(|| engine.disparity(&pair));
            assert!(again == first, "{settings:?} {threads}");
        }
    }
}

/// The reused memory does not leak from one pair into the next.
#[test]
fn does_not_depend_on_previous_pairs() {
    let (large, small) = (
        step(333, 41, 7.3, 30.6, 120.0, 200.0),
        step(101, 12, 3.0, 9.5, 40.0, 60.0),
    );
    for settings in SETTINGS {
        let engine = StereoMatching::new(changed(settings)).unwrap();
        let first = engine.disparity(&pair(&small));
        let _ = engine.disparity(&pair(&large));
        assert!(engine.disparity(&pair(&small)) == first, "{settings:?}");
        let copy = engine.clone();
        assert!(copy.disparity(&pair(&small)) == first && copy == engine);
    }
}
