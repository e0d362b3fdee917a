use std::collections::BTreeSet;
use std::path::Path;

use oaktwin_camera::ApertureOffsets;
use oaktwin_catalog::{Origin, Role};

use super::sample::{calibrated, nominal, nominal_of};
use super::*;

fn plain() -> AssetOptions {
    AssetOptions::default()
}

fn text(twin: &Twin, options: &AssetOptions) -> String {
    asset(twin, options).unwrap().text()
}

/// The prim at `/Root/DEVICE/PATH`.
fn prim<'a>(asset: &'a Asset, path: &str) -> &'a Prim {
    path.split('/')
        .fold(&asset.layer.prims[0].children[0], |prim, name| {
            prim.child(name).unwrap_or_else(|| panic!("{path}"))
        })
}

fn number(prim: &Prim, name: &str) -> f64 {
    match prim.attribute(name).and_then(|attribute| attribute.value.clone()) {
        Some(Value::Float(value)) => value.into(),
        other => panic!("{name}: {other:?}"),
    }
}

fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} {b}");
}

/// A release changes the version in every asset and nothing else.
fn snapshot(text: &str, name: &str) {
    insta::assert_snapshot!(name, text.replace(env!("CARGO_PKG_VERSION"), "VERSION"));
}

#[test]
fn the_text_of_one_asset() {
    let options = AssetOptions {
        body: false,
        ..plain()
    };
    snapshot(&text(&nominal_of("oak_d_pro_poe"), &options), "asset");
}

#[test]
fn the_text_of_overrides() {
    let twin = calibrated(nominal_of("oak_d_tof"), false);
    let base = OverrideBase::new("./oak_d_tof.usd", &twin, PrimNames::Isaac);
    snapshot(&overrides(&twin, &plain(), &base).unwrap().text(), "overrides");
}

