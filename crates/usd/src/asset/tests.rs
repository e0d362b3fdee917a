mod calibration;
mod every_option;

use std::collections::BTreeSet;

use super::sample::{calibrated, nominal_of};
use super::*;

fn plain() -> AssetOptions {
    AssetOptions::default()
}

fn text(twin: &Twin, options: &AssetOptions) -> String {
    asset(twin, options).unwrap().text()
}

/// Returns the prim at `/Root/DEVICE/PATH`.
fn prim<'a>(asset: &'a Asset, path: &str) -> &'a PrimSpec {
    path.split('/')
        .fold(&asset.layer.prims[0].children[0], |prim, name| {
            prim.child(name).unwrap_or_else(|| panic!("{path}"))
        })
}

fn number(prim: &PrimSpec, name: &str) -> f64 {
    match prim.attribute(name).and_then(|attribute| attribute.value.clone()) {
        Some(SpecValue::Float(value)) => value.into(),
        other => panic!("{name}: {other:?}"),
    }
}

fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} {b}");
}

/// Compares with a snapshot in which the version is masked, since every release changes it.
fn snapshot(text: &str, name: &str) {
    insta::assert_snapshot!(name, text.replace(env!("CARGO_PKG_VERSION"), "VERSION"));
}

#[test]
fn writes_the_expected_text_of_an_asset() {
    let options = AssetOptions {
        body: false,
        ..plain()
    };
    snapshot(&text(&nominal_of("oak_d_pro_poe"), &options), "asset");
}

#[test]
fn writes_the_expected_text_of_overrides() {
    let twin = calibrated(nominal_of("oak_d_tof"), false);
    let base = OverrideBase::new("./oak_d_tof.usd", &twin, PrimNames::Isaac);
    snapshot(&overrides(&twin, &plain(), &base).unwrap().text(), "overrides");
}

/// The sheet's "Camera Parameters" table: focal length, apertures, by model.
#[test]
fn optics_match_the_sheet() {
    for (id, first, (f, w, h), (stereo_f, stereo)) in [
        (
            "oak_d_pro_poe",
            "Camera_rgb_imx378",
            (4.7626, 5.952, 3.348),
            (2.4138, "ov9282"),
        ),
        (
            "oak_d_pro_w_poe",
            "Camera_rgb_imx378",
            (3.5467, 5.952, 3.348),
            (1.6987, "ov9282"),
        ),
        (
            "oak4_d",
            "Camera_rgb_imx586",
            (4.7442, 6.4, 4.8),
            (2.4138, "ov9282"),
        ),
        (
            "oak4_d_wide",
            "Camera_rgb_imx586",
            (3.3137, 6.4, 4.8),
            (1.6987, "ov9282"),
        ),
        (
            "oak_d_tof",
            "Camera_tof_33d",
            (3.1991, 4.48, 3.36),
            (2.2882, "ov9782"),
        ),
    ] {
        let asset = asset(&nominal_of(id), &plain()).unwrap();
        let left = format!("Camera_left_{stereo}");
        let right = format!("Camera_right_{stereo}");
        for (name, f, w, h) in [
            (first, f, w, h),
            (&left, stereo_f, 3.84, 2.4),
            (&right, stereo_f, 3.84, 2.4),
        ] {
            let camera = prim(&asset, name);
            near(number(camera, "focalLength"), f, 0.5e-4);
            near(number(camera, "horizontalAperture"), w, 1e-6);
            near(number(camera, "verticalAperture"), h, 1e-6);
            for zero in ["horizontalApertureOffset", "verticalApertureOffset", "fStop"] {
                assert_eq!(number(camera, zero), 0.0);
            }
        }
    }
}

