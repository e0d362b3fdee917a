use super::*;
use proptest::prelude::*;

fn camera(f: f64, cx: f64, cy: f64) -> Camera {
    let lens = LensModel::OpenCvPinhole(OpenCvPinhole::from_slice(&[-0.05, 0.01, 1e-3, -1e-3]).unwrap());
    let centre = PixelPoint::<OpenCv>::new(cx, cy);
    Camera::new(
        Intrinsics::new(ImageSize::new(1280, 800), f, f + 1.0, centre),
        lens,
    )
}

#[test]
fn ideal_pairs_do_not_change() {
    let camera = Camera::new(
        Intrinsics::from_hfov(ImageSize::new(1280, 800), 1.34),
        LensModel::Pinhole,
    );
    let shift = RigidTransform::new(DMat3::IDENTITY, DVec3::new(-0.075, 0.0, 0.0));
    let pair = stereo_rectify(&camera, &camera, &shift).unwrap();
    assert_eq!(pair.rectified_from_left, DMat3::IDENTITY);
    assert_eq!(pair.rectified_from_right, DMat3::IDENTITY);
    assert_eq!(
        (pair.baseline, pair.offset, pair.axis),
        (0.075, -0.075, BaselineAxis::Horizontal)
    );
    assert_eq!(pair.projection_right()[0][3], -0.075 * pair.right.fx);
    assert_eq!(pair.stereo_geometry().disparity(4.0), pair.left.fx * 0.075 / 4.0);
}

#[test]
fn rejects_invalid_geometry() {
    let a = camera(800.0, 640.0, 400.0);
    let of = |b: &Camera, rotation, x| {
        stereo_rectify(&a, b, &RigidTransform::new(rotation, DVec3::new(x, 0.0, 0.0)))
    };
    assert_eq!(of(&a, DMat3::IDENTITY, 0.0), Err(RectifyError::Baseline(0.0)));
    assert!(matches!(
        of(&a, DMat3::IDENTITY, f64::NAN),
        Err(RectifyError::Baseline(_))
    ));
    assert_eq!(of(&a, DMat3::ZERO, 1.0), Err(RectifyError::Rotation(0.0)));
    assert_eq!(of(&a, -DMat3::IDENTITY, 1.0), Err(RectifyError::Rotation(-1.0)));
    let mut b = a;
    b.intrinsics.size = ImageSize::new(640, 400);
    let error = of(&b, DMat3::IDENTITY, 1.0).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the image sizes 1280x800 and 640x400 differ; resize the intrinsics first"
    );
}

#[test]
fn fisheye_pairs_use_the_left_intrinsics() {
    let mut a = camera(560.0, 640.0, 400.0);
    a.lens = LensModel::OpenCvFisheye(crate::OpenCvFisheye::default());
    let b = camera(570.0, 630.0, 410.0);
    let shift = RigidTransform::new(DMat3::from_rotation_z(0.01), DVec3::new(-0.075, 0.0, 0.0));
    let pair = stereo_rectify(&a, &b, &shift).unwrap();
    assert_eq!((pair.left, pair.right), (a.intrinsics, a.intrinsics));
}

proptest! {
    #[test]
    fn aligns_epipolar_lines_and_preserves_depth(
        turn in prop::array::uniform3(-0.1..0.1f64), t in prop::array::uniform3(-0.02..0.02f64),
        vertical: bool, sign: bool, p in prop::array::uniform2(-0.5..0.5f64), z in 1.0..5.0f64,
        choice in prop::sample::select(vec![RectifiedIntrinsics::ZeroDisparity, RectifiedIntrinsics::FreeDisparity]),
    ) {
        let rotation = DMat3::from_euler(glam::EulerRot::XYZ, turn[0], turn[1], turn[2]);
        let mut t = DVec3::from(t);
        t[usize::from(vertical)] = if sign { 0.08 } else { -0.08 };
        let right_from_left = RigidTransform::new(rotation, t);
        let pair =
            stereo_rectify_to(&camera(800.0, 630.0, 410.0), &camera(805.0, 650.0, 390.0), &right_from_left, choice)
                .unwrap();

        let point_in_left = DVec3::new(p[0], p[1], z);
        let left = pair.rectified_from_left * point_in_left;
        let right = pair.rectified_from_right * right_from_left.apply(point_in_left);
        let a = pair.left.pixel_from_normalized(left.truncate() / left.z);
        let b = pair.right.pixel_from_normalized(right.truncate() / right.z);
        let (across, disparity) = match pair.axis {
            BaselineAxis::Horizontal => (a.y - b.y, a.x - b.x),
            BaselineAxis::Vertical => (a.x - b.x, a.y - b.y),
        };
        prop_assert!(across.abs() < 1e-9);
        prop_assert_eq!(pair.axis, if vertical { BaselineAxis::Vertical } else { BaselineAxis::Horizontal });

        let h = pair.disparity_to_depth() * DVec4::new(a.x, a.y, disparity, 1.0);
        prop_assert!((h.truncate() / h.w - left).length() < 1e-9);

        let [row, ..] = pair.projection_right();
        let through_p = (row[0] * left.x + row[2] * left.z + row[3]) / left.z;
        if !vertical {
            prop_assert!((through_p - b.x).abs() < 1e-9);
        }
    }

    #[test]
    fn returns_rotations(turn in prop::array::uniform3(-1.5..1.5f64), noise in prop::array::uniform9(-1e-7..1e-7f64)) {
        let rotation = DMat3::from_euler(glam::EulerRot::XYZ, turn[0], turn[1], turn[2]);
        let near = nearest_rotation(rotation + DMat3::from_cols_array(&noise)).unwrap();
        let error = |m: DMat3| RigidTransform::new(m, DVec3::ZERO).orthonormality_error();
        prop_assert!(error(near) < 1e-14);
        let half = half_rotation(rotation);
        prop_assert!(error(half) < 1e-14);
        prop_assert!(half.mul_mat3(&half).abs_diff_eq(rotation, 1e-14));
    }
}
