//! All assets that this crate writes pass its linter.
#![expect(clippy::unwrap_used, reason = "a test")]

use oaktwin_base::diagnostic::Level;
use oaktwin_camera::{
    ApertureOffsets, Intrinsics, LensModel, OpenCv, OpenCvFisheye, OpenCvPinhole, PixelPoint,
};
use oaktwin_catalog::{Catalog, Origin, Twin};

use oaktwin_usd::asset::{
    AssetOptions, AssetTarget, Format, IsaacVersion, LensChoice, OverrideBase, PrimNames, asset, overrides,
};
use oaktwin_usd::check::{CheckOptions, CheckReport, RULES, check, check_stage};
use oaktwin_usd::stage::{self, SceneLimit};

/// Returns a unit with typical calibration: focal lengths 2 % off, unequal fx and fy, an off-centre principal point.
fn calibrated(nominal: &Twin, fisheye: bool) -> Twin {
    let mut twin = nominal.clone();
    for (index, camera) in twin.cameras.iter_mut().enumerate() {
        let k = camera.intrinsics;
        let f = k.fx * if index % 2 == 0 { 1.02 } else { 0.985 };
        let centre = k.principal_point::<OpenCv>();
        camera.intrinsics = Intrinsics::new(
            k.size,
            f + 0.7,
            f - 0.7,
            PixelPoint::<OpenCv>::new(centre.x + 9.3, centre.y - 6.1),
        );
        camera.lens = if fisheye {
            LensModel::OpenCvFisheye(OpenCvFisheye {
                k: [0.02, -0.01, 0.003, -0.0005],
            })
        } else {
            let mut coefficients = [0.0; 14];
            coefficients[..8].copy_from_slice(&[2.1, 1.3, 1e-4, -2e-4, 0.05, 2.4, 1.9, 0.2]);
            LensModel::OpenCvPinhole(OpenCvPinhole::new(coefficients))
        };
    }
    twin.origin = Origin::Calibration {
        product_name: twin.device.name.clone(),
        file_name: "unit.json".into(),
    };
    for index in 0..twin.depth_sensors.len() {
        let camera = twin.depth_camera(&twin.depth_sensors[index]);
        twin.depth_sensors[index].focal_length_px = camera.unwrap().intrinsics.fx.round();
    }
    twin
}

fn every_option() -> Vec<AssetOptions> {
    const OFFSETS: [ApertureOffsets; 3] = [
        ApertureOffsets::OpenUsd,
        ApertureOffsets::Document,
        ApertureOffsets::Zero,
    ];
    (0..16)
        .map(|bits| {
            let bit = |n: u32| bits >> n & 1 == 1;
            AssetOptions {
                isaac: if bit(0) {
                    IsaacVersion::V6
                } else {
                    IsaacVersion::V5_1
                },
                target: if bit(1) {
                    AssetTarget::Ovrtx
                } else {
                    AssetTarget::Isaac
                },
                lens: if bit(2) {
                    LensChoice::Fisheye
                } else {
                    LensChoice::Pinhole
                },
                aperture_offsets: OFFSETS[bits % 3],
                extended_disparity: bit(3),
                legacy_distortion: bit(0),
                rigid_body: bit(3),
                body: bits == 9,
            }
        })
        .collect()
}

/// Returns the findings above the level of notes.
fn problems(report: &CheckReport) -> Vec<String> {
    let worse = report
        .findings
        .iter()
        .filter(|finding| finding.level > Level::Note);
    worse.map(ToString::to_string).collect()
}

#[test]
fn exhaustive_options_of_assets_have_notes_at_most() {
    let folder = tempfile::tempdir().unwrap();
    let catalog = Catalog::builtin();
    let mut checked = 0;
    for device in catalog.devices() {
        let nominal = catalog.nominal(device);
        let units = [
            nominal.clone(),
            calibrated(&nominal, false),
            calibrated(&nominal, true),
        ];
        for twin in &units {
            for options in every_option() {
                let Ok(asset) = asset(twin, &options) else {
                    continue;
                };
                let format = if options.rigid_body {
                    Format::Usdz
                } else {
                    Format::Usd
                };
                let path = folder.path().join(asset.file_name(format));
                std::fs::write(&path, asset.bytes(format).unwrap()).unwrap();
                let stage = stage::open(&path, SceneLimit::default()).unwrap();
                for model in [None, Some(&nominal)] {
                    let report = check_stage(
                        &stage,
                        &CheckOptions {
                            catalog,
                            model,
                            ..CheckOptions::default()
                        },
                    );
                    assert_eq!(problems(&report), [""; 0], "{} {options:?}", device.name);
                    assert_eq!(report.depth_sensors.len(), device.depth_sensors.len());
                    assert_eq!(
                        report.cameras.len(),
                        device.cameras.len() + device.depth_sensors.len()
                    );
                    assert!(report.cameras.iter().all(|camera| camera.model.is_some()));
                }
                checked += 1;
            }
        }
    }
    assert!(checked > 100, "only {checked} assets could be written");
}

#[test]
fn checks_overrides_together_with_their_base() {
    let folder = tempfile::tempdir().unwrap();
    let catalog = Catalog::builtin();
    for device in catalog.devices() {
        let nominal = catalog.nominal(device);
        let options = AssetOptions::default();
        let base = asset(&nominal, &options).unwrap();
        let base_name = base.file_name(Format::Usd);
        std::fs::write(folder.path().join(&base_name), base.text()).unwrap();
        let unit = calibrated(&nominal, false);
        let reference = format!("./{base_name}");
        let over = overrides(
            &unit,
            &options,
            &OverrideBase::new(&reference, &unit, PrimNames::Document),
        )
        .unwrap();
        let path = folder.path().join("unit.usda");
        std::fs::write(&path, over.text()).unwrap();
        let report = check(&path, &CheckOptions::default()).unwrap();
        assert_eq!(problems(&report), [""; 0], "{}", device.name);
        assert!(report.cameras.iter().all(|camera| camera.lens.is_some()));

        std::fs::remove_file(folder.path().join(&base_name)).unwrap();
        let report = check(&path, &CheckOptions::default()).unwrap();
        let codes: Vec<&str> = report.findings.iter().map(|finding| finding.code).collect();
        assert_eq!(codes, ["no-camera", "composition"], "{:?}", report.findings);
        assert!(
            report.findings[0].message.contains("only overrides"),
            "{:?}",
            report.findings
        );
    }
}

#[test]
fn rules_have_unique_codes_and_texts() {
    let mut codes: Vec<&str> = RULES.iter().map(|rule| rule.code).collect();
    codes.sort_unstable();
    let all = codes.len();
    codes.dedup();
    assert_eq!(codes.len(), all);
    assert!(RULES.iter().all(|rule| !rule.what.is_empty()));
    assert!(
        RULES
            .iter()
            .all(|rule| rule.level == Level::Note || !rule.remedy.is_empty())
    );
}
