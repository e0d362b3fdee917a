use oaktwin_image::Image;
use oaktwin_simd::Level;
use proptest::prelude::*;

use super::temporal::Memory;
use super::*;

const MEDIANS: [Median; 3] = [Median::Kernel3x3, Median::Kernel5x5, Median::Kernel7x7];

fn image<P: Pixel>(width: u32, pixels: &[P]) -> Image<P> {
    let height = u32::try_from(pixels.len()).unwrap() / width;
    let pixels = pixels[..(width * height) as usize].to_vec();
    Image::new(width, height, pixels).unwrap()
}

/// Images of similar values, extreme values, arbitrary values and holes.
fn pixels() -> impl Strategy<Value = Vec<u16>> {
    let pixel = prop_oneof![
        3 => 900u16..912,
        1 => Just(0),
        1 => prop_oneof![Just(1u16), Just(2), Just(32767), Just(32768), Just(65535)],
        1 => any::<u16>(),
    ];
    proptest::collection::vec(pixel, 1..2600)
}

/// A reference implementation of the speckle filter by flood filling.
fn without_speckles(image: &Image<u16>, speckle: Speckle) -> Image<u16> {
    let (width, mut out) = (image.width() as usize, image.clone());
    let before = image.pixels();
    let mut seen = vec![false; before.len()];
    for start in 0..before.len() {
        let mut patch = vec![start];
        let mut next = 0;
        if before[start] == 0 || std::mem::replace(&mut seen[start], true) {
            continue;
        }
        while let Some(&at) = patch.get(next) {
            next += 1;
            let (x, mut around) = (at % width, Vec::new());
            around.extend((x > 0).then(|| at - 1));
            around.extend((x + 1 < width).then_some(at + 1));
            around.extend(at.checked_sub(width));
            around.extend(Some(at + width).filter(|&below| below < before.len()));
            for other in around {
                let step = before[other].cast_signed().abs_diff(before[at].cast_signed());
                if before[other] != 0 && u32::from(step) <= speckle.difference_threshold && !seen[other] {
                    seen[other] = true;
                    patch.push(other);
                }
            }
        }
        if patch.len() <= speckle.speckle_range as usize {
            patch.iter().for_each(|&at| out.pixels_mut()[at] = 0);
        }
    }
    out
}

/// A reference implementation of decimation, block by block.
fn decimated(image: &Image<u16>, decimation: Decimation) -> Image<u16> {
    let (width, height) = decimation.size(image.width(), image.height());
    let factor = decimation.factor;
    let blocks = (0..height).flat_map(|y| (0..width).map(move |x| (x * factor, y * factor)));
    let pixels = blocks.map(|(left, top)| {
        let places = (top..top + factor).flat_map(|y| (left..left + factor).map(move |x| (x, y)));
        let values = places.filter_map(|(x, y)| image.get(x, y).copied());
        let mut values: Vec<u16> = values.filter(|&value| value != 0).collect();
        values.sort_unstable();
        if decimation.mode == DecimationMode::NonZeroMedian {
            return values
                .get(values.len().saturating_sub(1) / 2)
                .copied()
                .unwrap_or(0);
        }
        let sum: usize = values.iter().map(|&value| usize::from(value)).sum();
        u16::try_from(sum / values.len().max(1)).unwrap()
    });
    Image::new(width, height, pixels.collect()).unwrap()
}

fn median_of(image: &Image<u16>, size: u32) -> Image<u16> {
    let (width, height) = (i64::from(image.width()), i64::from(image.height()));
    let radius = i64::from(size / 2);
    let medians = (0..height * width).map(|at| {
        let mut square = Vec::new();
        for dy in -radius..=radius {
            for dx in -radius..=radius {
                let x = (at % width + dx).clamp(0, width - 1);
                let y = (at / width + dy).clamp(0, height - 1);
                square.push(image.pixels()[usize::try_from(y * width + x).unwrap()]);
            }
        }
        square.sort_unstable();
        square[square.len() / 2]
    });
    Image::new(image.width(), image.height(), medians.collect()).unwrap()
}

