use proptest::prelude::*;

use super::*;

/// The bits of the results of every operation.
struct Everything {
    a: [f32; 8],
    b: [f32; 8],
    integers: [[i32; 8]; 2],
    shift: u32,
}

/// Collects bits; all NaN are the same.
#[derive(Default)]
struct Bits(Vec<u32>);

impl Bits {
    fn f32<L: Lanes>(&mut self, values: L) {
        let values = values.to_array();
        self.0
            .extend(values.map(|x| if x.is_nan() { f32::NAN } else { x }.to_bits()));
    }

    fn i32<I: I32Lanes>(&mut self, values: I) {
        self.0.extend(values.to_array().map(i32::cast_unsigned));
    }

    #[expect(clippy::cast_possible_truncation, reason = "takes both halves")]
    fn f64<D: F64Lanes>(&mut self, values: D) {
        let mut array = [0.0; 8];
        values.store(&mut array);
        for value in array.map(|x| if x.is_nan() { f64::NAN } else { x }.to_bits()) {
            self.0.extend([(value >> 32) as u32, value as u32]);
        }
    }
}

impl LaneKernel for Everything {
    type Output = Vec<u32>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Vec<u32> {
        let mut bits = Bits::default();
        self.single::<L>(&mut bits);
        self.integers::<L>(&mut bits);
        self.double::<L>(&mut bits);
        self.memory::<L>(&mut bits);
        bits.0
    }
}

impl Everything {
    #[inline(always)]
    fn single<L: Lanes>(&self, bits: &mut Bits) {
        let (a, b) = (L::load(&self.a), L::load(&self.b));
        let integers = self.integers.map(|values| L::I32::load(&values));
        for result in [a + b, a - b, a * b, a / b, a.sqrt(), a.min(b), a.max(b)] {
            bits.f32(result);
        }
        bits.f32(L::splat(self.a[3]));
        bits.f32(L::from_i32(integers[0]));
        bits.i32((L::from_i32(integers[1]) * L::splat(0.3)).trunc());
        bits.i32(L::from_bits(integers[0]).to_bits());
        bits.i32(a.le(b));
        bits.i32(a.lt(b));
        bits.f32(L::select(a.le(b), a, b));
        bits.f32(L::select(integers[0], a, b));
        let ordered = self.a.map(|x| if x.is_nan() { 1.0 } else { x + 0.0 });
        bits.0.push(L::load(&ordered).reduce_min().to_bits());
        bits.0.extend(a.ranks());
    }

    #[inline(always)]
    fn integers<L: Lanes>(&self, bits: &mut Bits) {
        let [a, b] = self.integers.map(|values| L::I32::load(&values));
        for result in [a + b, a - b, a * b, a & b, a | b, a ^ b, a.min(b), a.max(b)] {
            bits.i32(result);
        }
        bits.i32(a.shift_left(self.shift));
        bits.i32(a.shift_right(self.shift));
        bits.i32(L::I32::select(a, b, a));
        bits.i32(L::I32::splat(self.integers[0][5]));
        bits.0.push(a.signs());
        let mut unsigned = [0; 8];
        a.store_unsigned(&mut unsigned);
        bits.0.extend(unsigned);
        bits.i32(L::I32::load_unsigned(&unsigned.map(|x| x ^ 1)));
    }

    #[inline(always)]
    fn double<L: Lanes>(&self, bits: &mut Bits) {
        let [i, j] = self.integers.map(|values| L::I32::load(&values));
        let (a, b) = (L::load(&self.a).widen(), L::widen_i32(i));
        for result in [a, b, a + b, a - b, a * b, a / b, L::F64::splat(0.1) * a] {
            bits.f64(result);
            bits.f32(L::narrow(result));
        }
        // Halves are ties.
        for factor in [0.5, 0.3] {
            bits.i32(L::round(b * L::F64::splat(factor)));
            bits.i32(L::round(L::widen_i32(j) * L::F64::splat(factor)));
        }
        let values = self.b.map(f64::from);
        bits.f64(L::F64::load(&values) * a);
    }

