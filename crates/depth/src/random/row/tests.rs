use oaktwin_simd::Level;

use super::*;
use crate::random::{NoiseStage, Stream};

fn plane() -> RandomPlane {
    Stream::new(7, "left").plane(NoiseStage::Jitter, 3, 1)
}

fn normals(plane: &RandomPlane, rows: std::ops::Range<u32>, columns: usize) -> Vec<f64> {
    let mut row = vec![0.0; columns];
    rows.flat_map(|y| {
        plane.normals(y, &mut row);
        row.iter().map(|&n| f64::from(n)).collect::<Vec<f64>>()
    })
    .collect()
}

#[test]
fn the_layout_is_the_documented_one() {
    let plane = plane();
    let mut words = [0; 300];
    plane.row_words(9, &mut words);
    for (i, &word) in (0u32..).zip(&words) {
        let block = 16 * (i / 64) + i % 16;
        assert_eq!(word, plane.words(block, 9)[(i / 16 % 4) as usize]);
    }
    let mut bytes = [0; 1200];
    plane.bytes(9, &mut bytes);
    let expected: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    assert_eq!(bytes[..], expected);
    let mut uniforms = [0.0; 300];
    plane.uniforms(9, &mut uniforms);
    assert_eq!(uniforms, words.map(|word| (word >> 8) as f32 / 16_777_216.0));
    let mut normals = [0.0; 300];
    plane.normals(9, &mut normals);
    for i in (0..288).filter(|i| i / 16 % 2 == 0) {
        assert_eq!([normals[i], normals[i + 16]], box_muller(words[i], words[i + 16]));
    }
}

#[test]
fn all_instructions_give_the_same_bits_for_any_length() {
    let plane = plane();
    let mut long = [0.0; 1281];
    simd::run_at(Level::BASELINE, plane.kernel::<_, Normals>(5, &mut long));
    for level in Level::available() {
        for length in [0, 1, 15, 16, 63, 64, 65, 106, 1281] {
            let mut row = vec![0.0f32; length];
            simd::run_at(level, plane.kernel::<_, Normals>(5, &mut row));
            let same = row.iter().zip(&long).all(|(a, b)| a.to_bits() == b.to_bits());
            assert!(same, "{level:?} {length}");
        }
        let (mut bytes, mut expected) = ([0; 999], [0; 999]);
        simd::run_at(level, plane.kernel::<_, Bytes>(5, &mut bytes));
        simd::run_at(Level::BASELINE, plane.kernel::<_, Bytes>(5, &mut expected));
        assert_eq!(bytes, expected);
    }
}

/// The standard normal distribution function, by its series (Marsaglia 2004).
fn cdf(x: f64) -> f64 {
    if x.abs() > 7.0 {
        return f64::from(u8::from(x > 0.0));
    }
    let (mut sum, mut term, mut i) = (x, x, 1.0);
    while sum + term != sum {
        i += 2.0;
        term *= x * x / i;
        sum += term;
    }
    0.5 + sum * (-0.5 * x * x).exp() / std::f64::consts::TAU.sqrt()
}

#[test]
fn normals_are_normal() {
    let mut values = normals(&plane(), 0..800, 1280);
    let n = values.len() as f64;
    let moment = |k: i32| values.iter().map(|v| v.powi(k)).sum::<f64>() / n;
    // Five standard errors of each moment.
    for (k, expected, variance) in [(1, 0.0, 1.0), (2, 1.0, 2.0), (3, 0.0, 15.0), (4, 3.0, 96.0)] {
        let off = (moment(k) - expected).abs();
        assert!(off < 5.0 * f64::sqrt(variance / n), "moment {k} is off by {off}");
    }
    values.sort_by(f64::total_cmp);
    let distance = values
        .iter()
        .enumerate()
        .map(|(i, &v)| (cdf(v) - (i as f64 + 0.5) / n).abs())
        .fold(0.0, f64::max);
    // Kolmogorov's limit at 1e-4: 2.23.
    assert!(distance * n.sqrt() < 2.23, "{}", distance * n.sqrt());
    // As many beyond 4 sigma as there should be: 64.9 of 1 024 000.
    let tail = values.iter().filter(|v| v.abs() > 4.0).count();
    assert!((30..100).contains(&tail), "{tail}");
}

#[test]
fn nothing_depends_on_anything_else() {
    let stream = Stream::new(7, "left");
    let reference = normals(&stream.plane(NoiseStage::Jitter, 3, 1), 10..110, 640);
    let others = [
        ("frame", stream.plane(NoiseStage::Jitter, 4, 1), 10),
        ("item", stream.plane(NoiseStage::Jitter, 3, 2), 10),
        ("stage", stream.plane(NoiseStage::Dropout, 3, 1), 10),
        ("row", stream.plane(NoiseStage::Jitter, 3, 1), 11),
        ("seed", Stream::new(8, "left").plane(NoiseStage::Jitter, 3, 1), 10),
        (
            "camera",
            Stream::new(7, "right").plane(NoiseStage::Jitter, 3, 1),
            10,
        ),
    ];
    let n = reference.len() as f64;
    let correlation = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() / n;
    for (what, plane, row) in others {
        let other = normals(&plane, row..row + 100, 640);
        let r = correlation(&reference, &other);
        assert!(r.abs() < 5.0 / n.sqrt(), "{what}: {r}");
    }
    for lag in [1, 2, 15, 16, 17, 32, 48, 64] {
        let r = correlation(&reference[lag..], &reference);
        assert!(r.abs() < 5.0 / n.sqrt(), "columns {lag} apart: {r}");
    }
}

#[test]
fn bytes_and_uniforms_are_even() {
    let plane = plane();
    let mut counts = [0u32; 256];
    let mut row = vec![0; 1280];
    for y in 0..800 {
        plane.bytes(y, &mut row);
        row.iter().for_each(|&byte| counts[usize::from(byte)] += 1);
    }
    let expected = 800.0 * 1280.0 / 256.0;
    let chi: f64 = counts
        .iter()
        .map(|&c| (f64::from(c) - expected).powi(2) / expected)
        .sum();
    // 255 degrees of freedom: mean 255, standard deviation 22.6.
    assert!((255.0 - 5.0 * 22.6..255.0 + 5.0 * 22.6).contains(&chi), "{chi}");
    let mut row = vec![0.0; 100_000];
    plane.uniforms(0, &mut row);
    assert!(row.iter().all(|u| (0.0..1.0).contains(u)));
    let mean = row.iter().map(|&u| f64::from(u)).sum::<f64>() / 1e5;
    assert!((mean - 0.5).abs() < 5.0 * (1.0 / 12e5f64).sqrt(), "{mean}");
}
