//! What a colour camera records.

#![expect(clippy::unwrap_used, reason = "a test")]

use oaktwin::camera::ImageSize;
use oaktwin::camera::math::DVec3;
use oaktwin::catalog::Catalog;
use oaktwin::depth::imager::ColorParameters;
use oaktwin::image::annotation::{Annotator, Frame};
use oaktwin::render::{Renderer, Rig, RigSpec, look_at};

use crate::plates::{plate, room};

fn shoot(cameras: &[&str], imager: Option<ColorParameters>, number: u64) -> Vec<Frame> {
    let mut scene = room(64, None);
    plate(&mut scene, 3.0, [-9.0, 9.0], [-9.0, 9.0], 20.0);
    let renderer = Renderer::new(scene);
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(catalog.device("OAK-D Pro PoE").unwrap());
    let spec = RigSpec {
        cameras: cameras.iter().map(|name| (*name).to_owned()).collect(),
        size: Some(ImageSize::new(320, 200)),
        annotators: vec![
            Annotator::Rgb,
            Annotator::DistanceToImagePlane,
            Annotator::DepthSensorDistance,
        ],
        rgb_imager: imager,
        is_sensor_optional: true,
        ..RigSpec::default()
    };
    let (mut rig, _) = Rig::new(&twin, &spec).unwrap();
    let pose = look_at(DVec3::ZERO, DVec3::X, DVec3::Z).unwrap();
    let (shots, _) = rig.shoot(&renderer, Some(&pose), number).unwrap();
    shots.into_iter().map(|shot| shot.frame).collect()
}

/// The mean of green over the image, and the mean of its absolute difference to another image.
fn green(frame: &Frame, other: &Frame) -> [f64; 2] {
    let [own, other] = [frame, other].map(|frame| frame.rgb.as_ref().unwrap());
    let pixels = own.pixels().iter().zip(other.pixels());
    let sums = pixels.fold([0.0; 2], |[sum, differs], (own, other)| {
        [
            sum + f64::from(own[1]),
            differs + f64::from(own[1].abs_diff(other[1])),
        ]
    });
    sums.map(|sum| sum / own.pixels().len() as f64)
}

/// Noise depends on the frame and the camera only, and changes neither depth nor coverage.
#[test]
fn colours_are_recorded_and_depth_is_not() {
    let cameras = ["rgb", "depth"];
    let exact = shoot(&cameras, None, 4);
    let on = Some(ColorParameters::default());
    let recorded = shoot(&cameras, on, 4);
    assert_eq!(recorded, shoot(&cameras, on, 4));
    let next = shoot(&cameras, on, 5);
    for ((exact, recorded), next) in exact.iter().zip(&recorded).zip(&next) {
        assert_eq!(exact.distance_to_image_plane, recorded.distance_to_image_plane);
        assert_eq!(exact.depth_sensor_distance, recorded.depth_sensor_distance);
        assert!(recorded.light.is_none());
        let alpha = |frame: &Frame| -> Vec<u8> {
            let rgb = frame.rgb.as_ref().unwrap();
            rgb.pixels().iter().map(|pixel| pixel[3]).collect()
        };
        assert_eq!(alpha(exact), alpha(recorded));
        let [_, differs] = green(recorded, next);
        assert!(differs > 0.2, "{differs}");
    }
    assert!(exact[1].depth_sensor_distance.is_some());
    // 18 % of linear light is 118 in sRGB; the mean of a pattern is lower.
    let [mean, _] = green(&recorded[0], &exact[0]);
    assert!((85.0..125.0).contains(&mean), "{mean}");
}

/// The OV9282 of the pair has no colour filters, and the IMX378 has.
#[test]
fn monochrome_cameras_record_grey() {
    let colourful = |frame: &Frame| {
        let rgb = frame.rgb.as_ref().unwrap();
        rgb.pixels().iter().any(|[r, g, b, _]| r != g || g != b)
    };
    let recorded = shoot(&["rgb", "left", "depth"], Some(ColorParameters::default()), 0);
    assert_eq!(
        recorded.iter().map(colourful).collect::<Vec<_>>(),
        [true, false, false]
    );
}

/// With a fixed exposure, half the light gives half of each value, and a dim room is noisy.
#[test]
fn the_light_is_a_parameter() {
    let fixed = |light: f64| ColorParameters {
        light,
        auto_exposure: false,
        exposure: 0.5,
        noise: false,
        ..ColorParameters::default()
    };
    let linear = |imager: ColorParameters| -> f64 {
        let table = oaktwin::image::srgb::linear_from_srgb();
        let frame = &shoot(&["rgb"], Some(imager), 0)[0];
        let rgb = frame.rgb.as_ref().unwrap();
        let all = rgb
            .pixels()
            .iter()
            .map(|pixel| f64::from(table[usize::from(pixel[1])]));
        all.sum()
    };
    let (bright, dim) = (linear(fixed(1.0)), linear(fixed(0.5)));
    assert!((dim / bright - 0.5).abs() < 0.005, "{}", dim / bright);
    let noise = |light: f64| {
        let imager = ColorParameters {
            light,
            ..ColorParameters::default()
        };
        let [one, two] = [0, 1].map(|number| shoot(&["rgb"], Some(imager), number));
        green(&one[0], &two[0])[1]
    };
    let (day, night) = (noise(1.0), noise(0.02));
    assert!(night > 2.0 * day, "{day} {night}");
}
