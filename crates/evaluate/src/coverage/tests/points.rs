//! The points on the surface.

use oaktwin_camera::math::DVec3;
use oaktwin_scene::shape::{Axis, cube, plane, sphere};
use oaktwin_scene::{Bounds, Mesh};

use super::*;

/// The sum of the squared deviations, each relative to the expected number.
fn chi_square(counts: &[u32], expected: &[f64]) -> f64 {
    let term = |(count, expected): (&u32, &f64)| (f64::from(*count) - expected).powi(2) / expected;
    counts.iter().zip(expected).map(term).sum()
}

#[test]
fn the_number_of_points_is_proportional_to_the_area() {
    // Strips whose areas are 1, 2, …, 12 units.
    let mut mesh = Mesh::default();
    for i in 1..=12u16 {
        let (x, length) = (f32::from(i), f32::from(i));
        let first = u32::try_from(mesh.positions.len()).unwrap();
        mesh.positions
            .extend([[x, 0.0, 0.0], [x + 0.5, 0.0, 0.0], [x, length, 0.0]]);
        mesh.triangles.push([first, first + 1, first + 2]);
    }
    let stage = Stage::default().with("/Strips", mesh, DAffine3::from_scale(DVec3::new(2.0, 2.0, 1.0)));
    let samples = Samples::new(&stage.0, &Region::default(), SAMPLES).unwrap();
    assert!((samples.area_m2 - 78.0).abs() < 1e-9);
    assert_eq!(samples.points.len(), SAMPLES as usize);
    let mut counts = [0; 12];
    for point in &samples.points {
        counts[point.triangle as usize] += 1;
    }
    let expected: Vec<f64> = (1..=12)
        .map(|i| f64::from(SAMPLES) * f64::from(i) / 78.0)
        .collect();
    // For independent points with 11 degrees of freedom, 99.9 % would be below 31.3. These are more even.
    assert!(chi_square(&counts, &expected) < 1.0, "{counts:?}");
}

#[test]
fn points_cover_a_triangle_uniformly() {
    let mesh = Mesh {
        positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let stage = Stage::default().with("/Triangle", mesh, DAffine3::IDENTITY);
    let samples = Samples::new(&stage.0, &Region::default(), SAMPLES).unwrap();
    // The 100 triangles of a regular subdivision.
    let mut counts = [0; 100];
    for point in &samples.points {
        let at = point.position * 10.0;
        assert!(at.x >= 0.0 && at.y >= 0.0 && at.x + at.y <= 10.0 + 1e-9);
        let upper = at.x.fract() + at.y.fract() > 1.0;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "below 10")]
        let (column, row) = (at.x as usize, at.y as usize);
        counts[column * (20 - column) + 2 * row + usize::from(upper)] += 1;
    }
    assert!(chi_square(&counts, &[100.0; 100]) < 50.0, "{counts:?}");
}

#[test]
fn normals_point_outside_also_of_mirrored_meshes() {
    for scale in [DVec3::ONE, DVec3::new(-1.0, 2.0, 0.5), DVec3::splat(-1.0)] {
        for mesh in [cube(1.0), sphere(0.5)] {
            let stage = Stage::default().with("/Solid", mesh, DAffine3::from_scale(scale));
            let samples = Samples::new(&stage.0, &Region::default(), 500).unwrap();
            for point in &samples.points {
                assert!((point.normal.length() - 1.0).abs() < 1e-9);
                assert!(point.normal.dot(point.position) > 0.0, "{scale:?}: {point:?}");
            }
        }
    }
}

#[test]
fn a_box_cuts_triangles() {
    let stage = Stage::default()
        .with("/World/Floor", plane(10.0, 10.0, Axis::Z), DAffine3::IDENTITY)
        .block("/World/Block", DVec3::new(0.0, 0.0, 5.0), DVec3::ONE);
    let within = Bounds {
        min: DVec3::new(-1.0, 0.0, -0.1),
        max: DVec3::new(2.0, 4.5, 0.1),
    };
    let region = Region {
        within: Some(within),
        ..Region::default()
    };
    let samples = Samples::new(&stage.0, &region, 1000).unwrap();
    assert!((samples.area_m2 - 13.5).abs() < 1e-12);
    for SurfacePoint { position, .. } in &samples.points {
        assert!(position.cmpge(within.min).all() && position.cmple(within.max).all());
    }
    let mean = samples.points.iter().map(|point| point.position).sum::<DVec3>() / 1000.0;
    assert!((mean - DVec3::new(0.5, 2.25, 0.0)).length() < 0.02, "{mean}");
    // A box and an object: their intersection.
    let region = Region {
        objects: vec!["/World/Block".to_owned()],
        within: Some(Bounds {
            min: DVec3::new(-9.0, -9.0, 5.0),
            max: DVec3::splat(9.0),
        }),
        ..Region::default()
    };
    let samples = Samples::new(&stage.0, &region, 1000).unwrap();
    assert!((samples.area_m2 - 3.0).abs() < 1e-12);
    assert!(samples.points.iter().all(|point| point.instance == 1));
}

#[test]
fn any_number_of_points_is_exact() {
    let stage = Stage::default()
        .with("/Sphere", sphere(1.0), DAffine3::IDENTITY)
        .plate("/Plate", DVec3::X)
        .with("/Empty", Mesh::default(), DAffine3::IDENTITY);
    for count in [1, 2, 7, 1000, 54_321] {
        let samples = Samples::new(&stage.0, &Region::default(), count).unwrap();
        assert_eq!(samples.points.len(), count as usize);
        let is_sorted = samples
            .points
            .is_sorted_by_key(|point| (point.instance, point.triangle));
        assert!(is_sorted);
    }
}
