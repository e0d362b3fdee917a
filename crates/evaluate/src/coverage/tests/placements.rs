//! Sweeps of poses.

use oaktwin_camera::math::DVec3;
use proptest::prelude::*;

use super::*;

fn sweep(heights: &str, tilts: &str) -> PlacementSweep {
    let [heights, tilts] = [heights, tilts].map(|text| Some(text).filter(|text| !text.is_empty()));
    PlacementSweep::parse(heights, tilts).unwrap()
}

#[test]
fn a_look_at_keeps_its_target_at_any_height() {
    let (eye, target) = (DVec3::new(1.0, 2.0, 9.0), DVec3::new(4.0, 2.0, 0.5));
    let base = Base::LookAt {
        eye,
        target,
        up: DVec3::Z,
    };
    let placed = sweep("0.5:1.5:0.5", "").placements(&base, DVec3::Z).unwrap();
    let names: Vec<&str> = placed.iter().map(|one| one.name.as_str()).collect();
    assert_eq!(names, ["height 0.5 m", "height 1 m", "height 1.5 m"]);
    for (placement, height) in placed.iter().zip([0.5, 1.0, 1.5]) {
        let body = placement.world_from_body;
        assert_eq!(body.translation, DVec3::new(1.0, 2.0, height));
        let seen = body.inverse().apply(target);
        assert!(seen.x > 0.0 && seen.y.abs() < 1e-12 && seen.z.abs() < 1e-12);
    }
    let as_given = PlacementSweep::default().placements(&base, DVec3::Z).unwrap();
    assert_eq!(as_given.len(), 1);
    assert_eq!(as_given[0].name, "pose 0");
    assert_eq!(
        as_given[0].world_from_body,
        look_at(eye, target, DVec3::Z).unwrap()
    );
}

#[test]
fn every_combination_is_placed() {
    let base = Base::Poses(vec![RigidTransform::IDENTITY; 3]);
    let placed = sweep("1,2", "0,30").placements(&base, DVec3::Z).unwrap();
    assert_eq!(placed.len(), 12);
    assert_eq!(placed[0].name, "pose 0, height 1 m, tilt 0°");
    assert_eq!(placed[11].name, "pose 2, height 2 m, tilt 30°");
}

#[test]
fn a_camera_that_faces_down_keeps_the_heading_of_its_image() {
    for (straight, tilt) in [(DVec3::NEG_Z, 0.0), (DVec3::Z, 0.0)] {
        // The top of the image is towards y, or away from it.
        let body = look_at(DVec3::ZERO, straight, DVec3::Y).unwrap();
        let base = Base::Poses(vec![body]);
        let placed = sweep("", &tilt.to_string()).placements(&base, DVec3::Z).unwrap();
        let forward = placed[0].world_from_body.rotation.x_axis;
        assert!((forward - DVec3::Y * -straight.z).length() < 1e-12, "{forward}");
    }
}

#[test]
fn sweeps_out_of_range_are_rejected() {
    let error = |heights, tilts| PlacementSweep::parse(heights, tilts).unwrap_err().to_string();
    assert_eq!(
        error(Some("1,x"), None),
        "'height': 'x' is not a number; give metres, separated by commas, or FROM:TO:STEP"
    );
    assert!(error(None, Some("1:2")).starts_with("'tilt': '1:2' is neither a number nor a range"));
    assert!(error(None, Some("0:120:30")).starts_with("'tilt': 120 is out of range; give -90 (up)"));
    assert!(error(Some("nan"), None).contains("is not finite"));
    assert!(error(Some("0:1e9:1"), None).contains("has too many steps"));

    let many = sweep("0:99:1", "0:89.9:0.1");
    let error = many.placements(&Base::Poses(vec![RigidTransform::IDENTITY]), DVec3::Z);
    assert!(
        error
            .unwrap_err()
            .to_string()
            .contains("90000 candidates are too many")
    );
    let above = Base::LookAt {
        eye: DVec3::new(0.0, 0.0, 5.0),
        target: DVec3::ZERO,
        up: DVec3::Z,
    };
    let error = sweep("1", "")
        .placements(&above, DVec3::Z)
        .unwrap_err()
        .to_string();
    assert!(
        error.starts_with("'look-at' at a height of 1 m: the direction of view is parallel"),
        "{error}"
    );
}

proptest! {
    #[test]
    fn a_tilt_is_absolute_and_keeps_the_heading(
        eye in prop::array::uniform3(-5.0..5.0f64),
        target in prop::array::uniform3(-5.0..5.0f64),
        tilt in -90i32..=90,
        y_up in any::<bool>(),
    ) {
        let up = if y_up { DVec3::Y } else { DVec3::Z };
        let (eye, target) = (DVec3::from(eye), DVec3::from(target));
        let Ok(body) = look_at(eye, target, up) else { return Ok(()) };
        let placed = sweep("", &tilt.to_string()).placements(&Base::Poses(vec![body]), up).unwrap();
        let tilted = placed[0].world_from_body;
        let angle = (-tilted.rotation.x_axis.dot(up)).clamp(-1.0, 1.0).asin().to_degrees();
        prop_assert!((angle - f64::from(tilt)).abs() < 1e-5, "{angle}");
        prop_assert_eq!(tilted.translation, eye);
        // No roll: the left of the image is horizontal, like the base's.
        prop_assert!((tilted.rotation.y_axis - body.rotation.y_axis).length() < 1e-6);
        prop_assert!(tilted.orthonormality_error() < 1e-9);
    }
}
