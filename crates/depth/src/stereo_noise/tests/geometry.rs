use super::*;
use crate::preset::Platform;
use crate::stereo_noise::{DepthRounding, Subpixel};

/// Near from column `from` up to, not with, `to`; far elsewhere.
fn step(width: u32, (from, to): (u32, u32), near: f32, far: f32) -> Image<f32> {
    let row = (0..width).map(|x| if (from..to).contains(&x) { near } else { far });
    let rows: Vec<f32> = std::iter::repeat_n(row.collect::<Vec<_>>(), 3)
        .flatten()
        .collect();
    Image::new(width, 3, rows).unwrap()
}

/// The columns of the middle row where nothing was measured.
fn lost(distance: &ZDepth) -> Vec<usize> {
    let row = distance
        .0
        .pixels()
        .chunks_exact(distance.0.width() as usize)
        .nth(1)
        .unwrap();
    (0..row.len()).filter(|&x| row[x] == 0.0).collect()
}

#[test]
fn a_shadow_lies_left_of_near_things_and_is_as_wide_as_disparities_differ() {
    // 60 and 20 px: the band is 40 px; the left band, 20 px.
    let depth = step(1280, (600, 900), 1.0, 3.0);
    let expected: Vec<usize> = (0..20).chain(560..600).collect();
    assert_eq!(lost(&sense(exact(), &depth)), expected);

    // Of an image half as wide, half as many.
    let depth = step(640, (300, 450), 1.0, 3.0);
    let expected: Vec<usize> = (0..10).chain(280..300).collect();
    assert_eq!(lost(&sense(exact(), &depth)), expected);

    // Of one of 106 px: 40 · 106 / 1280 = 3.3, 20 · 106 / 1280 = 1.7 px.
    let depth = step(106, (50, 70), 1.0, 3.0);
    assert_eq!(lost(&sense(exact(), &depth)), vec![0, 1, 47, 48, 49]);

    let p = Parameters {
        occlusion: false,
        ..exact()
    };
    assert!(lost(&sense(p, &depth)).is_empty());
}

#[test]
fn between_a_thin_pole_and_its_shadow_the_wall_is_seen() {
    // The pole is 6 px wide, its shadow lies 40 px on its left.
    let depth = step(1280, (600, 606), 1.0, 3.0);
    let expected: Vec<usize> = (0..20).chain(560..566).collect();
    assert_eq!(lost(&sense(exact(), &depth)), expected);
}

#[test]
fn a_thing_nearer_than_the_range_hides_too() {
    // 120 px: nothing is measured there, and 100 px of the wall are hidden.
    let depth = step(1280, (600, 900), 0.5, 3.0);
    let expected: Vec<usize> = (0..20).chain(500..900).collect();
    assert_eq!(lost(&sense(exact(), &depth)), expected);
}

#[test]
fn a_slope_hides_nothing() {
    // From 60 to 20 px of disparity within 60 px.
    let row: Vec<f32> = (0..1280)
        .map(|x| 60.0 / (20.0 + 40.0 * (f64::from((x - 600).clamp(0, 60)) / 60.0)) as f32)
        .collect();
    let depth = Image::new(1280, 1, row).unwrap();
    let distance = sense(exact(), &depth);
    assert!(distance.0.pixels()[20..].iter().all(|&z| z > 0.0));
}

#[test]
fn the_nearest_and_the_farthest() {
    let measured = |p: Parameters, z: f32| sense(p, &Image::filled(400, 1, z)).0.pixels()[399];
    // f·b = 60 px·m: 95 px are 0.6316 m.
    assert_eq!(measured(exact(), 0.631), 0.0);
    assert_eq!(measured(exact(), 0.632), 0.632);
    let extended = Parameters {
        extended_disparity: true,
        ..exact()
    };
    assert_eq!(measured(extended, 0.315), 0.0);
    assert_eq!(measured(extended, 0.316), 0.316);
    // 10 px farther: nearer, but 10 px and less are not found.
    let shifted = Parameters {
        disparity_shift_px: 10,
        ..exact()
    };
    assert_eq!(measured(shifted, 0.571), 0.0);
    assert_eq!(measured(shifted, 0.572), 0.572);
    assert_eq!(measured(shifted, 5.9), 5.908);
    assert_eq!(measured(shifted, 6.1), 0.0);
    // One step is 1920 m, more than 16 bits of millimetres; 30 steps are 64 m.
    assert_eq!(measured(exact(), 1920.0), 0.0);
    assert_eq!(measured(exact(), 70.0), 0.0);
    assert_eq!(measured(exact(), 64.0), 64.0);
}

#[test]
fn steps_of_disparity() {
    for (subpixel, steps) in [
        (Subpixel::Off, 1.0),
        (Subpixel::Bits3, 8.0),
        (Subpixel::Bits4, 16.0),
        (Subpixel::Bits5, 32.0),
    ] {
        let p = Parameters { subpixel, ..exact() };
        for z in [0.7, 1.1, 2.3, 4.7, 9.1f32] {
            let depth = Image::filled(300, 1, z);
            let expected = (60.0 / f64::from(z) * steps).round();
            assert_eq!(f64::from(disparity(p, &depth).pixels()[299]), expected);
            let metres = (60.0 / (expected / steps) * 1000.0).round() / 1000.0;
            assert_eq!(sense(p, &depth).0.pixels()[299], metres as f32);
        }
    }
    let truncated = Parameters {
        depth_rounding: DepthRounding::Truncate,
        ..exact()
    };
    // 60 / (1828 / 32) m are 1050.33 mm, 60 / (1829 / 32) m are 1049.75 mm.
    let depth = Image::filled(300, 1, 60.0 * 32.0 / 1829.0);
    assert_eq!(sense(truncated, &depth).0.pixels()[299], 1.049);
    assert_eq!(sense(exact(), &depth).0.pixels()[299], 1.050);
}

