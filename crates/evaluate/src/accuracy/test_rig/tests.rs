use super::*;
use oaktwin_camera::StereoDrift;
use oaktwin_catalog::Catalog;
use oaktwin_pipeline::sensor::{
    EngineKind, SINGLE_VIEW, STEREO_MATCHING, STEREO_NOISE, SensorOptions, sensor,
};

fn work(effort: Effort) -> RunControl<'static> {
    RunControl {
        effort,
        wants_more: &|| true,
    }
}

fn test_rig(model: &str, engine: &'static EngineKind, parameters: &[(&str, &str)]) -> TestRig {
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(catalog.device(model).unwrap());
    let depth = twin.depth_sensors.last().unwrap();
    let options = SensorOptions {
        engine: Some(engine.into()),
        parameters: parameters
            .iter()
            .map(|(a, b)| ((*a).to_owned(), (*b).into()))
            .collect(),
        ..SensorOptions::default()
    };
    let (sensor, _) = sensor(&twin, depth, &options).unwrap();
    let intrinsics = twin.camera(depth.spec.camera).unwrap().intrinsics;
    TestRig {
        intrinsics,
        region: ImageRegion::centred(intrinsics.size.width, intrinsics.size.height, 0.05),
        first: 0,
        units: vec![Unit {
            drifted: None,
            engine: Arc::clone(sensor.engine()),
            filters: Chain::default(),
            bias_px: 0.0,
        }],
        random: Stream::new(0, ""),
        stereo_camera: None,
        picture: OnceLock::new(),
    }
}

fn whole(rig: &TestRig) -> Part {
    Part {
        intrinsics: rig.intrinsics,
        columns: 0..rig.intrinsics.size.width,
        rows: 0..rig.intrinsics.size.height,
        region: rig.region.clone(),
    }
}

#[test]
fn a_crop_measures_the_same_as_the_whole_image() {
    let effort = Effort {
        captures: 3,
        quality: false,
    };
    for (model, engine, quiet) in [
        ("oak4-d", &STEREO_NOISE, ("jitter", "0")),
        ("oak-d-tof", &SINGLE_VIEW, ("noiseSigma", "0")),
    ] {
        let rig = test_rig(model, engine, &[quiet]);
        for distance in [0.8, 1.31, 3.3] {
            let part = rig.part(distance);
            assert!(part.intrinsics.size.width < rig.intrinsics.size.width / 2);
            let [part, whole] = [part, whole(&rig)].map(|part| {
                // Each with its own picture.
                let rig = test_rig(model, engine, &[quiet]);
                rig.prepare_rows(&part.rows);
                let scenery = Scenery::new(&rig, &part, distance);
                let unit = &rig.units[0];
                let engines = [Some(unit.engine.clone()), other_reading(&unit.engine).unwrap()];
                engines.map(|engine| {
                    engine.map(|engine| {
                        rig.measure_unit(&engine, unit, 0, &scenery, &part, work(effort))
                            .unwrap()
                            .vendor
                    })
                })
            });
            assert_eq!(part, whole, "{model} {distance}");
            assert!(part[0].unwrap().depth_m.is_some(), "{model} {distance}");
        }
    }
}

#[test]
fn a_pair_that_cannot_be_matched_is_an_error_of_the_region() {
    let mut rig = test_rig("oak4-d", &STEREO_MATCHING, &[]);
    rig.stereo_camera = Some(StereoCamera::new((0.075, StereoDrift::default()), 1.0, 0).unwrap());
    let mut part = rig.part(2.0);
    part.intrinsics.size.height = 0;
    let scenery = Scenery::new(&rig, &part, 2.0);
    let unit = &rig.units[0];
    let mut sensor = Sensor::new(unit.engine.clone(), unit.filters.clone(), rig.random);
    let error = scenery
        .captures(
            &mut sensor,
            unit,
            0,
            &part,
            work(Effort {
                captures: 1,
                quality: false,
            }),
        )
        .unwrap_err();
    let text = error.to_string();
    assert!(
        text.contains("region: the images have no pixels; give images with pixels"),
        "{text}"
    );
}

/// The noise, the exposure and the far ends of the matcher's paths differ between the crop and the whole image.
#[test]
fn matching_a_crop_nearly_equals_matching_the_whole_image() {
    let mut rig = test_rig("oak4-d", &STEREO_MATCHING, &[]);
    rig.stereo_camera = Some(StereoCamera::new((0.075, StereoDrift::default()), 1.0, 0).unwrap());
    let effort = Effort {
        captures: 2,
        quality: false,
    };
    for disparity in [75.0, 46.15, 18.9, 18.35] {
        let distance = rig.disparity_times_depth() / disparity;
        let part = rig.part(distance);
        assert!(part.intrinsics.size.height < rig.intrinsics.size.height / 2);
        let [part, whole] = [part, whole(&rig)].map(|part| {
            let scenery = Scenery::new(&rig, &part, distance);
            let unit = &rig.units[0];
            let measured = rig.measure_unit(&unit.engine, unit, 0, &scenery, &part, work(effort));
            rig.disparity_times_depth() / measured.unwrap().vendor.depth_m.unwrap()
        });
        assert!((part - whole).abs() < 0.15, "{distance} m: {part} {whole} px");
    }
}
