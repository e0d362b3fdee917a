use std::collections::BTreeSet;

use oaktwin_catalog::Origin;

use super::super::sample::{calibrated, nominal};
use super::super::*;
use super::plain;

/// Returns the assets of all models with all valid options, nominal and calibrated.
fn every_asset() -> Vec<(String, Asset)> {
    let mut all = Vec::new();
    for twin in nominal() {
        for (kind, twin) in [
            ("nominal", twin.clone()),
            ("rational", calibrated(twin.clone(), false)),
            ("fisheye", calibrated(twin.clone(), true)),
        ] {
            for (isaac, target) in [
                (IsaacVersion::V5_1, AssetTarget::Isaac),
                (IsaacVersion::V6, AssetTarget::Isaac),
                (IsaacVersion::V6, AssetTarget::Ovrtx),
            ] {
                // Bodies are large and interact with the rigid body only.
                let bodies = kind == "nominal" && (isaac, target) == (IsaacVersion::V5_1, AssetTarget::Isaac);
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
fn assets_are_reproducible_and_relationships_have_targets() {
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

fn walk(prim: &PrimSpec, parent: &str, paths: &mut BTreeSet<String>, targets: &mut Vec<String>) {
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