#[test]
fn prim_names_match_the_sheet() {
    let names = |id: &str| {
        let asset = asset(
            &nominal_of(id),
            &AssetOptions {
                body: false,
                ..plain()
            },
        )
        .unwrap();
        let device = &asset.layer.prims[0].children[0];
        let mut names: Vec<String> = device.children.iter().map(|child| child.name.clone()).collect();
        let products = device.child(PRODUCTS).unwrap();
        names.extend(products.children.iter().map(|child| child.name.clone()));
        names
    };
    assert_eq!(
        names("oak_d_pro_poe"),
        [
            "Camera_pseudo_depth",
            "Camera_rgb_imx378",
            "Camera_left_ov9282",
            "Camera_right_ov9282",
            "Imu_Sensor",
            "TemplateRenderProducts",
            "Camera_pseudo_depth_render_product",
        ]
    );
    assert_eq!(
        names("oak_d_tof"),
        [
            "Camera_pseudo_depth_stereo",
            "Camera_pseudo_depth_tof",
            "Camera_tof_33d",
            "Camera_left_ov9782",
            "Camera_right_ov9782",
            "Imu_Sensor",
            "TemplateRenderProducts",
            "Camera_pseudo_depth_stereo_render_product",
            "Camera_pseudo_depth_tof_render_product",
        ]
    );
}

/// A camera prim looks along −z with y up, which must be forward and up in the body frame.
#[test]
fn cameras_look_forward_and_are_upright() {
    let asset = asset(&nominal_of("oak_d_pro_poe"), &plain()).unwrap();
    let left = prim(&asset, "Camera_left_ov9282");
    let value = |name: &str| left.attribute(name).unwrap().value.clone().unwrap();
    assert_eq!(value("xformOp:translate"), SpecValue::Double3([0.0, 0.0375, 0.0]));
    let SpecValue::Quatd([w, x, y, z]) = value("xformOp:orient") else {
        panic!("a quatd");
    };
    let q = oaktwin_camera::math::DQuat::from_xyzw(x, y, z, w);
    let v = oaktwin_camera::math::DVec3::new;
    assert!((q * v(0.0, 0.0, -1.0)).abs_diff_eq(v(1.0, 0.0, 0.0), 1e-15));
    assert!((q * v(0.0, 1.0, 0.0)).abs_diff_eq(v(0.0, 0.0, 1.0), 1e-15));
}

#[test]
fn isaac_version_selects_attribute_names_types_and_render_variables() {
    let twin = nominal_of("oak_d_pro_poe");
    let product = "TemplateRenderProducts/Camera_pseudo_depth_render_product";
    let outlier = "omni:rtx:post:depthSensor:outlierRemovalEnabled";
    let old = asset(&twin, &plain()).unwrap();
    let v6 = AssetOptions {
        isaac: IsaacVersion::V6,
        ..plain()
    };
    let new = asset(&twin, &v6).unwrap();
    let value = |asset: &Asset| prim(asset, product).attribute(outlier).unwrap().value.clone();
    assert_eq!(value(&old), Some(SpecValue::Int(3)));
    assert_eq!(value(&new), Some(SpecValue::Bool(true)));
    let depth_attributes = |asset: &Asset| {
        let product = prim(asset, product);
        let names = product.properties.iter().map(|p| p.name().to_owned());
        names.filter(|name| name.starts_with("omni:")).count()
    };
    assert_eq!((depth_attributes(&old), depth_attributes(&new)), (11, 11));
    for camera in ["Camera_rgb_imx378", "Camera_left_ov9282", "Camera_pseudo_depth"] {
        assert!(prim(&old, camera).api_schemas.is_empty());
        assert_eq!(prim(&new, camera).api_schemas, ["OmniSensorAPI"]);
    }

    let rgb = "Camera_rgb_imx378";
    assert_eq!(number(prim(&old, rgb), "fthetaMaxFov"), 82.0);
    assert!(!text(&twin, &v6).contains("ftheta"));
    assert!(
        text(
            &twin,
            &AssetOptions {
                legacy_distortion: true,
                ..v6
            }
        )
        .contains("fthetaPolyF")
    );
    assert!(!old.text().contains("Not Applicable"));
    assert!(!old.text().contains("RenderVar"));
    assert_eq!(new.text().matches("def RenderVar").count(), 7);
}

#[test]
fn ovrtx_assets_apply_the_schema_to_the_camera_and_note_that_it_is_assumed() {
    let options = AssetOptions {
        target: AssetTarget::Ovrtx,
        ..plain()
    };
    let asset = asset(&nominal_of("oak_d_tof"), &options).unwrap();
    let camera = prim(&asset, "Camera_pseudo_depth_tof");
    assert_eq!(camera.api_schemas, ["OmniSensorGenericDepthSensorSingleViewAPI"]);
    assert_eq!(number(camera, "omni:sensor:depthSensor:baselineMM"), 0.5);
    assert!(!asset.text().contains("omni:rtx:post"));
    assert_eq!(asset.text().matches("def RenderVar").count(), 8);
    assert_eq!(asset.findings.len(), 2);
    assert!(
        asset.findings[0]
            .message
            .contains("omni:sensor:depthSensor:noiseMean")
    );
}