proptest! {
    #[test]
    fn results_do_not_depend_on_instructions(
        pixels in pixels(), width in 1u32..200, alpha in 0f32..=1.0, delta: u8, radius in 0u8..6,
    ) {
        prop_assume!(pixels.len() >= width as usize);
        let before = image(width, &pixels);
        let spatial = Spatial { alpha, delta, hole_filling_radius: radius, num_iterations: 2 };
        let temporal = Temporal { alpha, delta, ..Temporal::default() };
        let run = |level: Level| {
            let mut out = Vec::new();
            for median in MEDIANS {
                let mut image = before.clone();
                median.run(level, &mut image);
                out.push(image);
            }
            let mut image = before.clone();
            spatial.run(level, &mut image);
            out.push(image);
            let (mut memory, mut image) = (Memory::default(), before.clone());
            for _ in 0..3 {
                temporal.run(level, &mut image, &mut memory);
                image.pixels_mut().rotate_left(1);
            }
            out.push(image);
            let mut image = before.clone();
            Speckle::default().run(level, &mut image);
            out.push(image);
            for (factor, mode) in (1..=4).zip(DecimationMode::ALL.iter().copied().cycle()) {
                out.push(Decimation { factor, mode }.run(level, &before));
            }
            out
        };
        let baseline = run(Level::BASELINE);
        for level in Level::available() {
            prop_assert_eq!(&run(level), &baseline, "{:?}", level);
        }
    }

    #[test]
    fn medians_match_sorting(pixels in pixels(), width in 1u32..150) {
        prop_assume!(pixels.len() >= width as usize);
        let before = image(width, &pixels);
        for median in MEDIANS {
            let after = Chain::new(vec![Filter::Median(median)]).run(before.clone());
            prop_assert_eq!(after, median_of(&before, median.size()));
        }
    }

    #[test]
    fn decimation_matches_the_reference(pixels in pixels(), width in 1u32..300, factor in 1u32..=4) {
        prop_assume!(pixels.len() >= width as usize);
        let before = image(width, &pixels);
        for mode in [DecimationMode::NonZeroMedian, DecimationMode::NonZeroMean] {
            let decimation = Decimation { factor, mode };
            let after = Chain::new(vec![Filter::Decimation(decimation)]).run(before.clone());
            prop_assert_eq!(after, decimated(&before, decimation));
        }
    }

    #[test]
    fn speckles_match_flood_filling(
        pixels in pixels(), width in 1u32..150, range in 0u32..300, threshold in prop_oneof![0u32..20, 0u32..70_000],
        band in 1usize..6,
    ) {
        prop_assume!(pixels.len() >= width as usize);
        let before = image(width, &pixels);
        let speckle = Speckle { speckle_range: range, difference_threshold: threshold };
        let mut chain = Chain::new(vec![Filter::Speckle(speckle)]);
        let after = chain.run(before.clone());
        prop_assert_eq!(&after, &without_speckles(&before, speckle));
        let mut in_bands = before;
        speckle.run_in_bands(Level::detect(), &mut in_bands, band);
        prop_assert_eq!(&after, &in_bands);
        // The filter is idempotent.
        prop_assert_eq!(&chain.run(after.clone()), &after);
    }

    #[test]
    fn results_do_not_depend_on_threads(pixels in pixels(), width in 1u32..80) {
        prop_assume!(pixels.len() >= width as usize);
        let before = image(width, &pixels);
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let texts = ["median:size=7", "spatial:delta=20,iterations=2", "speckle", "temporal", "decimation:factor=2"];
            let mut chain = Chain::new(texts.iter().map(|text| parse(text).unwrap()).collect());
            pool.install(|| (chain.run(before.clone()), chain.run(before.clone())))
        };
        prop_assert_eq!(run(1), run(3));
    }

    #[test]
    fn filters_of_bytes_match_those_of_words(pixels in proptest::collection::vec(any::<u8>(), 1..900), width in 1u32..60) {
        prop_assume!(pixels.len() >= width as usize);
        let words: Vec<u16> = pixels.iter().map(|&pixel| pixel.into()).collect();
        for text in ["median:size=3", "median:size=7", "spatial:delta=20", "temporal:delta=20", "speckle:difference=9"] {
            let (mut of_bytes, mut of_words) = (Chain::new(vec![parse(text).unwrap()]), Chain::new(vec![parse(text).unwrap()]));
            for _ in 0..2 {
                let (a, b) = (of_bytes.run(image(width, &pixels)), of_words.run(image(width, &words)));
                prop_assert_eq!(a.map(|&pixel| u16::from(pixel)), b, "{}", text);
            }
        }
    }

    #[test]
    fn text_round_trips(alpha in 0f32..=1.0, delta: u8, n in 0u32..=100, mode in 0usize..9, a: u16, b: u16) {
        let (low, high) = (a.min(b), a.max(b));
        for filter in [
            Filter::Median(Median::Kernel7x7),
            Filter::Spatial(Spatial { alpha, delta, hole_filling_radius: delta, num_iterations: n }),
            Filter::Temporal(Temporal { alpha, delta, persistency_mode: PersistencyMode::ALL[mode] }),
            Filter::Speckle(Speckle { speckle_range: n, difference_threshold: a.into() }),
            Filter::Decimation(Decimation { factor: n % 4 + 1, mode: DecimationMode::ALL[mode % 3] }),
            Filter::Threshold(Threshold { min_range: low, max_range: high }),
            Filter::Brightness(Brightness { min_brightness: -1, max_brightness: 256 }),
        ] {
            prop_assert_eq!(parse(&filter.to_string()).unwrap(), filter);
        }
    }
}

