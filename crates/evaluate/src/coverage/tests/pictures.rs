//! The picture of a candidate.

use oaktwin_camera::math::DVec3;
use oaktwin_image::Image;
use oaktwin_scene::shape::{Axis, plane};

use super::*;

/// The number of pixels whose colour has this hue: a multiple of a colour.
fn count(image: &Image<[u8; 3]>, color: [f64; 3]) -> usize {
    let is_like = |pixel: &&[u8; 3]| {
        let pixel = pixel.map(f64::from);
        let scale = pixel.iter().copied().fold(0.0, f64::max) / color.iter().copied().fold(0.0, f64::max);
        scale > 0.3
            && pixel
                .iter()
                .zip(color)
                .all(|(own, wanted)| (own - wanted * scale).abs() < 3.0)
    };
    image.pixels().iter().filter(is_like).count()
}

const MEASURED: [f64; 3] = [0.0, 158.0, 115.0];
const HIDDEN: [f64; 3] = [0.0, 114.0, 178.0];

#[test]
fn the_region_is_painted_with_the_outcomes() {
    // Behind a post, a stripe of the plate is hidden; the floor does not belong to the region.
    let floor = plane(9.0, 9.0, Axis::Z);
    let stage = Stage::default()
        .plate("/Plate", DVec3::new(2.0, 0.0, 0.0))
        .block("/Post", DVec3::new(1.5, 0.0, 0.0), DVec3::new(0.02, 0.1, 0.7))
        .with(
            "/Floor",
            floor,
            DAffine3::from_translation(DVec3::new(0.0, 0.0, -0.5)),
        );
    let renderer = Renderer::new(stage.0);
    let rig = rig_of("OAK4-D", &[]);
    let candidate = Candidate::new(&rig, "ahead", facing(&rig, DVec3::ZERO, DVec3::X));
    let region = objects(&["/Plate"]);
    let options = CoverageOptions::default();
    let found = measure(
        &renderer,
        &region,
        std::slice::from_ref(&candidate),
        &options,
        &go_on,
    )
    .unwrap();
    let shares = &found.candidates[0].shares;
    let image = picture(&renderer, &region, &candidate, shares).unwrap();
    let (measured, hidden) = (count(&image, MEASURED), count(&image, HIDDEN));
    assert!(measured > 20_000, "{measured}");
    // The camera does not see the hidden stripe; the view from outside does.
    assert!(hidden > 500, "{hidden}");
    assert!(measured + hidden < image.pixels().len() / 2);
    assert_eq!(image, picture(&renderer, &region, &candidate, shares).unwrap());
    assert!(picture(&renderer, &objects(&["/None"]), &candidate, shares).is_err());
}
