//! Depth as a picture for people: turbo colours, near in red, and a scale under it.

use crate::colormap::turbo;
use crate::text::{self, Style};
use crate::{Image, RangeDepth, ZDepth};

/// Where there is no value: a grey that turbo does not have.
const NONE: [u8; 3] = [96, 96, 96];

/// Behind the scale.
const PAPER: [u8; 3] = [24, 24, 24];

const INK: [u8; 3] = [235, 235, 235];

/// Farthest over nearest from which on the scale is logarithmic: near things would share a few colours else.
const LOGARITHMIC_FROM: f32 = 12.0;

/// Values looked at to find the range of an image.
const SAMPLES: usize = 1 << 18;

/// What of a depth image is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// The nearest and the farthest depth that has a colour of its own, metres. Without it the image decides: half a
    /// percent of its values may lie outside on either side.
    pub range: Option<(f32, f32)>,
}

impl ZDepth {
    /// A picture of this depth, as [`depth`] draws it.
    #[must_use]
    pub fn preview(&self, options: &Options) -> Image<[u8; 3]> {
        depth(&self.0, options)
    }
}

impl RangeDepth {
    /// A picture of this depth, as [`depth`] draws it.
    #[must_use]
    pub fn preview(&self, options: &Options) -> Image<[u8; 3]> {
        depth(&self.0, options)
    }
}

/// A picture of a depth image (metres; what is not positive and finite has no value) in its own size, and a scale in
/// [`legend_height`] more rows under it.
///
/// The scale is linear, or logarithmic where the farthest is more than twelve times the nearest. `<` and `>` at its
/// ends say that what lies beyond has the same colour.
#[must_use]
pub fn depth(metres: &Image<f32>, options: &Options) -> Image<[u8; 3]> {
    let scale = Scale::of(metres, options);
    let (width, height) = (metres.width(), metres.height());
    let mut pixels = Vec::with_capacity(width as usize * (height + legend_height(width)) as usize);
    let mut missing = 0usize;
    let mut beyond = [false; 2];
    if let Some(scale) = &scale {
        let turbo = turbo();
        for &z in metres.pixels() {
            let valid = is_value(z);
            missing += usize::from(!valid);
            beyond[0] |= valid & (z < scale.near);
            beyond[1] |= valid & (z > scale.far);
            let color = turbo[step(scale.place(z))];
            pixels.push(if valid { color } else { NONE });
        }
    } else {
        missing = metres.pixels().len();
        pixels.resize(missing, NONE);
    }
    pixels.resize(
        pixels.len() + width as usize * legend_height(width) as usize,
        PAPER,
    );
    let Some(mut picture) = Image::new(width, height + legend_height(width), pixels) else {
        return Image::filled(0, 0, PAPER);
    };
    Legend::new(&mut picture, height).draw(scale.as_ref(), missing > 0, beyond);
    picture
}

/// Rows that [`depth`] adds to an image of so many columns.
#[must_use]
pub fn legend_height(width: u32) -> u32 {
    text_height(width) * 4
}

/// Height of the scale's capitals, px.
fn text_height(width: u32) -> u32 {
    (width / 80).max(10)
}

fn is_value(metres: f32) -> bool {
    metres > 0.0 && metres < f32::INFINITY
}

/// What is used of turbo: its ends are nearly black, and nothing there would be told apart.
const STEPS: std::ops::RangeInclusive<u8> = 12..=243;

/// How a depth becomes a step of the colour map.
struct Scale {
    near: f32,
    far: f32,
    logarithmic: bool,
    offset: f32,
    factor: f32,
}

impl Scale {
    /// `None` where no depth has a value.
    fn of(metres: &Image<f32>, options: &Options) -> Option<Self> {
        let (near, far) = match options.range {
            Some((near, far)) => (near.min(far), near.max(far)),
            None => range(metres)?,
        };
        // A range of one value still has a colour and a scale.
        let near = near.max(1e-6);
        let far = if far > near { far } else { near * 1.001 };
        let logarithmic = far / near > LOGARITHMIC_FROM;
        let place = |z| if logarithmic { log2(z) } else { z };
        Some(Self {
            near,
            far,
            logarithmic,
            offset: place(near),
            factor: 1.0 / (place(far) - place(near)),
        })
    }

