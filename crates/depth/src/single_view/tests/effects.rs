use super::*;

/// Returns the runs of equal values in a row: value and length.
fn runs(row: &[f32]) -> Vec<(f32, usize)> {
    let mut runs: Vec<(f32, usize)> = Vec::new();
    for &z in row {
        match runs.last_mut() {
            Some((value, length)) if *value == z => *length += 1,
            _ => runs.push((z, 1)),
        }
    }
    runs
}

/// b·f·W/S, px·m.
const PX_M: f32 = 0.075 * 805.0;

#[test]
fn objects_move_by_their_disparity_and_leave_holes_on_the_left() {
    // 15.09 px at 4 m, 40.25 px at 1.5 m.
    let depth = step(1280, 1.5, 500, 700);
    let seen = distance(quiet(), &depth, 0);
    let (far, near) = ((PX_M / 4.0).round() as usize, (PX_M / 1.5).round() as usize);
    let expected = vec![
        (0.0, far),
        (4.0, 500),
        (0.0, near - far),
        (1.5, 200),
        (4.0, 1280 - 700 - near),
    ];
    for row in seen.rows() {
        assert_eq!(runs(row), expected);
    }
    // The width of the hole in closed form: W/S·b·f·(1/z₁ − 1/z₂).
    assert!(((near - far) as f32 - PX_M * (1.0 / 1.5 - 1.0 / 4.0)).abs() <= 1.0);

    let seen = distance(
        Parameters {
            baseline_mm: -75.0,
            ..quiet()
        },
        &depth,
        0,
    );
    let expected = vec![
        (4.0, 500 - near),
        (1.5, 200),
        (0.0, near - far),
        (4.0, 1280 - 700),
        (0.0, far),
    ];
    for row in seen.rows() {
        assert_eq!(runs(row), expected);
    }
}

#[test]
fn shifts_scale_with_the_width_of_the_image() {
    // The vendor's images at 1920 px show 25 to 26 px at 3.5 m and 33 to 36 px at 2.5 m.
    for (z, px) in [(3.5, 25..=26), (2.5, 33..=36)] {
        let depth = image(1920, 3, |_, _| z);
        for row in distance(quiet(), &depth, 0).rows() {
            let holes = row.iter().take_while(|&&z| z == 0.0).count();
            assert!(px.contains(&holes), "{z} m: {holes} px");
        }
    }
}

#[test]
fn disparities_are_multiples_of_noise_mean() {
    let mut recomputed = Assumptions::default();
    recomputed.set("depth", "recomputed").unwrap();
    let parameters = Parameters {
        noise_sigma_px: 0.0,
        outlier_removal_range_px: 0,
        ..oak_d_pro()
    };
    let depth = image(1280, 4, |x, _| 1.0 + x as f32 * 0.005);
    let sensor = SingleView::new(parameters, recomputed).unwrap();
    let seen = sensor.sense(
        &DepthShot::new((&depth).into()),
        &Stream::new(1, ""),
        Wanted::default(),
    );
    let mut steps = std::collections::BTreeSet::new();
    for &z in seen.distance.0.pixels().iter().filter(|&&z| z > 0.0) {
        let step = PX_M / z / 0.25;
        assert!((step - step.round()).abs() < 1e-3, "{z}");
        steps.insert(step.round() as u32);
    }
    // The disparities range from 60.4 px to 8.2 px.
    assert!(steps.len() > 180, "{}", steps.len());
    assert!(steps.iter().all(|step| (32..=242).contains(step)));
}

#[test]
fn depth_is_carried_unchanged_and_faces_keep_one_value() {
    for frame in 0..3 {
        let seen = distance(oak_d_pro(), &step(1280, 1.5, 500, 700), frame);
        assert!(seen.pixels().iter().all(|z| [0.0, 1.5, 4.0].contains(z)));
    }
}

#[test]
fn drops_samples_outside_the_distance_and_disparity_range() {
    let depths = [0.59, 0.6, 0.63, 0.64, 11.99, 12.0, 12.01, 1e6, 1e30];
    for z in depths {
        let seen = distance(quiet(), &image(1280, 1, |_, _| z), 0);
        let is_seen = (0.6..=12.0).contains(&z) && PX_M / z <= 95.0;
        assert_eq!(seen.pixels().contains(&z), is_seen, "{z}");
    }
}

#[test]
fn invalid_depths_are_not_measured() {
    for z in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.0, -0.0, -3.0, 1e-40] {
        let parameters = Parameters {
            min_distance_m: 0.0,
            ..oak_d_pro()
        };
        let seen = distance(parameters, &image(70, 9, |_, _| z), 0);
        assert!(seen.pixels().iter().all(|&z| z == 0.0), "{z}");
    }
}

