use super::super::pyramid::Pyramid;
use super::super::tone::Encoder;
use super::*;
use oaktwin_simd::{Level, run_lanes_at};

const REPEAT: Wraps = Wraps {
    s: Wrap::Repeat,
    t: Wrap::Repeat,
};

fn numbered() -> Image<[u8; 4]> {
    // Columns in red, rows from the top in green.
    let pixels = (0..6u8).flat_map(|y| (0..8u8).map(move |x| [x * 30, y * 40, 7, 255]));
    Image::new(8, 6, pixels.collect()).unwrap()
}

fn filtered(pyramid: &Pyramid, at: [f32; 2], across: [f32; 2], down: [f32; 2], wraps: Wraps) -> [f32; 3] {
    let mut footprints = Footprints::default();
    footprints.set(3, at, across, down);
    let all = Level::available().into_iter().map(|level| {
        let colors = pyramid.filtered(level, &footprints, wraps, 1 << 3);
        assert!(colors.iter().all(|channel| channel[4] == 0.0));
        colors.map(|channel| channel[3])
    });
    let all: Vec<_> = all.collect();
    assert!(all.iter().all(|color| *color == all[0]), "{all:?}");
    all[0]
}

fn bytes(color: [f32; 3]) -> [u8; 3] {
    color.map(|value| Encoder::new().srgb(value))
}

#[test]
fn full_size_returns_the_texels() {
    let image = numbered();
    let pyramid = Pyramid::new(image.clone(), true);
    for y in 0..6u8 {
        for x in 0..8u8 {
            let at = [(f32::from(x) + 0.5) / 8.0, 1.0 - (f32::from(y) + 0.5) / 6.0];
            let color = filtered(&pyramid, at, [1.0 / 8.0, 0.0], [0.0, 1.0 / 6.0], REPEAT);
            let [r, g, b, _] = *image.get(x.into(), y.into()).unwrap();
            assert_eq!(bytes(color), [r, g, b]);
        }
    }
}

#[test]
fn distant_textures_are_averaged() {
    // Seven columns, which is not a multiple of two, alternately black and white.
    let pixels = (0..7 * 5).map(|i| if i % 7 % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] });
    let pyramid = Pyramid::new(Image::new(7, 5, pixels.collect()).unwrap(), true);
    let far = filtered(&pyramid, [0.3, 0.3], [2.0, 0.0], [0.0, 2.0], REPEAT);
    assert!((far[0] - 4.0 / 7.0).abs() < 0.01, "{far:?}");
    // At a grazing angle only one direction is filtered.
    let pixels = (0..64 * 64).map(|i| if i / 64 % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] });
    let stripes = Pyramid::new(Image::new(64, 64, pixels.collect()).unwrap(), true);
    let row = [0.5, 1.0 - 10.5 / 64.0];
    let along = filtered(&stripes, row, [4.0 / 64.0, 0.0], [0.0, 1.0 / 64.0], REPEAT);
    assert!(along[0] > 0.99, "{along:?}");
    let across = filtered(&stripes, row, [0.0, 4.0 / 64.0], [1.0 / 64.0, 0.0], REPEAT);
    assert!((across[0] - 0.5).abs() < 0.01, "{across:?}");
}

#[test]
fn wrap_modes() {
    let at = |wrap: Wrap, x| wrap.index(x, 4);
    assert_eq!(
        [-1, 4, 9].map(|x| at(Wrap::Repeat, x)),
        [Some(3), Some(0), Some(1)]
    );
    assert_eq!(
        [-1, 4, 9].map(|x| at(Wrap::Mirror, x)),
        [Some(0), Some(3), Some(1)]
    );
    assert_eq!(
        [-9, 4, 9].map(|x| at(Wrap::Clamp, x)),
        [Some(0), Some(3), Some(3)]
    );
    assert_eq!([-1, 2, 4].map(|x| at(Wrap::Black, x)), [None, Some(2), None]);
}

#[test]
fn non_finite_coordinates_give_finite_colours() {
    let pyramid = Pyramid::new(numbered(), false);
    for odd in [f32::NAN, f32::INFINITY, 1e30, -1e30] {
        for wraps in [
            REPEAT,
            Wraps {
                s: Wrap::Mirror,
                t: Wrap::Clamp,
            },
        ] {
            let color = filtered(&pyramid, [odd; 2], [odd; 2], [0.0; 2], wraps);
            assert!(color.iter().all(|value| value.is_finite()), "{odd}");
            let color = filtered(&pyramid, [0.5; 2], [odd; 2], [0.0; 2], wraps);
            assert!(color.iter().all(|value| value.is_finite()), "{odd}");
        }
    }
}

#[test]
fn bytes_are_decoded_within_a_sixteenth_of_a_step() {
    struct Decoded([f32; 8]);
    impl LaneKernel for Decoded {
        type Output = [f32; 8];

        #[inline(always)]
        fn run<L: Lanes>(self) -> [f32; 8] {
            linear_from_srgb_byte(L::load(&self.0)).to_array()
        }
    }
    let exact = oaktwin_image::srgb::linear_from_srgb();
    for level in Level::available() {
        for byte in 0..=255u8 {
            let at = usize::from(byte);
            let decoded = run_lanes_at(level, Decoded([f32::from(byte); 8]))[0];
            let step = exact[at.max(1)] - exact[at.max(1) - 1];
            assert!((decoded - exact[at]).abs() <= step / 16.0, "{byte}: {decoded}");
        }
    }
}

#[test]
fn logarithms() {
    struct Logs([f32; 8]);
    impl LaneKernel for Logs {
        type Output = [f32; 8];

        #[inline(always)]
        fn run<L: Lanes>(self) -> [f32; 8] {
            log2(L::load(&self.0)).to_array()
        }
    }
    for level in Level::available() {
        let logs = run_lanes_at(level, Logs([1.0, 2.0, 3.0, 1024.0, 1.0, 1.0, 1.0, 1.0]));
        assert_eq!(logs[..4], [0.0, 1.0, 1.5, 10.0]);
    }
}