    /// 0 at the near end, 1 at the far one.
    fn place(&self, metres: f32) -> f32 {
        let value = if self.logarithmic { log2(metres) } else { metres };
        (value - self.offset) * self.factor
    }

    /// Round numbers to write at the scale, coarsest first.
    fn ticks(&self) -> Vec<f32> {
        let mut ticks = Vec::new();
        // From 1 µm to 10 000 km.
        let decades = (-6..8).map(|exponent| 10f32.powi(exponent));
        if self.logarithmic {
            let decades: Vec<f32> = decades.collect();
            for digit in [1.0, 3.0, 2.0, 5.0] {
                ticks.extend(decades.iter().map(|decade| digit * decade));
            }
            ticks.retain(|&tick| tick > self.near && tick < self.far);
            return ticks;
        }
        let length = self.far - self.near;
        let steps = decades.flat_map(|decade| [decade, 2.0 * decade, 5.0 * decade]);
        let Some(step) = steps.into_iter().find(|step| length / step <= 8.0) else {
            return ticks;
        };
        let first = (self.near / step).ceil();
        ticks.extend((0u8..=8).map(|i| (first + f32::from(i)) * step));
        ticks.retain(|&tick| tick > self.near && tick < self.far);
        ticks
    }
}

/// The step of turbo for a place between the near end, 0, and the far one, 1.
fn step(place: f32) -> usize {
    let (far, near) = (f32::from(*STEPS.start()), f32::from(*STEPS.end()));
    let step = near - place.clamp(0.0, 1.0) * (near - far);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "within the steps"
    )]
    let step = (step + 0.5) as u8;
    usize::from(step)
}

/// The nearest and farthest depths but for half a percent on either side.
fn range(metres: &Image<f32>) -> Option<(f32, f32)> {
    let stride = (metres.pixels().len() / SAMPLES).max(1);
    // Not a divisor of common widths, so that every column is looked at.
    let stride = if stride > 1 { stride | 1 } else { 1 };
    let sample = |stride| -> Vec<f32> {
        let pixels = metres.pixels().iter().step_by(stride);
        pixels.copied().filter(|&z| is_value(z)).collect()
    };
    let mut values = sample(stride);
    if values.is_empty() {
        values = sample(1);
    }
    let last = values.len().checked_sub(1)?;
    let cut = values.len() / 200;
    let (_, &mut near, _) = values.select_nth_unstable_by(cut, f32::total_cmp);
    let (_, &mut far, _) = values.select_nth_unstable_by(last - cut, f32::total_cmp);
    Some((near, far))
}

/// The logarithm to base 2 of a positive, finite number, within 3e-5: made of operations that every machine rounds
/// alike, which a system's `log` is not.
fn log2(x: f32) -> f32 {
    let bits = x.to_bits();
    let exponent = (bits >> 23) as f32 - 127.0;
    let mantissa = f32::from_bits((bits & 0x007F_FFFF) | 0x3F80_0000);
    // ln m = 2 atanh((m − 1)/(m + 1))
    let t = (mantissa - 1.0) / (mantissa + 1.0);
    let u = t * t;
    let atanh = t * (1.0 + u * (1.0 / 3.0 + u * (1.0 / 5.0 + u * (1.0 / 7.0))));
    exponent + atanh * (2.0 * std::f32::consts::LOG2_E)
}

/// Metres with as many digits as tell neighbouring ticks apart.
fn label(metres: f32) -> String {
    let digits = match metres {
        m if m >= 99.95 => 0,
        m if m >= 9.995 => 1,
        m if m >= 0.0995 => 2,
        m if m >= 0.00995 => 3,
        _ => 4,
    };
    format!("{metres:.digits$}")
}

