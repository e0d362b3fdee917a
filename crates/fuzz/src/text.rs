//! Short texts: parameters and the catalog.

use std::path::Path;

use oaktwin_camera::StereoDrift;
use oaktwin_catalog::Catalog;
use oaktwin_depth::engines::ENGINES;
use oaktwin_depth::filter::parse;
use oaktwin_depth::{EngineKind, Setup};

use crate::file;

/// Lines of `FILTER`, `DRIFT`, `ENGINE` or `ENGINE NAME=VALUE`.
pub(crate) fn parameters(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    for line in text.lines().take(8) {
        if let Ok(filter) = parse(line) {
            let again = parse(&filter.to_string()).unwrap_or_else(|error| panic!("{filter}: {error}"));
            assert_eq!(again, filter);
        }
        if let Ok(drift) = StereoDrift::parse(line) {
            let again =
                StereoDrift::parse(&drift.to_text()).unwrap_or_else(|error| panic!("{line}: {error}"));
            assert_eq!(again, drift, "{line}");
            assert!(
                drift.baseline_m().is_finite() && drift.focal_length_ratio() > 0.0,
                "{line}"
            );
        }
        let (engine, setting) = line.split_once(' ').unwrap_or((line, ""));
        let (Ok(kind), Some((name, value))) = (EngineKind::parse(engine), setting.split_once('=')) else {
            continue;
        };
        let mut setup = Setup::new(800.0, 1280, 0.075);
        setup.parameters.push((name.to_owned(), value.into()));
        let Ok(engine) = kind.create(&setup) else { continue };
        for (name, value) in engine.parameters() {
            assert!(!value.contains("NaN"), "{name}={value}");
        }
    }
}

pub(crate) fn parameters_seeds() -> Vec<Vec<u8>> {
    let mut all =
        vec![b"yaw=0.3,pitch=-0.2,roll=1e-3\nbaseline=50,temperature=20\nspeckle:speckleRange=60\nspatial:alpha=0.5,delta=20\nmedian:kernel=KERNEL_5x5".to_vec()];
    for kind in ENGINES {
        let lines = (kind.parameters)()
            .into_iter()
            .map(|name| format!("{} {name}=1.5\n", kind.name));
        all.extend(lines.map(String::into_bytes));
    }
    all
}

/// A file of a sensor or a device that is added to the catalog.
pub(crate) fn catalog(bytes: &[u8]) {
    let read = |path: &Path| Catalog::with_dir(path.parent().unwrap_or(path));
    match file::with("x.toml", bytes, read) {
        Ok(catalog) => {
            for device in catalog.devices() {
                let twin = catalog.nominal(device);
                for camera in &twin.cameras {
                    assert!(camera.intrinsics.matrix().is_finite(), "{camera:?}");
                    assert!(camera.body_from_camera.rotation.is_finite(), "{camera:?}");
                }
            }
        }
        Err(error) => assert!(error.to_string().contains("x.toml"), "{error}"),
    }
}

pub(crate) fn catalog_seeds() -> Vec<Vec<u8>> {
    let text = |text: &str, from: &str, to: &str| text.replacen(from, to, 1).into_bytes();
    vec![
        text(
            include_str!("../../catalog/data/devices/oak4_d.toml"),
            "oak4_d",
            "oak4_x",
        ),
        text(
            include_str!("../../catalog/data/devices/oak_d_tof.toml"),
            "oak_d_tof",
            "tof_x",
        ),
        text(
            include_str!("../../catalog/data/sensors/ov9282.toml"),
            "ov9282",
            "ov9999",
        ),
    ]
}