#[test]
fn slanted_faces_have_holes_at_disparity_steps() {
    // The surface approaches by 0.005 m per column: disparity grows from 5.4 px by 7.2 px, and the row is stretched.
    let toward = image(400, 20, |x, _| 3.5 - x as f32 * 0.005);
    let parameters = Parameters {
        noise_sigma_px: 0.0,
        ..oak_d_pro()
    };
    let seen = distance(parameters, &toward, 0);
    let row = seen.rows().next().unwrap();
    let first = row.iter().position(|&z| z > 0.0).unwrap();
    let holes: Vec<usize> = (first..400).filter(|&x| row[x] == 0.0).collect();
    // One hole per step of disparity, in the same columns of every row; some leave the image.
    assert!((5..=7).contains(&holes.len()), "{holes:?}");
    assert!(holes.windows(2).all(|pair| pair[1] > pair[0] + 1), "{holes:?}");
    assert!(seen.rows().all(|other| other == row));
}

#[test]
fn left_edges_are_ragged_and_right_edges_have_no_hole() {
    let seen = distance(oak_d_pro(), &step(1280, 1.5, 500, 700), 4);
    let edges = |row: &[f32]| {
        let from = row.iter().position(|&z| z == 1.5).unwrap();
        let to = row.iter().rposition(|&z| z == 1.5).unwrap();
        (from, to, row[to + 4])
    };
    let all: Vec<_> = seen.rows().map(edges).collect();
    // Jitter moves whole patches: the left edge varies between rows, within 2 px of its exact column.
    let lefts: std::collections::BTreeSet<usize> = all.iter().map(|edge| edge.0).collect();
    assert!(
        lefts.len() > 1 && lefts.iter().all(|x| x.abs_diff(540) <= 2),
        "{lefts:?}"
    );
    // The wall continues without a hole to the right of the right edge.
    assert!(
        all.iter()
            .all(|&(_, to, beyond)| to.abs_diff(739) <= 2 && beyond == 4.0)
    );
}

#[test]
fn noise_mean_0_disables_jitter() {
    let parameters = Parameters {
        noise_mean_px: 0.0,
        noise_sigma_px: 50.0,
        ..oak_d_pro()
    };
    let depth = image(640, 20, |x, y| 1.0 + (x + y) as f32 * 0.003);
    assert_eq!(distance(parameters, &depth, 0), distance(parameters, &depth, 9));
    let without = Parameters {
        noise_sigma_px: 0.0,
        ..parameters
    };
    assert_eq!(distance(parameters, &depth, 0), distance(without, &depth, 0));
}

#[test]
fn jitter_has_the_set_sigma_and_is_uncorrelated_over_time() {
    // A wall with recomputed depth: the disparities of pixels that move to themselves, over several frames.
    let mut recomputed = Assumptions::default();
    recomputed.set("depth", "recomputed").unwrap();
    let parameters = Parameters {
        noise_downscale_factor_px: 1.0,
        outlier_removal_range_px: 0,
        noise_sigma_px: 0.1,
        max_distance_m: 1e7,
        ..oak_d_pro()
    };
    // A disparity of exactly 12 px rounds to 12 within 5 sigma, so that no samples collide.
    let depth = image(106, 60, |_, _| PX_M / 12.0);
    let sensor = SingleView::new(parameters, recomputed).unwrap();
    // b·f·W/S at this width, px·m.
    let px_m = PX_M * 106.0 / 1280.0;
    let d = px_m / (PX_M / 12.0);
    let quantized = (d / 0.25).round() * 0.25;
    let stream = Stream::new(3, "left");
    let (mut sum, mut squares, mut lagged, mut n) = (0.0f64, 0.0, 0.0, 0.0);
    let mut before = vec![0.0; 106 * 60];
    for frame in 0..40 {
        let mut shot = DepthShot::new((&depth).into());
        shot.frame = frame;
        let seen = sensor.sense(&shot, &stream, Wanted::default()).distance.0;
        for (z, before) in seen.pixels().iter().zip(&mut before).filter(|(z, _)| **z > 0.0) {
            let off = f64::from(px_m / z - quantized);
            (sum, squares, lagged, n) = (sum + off, squares + off * off, lagged + off * *before, n + 1.0);
            *before = off;
        }
    }
    let sigma = (squares / n).sqrt();
    assert!((sigma - 0.1).abs() < 0.001, "{sigma}");
    assert!((sum / n).abs() < 0.001, "{}", sum / n);
    assert!((lagged / squares).abs() < 0.02, "{}", lagged / squares);
}

#[test]
fn pixels_of_a_patch_share_their_jitter() {
    let parameters = Parameters {
        noise_downscale_factor_px: 4.0,
        noise_sigma_px: 1.5,
        outlier_removal_range_px: 0,
        ..oak_d_pro()
    };
    let seen = distance(parameters, &image(256, 32, |_, _| 4.0), 0);
    let rows: Vec<&[f32]> = seen.rows().collect();
    assert!(
        rows.chunks(4)
            .all(|patch| patch.iter().all(|row| *row == patch[0]))
    );
    assert_ne!(rows[0], rows[4]);
}

