//! The five models, for tests: the sheet's numbers, typed in by hand.

use std::collections::BTreeMap;

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{
    Axes, ImageSize, Intrinsics, LensModel, OpenCv, OpenCvFisheye, OpenCvPinhole, PixelPoint, RigidTransform,
};
use oaktwin_catalog::{
    Body, Camera, DepthKind, DepthSensor, Device, Imu, LegacyDistortion, Origin, Role, Source, Twin,
    TwinCamera, TwinDepthSensor,
};

struct Model {
    id: &'static str,
    name: &'static str,
    prim: &'static str,
    first: (Role, &'static str, u32, u32, f64, f64, f64), // role, sensor, width, height, µm, hfov, maxFOV
    stereo: (&'static str, f64, f64, Option<f64>),        // sensor, hfov, maxFOV, fisheye hfov
    baseline_mm: f64,
    range_m: (f64, f64),
    extended_min_m: Option<f64>,
}

const MODELS: [Model; 5] = [
    Model {
        id: "oak_d_pro_poe",
        name: "OAK-D Pro PoE",
        prim: "oak_d_pro",
        first: (Role::Rgb, "IMX378", 3840, 2160, 1.55, 64.0, 82.0),
        stereo: ("OV9282", 77.0, 89.5, None),
        baseline_mm: 75.0,
        range_m: (0.6, 12.0),
        extended_min_m: Some(0.3),
    },
    Model {
        id: "oak_d_pro_w_poe",
        name: "OAK-D Pro W PoE",
        prim: "oak_d_pro_w",
        first: (Role::Rgb, "IMX378", 3840, 2160, 1.55, 80.0, 108.0),
        stereo: ("OV9282", 97.0, 127.0, Some(127.0)),
        baseline_mm: 75.0,
        range_m: (0.2, 8.0),
        extended_min_m: None,
    },
    Model {
        id: "oak4_d",
        name: "OAK4-D",
        prim: "oak4_d",
        first: (Role::Rgb, "IMX586", 4000, 3000, 1.6, 68.0, 80.3),
        stereo: ("OV9282", 77.0, 86.3, None),
        baseline_mm: 75.0,
        range_m: (0.6, 12.0),
        extended_min_m: Some(0.3),
    },
    Model {
        id: "oak4_d_wide",
        name: "OAK4-D Wide",
        prim: "oak4_d_wide",
        first: (Role::Rgb, "IMX586", 4000, 3000, 1.6, 88.0, 100.7),
        stereo: ("OV9282", 97.0, 106.2, Some(127.0)),
        baseline_mm: 75.0,
        range_m: (0.2, 8.0),
        extended_min_m: None,
    },
    Model {
        id: "oak_d_tof",
        name: "OAK-D ToF",
        prim: "oak_d_tof",
        first: (Role::Tof, "33D", 640, 480, 7.0, 70.0, 70.0),
        stereo: ("OV9782", 80.0, 80.0, None),
        baseline_mm: 20.0,
        range_m: (0.2, 5.0),
        extended_min_m: None,
    },
];

/// The five nominal twins, in the sheet's order.
pub(crate) fn nominal() -> Vec<Twin> {
    MODELS.iter().map(twin).collect()
}

/// One of them.
pub(crate) fn nominal_of(id: &str) -> Twin {
    nominal()
        .into_iter()
        .find(|twin| twin.device.id == id)
        .expect("a model of the sheet")
}

/// A unit with every camera off its nominal numbers: rational lenses with a tilt, or fisheyes.
pub(crate) fn calibrated(mut twin: Twin, fisheye: bool) -> Twin {
    for (i, camera) in (0u32..).zip(&mut twin.cameras) {
        let i = f64::from(i);
        let size = camera.intrinsics.size;
        let f = camera.intrinsics.fx * (1.0 + 0.003 * (i + 1.0));
        camera.intrinsics = Intrinsics::new(
            size,
            f,
            f + 0.75,
            PixelPoint::<OpenCv>::new(
                f64::from(size.width) / 2.0 + 7.25 - i,
                f64::from(size.height) / 2.0 - 3.5 + i,
            ),
        );
        camera.lens = if fisheye {
            LensModel::OpenCvFisheye(OpenCvFisheye {
                k: [0.05, -0.01, 0.002, -0.0001],
            })
        } else {
            LensModel::OpenCvPinhole(OpenCvPinhole {
                coefficients: [
                    -5.1,
                    12.4,
                    0.0004,
                    -0.0002,
                    3.25,
                    -5.2,
                    12.7,
                    2.9,
                    1e-4,
                    -2e-4,
                    3e-4,
                    -4e-4,
                    0.0015 * i,
                    0.0,
                ],
            })
        };
        let turn = DMat3::from_rotation_y(0.004 * i) * DMat3::from_rotation_x(-0.002);
        camera.body_from_camera = RigidTransform::new(
            camera.body_from_camera.rotation * turn,
            camera.body_from_camera.translation + DVec3::new(0.0011, 0.0002, -0.0003),
        );
    }
    for sensor in 0..twin.depth_sensors.len() {
        let role = twin.depth_sensors[sensor].spec.camera;
        let fx = twin.camera(role).expect("its camera").intrinsics.fx;
        twin.depth_sensors[sensor].focal_length_px = fx.round();
    }
    twin.origin = Origin::Calibration {
        product_name: "OAK-D-UNIT".into(),
        file_name: "unit \"7\".json".into(),
    };
    twin
}

fn twin(model: &Model) -> Twin {
    let (role, sensor, width, height, pixel_um, hfov, max_fov) = model.first;
    let (stereo, stereo_hfov, stereo_max_fov, fisheye) = model.stereo;
    let half = model.baseline_mm / 2.0;
    let tof = role == Role::Tof;
    let first_name = if tof { "tof" } else { "rgb" };
    let first_y = if tof { -27.382 } else { 0.0 };
    let camera = |role: Role, name: &str, sensor: &str, hfov_deg: f64, max_fov_deg: f64, y: f64| Camera {
        role,
        prim: format!("Camera_{name}_{}", sensor.to_lowercase()),
        sensor: sensor.into(),
        socket: 0,
        hfov_deg,
        fisheye_hfov_deg: None,
        position_mm: [0.0, y, 0.0],
        focus_distance: if matches!(role, Role::Left | Role::Right) {
            196.0
        } else {
            500.0
        },
        f_stop: 0.0,
        projection: "perspective".into(),
        stereo_role: match role {
            Role::Left => "left",
            Role::Right => "right",
            Role::Rgb | Role::Tof => "mono",
        }
        .into(),
        clipping_range_m: (0.01, 100.0),
        projection_type: "pinhole".into(),
        max_fov_deg,
        legacy_distortion: LegacyDistortion {
            poly_k: [0.0, 0.002_45, 0.0, 0.0, 0.0, 0.0],
            p: [-0.000_37, -0.000_74],
            s: [-0.000_58, -0.000_22, 0.000_19, -0.000_2],
            physical_model: "Not Applicable".into(),
            physical_coefficients: "Not Applicable".into(),
        },
        source: Source::Document,
        sources: BTreeMap::new(),
    };
    let with_fisheye = |camera: Camera| Camera {
        fisheye_hfov_deg: fisheye,
        ..camera
    };
    let cameras = vec![
        camera(role, first_name, sensor, hfov, max_fov, first_y),
        with_fisheye(camera(
            Role::Left,
            "left",
            stereo,
            stereo_hfov,
            stereo_max_fov,
            half,
        )),
        with_fisheye(camera(
            Role::Right,
            "right",
            stereo,
            stereo_hfov,
            stereo_max_fov,
            -half,
        )),
    ];
    let twin_cameras: Vec<TwinCamera> = cameras
        .iter()
        .map(|spec| {
            let own = spec.role == role;
            let (size, pixel_size_um) = if own {
                (ImageSize::new(width, height), pixel_um)
            } else {
                (ImageSize::new(1280, 800), 3.0)
            };
            TwinCamera {
                spec: spec.clone(),
                pixel_size_um,
                intrinsics: Intrinsics::from_hfov(size, spec.hfov_deg.to_radians()),
                lens: LensModel::Pinhole,
                body_from_camera: RigidTransform::new(
                    Axes::Ros.rotation_from(Axes::OpenCv),
                    DVec3::from(spec.position_mm) * 1e-3,
                ),
            }
        })
        .collect();
    let fx = |role| {
        let camera = twin_cameras.iter().find(|camera| camera.spec.role == role);
        camera.expect("its camera").intrinsics.fx.round()
    };
    let sensor =
        |kind: DepthKind, prim: &str, camera: Role, baseline_mm: f64, width: f64, noise: (f64, f64)| {
            DepthSensor {
                kind,
                prim: prim.into(),
                camera,
                focus_distance: if kind == DepthKind::Tof { 500.0 } else { 196.0 },
                clipping_range_m: (0.01, 100.0),
                baseline_mm,
                focal_length_px: fx(camera),
                sensor_size_px: width,
                max_disparity_px: 95.0,
                extended_max_disparity_px: (!tof).then_some(191.0),
                min_distance_m: model.range_m.0,
                extended_min_distance_m: model.extended_min_m,
                max_distance_m: model.range_m.1,
                noise_mean_px: noise.0,
                noise_sigma_px: noise.1,
                noise_downscale_factor_px: 2.0,
                confidence_threshold: 0.8,
                outlier_removal_range_px: 3,
                ideal_range_m: model.range_m,
                source: Source::Document,
                sources: BTreeMap::new(),
            }
        };
    let noise = (0.25, 0.2);
    let depth_sensors = if tof {
        vec![
            sensor(
                DepthKind::Stereo,
                "Camera_pseudo_depth_stereo",
                Role::Left,
                model.baseline_mm,
                1280.0,
                noise,
            ),
            sensor(
                DepthKind::Tof,
                "Camera_pseudo_depth_tof",
                Role::Tof,
                0.5,
                640.0,
                (0.1, 0.1),
            ),
        ]
    } else {
        vec![sensor(
            DepthKind::Stereo,
            "Camera_pseudo_depth",
            Role::Left,
            model.baseline_mm,
            1280.0,
            noise,
        )]
    };
    Twin {
        device: Device {
            id: model.id.into(),
            name: model.name.into(),
            aliases: Vec::new(),
            prim: model.prim.into(),
            manufacturer: "Luxonis".into(),
            generation: "RVC2".into(),
            platform: "Myriad X (Intel VPU)".into(),
            variant: "fixed focus".into(),
            body: Body {
                dimensions_mm: [111.0, 40.0, 31.3],
                front_mm: [5.0, 0.0, 1.5],
                mass_g: 180.0,
                projector_mm: Some([0.0, 15.0, 0.0]),
                source: Source::Document,
                sources: BTreeMap::from([
                    ("front_mm".into(), Source::Estimate),
                    ("mass_g".into(), Source::Estimate),
                ]),
            },
            imu: Imu {
                model: "BNO086 (9-axis)".into(),
                position_mm: [-8.0, -40.0, -20.265],
                rotation: DMat3::IDENTITY.to_cols_array_2d(),
                source: Source::Estimate,
                sources: BTreeMap::new(),
            },
            stereo_baseline_mm: model.baseline_mm,
            cameras,
            depth_sensors: depth_sensors.clone(),
            accuracy: Vec::new(),
            evidence: Vec::new(),
            notes: Vec::new(),
            source: Source::Document,
            sources: BTreeMap::new(),
        },
        cameras: twin_cameras,
        depth_sensors: depth_sensors
            .into_iter()
            .map(|spec| TwinDepthSensor {
                focal_length_px: spec.focal_length_px,
                spec,
            })
            .collect(),
        body_from_imu: RigidTransform::new(DMat3::IDENTITY, DVec3::new(-0.008, -0.04, -0.020_265)),
        origin: Origin::Nominal,
    }
}