#[test]
fn extended_disparity_changes_range_and_is_rejected_for_tof() {
    let options = AssetOptions {
        extended_disparity: true,
        ..plain()
    };
    for (id, min_distance) in [("oak_d_pro_poe", 0.3), ("oak_d_pro_w_poe", 0.2), ("oak4_d", 0.3)] {
        let asset = asset(&nominal_of(id), &options).unwrap();
        let product = prim(
            &asset,
            "TemplateRenderProducts/Camera_pseudo_depth_render_product",
        );
        assert_eq!(
            number(product, "omni:rtx:post:depthSensor:maxDisparityPixel"),
            191.0
        );
        near(
            number(product, "omni:rtx:post:depthSensor:minDistance"),
            min_distance,
            1e-7,
        );
    }
    let error = asset(&nominal_of("oak_d_tof"), &options).unwrap_err();
    assert!(matches!(error, AssetError::NoExtendedDisparity { .. }), "{error}");
}

#[test]
fn rigid_bodies_have_mass_collider_and_materials() {
    let twin = nominal_of("oak4_d");
    let made = asset(
        &twin,
        &AssetOptions {
            rigid_body: true,
            ..plain()
        },
    )
    .unwrap();
    let device = &made.layer.prims[0].children[0];
    assert_eq!(device.api_schemas, ["PhysicsRigidBodyAPI", "PhysicsMassAPI"]);
    near(
        number(device, "physics:mass"),
        twin.device.body.mass_g * 1e-3,
        1e-7,
    );
    let collider = prim(&made, "collisions").children[0].clone();
    let Some(SpecValue::Float3Array(extent)) = &collider.attribute("extent").unwrap().value else {
        panic!("an extent");
    };
    // x is the depth, y the width, z the height.
    let [width, height, depth] = twin.device.body.dimensions_mm;
    for (axis, mm) in [depth, width, height].into_iter().enumerate() {
        near(f64::from(extent[1][axis] - extent[0][axis]), mm * 1e-3, 2e-6);
    }
    // Every mesh is bound to an existing material, and every material is bound.
    let bound: BTreeSet<String> = prim(&made, "visuals")
        .children
        .iter()
        .flat_map(|mesh| &mesh.properties)
        .filter_map(|property| match property {
            crate::text::Property::Relationship(binding) => binding.targets.first().cloned(),
            crate::text::Property::Attribute(_) => None,
        })
        .collect();
    let looks = &prim(&made, "Looks").children;
    let materials = looks.iter().map(|m| format!("/Root/oak4_d/Looks/{}", m.name));
    assert_eq!(bound, materials.collect());

    // The collider does not depend on the visible body.
    let bare = AssetOptions {
        body: false,
        rigid_body: true,
        ..plain()
    };
    let made = asset(&twin, &bare).unwrap();
    assert!(made.text().contains("PhysicsCollisionAPI") && !made.text().contains("Looks"));
}

#[test]
fn rejects_invalid_names_and_numbers() {
    let mut twin = nominal_of("oak4_d");
    twin.cameras[1].spec.prim = "Camera left".into();
    let error = asset(&twin, &plain()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "OAK4-D: /Root/oak4_d: invalid prim name \"Camera left\"; use letters, digits and underscores"
    );
    twin.cameras[1].spec.prim = "Imu_Sensor".into();
    assert!(matches!(
        asset(&twin, &plain()),
        Err(AssetError::Duplicate { .. })
    ));

    let mut twin = nominal_of("oak4_d");
    twin.cameras[0].intrinsics.fx = f64::NAN;
    let error = asset(&twin, &plain()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "OAK4-D: /Root/oak4_d/Camera_rgb_imx586.focalLength: not a finite 32-bit number; correct the catalog or the \
         calibration"
    );
    twin.cameras.clear();
    assert!(matches!(
        asset(&twin, &plain()),
        Err(AssetError::MissingCamera { .. })
    ));
}