/// The sheet's "Camera Parameters" table: focal length, apertures, by model.
#[test]
fn optics_are_those_of_the_sheet() {
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
fn the_trees_of_the_sheet() {
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

/// A camera prim looks along −z with y up: that is forward and up in the body.
#[test]
fn cameras_look_forward_right_way_up() {
    let asset = asset(&nominal_of("oak_d_pro_poe"), &plain()).unwrap();
    let left = prim(&asset, "Camera_left_ov9282");
    let value = |name: &str| left.attribute(name).unwrap().value.clone().unwrap();
    assert_eq!(value("xformOp:translate"), Value::Double3([0.0, 0.0375, 0.0]));
    let Value::Quatd([w, x, y, z]) = value("xformOp:orient") else {
        panic!("a quatd");
    };
    let q = oaktwin_camera::math::DQuat::from_xyzw(x, y, z, w);
    let v = oaktwin_camera::math::DVec3::new;
    assert!((q * v(0.0, 0.0, -1.0)).abs_diff_eq(v(1.0, 0.0, 0.0), 1e-15));
    assert!((q * v(0.0, 1.0, 0.0)).abs_diff_eq(v(0.0, 0.0, 1.0), 1e-15));
}

#[test]
fn the_version_decides_about_old_names_types_and_render_variables() {
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
    assert_eq!(value(&old), Some(Value::Int(3)));
    assert_eq!(value(&new), Some(Value::Bool(true)));
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
fn ovrtx_has_its_schema_on_the_camera_and_says_that_it_guesses() {
    let options = AssetOptions {
        target: Target::Ovrtx,
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
fn extended_disparity() {
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
fn fisheye_lenses_of_the_wide_models() {
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

    // A calibration's own lens wins, and that is said.
    let unit = calibrated(nominal_of("oak4_d_wide"), false);
    let made = asset(&unit, &options).unwrap();
    let left = prim(&made, "Camera_left_ov9282");
    assert_eq!(left.api_schemas, ["OmniLensDistortionOpenCvPinholeAPI"]);
    assert!(made.findings.iter().any(|f| f.code == "lens-from-calibration"));
}

#[test]
fn a_calibration_is_authored_whole() {
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
    // The depth camera is the left one, rectified.
    let depth = prim(&made, "Camera_pseudo_depth");
    near(
        number(depth, "omni:lensdistortion:opencvPinhole:cx"),
        646.25,
        1e-4,
    );
    assert_eq!(number(depth, "omni:lensdistortion:opencvPinhole:k1"), 0.0);
    let product = prim(&made, "TemplateRenderProducts/Camera_pseudo_depth_render_product");
    let focal_length_px = number(product, "omni:rtx:post:depthSensor:focalLengthPixel");
    assert_eq!(focal_length_px, fx.round());
    assert_eq!(number(product, "omni:rtx:post:depthSensor:noiseMean"), 0.25);
    // The tilt cannot be written: two of the three cameras have one.
    assert_eq!(
        made.findings
            .iter()
            .filter(|f| f.code == "lens-tilt-lost")
            .count(),
        2
    );
    // Lens schema or old names, not both.
    assert!(!made.text().contains("ftheta"));

    let document = AssetOptions {
        aperture_offsets: ApertureOffsets::Document,
        ..plain()
    };
    let left = prim(&asset(&unit, &document).unwrap(), "Camera_left_ov9282").clone();
    near(number(&left, "horizontalApertureOffset"), 0.01875, 1e-8);
    // Nominal cameras are centred, whatever the formula.
    let nominal = asset(&nominal_of("oak_d_pro_poe"), &document).unwrap();
    assert_eq!(
        number(prim(&nominal, "Camera_left_ov9282"), "horizontalApertureOffset"),
        0.0
    );
}

#[test]
fn overrides_hold_what_a_calibration_changes() {
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

#[test]
fn bodies_and_rigid_bodies() {
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
    let Some(Value::Float3Array(extent)) = &collider.attribute("extent").unwrap().value else {
        panic!("an extent");
    };
    // x is along the depth, y along the width, z along the height.
    let [width, height, depth] = twin.device.body.dimensions_mm;
    for (axis, mm) in [depth, width, height].into_iter().enumerate() {
        near(f64::from(extent[1][axis] - extent[0][axis]), mm * 1e-3, 2e-6);
    }
    // Every mesh has a material that is there, and no material is there for nothing.
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

    // The collider needs no visible body.
    let bare = AssetOptions {
        body: false,
        rigid_body: true,
        ..plain()
    };
    let made = asset(&twin, &bare).unwrap();
    assert!(made.text().contains("PhysicsCollisionAPI") && !made.text().contains("Looks"));
}

#[test]
fn bad_names_and_numbers_are_refused() {
    let mut twin = nominal_of("oak4_d");
    twin.cameras[1].spec.prim = "Camera left".into();
    let error = asset(&twin, &plain()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "OAK4-D: /Root/oak4_d: \"Camera left\" is no prim name; use letters, digits and underscores"
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

/// Every option that a model can have, nominal and calibrated.
fn every_asset() -> Vec<(String, Asset)> {
    let mut all = Vec::new();
    for twin in nominal() {
        for (kind, twin) in [
            ("nominal", twin.clone()),
            ("rational", calibrated(twin.clone(), false)),
            ("fisheye", calibrated(twin.clone(), true)),
        ] {
            for (isaac, target) in [
                (IsaacVersion::V5_1, Target::Isaac),
                (IsaacVersion::V6, Target::Isaac),
                (IsaacVersion::V6, Target::Ovrtx),
            ] {
                // Bodies are bulky and meet no other option but the rigid body.
                let bodies = kind == "nominal" && (isaac, target) == (IsaacVersion::V5_1, Target::Isaac);
                for flags in (0..16u8).chain([16, 24].into_iter().filter(|_| bodies)) {
                    let flag = |bit: u8| flags >> bit & 1 == 1;
                    let options = AssetOptions {
                        isaac,
                        target,
                        lens: if flag(0) {
                            LensChoice::Fisheye
                        } else {
                            LensChoice::Pinhole
                        },
                        extended_disparity: flag(1),
                        legacy_distortion: flag(2),
                        rigid_body: flag(3),
                        body: flag(4),
                        ..plain()
                    };
                    let Ok(made) = asset(&twin, &options) else {
                        continue;
                    };
                    let name = format!("{}-{kind}-{}-{}-{flags}", made.stem, isaac.name(), target.name());
                    all.push((name, made));
                }
            }
            if twin.origin != Origin::Nominal {
                for (name, names) in [("document", PrimNames::Document), ("isaac", PrimNames::Isaac)] {
                    let base = format!("./{}-nominal-5.1-isaac-0.usda", twin.device.id);
                    let base = OverrideBase::new(&base, &twin, names);
                    let made = overrides(&twin, &plain(), &base).unwrap();
                    all.push((format!("{}-{kind}-over-{name}", twin.device.id), made));
                }
            }
        }
    }
    all
}

#[test]
fn same_bytes_every_time_and_relationships_reach_something() {
    for (name, made) in every_asset() {
        assert_eq!(
            made.bytes(Format::Usdz).unwrap(),
            made.bytes(Format::Usdz).unwrap()
        );
        let mut paths = BTreeSet::new();
        let mut targets = Vec::new();
        for root in &made.layer.prims {
            walk(root, "", &mut paths, &mut targets);
        }
        for target in targets {
            let prim = target.split('.').next().unwrap();
            assert!(paths.contains(prim), "{name}: {target}");
        }
    }
}

fn walk(prim: &Prim, parent: &str, paths: &mut BTreeSet<String>, targets: &mut Vec<String>) {
    use crate::text::Property;
    let path = format!("{parent}/{}", prim.name);
    for property in &prim.properties {
        targets.extend(match property {
            Property::Relationship(relationship) => relationship.targets.clone(),
            Property::Attribute(attribute) => attribute.connections.clone(),
        });
    }
    for child in &prim.children {
        walk(child, &path, paths, targets);
    }
    paths.insert(path);
}

/// Writes every asset to the folder that `OAKTWIN_WRITE_ASSETS` names, for OpenUSD and the validators to look at.
#[test]
fn write_for_openusd() {
    let Some(folder) = std::env::var_os("OAKTWIN_WRITE_ASSETS") else {
        println!("skipped: OAKTWIN_WRITE_ASSETS is not set");
        return;
    };
    for (name, made) in every_asset() {
        let path = Path::new(&folder).join(name);
        for format in [Format::Usda, Format::Usdz] {
            if format == Format::Usdz && !made.layer.sub_layers.is_empty() {
                continue;
            }
            let path = format!("{}.{}", path.display(), format.extension());
            std::fs::write(path, made.bytes(format).unwrap()).unwrap();
        }
    }
}