    #[inline(always)]
    fn memory<L: Lanes>(&self, bits: &mut Bits) {
        let points = [[self.a[0], self.b[0], 0.5], [self.a[1], self.b[1], 1.5], [2.5; 3]];
        L::prefetch(&points);
        for axis in L::gather(&points, [0, 1, 2, 0, 2, 1, 1, 2]) {
            bits.f32(axis);
        }
        let [x, y] = self.integers.map(|values| L::I32::load(&values));
        let mut rows = [PackedVertex([7; 4]); 8];
        L::store_rows(x, y, L::load(&self.a), &mut rows);
        for row in &rows {
            let [x, y, z, unused] = row.0;
            let z = f32::from_bits(z);
            let z = if z.is_nan() { f32::NAN } else { z };
            bits.0.extend([x, y, z.to_bits(), unused]);
        }
        let [a, b, c, d, e, f, g, h] = &rows;
        let (x, y, z) = L::load_rows([b, a, d, c, h, g, f, e]);
        bits.i32(x);
        bits.i32(y);
        bits.f32(z);
    }
}

fn number() -> impl Strategy<Value = f32> {
    prop_oneof![
        any::<f32>(),
        -1e3f32..1e3,
        Just(0.0),
        Just(-0.0),
        Just(f32::INFINITY),
        Just(f32::NAN)
    ]
}

fn integer() -> impl Strategy<Value = i32> {
    prop_oneof![any::<i32>(), -100..100, Just(i32::MIN), Just(i32::MAX), Just(0)]
}

proptest! {
    #[test]
    fn every_level_gives_the_bits_of_the_scalar_twin(
        a in prop::array::uniform8(number()), b in prop::array::uniform8(number()),
        i in prop::array::uniform8(integer()), j in prop::array::uniform8(integer()),
        shift in 0u32..32,
    ) {
        let run = |level| run_lanes_at(level, Everything { a, b, integers: [i, j], shift });
        let expected = run(Level::BASELINE);
        for level in Level::available() {
            prop_assert_eq!(&run(level), &expected, "{:?}", level);
        }
    }

    #[test]
    fn weights_mix_within_both_numbers(alpha in any::<f32>(), first in any::<u16>(), second in any::<u16>()) {
        let weight = Weight::new(alpha);
        let (low, high) = (i32::from(first.min(second)), i32::from(first.max(second)));
        for mixed in [weight.mix_rounded(first, second), weight.mix_truncated(first, second)] {
            prop_assert!((low - 1..=high + 1).contains(&mixed));
        }
    }
}

struct Truncate<'a>(&'a [f32], &'a mut [i32]);

impl Kernel for Truncate<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for (value, out) in self.0.iter().zip(self.1) {
            *out = saturating_trunc(*value);
        }
    }
}

#[test]
fn truncation_saturates_at_every_level() {
    const MAX: i32 = 2_147_483_520;
    let values = [
        0.0,
        -0.9,
        2.9,
        -7.5,
        2.147_483_5e9,
        2.147_483_6e9,
        3e9,
        -3e9,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::NAN,
    ];
    let expected = [0, 0, 2, -7, MAX, MAX, MAX, -MAX, MAX, -MAX, -MAX];
    for level in Level::available() {
        let mut out = [1; 11];
        run_at(level, Truncate(&values, &mut out));
        assert_eq!(out, expected, "{level:?}");
    }
}

#[test]
fn the_best_level_is_the_last() {
    let levels = Level::available();
    assert_eq!(levels[0], Level::BASELINE);
    assert_eq!(levels.last(), Some(&Level::detect()));
    if cfg!(feature = "portable") {
        assert_eq!(levels, [Level::BASELINE]);
    }
}

#[test]
fn weights_are_clamped() {
    assert_eq!(Weight::new(f32::NAN), Weight::new(0.0));
    assert_eq!(Weight::new(-1.0), Weight::new(0.0));
    assert_eq!(Weight::new(7.0), Weight::new(1.0));
}

#[test]
fn ties_are_rounded_to_even() {
    let rounded = [0.5, 1.5, 2.5, -0.5, -1.5, 2_147_483_647.0, -2_147_483_648.0].map(round_ties_even);
    assert_eq!(rounded, [0, 2, 2, 0, -2, i32::MAX, i32::MIN]);
}
