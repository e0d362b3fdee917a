//! The Allan deviation finds the densities of the noise again, with the project's random numbers.

use oaktwin_camera::math::DVec3;
use oaktwin_depth::random::{NoiseStage, Stream, standard_normal};
use oaktwin_imu::{Channel, ChannelNoise, Draws, allan_deviation};

const RATE_HZ: f64 = 200.0;
const SAMPLES: usize = 1 << 19;

fn record(noise: ChannelNoise, seed: u64) -> [Vec<f64>; 3] {
    let stream = Stream::new(seed, "test");
    let mut channel = Channel::new(noise, RATE_HZ, DVec3::ZERO);
    let mut axes = [(); 3].map(|()| Vec::with_capacity(SAMPLES));
    for sample in 0..SAMPLES as u64 {
        let plane = stream.plane(NoiseStage::Jitter, sample, 0);
        let normals = [0, 1].map(|block| {
            let [a, b, c, d] = plane.words(block, 0);
            [standard_normal(a, b), standard_normal(c, d)]
        });
        let [[[a, b], [c, _]], [[d, e], [f, _]]] = normals;
        let draws = Draws {
            white: DVec3::new(a, b, c),
            walk: DVec3::new(d, e, f),
        };
        let value = channel.measure(DVec3::ZERO, draws).to_array();
        for (axis, value) in axes.iter_mut().zip(value) {
            axis.push(value);
        }
    }
    axes
}

#[test]
fn white_noise_and_random_walk_are_recovered() {
    let noise = ChannelNoise {
        density: DVec3::new(1e-3, 2e-3, 0.0),
        random_walk: DVec3::new(0.0, 2e-3, 3e-3),
        ..ChannelNoise::NONE
    };
    let [white, both, walk] = record(noise, 7);
    for cluster in [1usize, 10, 200] {
        let [point] = allan_deviation(&white, RATE_HZ, &[cluster])[..] else {
            panic!("one size")
        };
        let density = point.deviation * point.tau_s.sqrt();
        assert!((density / 1e-3 - 1.0).abs() < 0.04, "{cluster}: {density}");
    }
    let point = allan_deviation(&walk, RATE_HZ, &[2000])[0];
    let found = point.deviation / (point.tau_s / 3.0).sqrt();
    assert!((found / 3e-3 - 1.0).abs() < 0.1, "{found}");
    // Where both matter, their variances add.
    for cluster in [100usize, 340, 1000] {
        let point = allan_deviation(&both, RATE_HZ, &[cluster])[0];
        let expected = (4e-6 / point.tau_s + 4e-6 * point.tau_s / 3.0).sqrt();
        assert!(
            (point.deviation / expected - 1.0).abs() < 0.1,
            "{cluster}: {}",
            point.deviation
        );
    }
}

/// The standard deviation of a sample is density · √rate.
#[test]
fn samples_have_the_standard_deviation_of_their_rate() {
    let noise = ChannelNoise {
        density: DVec3::splat(1e-3),
        ..ChannelNoise::NONE
    };
    for axis in record(noise, 3) {
        let variance = axis.iter().map(|x| x * x).sum::<f64>() / axis.len() as f64;
        assert!((variance.sqrt() / (1e-3 * RATE_HZ.sqrt()) - 1.0).abs() < 0.005);
    }
}

/// Worked example: the five values 1, 2, 4, 7, 11 with averages of two.
#[test]
fn allan_deviations_are_those_of_the_definition() {
    let points = allan_deviation(&[1.0, 2.0, 4.0, 7.0, 11.0], 10.0, &[0, 1, 2, 3]);
    assert_eq!(points.len(), 2);
    // Differences 1, 2, 3, 4: (1 + 4 + 9 + 16)/8.
    assert!((points[0].deviation - 3.75f64.sqrt()).abs() < 1e-12);
    // Averages 1.5, 3, 5.5, 9: differences at distance two, 4 and 6: (16 + 36)/4.
    assert!((points[1].deviation - 13f64.sqrt()).abs() < 1e-12);
    assert_eq!((points[1].tau_s, points[1].differences), (0.2, 2));
}
