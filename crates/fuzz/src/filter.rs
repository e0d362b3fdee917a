//! Filters of depth and disparity.

use oaktwin_depth::filter::{Chain, Filter, NAMES, parse};
use oaktwin_image::Image;

use crate::random::Random;

/// The first line is a list of filters separated by semicolons. If it is empty, the filters are drawn from the bytes. The
/// rest describes two frames.
pub(crate) fn check(bytes: &[u8]) {
    let at = bytes.iter().position(|&byte| byte == b'\n');
    let (text, rest) = bytes.split_at(at.unwrap_or(0));
    let mut random = Random::new(rest.get(1..).unwrap_or_default());
    let mut filters = Vec::new();
    for text in String::from_utf8_lossy(text).split(';').take(4) {
        if let Ok(filter) = parse(text) {
            filters.push(filter);
        }
    }
    for _ in 0..random.up_to(3) {
        filters.extend(drawn(&mut random));
    }
    for filter in &filters {
        let again = parse(&filter.to_string()).unwrap_or_else(|error| panic!("{filter}: {error}"));
        assert_eq!(again, *filter, "the text of a filter does not round-trip");
    }
    let (width, height) = (1 + random.up_to(47), 1 + random.up_to(31));
    let colors = random.image(width, height, |random| [random.byte(); 4]);
    let first = frame(&mut random, width, height);
    let second = frame(&mut random, width, height);
    let mut chain = Chain::new(filters);
    let once = run(&mut chain, &[&first, &second, &first], &colors);
    chain.reset();
    let twice = run(&mut chain, &[&first, &second, &first], &colors);
    assert!(once == twice, "other pixels the second time");
}

fn run(chain: &mut Chain, frames: &[&Image<u16>], colors: &Image<[u8; 4]>) -> Vec<Image<u16>> {
    let mut out = Vec::new();
    for frame in frames {
        let filtered = chain.run_seeing((*frame).clone(), Some(colors.into()));
        let size = chain.size(frame.width(), frame.height());
        assert_eq!((filtered.width(), filtered.height()), size);
        out.push(filtered);
    }
    out
}

fn drawn(random: &mut Random<'_>) -> Option<Filter> {
    let name = random.pick(&NAMES);
    let default = parse(name).ok()?.to_string();
    let (_, settings) = default.split_once(':')?;
    let names: Vec<&str> = settings
        .split(',')
        .filter_map(|setting| Some(setting.split_once('=')?.0))
        .collect();
    let mut text = format!("{name}:");
    for _ in 0..random.up_to(3) {
        let value = match random.up_to(2) {
            0 => random.up_to(300).to_string(),
            1 => random.number().to_string(),
            _ => random
                .pick(&["true", "false", "KERNEL_3x3", "KERNEL_5x5", "KERNEL_7x7"])
                .to_owned(),
        };
        text += &format!("{}={value},", random.pick(&names));
    }
    parse(&text).ok()
}

fn frame(random: &mut Random<'_>, width: u32, height: u32) -> Image<u16> {
    random.image(width, height, |random| match random.byte() {
        0 => 0,
        1 => 65535,
        2 => 32768,
        byte @ 3..16 => u16::from(byte) << 8 | u16::from(random.byte()),
        byte => 900 + u16::from(byte),
    })
}

pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let texts = NAMES
        .iter()
        .map(|name| parse(name).map(|filter| filter.to_string()).unwrap_or_default());
    let mut all: Vec<Vec<u8>> = texts.map(|text| format!("{text}\n").into_bytes()).collect();
    for seed in &mut all {
        seed.extend((0..200u8).map(|at| at.wrapping_mul(37)));
    }
    all.push(b"decimation:factor=3;speckle;spatial;temporal\n".to_vec());
    all
}
