use oaktwin_camera::OpenCv;
use oaktwin_camera::math::DVec3;
use proptest::prelude::*;

use super::*;
use crate::stage::{Attribute, AttributeValue};

const SIZE: ImageSize = ImageSize::new(640, 400);

fn prim_camera(schemas: &[&str], attributes: &[(&str, AttributeValue)]) -> SceneCamera {
    let mut camera = SceneCamera::default();
    camera.prim.path = "/World/Camera".to_owned();
    camera.prim.api_schemas = schemas.iter().map(|s| (*s).to_owned()).collect();
    for (name, value) in attributes {
        camera.prim.attributes.insert(
            (*name).to_owned(),
            Attribute {
                type_name: String::new(),
                value: Some(value.clone()),
                animated: false,
            },
        );
    }
    camera
}

fn apertures(focal: f64, horizontal: f64, vertical: f64) -> Vec<(&'static str, AttributeValue)> {
    vec![
        ("focalLength", AttributeValue::Float(focal)),
        ("horizontalAperture", AttributeValue::Float(horizontal)),
        ("verticalAperture", AttributeValue::Float(vertical)),
    ]
}

fn opencv(token: &str, values: &[(&str, f64)], size: [i64; 2]) -> Vec<(String, AttributeValue)> {
    let name = |name: &str| format!("omni:lensdistortion:{token}:{name}");
    let mut all = vec![
        (MODEL.to_owned(), AttributeValue::Text(token.to_owned())),
        (name("imageSize"), AttributeValue::Ints(size.to_vec())),
    ];
    all.extend(values.iter().map(|(n, v)| (name(n), AttributeValue::Float(*v))));
    all
}

fn with_lens(schema: &str, attributes: &[(String, AttributeValue)]) -> SceneCamera {
    let borrowed: Vec<(&str, AttributeValue)> =
        attributes.iter().map(|(n, v)| (n.as_str(), v.clone())).collect();
    prim_camera(&[schema], &borrowed)
}

fn codes(findings: &[Finding]) -> Vec<&str> {
    findings.iter().map(|f| f.code).collect()
}

#[test]
fn isaac_projection_ignores_aperture_offsets() {
    let mut attributes = apertures(20.0, 20.0, 20.0);
    attributes.push(("horizontalApertureOffset", AttributeValue::Float(1.0)));
    let prim = prim_camera(&[], &attributes);
    let (isaac, findings) = camera(&prim, SIZE, Projection::Isaac).unwrap();
    assert_eq!((isaac.intrinsics.fx, isaac.intrinsics.fy), (640.0, 640.0));
    assert_eq!(
        isaac.intrinsics.principal_point::<Usd>(),
        PixelPoint::new(320.0, 200.0)
    );
    assert_eq!(codes(&findings), ["aperture-offsets-ignored"]);
    let (usd, findings) = camera(&prim, SIZE, Projection::OpenUsd).unwrap();
    assert_eq!((usd.intrinsics.fx, usd.intrinsics.fy), (640.0, 400.0));
    assert_eq!(
        usd.intrinsics.principal_point::<Usd>(),
        PixelPoint::new(288.0, 200.0)
    );
    assert!(findings.is_empty());
}

#[test]
fn unauthored_optics_use_openusd_fallbacks() {
    let prim = prim_camera(&[], &[]);
    assert_eq!(default_size(&prim).unwrap(), ImageSize::new(1280, 934));
    let (view, findings) = camera(&prim, SIZE, Projection::Isaac).unwrap();
    assert!((view.intrinsics.fx - 640.0 * 50.0 / 20.955).abs() < 1e-9 && findings.is_empty());
    assert_eq!(clipping_range_m(&prim, 0.01).0, Some((0.01, 10_000.0)));
}

#[test]
fn default_size_is_at_least_one_pixel_high() {
    let prim = prim_camera(&[], &apertures(20.0, 20.0, 1e-9));
    assert_eq!(default_size(&prim).unwrap(), ImageSize::new(1280, 1));
}

#[test]
fn rejects_invalid_attributes_by_name() {
    for (focal, horizontal, vertical, attribute) in [
        (0.0, 20.0, 20.0, "focalLength is 0"),
        (-5.0, 20.0, 20.0, "focalLength is -5"),
        (f64::NAN, 20.0, 20.0, "focalLength is NaN"),
        (20.0, 0.0, 20.0, "horizontalAperture is 0"),
        (20.0, f64::INFINITY, 20.0, "horizontalAperture is inf"),
        (20.0, 20.0, -1.0, "verticalAperture is -1"),
        (1e-300, 1e300, 1.0, "focal length of 0 px"),
    ] {
        let prim = prim_camera(&[], &apertures(focal, horizontal, vertical));
        let error = camera(&prim, SIZE, Projection::OpenUsd).unwrap_err().to_string();
        assert!(
            error.starts_with("/World/Camera: ") && error.contains(attribute),
            "{error}"
        );
    }
    let prim = prim_camera(
        &[],
        &[("projection", AttributeValue::Text("orthographic".to_owned()))],
    );
    let error = camera(&prim, SIZE, Projection::Isaac).unwrap_err().to_string();
    assert!(error.contains("projection `orthographic`"), "{error}");
}

