//! Small images are measured on the calling thread. The only test of its process, because it observes the process's thread pool.

#![expect(clippy::unwrap_used, reason = "tests")]

use oaktwin_depth::engines::{STEREO_NOISE, TIME_OF_FLIGHT};
use oaktwin_depth::filter::Chain;
use oaktwin_depth::random::Stream;
use oaktwin_depth::{DepthShot, EngineKind, Sensor, Setup};
use oaktwin_image::{Image, ImageView};
use rayon::ThreadPoolBuilder;

fn sensor(kind: &EngineKind) -> Sensor {
    let engine = kind.create(&Setup::new(66.0, 106, 0.075)).unwrap();
    Sensor::new(engine, Chain::default(), Stream::new(1, "camera"))
}

#[test]
fn small_images_need_no_thread_pool() {
    let mut noise = sensor(&STEREO_NOISE);
    assert!(!noise.is_parallel(106, 60) && noise.is_parallel(106, 65) && noise.measures_batches());
    assert!(sensor(&TIME_OF_FLIGHT).is_parallel(106, 60));

    let depth = Image::filled(106, 60, 2.0);
    let mut measured = vec![0.0; 106 * 60];
    noise
        .sense_batch(depth.pixels(), None, [1, 60, 106], 3, 0, &mut measured)
        .unwrap();
    let mut shot = DepthShot::new(ImageView::from(&depth));
    shot.frame = 3;
    let alone = noise.capture(shot, &[]).unwrap();
    assert_eq!(alone.distance.0.pixels(), measured);
    assert!(measured.iter().any(|&metres| metres > 0.0));

    // The global pool can only be configured before its first use.
    ThreadPoolBuilder::new().num_threads(1).build_global().unwrap();
}
