use std::f64::consts::{PI, TAU};

use super::*;

/// One patch, one receiver, face to face and askew, against the closed form.
#[test]
fn two_patches_are_lamberts() {
    let turns_per_m = [0.53f32, 0.67];
    let normal = |x: f32, y: f32, z: f32| {
        let size = (x * x + y * y + z * z).sqrt();
        [x / size, y / size, z / size]
    };
    let cases = [
        ([0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0, 0.0, 0.8]),
        ([0.3, -0.2, 0.9], [0.1, 0.5, -1.0], [0.4, -0.3, 1.1]),
        ([1.0, 0.0, 0.1], [-1.0, 0.2, 0.0], [2.1, 0.7, 0.2]),
        // Looking away.
        ([0.0, 0.0, -1.0], [0.0, 0.0, -1.0], [0.0, 0.0, 0.8]),
    ];
    for (number, (receiver, patch, way)) in cases.into_iter().enumerate() {
        let (receiver, emits) = (
            normal(receiver[0], receiver[1], receiver[2]),
            normal(patch[0], patch[1], patch[2]),
        );
        let found = ReceiverPosition {
            point: [0.2, 0.1, 1.3],
            normal: receiver,
        };
        let patch = Patch {
            point: [0, 1, 2].map(|k| found.point[k] + way[k]),
            normal: emits,
            flux: 0.037,
            area: 0.002,
            range: 1.7,
        };
        let gather = |level| {
            let kernel = Gather {
                patches: &[patch],
                found: &Lit::new(&[ReceiverPosition::default(), found]),
                turns_per_m,
            };
            simd::run_at(level, kernel).map(|channel| channel[1])
        };
        let all = gather(Level::BASELINE);
        let dot = |a: [f32; 3], b: [f32; 3]| (0..3).map(|k| f64::from(a[k]) * f64::from(b[k])).sum::<f64>();
        let way = [0, 1, 2].map(|k| patch.point[k] - found.point[k]);
        let distance = dot(way, way).sqrt();
        let cosines = [dot(receiver, way), -dot(emits, way)].map(|dot| (dot / distance).max(0.0));
        let light = 0.037 * cosines[0] * cosines[1] / (PI * distance * distance + 0.002);
        assert_eq!(light > 0.0, number < 3);
        for (frequency, turns) in turns_per_m.into_iter().enumerate() {
            let phase = TAU * f64::from(turns) * (1.7 + distance) / 2.0;
            for (part, expected) in [phase.cos(), phase.sin()].into_iter().enumerate() {
                let found = f64::from(all[2 * frequency + part]);
                assert!(
                    (found - light * expected).abs() <= 3e-6 * light,
                    "{number}: {found}"
                );
            }
        }
        assert!((f64::from(all[4]) - light).abs() <= 1e-6 * light);
        assert!(Level::available().into_iter().all(|level| gather(level) == all));
    }
}

#[test]
fn images_of_any_size_are_divided() {
    let sizes = [
        (640, 480),
        (106, 80),
        (1280, 960),
        (1, 1),
        (1, 5000),
        (5000, 2),
        (41, 31),
        (40, 30),
    ];
    for (width, height) in sizes {
        let grid = Grid::new(width, height);
        let cells = grid.size.map(|size| size.div_ceil(grid.cell));
        assert!(cells[0] <= 40 && cells[1] <= 30);
        for (axis, cells) in cells.into_iter().enumerate() {
            let all = grid.receivers(axis);
            assert!(all.is_sorted_by(|a, b| a < b) && *all.last().unwrap() < grid.size[axis]);
            assert!(all.len() <= 2 * cells);
        }
    }
    assert_eq!((Grid::new(640, 480).cell, Grid::new(640, 480).step), (16, 8));
}