/// A round number without its trailing zeros.
fn round_label(metres: f32) -> String {
    let text = format!("{metres:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    text.to_owned()
}

/// The scale under a picture.
struct Legend<'a> {
    picture: &'a mut Image<[u8; 3]>,
    /// The first row.
    top: u32,
    unit: u32,
}

impl<'a> Legend<'a> {
    fn new(picture: &'a mut Image<[u8; 3]>, top: u32) -> Self {
        let unit = text_height(picture.width());
        Self { picture, top, unit }
    }

    fn draw(&mut self, scale: Option<&Scale>, any_missing: bool, beyond: [bool; 2]) {
        let unit = self.unit;
        let (left, mut right) = (unit, self.picture.width().saturating_sub(unit));
        let (bar_top, bar_bottom) = (self.top + unit * 2 / 3, self.top + unit * 5 / 3);
        let text_top = self.top + unit * 9 / 4;
        if any_missing {
            let label = "no value";
            let (label_width, swatch) = (self.width(label), unit * 3 / 2);
            // The bar keeps at least half of the picture.
            if label_width < self.picture.width() / 4 {
                let column = right.saturating_sub(label_width);
                self.fill(
                    column..column + swatch.max(label_width),
                    bar_top..bar_bottom,
                    |_| NONE,
                );
                self.write(label, column, text_top);
                right = column.saturating_sub(unit * 3 / 2);
            }
        }
        let Some(scale) = scale else { return };
        if right <= left + 8 {
            return;
        }
        let length = (right - left) as f32;
        let turbo = turbo();
        self.fill(left..right, bar_top..bar_bottom, |column| {
            turbo[step(((column - left) as f32 + 0.5) / length)]
        });
        // Text is kept clear of text, the most telling first.
        let mut taken: Vec<(u32, u32)> = Vec::new();
        let mut try_to_write = |legend: &mut Self, text: &str, column: u32| {
            let end = column + legend.width(text);
            let free = taken.iter().all(|&(a, b)| end + unit < a || column > b + unit);
            let fits = free && end <= right + unit / 2;
            if fits {
                legend.write(text, column, text_top);
                taken.push((column, end));
            }
            fits
        };
        let mark = |beyond: bool, sign: &str, metres: f32| {
            let sign = if beyond { sign } else { "" };
            format!("{sign}{} m", label(metres))
        };
        let (near, far) = (
            mark(beyond[0], "< ", scale.near),
            mark(beyond[1], "> ", scale.far),
        );
        try_to_write(self, &near, left);
        let far_column = right.saturating_sub(self.width(&far));
        try_to_write(self, &far, far_column);
        for tick in scale.ticks() {
            let text = round_label(tick);
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "within the bar"
            )]
            let column = left + (scale.place(tick) * length) as u32;
            if try_to_write(self, &text, column.saturating_sub(self.width(&text) / 2)) {
                let thickness = (unit / 10).max(1);
                self.fill(
                    column.saturating_sub(thickness / 2)..column + thickness.div_ceil(2),
                    bar_bottom..bar_bottom + unit / 3,
                    |_| INK,
                );
            }
        }
    }

    fn width(&self, text: &str) -> u32 {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a few words"
        )]
        let width = text::width(text, self.unit as f32).ceil() as u32;
        width
    }

    fn write(&mut self, text: &str, column: u32, row: u32) {
        let style = Style {
            height: self.unit as f32,
            color: INK,
        };
        text::draw(self.picture, text, (column as f32, row as f32), style);
    }

    fn fill(
        &mut self,
        columns: std::ops::Range<u32>,
        rows: std::ops::Range<u32>,
        color: impl Fn(u32) -> [u8; 3],
    ) {
        let (width, height) = (self.picture.width(), self.picture.height());
        for row in rows.start..rows.end.min(height) {
            for column in columns.start..columns.end.min(width) {
                let at = row as usize * width as usize + column as usize;
                self.picture.pixels_mut()[at] = color(column);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn ramp(width: u32, near: f32, far: f32) -> Image<f32> {
        let row = (0..width).map(|x| near + (far - near) * x as f32 / (width - 1) as f32);
        Image::new(width, 2, row.clone().chain(row).collect()).unwrap()
    }

    #[test]
    fn near_is_red_far_is_blue_and_what_is_missing_is_grey() {
        let mut image = ramp(300, 1.0, 3.0);
        image.pixels_mut()[5] = f32::INFINITY;
        image.pixels_mut()[6] = 0.0;
        image.pixels_mut()[7] = f32::NAN;
        image.pixels_mut()[8] = -2.0;
        let picture = depth(
            &image,
            &Options {
                range: Some((1.0, 3.0)),
            },
        );
        assert_eq!((picture.width(), picture.height()), (300, 2 + legend_height(300)));
        assert_eq!(picture.get(0, 0), Some(&turbo()[243]));
        assert_eq!(picture.get(299, 0), Some(&turbo()[12]));
        assert_eq!(picture.get(150, 1), Some(&turbo()[127]));
        for x in 5..9 {
            assert_eq!(picture.get(x, 0), Some(&NONE));
        }
    }

    #[test]
    fn outliers_do_not_set_the_range() {
        let mut image = ramp(1000, 1.0, 2.0);
        image.pixels_mut()[3] = 1e9;
        let scale = Scale::of(&image, &Options::default()).unwrap();
        assert!((1.0..1.02).contains(&scale.near) && (1.98..=2.0).contains(&scale.far));
        assert!(!scale.logarithmic);
        assert_eq!(step(scale.place(1e9)), 12);
        assert_eq!(scale.ticks().len(), 4, "{:?}", scale.ticks());
        // One value among thousands of misses is found.
        let mut sparse = Image::filled(2000, 1000, f32::INFINITY);
        sparse.pixels_mut()[1_234_567] = 4.0;
        assert_eq!(range(&sparse), Some((4.0, 4.0)));
    }

    #[test]
    fn wide_ranges_are_logarithmic() {
        let scale = Scale::of(
            &ramp(9, 0.1, 100.0),
            &Options {
                range: Some((0.1, 100.0)),
            },
        )
        .unwrap();
        assert!(scale.logarithmic);
        assert_eq!(
            [0.1, 1.0, 10.0, 100.0].map(|z| step(scale.place(z))),
            [243, 166, 89, 12]
        );
        assert!(scale.ticks().starts_with(&[1.0, 10.0]));
    }

    #[test]
    fn labels() {
        let labels = [0.001_2, 0.05, 0.7421, 3.0, 12.34, 250.4].map(label);
        assert_eq!(labels, ["0.0012", "0.050", "0.74", "3.00", "12.3", "250"]);
        assert_eq!([0.5, 20.0, 1.0].map(round_label), ["0.5", "20", "1"]);
    }

    #[test]
    fn nothing_to_show() {
        for image in [
            Image::filled(0, 0, 0.0),
            Image::filled(1, 1, f32::NAN),
            Image::filled(3, 2, 1.0),
            Image::filled(0, 5, 1.0),
        ] {
            let picture = depth(&image, &Options::default());
            assert_eq!(picture.width(), image.width());
            assert_eq!(picture.height(), image.height() + legend_height(image.width()));
        }
    }

    proptest! {
        #[test]
        fn log2_is_close(x in 1e-30..1e30f32) {
            prop_assert!((log2(x) - x.log2()).abs() < 1e-4);
        }

        #[test]
        fn any_numbers_make_a_picture(
            values in prop::collection::vec(prop::num::f32::ANY, 60), near: f32, far: f32,
        ) {
            let image = Image::new(60, 1, values).unwrap();
            let _ = depth(&image, &Options::default());
            let _ = depth(&image, &Options { range: Some((near, far)) });
        }
    }
}