#[test]
fn resizing_or_resetting_clears_the_memory() {
    let temporal = Filter::Temporal(Temporal {
        persistency_mode: PersistencyMode::Indefinitely,
        ..Temporal::default()
    });
    let mut chain = Chain::new(vec![temporal]);
    let (full, hole) = (Image::filled(2, 2, 7u16), Image::filled(2, 2, 0u16));
    let _ = chain.run(full.clone());
    assert_eq!(chain.run(hole.clone()), full);
    assert_eq!(chain.run(Image::filled(4, 1, 0u16)), Image::filled(4, 1, 0u16));
    assert_eq!(chain.run(hole.clone()), hole);
    let _ = chain.run(full);
    chain.reset();
    assert_eq!(chain.run(hole.clone()), hole);
}

#[test]
fn filters_accept_empty_images() {
    for text in NAMES {
        for (width, height) in [(0, 0), (0, 3), (3, 0)] {
            let none = Image::filled(width, height, 0u16);
            assert_eq!(Chain::new(vec![parse(text).unwrap()]).run(none.clone()), none);
        }
    }
}

#[test]
fn rejects_invalid_text() {
    let errors = [
        "spacial",
        "kalman",
        "spatial:alpa=1",
        "spatial:alpha",
        "spatial:alpha=nan",
        "temporal:alpha=1.5",
        "spatial:delta=256",
        "spatial:radius=-1",
        "spatial:iterations=101",
        "temporal:persistency=9",
        "temporal:persistency=VALID_2_IN_LAST_5",
        "decimation:factor=0",
        "median:size=4",
        "threshold:min=9,max=8",
        "brightness:max=300",
    ];
    let messages: Vec<String> = errors
        .iter()
        .map(|text| parse(text).unwrap_err().to_string())
        .collect();
    assert_eq!(
        messages,
        [
            "spacial: unknown filter 'spacial'; did you mean 'spatial' or 'speckle'?",
            "kalman: unknown filter 'kalman'; expected one of median, spatial, temporal, speckle, decimation, \
             threshold, brightness",
            "spatial:alpa=1: alpa: unknown parameter of spatial filter; did you mean 'alpha'?",
            "spatial:alpha: setting 'alpha' has no value; write alpha=VALUE",
            "spatial:alpha=nan: alpha: must not be NaN; expected a number from 0 to 1",
            "temporal:alpha=1.5: alpha: 1.5 is out of range; expected a number from 0 to 1",
            "spatial:delta=256: delta: invalid value '256'; expected a whole number from 0 to 255",
            "spatial:radius=-1: radius: invalid value '-1'; expected a whole number from 0 to 255 px",
            "spatial:iterations=101: iterations: 101 is out of range; expected a whole number from 0 to 100",
            "temporal:persistency=9: persistency: invalid value '9'; expected PERSISTENCY_OFF, VALID_8_OUT_OF_8, \
             VALID_2_IN_LAST_3, VALID_2_IN_LAST_4, VALID_2_OUT_OF_8, VALID_1_IN_LAST_2, VALID_1_IN_LAST_5, \
             VALID_1_IN_LAST_8 or PERSISTENCY_INDEFINITELY",
            "temporal:persistency=VALID_2_IN_LAST_5: persistency: invalid value 'VALID_2_IN_LAST_5'; expected \
             PERSISTENCY_OFF, VALID_8_OUT_OF_8, VALID_2_IN_LAST_3, VALID_2_IN_LAST_4, VALID_2_OUT_OF_8, \
             VALID_1_IN_LAST_2, VALID_1_IN_LAST_5, VALID_1_IN_LAST_8 or PERSISTENCY_INDEFINITELY",
            "decimation:factor=0: factor: 0 is out of range; expected 1, 2, 3 or 4 px",
            "median:size=4: size: invalid value '4'; expected 3, 5 or 7",
            "threshold filter: min: 9 is above max; expected up to 8",
            "brightness:max=300: max: 300 is out of range; expected a whole number from 0 to 256",
        ]
    );
}
