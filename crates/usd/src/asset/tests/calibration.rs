use std::collections::BTreeSet;

use oaktwin_camera::ApertureOffsets;
use oaktwin_catalog::Role;

use super::super::sample::{calibrated, nominal_of};
use super::super::*;
use super::{near, number, plain, prim};

#[test]
fn fisheye_lenses_are_limited_to_wide_models() {
    let options = AssetOptions {
        lens: LensChoice::Fisheye,
        ..plain()
    };
    let made = asset(&nominal_of("oak4_d_wide"), &options).unwrap();
    for name in ["Camera_left_ov9282", "Camera_right_ov9282"] {
        let camera = prim(&made, name);
        assert_eq!(camera.api_schemas, ["OmniLensDistortionOpenCvFisheyeAPI"]);
        near(
            number(camera, "omni:lensdistortion:opencvFisheye:fx"),
            577.5,
            0.05,
        );
        assert_eq!(number(camera, "omni:lensdistortion:opencvFisheye:cx"), 639.5);
        assert_eq!(number(camera, "omni:lensdistortion:opencvFisheye:k1"), 0.0);
    }
    for name in ["Camera_rgb_imx586", "Camera_pseudo_depth"] {
        assert!(prim(&made, name).api_schemas.is_empty());
    }
    for id in ["oak_d_pro_poe", "oak4_d", "oak_d_tof"] {
        let error = asset(&nominal_of(id), &options).unwrap_err();
        assert!(matches!(error, AssetError::NoFisheyeLens { .. }), "{error}");
    }

    // A calibration's lens takes precedence, and a finding reports it.
    let unit = calibrated(nominal_of("oak4_d_wide"), false);
    let made = asset(&unit, &options).unwrap();
    let left = prim(&made, "Camera_left_ov9282");
    assert_eq!(left.api_schemas, ["OmniLensDistortionOpenCvPinholeAPI"]);
    assert!(made.findings.iter().any(|f| f.code == "lens-from-calibration"));
}

#[test]
fn calibrated_assets_carry_all_calibrated_values() {
    let unit = calibrated(nominal_of("oak_d_pro_poe"), false);
    let made = asset(&unit, &plain()).unwrap();
    let left = prim(&made, "Camera_left_ov9282");
    let source = unit.camera(Role::Left).unwrap();
    let (fx, fy) = (source.intrinsics.fx, source.intrinsics.fy);
    near(
        number(left, "focalLength"),
        3.0 * f64::midpoint(fx, fy) * 1e-3,
        1e-6,
    );
    near(number(left, "horizontalAperture"), 3.84, 1e-6);
    let lens = |name: &str| number(left, &format!("omni:lensdistortion:opencvPinhole:{name}"));
    near(lens("fx"), fx, 1e-4);
    near(lens("fy"), fy, 1e-4);
    near(lens("cx"), 646.25, 1e-4);
    near(lens("cy"), 397.5, 1e-4);
    near(lens("k2"), 12.4, 1e-5);
    near(lens("s4"), -4e-4, 1e-9);
    // OpenUSD's sign and convention: h = −(646.25 + 0.5 − 640) · 3 µm, v = +(397.5 + 0.5 − 400) · 3 µm.
    near(number(left, "horizontalApertureOffset"), -0.02025, 1e-8);
    near(number(left, "verticalApertureOffset"), -0.006, 1e-8);
    // The depth camera is the rectified left camera, which has the right camera's intrinsics on RVC2.
    let depth = prim(&made, "Camera_pseudo_depth");
    let right = unit.camera(Role::Right).unwrap().intrinsics;
    for (name, expected) in [("cx", 645.25), ("fx", right.fx)] {
        let name = format!("omni:lensdistortion:opencvPinhole:{name}");
        near(number(depth, &name), expected, 1e-4);
    }
    assert_eq!(number(depth, "omni:lensdistortion:opencvPinhole:k1"), 0.0);
    let product = prim(&made, "TemplateRenderProducts/Camera_pseudo_depth_render_product");
    let focal_length_px = number(product, "omni:rtx:post:depthSensor:focalLengthPixel");
    assert_eq!(focal_length_px, right.fx.round());
    assert_eq!(number(product, "omni:rtx:post:depthSensor:noiseMean"), 0.25);
    // Tilt cannot be expressed; two of the three cameras have it.
    assert_eq!(
        made.findings
            .iter()
            .filter(|f| f.code == "lens-tilt-lost")
            .count(),
        2
    );
    // The lens schema excludes the legacy attributes.
    assert!(!made.text().contains("ftheta"));

    let document = AssetOptions {
        aperture_offsets: ApertureOffsets::Document,
        ..plain()
    };
    let left = prim(&asset(&unit, &document).unwrap(), "Camera_left_ov9282").clone();
    near(number(&left, "horizontalApertureOffset"), 0.01875, 1e-8);
    // Nominal cameras are centred with either formula.
    let nominal = asset(&nominal_of("oak_d_pro_poe"), &document).unwrap();
    assert_eq!(
        number(prim(&nominal, "Camera_left_ov9282"), "horizontalApertureOffset"),
        0.0
    );
}

#[test]
fn overrides_contain_calibrated_values_only() {
    let twin = nominal_of("oak_d_tof");
    let base = OverrideBase::new("../oak_d_tof.usd", &twin, PrimNames::Document);
    let error = overrides(&twin, &plain(), &base).unwrap_err();
    assert!(matches!(error, AssetError::NothingToOverride { .. }), "{error}");

    let unit = calibrated(twin, false);
    let base = OverrideBase::new("../oak_d_tof.usd", &unit, PrimNames::Document);
    let made = overrides(&unit, &plain(), &base).unwrap();
    assert_eq!(made.layer.sub_layers, ["../oak_d_tof.usd"]);
    assert!(!made.text().contains("def "));
    let names: BTreeSet<&str> = made.layer.prims[0].children[0]
        .children
        .iter()
        .flat_map(|prim| {
            prim.properties
                .iter()
                .chain(prim.children.iter().flat_map(|p| &p.properties))
        })
        .map(crate::text::Property::name)
        .filter(|name| !name.starts_with("omni:lensdistortion:"))
        .collect();
    let expected = [
        "focalLength",
        "horizontalApertureOffset",
        "omni:rtx:post:depthSensor:focalLengthPixel",
        "verticalApertureOffset",
    ];
    assert_eq!(names, BTreeSet::from(expected));
    let product = "TemplateRenderProducts/Camera_pseudo_depth_tof_render_product";
    let fx = unit.camera(Role::Tof).unwrap().intrinsics.fx;
    let focal_length_px = number(prim(&made, product), "omni:rtx:post:depthSensor:focalLengthPixel");
    assert_eq!(focal_length_px, fx.round());

    let base = OverrideBase::new("../oak_d_tof.usd", &unit, PrimNames::Isaac);
    let made = overrides(&unit, &plain(), &base).unwrap();
    for name in [
        "Camera_33d",
        "Camera_pseudo_depth",
        "Camera_pseudo_depth_tof",
        "Camera_left_ov9782",
    ] {
        prim(&made, name);
    }
    prim(&made, "TemplateRenderProducts/Camera_pseudo_depth_render_product");
}