#[test]
fn confidence_depends_on_texture() {
    let depth = image(640, 40, |_, _| 3.0);
    let smooth = image(640, 40, |_, _| [120, 130, 140, 255]);
    let textured = image(640, 40, |x, y| {
        if (x / 2 + y / 2) % 2 == 0 {
            [20, 20, 20, 255]
        } else {
            [230, 230, 230, 255]
        }
    });
    let fill = |grain: &str, picture: &Image<[u8; 4]>, threshold: f64| {
        let parameters = Parameters {
            confidence_threshold: threshold,
            ..quiet()
        };
        let mut assumptions = Assumptions::default();
        assumptions.set("sobel-gain", "1").unwrap();
        assumptions.set("grain", grain).unwrap();
        let shot = DepthShot::new((&depth).into()).with_rgb(picture.into()).unwrap();
        let sensor = SingleView::new(parameters, assumptions).unwrap();
        let seen = sensor.sense(&shot, &Stream::new(1, ""), Wanted::default());
        let measured = seen.distance.0.pixels().iter().filter(|&&z| z > 0.0).count();
        measured as f64 / (40.0 * (640.0 - 10.0))
    };
    let filled = |picture, threshold| fill("0", picture, threshold);
    for threshold in [0.0, 0.8, 0.99] {
        assert_eq!(filled(&smooth, threshold), 0.0);
        assert!(filled(&textured, threshold) > 0.9);
    }
    assert_eq!(filled(&smooth, 1.0), 1.0);
    // Lower thresholds drop more pixels of a faint texture.
    let faint = image(640, 40, |x, _| {
        let grey = if x % 40 < 20 {
            100 + 2 * (x % 20) as u8
        } else {
            100
        };
        [grey, grey, grey, 255]
    });
    let fills = [0.8, 0.95, 0.99].map(|threshold| filled(&faint, threshold));
    assert!(fills[0] < fills[1] && fills[1] < fills[2], "{fills:?}");
    // Lower thresholds thin a smooth wall with grain more.
    let fills = [0.0, 0.95, 0.98, 0.99, 1.0].map(|threshold| fill("1", &smooth, threshold));
    assert!(
        fills.is_sorted() && fills[0] == 0.0 && fills[4] == 1.0,
        "{fills:?}"
    );
    assert!(
        fills[2] > 0.1 && fills[3] < 0.9 && fills[2] < fills[3],
        "{fills:?}"
    );
}

#[test]
fn removes_outliers() {
    let lone = |reach: u32, z: &Image<f32>| {
        let parameters = Parameters {
            outlier_removal_range_px: reach,
            ..quiet()
        };
        // The disparity is negligible, so nothing moves.
        distance(
            Parameters {
                baseline_mm: 0.01,
                ..parameters
            },
            z,
            0,
        )
    };
    let point = image(101, 41, |x, y| if (x, y) == (70, 20) { 2.0 } else { 0.0 });
    let hole = image(101, 41, |x, y| {
        if (x, y) == (70, 20) {
            0.0
        } else {
            2.0 + x as f32 * 0.01
        }
    });
    let pair = image(101, 41, |x, y| {
        f32::from(u8::from([(70, 20), (73, 22)].contains(&(x, y))))
    });
    assert_eq!(lone(0, &point), point);
    for reach in [1, 2, 3, 63] {
        assert_eq!(lone(reach, &point).get(70, 20), Some(&0.0));
        assert_eq!(lone(reach, &hole).get(70, 20), hole.get(69, 20));
    }
    assert!(lone(2, &pair).pixels().iter().all(|&z| z == 0.0));
    assert_eq!(lone(3, &pair), pair);
}

/// A smoothly lit face in whole levels: the shade rises by a level in 13 rows, with a little smooth variation.
fn lit_face(width: u32, height: u32) -> Image<[u8; 4]> {
    let waves = [(1.0, 1.0, 0.3, 0.1), (0.7, 0.45, -0.5, 1.3), (0.5, 1.9, 0.7, 2.2)];
    image(width, height, |x, y| {
        let (x, y) = (f64::from(x), f64::from(y));
        let wave = |(amplitude, u, v, phase): (f64, f64, f64, f64)| {
            amplitude * (std::f64::consts::TAU * (u * x + v * y) / 150.0 + phase).sin()
        };
        let variation: f64 = waves.into_iter().map(wave).sum();
        let level = (120.0 + y / 13.0 + 1.5 * variation) as u8;
        [level, level, level, 255]
    })
}

