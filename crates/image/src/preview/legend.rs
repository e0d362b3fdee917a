use super::scale::{Scale, step};
use super::{INK, Marks, NONE, text_height};
use crate::Image;
use crate::colormap::turbo;
use crate::text::{self, TextStyle};

/// The legend below an image.
pub(super) struct Legend<'a> {
    picture: &'a mut Image<[u8; 3]>,
    /// The first row of the legend.
    top: u32,
    unit: u32,
}

impl<'a> Legend<'a> {
    pub(super) fn new(picture: &'a mut Image<[u8; 3]>, top: u32) -> Self {
        let unit = text_height(picture.width());
        Self { picture, top, unit }
    }

    pub(super) fn draw(&mut self, scale: Option<&Scale>, marks: Marks) {
        let unit = self.unit;
        let (left, mut right) = (unit, self.picture.width().saturating_sub(unit));
        let (bar_top, bar_bottom) = (self.top + unit * 2 / 3, self.top + unit * 5 / 3);
        let text_top = self.top + unit * 9 / 4;
        if marks.missing {
            let label = "no value";
            let (label_width, swatch) = (self.width(label), unit * 3 / 2);
            // The bar keeps at least half of the width.
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
        // Labels do not overlap; the most important are placed first.
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
            mark(marks.nearer, "< ", scale.near),
            mark(marks.farther, "> ", scale.far),
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
        let style = TextStyle {
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

/// Formats metres with enough digits to distinguish neighbouring ticks.
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

/// Formats a round number without trailing zeros.
fn round_label(metres: f32) -> String {
    let text = format!("{metres:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    text.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_have_enough_digits() {
        let labels = [0.001_2, 0.05, 0.7421, 3.0, 12.34, 250.4].map(label);
        assert_eq!(labels, ["0.0012", "0.050", "0.74", "3.00", "12.3", "250"]);
        assert_eq!([0.5, 20.0, 1.0].map(round_label), ["0.5", "20", "1"]);
    }
}