#[test]
fn clipping_range_is_in_metres_or_reported() {
    for (range, expected) in [
        ([1.0, 100.0], Some((0.01, 1.0))),
        ([0.0, 100.0], None),
        ([5.0, 5.0], None),
        ([f64::NAN, 5.0], None),
        ([1.0, f64::INFINITY], Some((0.01, f64::INFINITY))),
    ] {
        let prim = prim_camera(&[], &[("clippingRange", AttributeValue::Floats(range.to_vec()))]);
        let (got, finding) = clipping_range_m(&prim, 0.01);
        assert_eq!(got, expected, "{range:?}");
        assert_eq!(finding.is_none(), expected.is_some());
    }
}

#[test]
fn opencv_lens_replaces_apertures() {
    let values = [
        ("fx", 800.0),
        ("fy", 790.0),
        ("cx", 645.0),
        ("cy", 411.0),
        ("k1", -0.1),
    ];
    let prim = with_lens(
        "OmniLensDistortionOpenCvPinholeAPI",
        &opencv("opencvPinhole", &values, [1280, 800]),
    );
    for projection in [Projection::Isaac, Projection::OpenUsd] {
        let (view, findings) = camera(&prim, SIZE, projection).unwrap();
        assert_eq!((view.intrinsics.fx, view.intrinsics.fy), (400.0, 395.0));
        // Half of 645.5 in USD's convention, back in OpenCV's.
        assert_eq!(
            view.intrinsics.principal_point::<OpenCv>(),
            PixelPoint::new(322.25, 205.25)
        );
        let LensModel::OpenCvPinhole(lens) = view.lens else {
            panic!("{:?}", view.lens)
        };
        assert_eq!(lens.coefficients()[0], -0.1);
        assert!(findings.is_empty(), "{findings:?}");
    }
    let (_, findings) = camera(&prim, ImageSize::new(640, 480), Projection::Isaac).unwrap();
    assert_eq!(codes(&findings), ["lens-aspect"]);
}

#[test]
fn lens_without_distortion_is_a_pinhole() {
    let values = [("fx", 800.0), ("fy", 800.0), ("cx", 645.0), ("cy", 411.0)];
    let prim = with_lens(
        "OmniLensDistortionOpenCvPinholeAPI",
        &opencv("opencvPinhole", &values, [1280, 800]),
    );
    let (view, _) = camera(&prim, ImageSize::new(1280, 800), Projection::Isaac).unwrap();
    assert_eq!(view.lens, LensModel::Pinhole);
    assert_eq!(
        view.intrinsics.principal_point::<OpenCv>(),
        PixelPoint::new(645.0, 411.0)
    );
}

#[test]
fn reads_the_fisheye_of_wide_models() {
    let f = 1280.0 / 127f64.to_radians();
    let zeros = [("k1", 0.0), ("k2", 0.0), ("k3", 0.0), ("k4", 0.0)];
    let values = [&[("fx", f), ("fy", f), ("cx", 639.5), ("cy", 399.5)][..], &zeros].concat();
    let prim = with_lens(
        "OmniLensDistortionOpenCvFisheyeAPI",
        &opencv("opencvFisheye", &values, [1280, 800]),
    );
    let (view, findings) = camera(&prim, ImageSize::new(1280, 800), Projection::Isaac).unwrap();
    assert!(findings.is_empty());
    let edge = view.unproject(PixelPoint::<Usd>::new(1280.0, 400.0)).unwrap();
    assert!((edge.angle_between(DVec3::Z).to_degrees() - 63.5).abs() < 1e-9);
    // The schema's own fallback of k1 is not 0.
    let bare = with_lens(
        "OmniLensDistortionOpenCvFisheyeAPI",
        &opencv("opencvFisheye", &[("fx", f), ("fy", f)], [1280, 800]),
    );
    let (view, _) = camera(&bare, ImageSize::new(1280, 800), Projection::Isaac).unwrap();
    assert_eq!(
        view.lens,
        LensModel::OpenCvFisheye(OpenCvFisheye {
            k: [0.00245, 0.0, 0.0, 0.0]
        })
    );
}

