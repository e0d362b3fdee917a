//! Twins for tests.

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{
    Intrinsics, LensModel, OpenCv, OpenCvFisheye, OpenCvPinhole, PixelPoint, RigidTransform,
};
use oaktwin_catalog::{Catalog, Origin, Twin};

/// Returns the five nominal twins of the sheet, in its order.
pub(crate) fn nominal() -> Vec<Twin> {
    let catalog = Catalog::builtin();
    catalog.sheet().map(|device| catalog.nominal(device)).collect()
}

/// Returns the nominal twin of one model.
pub(crate) fn nominal_of(id: &str) -> Twin {
    let catalog = Catalog::builtin();
    catalog.nominal(catalog.device(id).expect("a model of the sheet"))
}

/// Returns a unit whose cameras all differ from nominal: rational lenses with tilt, or fisheyes.
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
            LensModel::OpenCvPinhole(OpenCvPinhole::new([
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
            ]))
        };
        let turn = DMat3::from_rotation_y(0.004 * i) * DMat3::from_rotation_x(-0.002);
        camera.body_from_camera = RigidTransform::new(
            camera.body_from_camera.rotation * turn,
            camera.body_from_camera.translation + DVec3::new(0.0011, 0.0002, -0.0003),
        );
    }
    twin.origin = Origin::Calibration {
        product_name: "OAK-D-UNIT".into(),
        file_name: "unit \"7\".json".into(),
    };
    for sensor in 0..twin.depth_sensors.len() {
        let camera = twin.depth_camera(&twin.depth_sensors[sensor]);
        let fx = camera.expect("its camera").intrinsics.fx;
        twin.depth_sensors[sensor].focal_length_px = fx.round();
    }
    twin
}
