//! Shares that a closed form predicts.

use oaktwin_camera::Usd;
use oaktwin_camera::math::DVec3;
use oaktwin_pipeline::render::Backend;
use oaktwin_scene::Bounds;
use oaktwin_scene::shape::{Axis, cylinder, plane, sphere};

use super::*;

#[test]
fn a_plate_in_front_of_the_camera_is_measured() {
    let plate = Stage::default().plate("/Plate", DVec3::new(2.0, 0.0, 0.0));
    let seen = ahead(plate, &Region::default(), &[]).shares;
    assert_eq!(seen.seen, 1.0);
    assert!((seen.measured - resolved(&seen)).abs() < 1e-12, "{seen:?}");
    // The noise of a subpixel step at 2 m is a few millimetres.
    let median = seen.median_absolute_error_mm.unwrap();
    assert!(median > 0.5 && median < 40.0, "{median}");
    assert!(seen.p95_absolute_error_mm.unwrap() > median);
}

#[test]
fn the_error_is_that_of_the_sensor() {
    // A bias shifts all disparities: z becomes z · d / (d + bias).
    let plate = || Stage::default().plate("/Plate", DVec3::new(2.0, 0.0, 0.0));
    let error = |bias: &str| {
        let exact = [("bias", bias), ("pixelLocking", "0"), ("jitter", "0")];
        let found = ahead(plate(), &Region::default(), &exact);
        found.shares.median_error_mm.unwrap()
    };
    let rig = rig_of("OAK4-D", &[]);
    let width = rig.camera().camera.intrinsics.size.width;
    let disparity = rig.sensor().engine().disparity_times_depth(width) / 2.0;
    assert!(error("0").abs() < 3.0, "{}", error("0"));
    for bias in [0.5, -0.5] {
        let expected = 2e3 * (disparity / (disparity + bias) - 1.0);
        let error = error(&bias.to_string());
        assert!((error - expected).abs() < 3.0, "{error} instead of {expected}");
    }
}

#[test]
fn a_box_hides_half_of_a_plate() {
    let stage = Stage::default()
        .plate("/World/Plate", DVec3::new(2.0, 0.0, 0.0))
        .block(
            "/World/Box",
            DVec3::new(1.0, -0.5, 0.0),
            DVec3::new(0.001, 1.0, 1.0),
        );
    let found = ahead(stage, &objects(&["/World/Plate"]), &[]);
    // The front edge of the box hides the line of sight to the middle of the plate.
    assert_share(found.shares.lost["hidden"], 0.5);
    assert_share(found.shares.seen, 0.5);
    assert_eq!(found.occluders.len(), 1);
    assert_eq!(found.occluders[0].path, "/World/Box");
    assert_eq!(found.occluders[0].share, found.shares.lost["hidden"]);
    // Beside the edge the other camera sees the box.
    assert!(found.shares.lost["occluded"] > 0.05, "{found:?}");
    assert!(found.shares.measured > 0.3);
}

#[test]
fn surfaces_outside_the_view_are_lost() {
    for centre in [
        [-2.0, 0.0, 0.0],
        [1.0, 5.0, 0.0],
        [1.0, 0.0, -5.0],
        [0.005, 0.0, 0.0],
    ] {
        let plate = plane(0.001, 0.001, Axis::X);
        let stage = Stage::default().with("/Plate", plate, DAffine3::from_translation(DVec3::from(centre)));
        let seen = ahead(stage, &Region::default(), &[]).shares;
        assert_eq!(seen.lost["outside_view"], 1.0, "{centre:?}");
        assert_eq!(seen.seen, 0.0);
        assert_eq!(seen.median_error_mm, None);
    }
}

#[test]
fn surfaces_out_of_range_are_seen_and_not_measured() {
    // The disparity of 20 m is 3 px.
    let shifted = [("disparityShift", "10")];
    for (distance, set, reason) in [(0.1, &[][..], "too_near"), (20.0, &shifted, "too_far")] {
        let plate = plane(0.02 * distance, 0.02 * distance, Axis::X);
        let at = DAffine3::from_translation(DVec3::new(distance, 0.0, 0.0));
        let stage = Stage::default().with("/Plate", plate, at);
        let seen = ahead(stage, &Region::default(), set).shares;
        assert_eq!((seen.seen, seen.measured), (1.0, 0.0), "{distance}");
        assert!(seen.lost[reason] > 0.9, "{seen:?}");
    }
}

#[test]
fn a_plate_without_texture_cannot_be_matched() {
    let plate = Stage::default().plate("/Plate", DVec3::new(2.0, 0.0, 0.0));
    let seen = ahead(plate, &Region::default(), &[("confidenceThreshold", "200")]).shares;
    assert!(seen.lost["no_texture"] > 0.9, "{seen:?}");
}

