use oaktwin_camera::math::*;
use oaktwin_camera::*;
use oaktwin_depth::imager::*;
use oaktwin_depth::random::*;
use oaktwin_depth::rectify::*;
use oaktwin_image::Image;
use std::time::Instant;
fn main() {
    rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build_global()
        .unwrap();
    let size = ImageSize::new(1280, 800);
    let k = Intrinsics::from_hfov(size, 1.3);
    let light = Image::new(
        1280,
        800,
        (0..1280 * 800).map(|i| (i % 97) as f32 / 97.0).collect(),
    )
    .unwrap();
    let imager = Imager::new(Parameters::default()).unwrap();
    let random = Stream::new(0, "l").plane(Stage::Exposure, 0, 0);
    let lens =
        LensModel::OpenCvPinhole(OpenCvPinhole::from_slice(&[-0.05, 0.02, 1e-3, -5e-4, 0.01]).unwrap());
    let camera = Camera::new(k, lens);
    let t = Instant::now();
    let pair = StereoRectify::new(
        &camera,
        &camera,
        &RigidTransform::new(DMat3::from_rotation_z(0.01), DVec3::new(-0.075, 0., 0.)),
        &RectifyOptions {
            method: Method::Full,
            ..Default::default()
        },
    )
    .unwrap();
    println!("prepare {:?}", t.elapsed());
    let (mut a, mut b, mut c) = (vec![], vec![], vec![]);
    for _ in 0..30 {
        let t = Instant::now();
        let e = imager.expose(&[((&light).into(), &k), ((&light).into(), &k)]);
        a.push(t.elapsed());
        let t = Instant::now();
        let r = imager.record((&light).into(), &k, e, &random);
        b.push(t.elapsed());
        let Recorded::Eight(image) = r else { return };
        let t = Instant::now();
        let out = pair.left().rectify((&image).into()).unwrap();
        c.push(t.elapsed());
        std::hint::black_box(out);
    }
    for (n, mut v) in [("expose pair", a), ("record one", b), ("rectify one", c)] {
        v.sort();
        println!("{n} {:?} median {:?}", v[0], v[15]);
    }
}