/// The shares of runs of 1, 2, 3 and 4 pixels, per cent.
fn shares(lines: impl Iterator<Item = Vec<bool>>) -> [f64; 4] {
    let mut counts = [0u32; 4];
    let mut all = 0;
    for line in lines {
        for run in line.split(|measured| !measured).filter(|run| !run.is_empty()) {
            all += 1;
            if let Some(count) = counts.get_mut(run.len() - 1) {
                *count += 1;
            }
        }
    }
    counts.map(|count| 100.0 * f64::from(count) / f64::from(all))
}

/// Counted in the vendor's pictures of a face at one depth: 21.4 % at the default threshold of Isaac Sim, and 14.7 % and
/// 14.8 % at a lower one, probably the sheet's; and the lengths of runs down the columns and along the rows.
#[test]
fn a_smoothly_lit_face_keeps_the_lines_of_the_vendors_pictures() {
    let (width, height) = (520u32, 450u32);
    let (depth, picture) = (image(width, height, |_, _| 2.5f32), lit_face(width, height));
    for (threshold, measured, down, along) in [
        (0.95, 21.4, [39.0, 29.0, 21.0, 7.0], [39.0, 28.0, 16.0, 8.0]),
        (0.8, 14.75, [45.0, 43.0, 9.0, 2.0], [46.0, 30.0, 13.0, 6.0]),
    ] {
        let parameters = Parameters {
            confidence_threshold: threshold,
            noise_sigma_px: 0.45,
            noise_downscale_factor_px: 1.0,
            // A part of an image that is 1920 px wide.
            sensor_size_px: 1280.0 * f64::from(width) / 1920.0,
            ..oak_d_pro()
        };
        let shot = DepthShot::new((&depth).into())
            .with_rgb((&picture).into())
            .unwrap();
        let seen = |assumptions: Assumptions| {
            let sensor = SingleView::new(parameters, assumptions).unwrap();
            let seen = sensor.sense(&shot, &Stream::new(1, "left"), Wanted::default());
            let rows = seen.distance.0.rows().skip(30).take(390);
            let rows: Vec<Vec<bool>> = rows
                .map(|row| row[80..440].iter().map(|z| *z > 0.0).collect())
                .collect();
            rows
        };
        let share = |rows: &[Vec<bool>]| {
            let measured = rows.iter().flatten().filter(|measured| **measured).count();
            100.0 * measured as f64 / (390.0 * 360.0)
        };
        let rows = seen(Assumptions::default());
        assert!(
            (share(&rows) - measured).abs() < 1.5,
            "{threshold}: {}",
            share(&rows)
        );
        let columns = (0..360).map(|x| rows.iter().map(|row| row[x]).collect());
        for (found, expected) in [(shares(columns), down), (shares(rows.iter().cloned()), along)] {
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 6.0, "{threshold}: {found} {expected}");
            }
        }
        // Grain fills the plateaus between the lines.
        let mut grainy = Assumptions::default();
        grainy.set("grain", "1").unwrap();
        assert!(share(&seen(grainy)) > 60.0);
    }
}

#[test]
fn plateaus_and_a_plain_sky_are_empty_and_lines_are_measured() {
    let (width, height) = (640u32, 200u32);
    let depth = image(width, height, |_, _| 8.0f32);
    // Steps of one level, 40 rows apart; a grid on the right half.
    let picture = image(width, height, |x, y| {
        let is_line = x >= 320 && (x % 40 < 2 || y % 50 < 2);
        let level = if is_line { 90 } else { 140 + (y / 40) as u8 };
        let sky = [level, level, level, 255];
        if y >= 160 && !is_line {
            [120, 160, 220, 255]
        } else {
            sky
        }
    });
    let parameters = Parameters {
        confidence_threshold: 0.95,
        outlier_removal_range_px: 0,
        noise_mean_px: 0.0,
        ..oak_d_pro()
    };
    let shot = DepthShot::new((&depth).into())
        .with_rgb((&picture).into())
        .unwrap();
    let seen = sensor(parameters).sense(&shot, &Stream::new(1, ""), Wanted::default());
    let shift = (PX_M * 640.0 / 1280.0 / 8.0).round() as u32;
    let is_measured = |x: u32, y: u32| *seen.distance.0.get(x + shift, y).unwrap() > 0.0;
    for y in 0..height {
        let is_step = y > 0 && y <= 160 && (y % 40 == 0 || y % 40 == 39);
        for x in 4..300 {
            assert_eq!(is_measured(x, y), is_step, "({x}, {y})");
        }
    }
    for y in (6..height - 6).filter(|y| (4..46).contains(&(y % 50)) && !(y % 40 < 2 || y % 40 > 37)) {
        for x in 325..620 {
            let from_line = x % 40;
            let is_edge = [39, 0, 1, 2].contains(&from_line);
            assert_eq!(is_measured(x, y), is_edge, "({x}, {y})");
        }
    }
}