#[test]
fn near_things_grow_and_the_check_loses_a_band_beyond_the_shadow() {
    let p = Parameters {
        edge_dilation_px: 3.0,
        ..exact()
    };
    let depth = step(1280, (600, 900), 1.0, 3.0);
    let distance = sense(p, &depth);
    // 3 px of the shadow are covered on the right, 3 px more are lost on its left.
    let expected: Vec<usize> = (0..20).chain(557..597).collect();
    assert_eq!(lost(&distance), expected);
    let row = &distance.0.pixels()[1280..2560];
    assert!(row[597..903].iter().all(|&z| z == 1.0) && row[903] == 3.0);

    let unchecked = Parameters {
        left_right_check: false,
        ..p
    };
    let expected: Vec<usize> = (0..20).chain(560..597).collect();
    assert_eq!(lost(&sense(unchecked, &depth)), expected);
    // They differ by 40 px.
    for (threshold, first) in [(39, 557), (41, 560)] {
        let p = Parameters {
            left_right_check_threshold_px: threshold,
            ..p
        };
        assert_eq!(lost(&sense(p, &depth))[20], first);
    }

    // Up and down too.
    // An image half as wide, half as far: 1.5 px are 2.
    for (width, count) in [(1280, 49), (640, 25)] {
        let mut spot = Image::filled(width, 21, 3.0f32);
        spot.pixels_mut()[(10 * width + 300) as usize] = 1.0;
        let distance = sense(p, &spot);
        assert_eq!(distance.0.pixels().iter().filter(|&&z| z == 1.0).count(), count);
    }
}

#[test]
fn columns_at_the_left_border_are_lost() {
    let p = Parameters {
        invalid_edge_px: 50,
        ..exact()
    };
    let lost_of = |width| lost(&sense(p, &Image::filled(width, 3, 3.0f32))).len();
    assert_eq!((lost_of(1280), lost_of(640)), (50, 25));
    assert_eq!(lost(&sense(p, &Image::filled(20, 3, 3.0f32))), vec![0]);
}

#[test]
fn what_is_no_surface_is_not_measured() {
    let nothing = [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        0.0,
        -0.0,
        -3.0,
        1e-30,
        1e-45,
        1e-3,
    ];
    for z in nothing {
        let mut depth = Image::filled(128, 2, 3.0f32);
        depth.pixels_mut()[100] = z;
        let distance = sense(Parameters::new(Platform::Rvc2, STEREO, 1280), &depth);
        assert_eq!(distance.0.pixels()[100], 0.0, "{z}");
        // And hides at most what is left of it.
        assert!(distance.0.pixels()[101..128].iter().all(|&z| z > 2.8));
        assert!(distance.0.pixels()[60..100].iter().all(|&z| z > 2.8), "{z}");
    }
}

#[test]
fn images_of_no_and_of_one_pixel() {
    for (width, height) in [(0, 0), (0, 5), (5, 0), (1, 1), (1, 9), (9, 1), (65, 1)] {
        let depth = Image::filled(width, height, 3.0f32);
        for p in [
            Parameters::new(Platform::Rvc2, STEREO, 1280),
            Parameters {
                edge_dilation_px: 3.0,
                ..Parameters::new(Platform::Rvc2, STEREO, 9)
            },
        ] {
            let rgb = Image::filled(width, height, [9u8; 4]);
            let shot = shot(&depth, 0).with_rgb((&rgb).into()).unwrap();
            let distance = sensor(p).sense(&shot, &random());
            assert_eq!((distance.0.width(), distance.0.height()), (width, height));
        }
    }
    let far = Image::filled(1, 1, 3.0f32);
    let p = Parameters {
        occlusion: false,
        ..exact()
    };
    assert_eq!(sense(p, &far).0.pixels(), [3.0]);
}

#[test]
fn little_texture_is_lost() {
    // Stripes along the row on the left, along the column on the right.
    let (width, height) = (256u32, 40u32);
    let rgb = Image::new(
        width,
        height,
        (0..width * height)
            .map(|i| {
                let (x, y) = (i % width, i / width);
                let bright = if x < 128 { x % 2 } else { y % 2 };
                [40 * bright as u8 + 60; 4]
            })
            .collect(),
    )
    .unwrap();
    let depth = Image::filled(width, height, 30.0f32);
    let kept = |confidence_threshold, rgb: &Image<[u8; 4]>| {
        let p = Parameters {
            confidence_threshold,
            width_px: width,
            ..exact()
        };
        let shot = shot(&depth, 0).with_rgb(rgb.into()).unwrap();
        let distance = sensor(p).sense(&shot, &random());
        distance.0.pixels().iter().map(|&z| z > 0.0).collect::<Vec<_>>()
    };
    let row = |kept: &[bool], y: usize| kept[y * 256..][..256].to_vec();
    let default = kept(55, &rgb);
    for y in [0, 20, 39] {
        let row = row(&default, y);
        assert!(row[2..127].iter().all(|&kept| kept) && !row[133..].contains(&true));
    }
    assert!(row(&kept(0, &rgb), 5)[2..].iter().all(|&kept| kept));
    // One grey level is a confidence of 72: a picture of steps of 1 grey level.
    let steps = rgb.map(|&[level, ..]| [level / 40 + 60; 4]);
    assert_eq!(row(&kept(72, &steps), 20)[2..123], [true; 121]);
    assert_eq!(row(&kept(73, &steps), 20)[2..123], [false; 121]);
    // Without a picture nothing is.
    assert!(sense(exact(), &depth).0.pixels()[2..256].iter().all(|&z| z > 0.0));
}
