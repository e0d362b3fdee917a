//! Regions, and what is wrong with them.

use oaktwin_camera::math::DVec3;
use oaktwin_scene::{Bounds, Mesh};

use super::*;

fn room() -> Scene {
    Stage::default()
        .plate("/World/Pallet/Left", DVec3::X)
        .plate("/World/Pallet/Right", DVec3::X)
        .plate("/World/Pallets", DVec3::X)
        .with("/World/Nothing", Mesh::default(), DAffine3::IDENTITY)
        .0
}

fn error(region: &Region) -> String {
    Samples::new(&room(), region, 10).unwrap_err().to_string()
}

#[test]
fn an_object_has_everything_below_its_path() {
    let instances = |paths: &[&str]| objects(paths).instances(&room()).unwrap();
    assert_eq!(instances(&["/World/Pallet"]), [0, 1]);
    assert_eq!(instances(&["/World/Pallet/"]), [0, 1]);
    assert_eq!(instances(&["/World/Pallet/Right"]), [1]);
    assert_eq!(
        instances(&["/World/Pallets", "/World/Pallet", "/World/Pallet/Left"]),
        [0, 1, 2]
    );
    assert_eq!(instances(&["/"]), [0, 1, 2, 3]);
    assert_eq!(instances(&[]), [0, 1, 2, 3]);
}

#[test]
fn an_unknown_object_suggests_others() {
    let of = |path: &str| error(&objects(&[path]));
    let expected = "'region': the scene has no geometry at '/World/Palet'; did you mean '/World/Pallet'";
    assert!(of("/World/Palet").starts_with(expected), "{}", of("/World/Palet"));
    assert!(
        of("pallet").ends_with("did you mean '/World/Pallet'?"),
        "{}",
        of("pallet")
    );
    assert!(of("/Room/left").ends_with("did you mean '/World/Pallet/Left'?"));
    assert!(
        of("xyz").contains("expected one of /World, /World/Nothing"),
        "{}",
        of("xyz")
    );
}

#[test]
fn regions_without_surface_are_rejected() {
    let nothing = error(&objects(&["/World/Nothing"]));
    assert_eq!(
        nothing,
        "'region': /World/Nothing has no surface; choose objects with faces"
    );
    let within = |min: [f64; 3], max: [f64; 3]| {
        error(&Region {
            within: Some(Bounds {
                min: DVec3::from(min),
                max: DVec3::from(max),
            }),
            ..Region::default()
        })
    };
    let elsewhere = within([5.0; 3], [6.0; 3]);
    assert!(elsewhere.contains("it contains no surface"), "{elsewhere}");
    assert!(elsewhere.contains("extends from 1.000 -0.250 -0.250 to 1.000 0.250 0.250 m"));
    // A line of a plate has no area.
    assert!(within([0.0, 0.0, -1.0], [2.0, 0.0, 1.0]).contains("contains no surface"));
    let reversed = within([0.0, 1.0, 0.0], [1.0, -1.0, 1.0]);
    assert!(
        reversed.contains("the minimum of y, 1, is above its maximum, -1"),
        "{reversed}"
    );
    for nonsense in [f64::NAN, f64::INFINITY] {
        let message = within([0.0, 0.0, nonsense], [1.0; 3]);
        assert!(message.contains("give finite numbers"), "{message}");
        let message = within([0.0; 3], [nonsense, 1.0, 1.0]);
        assert!(message.contains("give finite numbers"), "{message}");
    }
    assert!(Samples::new(&Scene::default(), &Region::default(), 10).is_err());
}