#[test]
fn f_theta_uses_schema_fallbacks() {
    let mut prim = prim_camera(
        &["OmniLensDistortionFthetaAPI"],
        &[(MODEL, AttributeValue::Text("ftheta".to_owned()))],
    );
    let (view, findings) = camera(&prim, ImageSize::new(1936, 1216), Projection::Isaac).unwrap();
    assert!(findings.is_empty());
    let pixel = view.project(DVec3::Z).unwrap().to::<Usd>();
    assert!((pixel.x - 970.942_44).abs() < 1e-9 && (pixel.y - 600.374_8).abs() < 1e-9);
    for (name, value) in [("nominalWidth", 0.0), ("k1", 0.0), ("maxFov", f64::NAN)] {
        let mut bad = prim.clone();
        bad.prim.attributes.insert(
            format!("omni:lensdistortion:ftheta:{name}"),
            Attribute {
                type_name: String::new(),
                value: Some(AttributeValue::Float(value)),
                animated: false,
            },
        );
        assert!(camera(&bad, SIZE, Projection::Isaac).is_err(), "{name}");
    }
    prim.prim.api_schemas.clear();
    let (view, findings) = camera(&prim, SIZE, Projection::Isaac).unwrap();
    assert_eq!(
        (view.lens, codes(&findings)),
        (LensModel::Pinhole, vec!["lens-model"])
    );
}

#[test]
fn unsupported_models_are_reported_and_become_pinholes() {
    for (schema, token) in [
        ("OmniLensDistortionKannalaBrandtK3API", "kannalaBrandtK3"),
        ("OmniLensDistortionLutAPI", "lut"),
    ] {
        let prim = prim_camera(&[schema], &[(MODEL, AttributeValue::Text(token.to_owned()))]);
        let (view, findings) = camera(&prim, SIZE, Projection::Isaac).unwrap();
        assert_eq!(
            (view.lens, codes(&findings)),
            (LensModel::Pinhole, vec!["lens-unsupported"])
        );
    }
    let legacy = prim_camera(
        &[],
        &[(
            "cameraProjectionType",
            AttributeValue::Text("fisheyePolynomial".to_owned()),
        )],
    );
    let (_, findings) = camera(&legacy, SIZE, Projection::Isaac).unwrap();
    assert_eq!(codes(&findings), ["lens-unsupported"]);
}

#[test]
fn model_token_selects_between_two_schemas() {
    let both = [
        "OmniLensDistortionOpenCvPinholeAPI",
        "OmniLensDistortionOpenCvFisheyeAPI",
    ];
    let prim = prim_camera(
        &both,
        &[(MODEL, AttributeValue::Text("opencvFisheye".to_owned()))],
    );
    let (view, _) = camera(&prim, ImageSize::new(2048, 1024), Projection::Isaac).unwrap();
    assert!(matches!(view.lens, LensModel::OpenCvFisheye(_)));
    let prim = prim_camera(&both, &[]);
    let (_, findings) = camera(&prim, ImageSize::new(2048, 1024), Projection::Isaac).unwrap();
    assert_eq!(codes(&findings), ["lens-model"]);
}

#[test]
fn rejects_invalid_lens_values() {
    for (name, value) in [("fx", 0.0), ("fy", -1.0), ("cx", f64::NAN), ("k1", f64::INFINITY)] {
        let prim = with_lens(
            "OmniLensDistortionOpenCvPinholeAPI",
            &opencv("opencvPinhole", &[(name, value)], [1280, 800]),
        );
        assert!(camera(&prim, SIZE, Projection::Isaac).is_err(), "{name}");
    }
    let prim = with_lens(
        "OmniLensDistortionOpenCvPinholeAPI",
        &opencv("opencvPinhole", &[], [0, 800]),
    );
    assert!(camera(&prim, SIZE, Projection::Isaac).is_err());
}

proptest! {
    /// The ray at a relative position does not depend on the image size.
    #[test]
    fn stretching_keeps_the_view(w in 1u32..4000, h in 1u32..4000, u in 0.0..1.0f64, v in 0.0..1.0f64, cx in 500.0..800.0f64) {
        let values = [("fx", 800.0), ("fy", 790.0), ("cx", cx), ("cy", 411.0)];
        let prim = with_lens("OmniLensDistortionOpenCvPinholeAPI", &opencv("opencvPinhole", &values, [1280, 800]));
        let (a, _) = camera(&prim, ImageSize::new(1280, 800), Projection::Isaac).unwrap();
        let (b, _) = camera(&prim, ImageSize::new(w, h), Projection::Isaac).unwrap();
        let at = |size: ImageSize| PixelPoint::<Usd>::new(u * f64::from(size.width), v * f64::from(size.height));
        let (p, q) = (a.unproject(at(a.intrinsics.size)).unwrap(), b.unproject(at(b.intrinsics.size)).unwrap());
        prop_assert!((p - q).length() < 1e-12);
    }
}