#[test]
fn a_plate_seen_edge_on_faces_away() {
    let plate = plane(0.5, 0.5, Axis::Z);
    let at = DAffine3::from_translation(DVec3::new(2.0, 0.0, 0.0));
    let seen = ahead(
        Stage::default().with("/Plate", plate, at),
        &Region::default(),
        &[],
    )
    .shares;
    assert_eq!(seen.lost["faces_away"], 1.0);
}

#[test]
fn the_visible_cap_of_a_sphere_matches_the_closed_form() {
    for distance in [0.8, 2.0] {
        let radius = 0.25;
        let at = DAffine3::from_translation(DVec3::new(distance, 0.0, 0.0));
        let stage = Stage::default().with("/Sphere", sphere(radius), at);
        let seen = ahead(stage, &Region::default(), &[]).shares;
        let cap = 0.5 * (1.0 - radius / distance);
        assert_share(seen.seen, cap);
        assert_share(seen.lost["faces_away"], 1.0 - cap);
    }
}

#[test]
fn an_open_surface_is_seen_from_both_sides() {
    for x in [1.0, -1.0] {
        let rig = rig_of("OAK4-D", &[]);
        let pose = facing(&rig, DVec3::ZERO, DVec3::new(x, 0.0, 0.0));
        let plate = Stage::default().plate("/Plate", DVec3::new(2.0 * x, 0.0, 0.0));
        let renderer = Renderer::new(plate.0);
        let candidate = Candidate::new(&rig, "", pose);
        let all = Region::default();
        let coverage = measure(&renderer, &all, &[candidate], &CoverageOptions::default(), &go_on).unwrap();
        let seen = &coverage.candidates[0].shares;
        assert_eq!(seen.seen, 1.0);
        assert!((seen.measured - resolved(seen)).abs() < 1e-12, "{seen:?}");
    }
}

#[test]
fn a_wire_thinner_than_a_pixel_is_visible_but_not_resolved() {
    // A pixel of the small image is 7 mm wide at 3 m, and a wall behind the wire is measured.
    let wire = cylinder(0.0005, 0.5, Axis::Z);
    let stage = Stage::default()
        .with(
            "/Wire",
            wire,
            DAffine3::from_translation(DVec3::new(3.0, 0.0013, 0.0)),
        )
        .plate("/Wall", DVec3::new(4.0, 0.0, 0.0));
    let seen = ahead(stage, &objects(&["/Wire"]), &[]).shares;
    assert!(seen.seen > 0.4, "{seen:?}");
    assert!(seen.lost["not_resolved"] > 0.9 * seen.seen, "{seen:?}");
}

#[test]
fn slanted_and_curved_surfaces_are_resolved() {
    // A floor from 0.9 m to 3.9 m, 0.3 m below the camera: its angle of incidence reaches 86°.
    let floor = plane(9.0, 9.0, Axis::Z);
    let at = DAffine3::from_translation(DVec3::new(0.0, 0.0, -0.3));
    let stage = Stage::default().with("/Floor", floor, at);
    let within = Bounds {
        min: DVec3::new(0.9, -0.2, -1.0),
        max: DVec3::new(3.9, 0.2, 1.0),
    };
    let region = Region {
        within: Some(within),
        ..Region::default()
    };
    let seen = ahead(stage, &region, &[]).shares;
    assert_eq!(seen.seen, 1.0);
    assert!(!seen.lost.contains_key("not_resolved"), "{seen:?}");
}

#[test]
fn the_pixels_of_a_sphere_that_miss_it_do_not_resolve_it() {
    let at = DAffine3::from_translation(DVec3::new(2.0, 0.0, 0.0));
    let renderer = Renderer::new(Stage::default().with("/Sphere", sphere(0.25), at).0);
    let rig = rig_of("OAK4-D", &[]);
    let candidate = Candidate::new(&rig, "", facing(&rig, DVec3::ZERO, DVec3::X));
    let view = rig.camera().view(&candidate.world_from_body);
    let options = CoverageOptions {
        keeps_points: true,
        ..CoverageOptions::default()
    };
    let coverage = measure(&renderer, &Region::default(), &[candidate], &options, &go_on).unwrap();
    let kept = coverage.points.unwrap();
    let depth = renderer.depth(&view, Backend::Auto);
    let mut missed = 0;
    for (point, outcome) in kept.samples.points.iter().zip(&kept.outcomes[0]) {
        if !outcome.is_seen() {
            continue;
        }
        let in_camera = view.camera_from_world().transform_point3(point.position);
        let pixel = view.camera.project(in_camera).unwrap().to::<Usd>();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "inside the image"
        )]
        let is_missed = depth.0.get(pixel.x as u32, pixel.y as u32).unwrap().is_infinite();
        assert_eq!(outcome.name() == "not_resolved", is_missed, "{point:?}");
        missed += u32::from(is_missed);
    }
    assert!(missed > 50);
}
