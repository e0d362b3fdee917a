//! All steps for an image, in strips of a few rows and in memory that fits the processor's caches.

use oaktwin_image::ImageView;
use oaktwin_simd::{self as simd, Level};
use rayon::prelude::*;

use super::StereoNoise;
use super::dilation::Dilation;
use super::field::Field;
use super::rows::{Disparities, Dropout, Measure, Textured};
use super::scale::Scale;
use super::shadow::{NEARER, Rows, Shadow};
use super::texture::{self, GAIN, Texture};
use super::window::{WindowSum, field_width};
use crate::DepthShot;
use crate::random::{NoiseStage, RandomPlane, Stream};
use crate::reason::Reason;

/// The rows that one thread processes. The first one also sums the windows of the rows before it.
pub(crate) const BAND: usize = 64;

/// Rows are padded to multiples of this, so that loops have no remainder. The padding has no surface.
const PADDING: usize = 16;

/// A row's low dropout bytes are padded to multiples of this before its high ones.
const DROPOUT: usize = 64;

/// The pixels of a strip: loops over few pixels are slow.
const STRIP: usize = 1280;

/// The measurement of one image.
pub(super) struct Job<'a> {
    sensor: &'a StereoNoise,
    scale: Scale,
    depth: ImageView<'a, f32>,
    picture: Option<ImageView<'a, [u8; 4]>>,
    jitter: RandomPlane,
    dropout: RandomPlane,
    /// Whether the reasons for invalid pixels are recorded.
    explains: bool,
    level: Level,
}

/// The memory of one thread: the rows of a strip, `stride` pixels apart.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    stride: usize,
    /// The column of each pixel.
    columns: Vec<f32>,
    disparities: Vec<f32>,
    sums: Vec<u32>,
    fixed: Vec<u16>,
    shadow: Shadow,
    jitter: WindowSum,
    field: Field,
    hidden: Vec<usize>,
    texture: Texture,
    texture_sums: Vec<u32>,
    dropout: Vec<u8>,
    dilation: Dilation,
    dilated: Vec<f32>,
    widened: Vec<f32>,
    /// Why pixels have no value; empty if that is not recorded.
    reasons: Vec<u8>,
}

impl<'a> Job<'a> {
    pub(super) fn new(sensor: &'a StereoNoise, shot: &DepthShot<'a>, random: &Stream) -> Self {
        let p = sensor.parameters();
        Self {
            sensor,
            scale: Scale::new(p, shot),
            depth: shot.depth(),
            picture: shot.rgb().filter(|_| p.confidence_threshold > 0),
            jitter: random.plane(NoiseStage::Jitter, shot.frame, shot.item),
            dropout: random.plane(NoiseStage::Dropout, shot.frame, shot.item),
            explains: false,
            level: Level::detect(),
        }
    }

    /// Records the reasons for invalid pixels.
    pub(super) fn with_reasons(self) -> Self {
        Self {
            explains: true,
            ..self
        }
    }

    #[cfg(test)]
    pub(super) fn at(mut self, level: Level) -> Self {
        self.level = level;
        self
    }

    fn width(&self) -> usize {
        self.depth.width() as usize
    }

    /// Computes all rows on all threads; `finish` makes each from its disparities. A small image is left to the calling thread.
    pub(super) fn image<T: Send>(&self, out: &mut [T], finish: impl Fn(&[u16], &[u8], &mut [T]) + Sync) {
        let band = BAND * self.width();
        if out.len() <= band {
            return self.rows(&mut Scratch::default(), 0, out, finish);
        }
        out.par_chunks_mut(band.max(1)).enumerate().for_each_init(
            Scratch::default,
            |scratch, (index, out)| {
                self.rows(scratch, index * BAND, out, &finish);
            },
        );
    }

    /// Computes as many rows from `first` as `out` holds.
    pub(super) fn rows<T>(
        &self,
        s: &mut Scratch,
        first: usize,
        out: &mut [T],
        finish: impl Fn(&[u16], &[u8], &mut [T]),
    ) {
        if out.is_empty() {
            return;
        }
        let width = self.width();
        s.begin(self, first);
        let together = (STRIP / s.stride).max(1);
        for (strip, out) in out.chunks_mut(together * width).enumerate() {
            s.strip(self, first + strip * together, out.len() / width);
            let mut reasons = s.reasons.chunks_exact(s.stride);
            for (fixed, out) in s.fixed.chunks_exact(s.stride).zip(out.chunks_exact_mut(width)) {
                let reasons = reasons.next().and_then(|row| row.get(..width));
                finish(
                    fixed.get(..width).unwrap_or_default(),
                    reasons.unwrap_or_default(),
                    out,
                );
            }
        }
    }
}

impl Scratch {
    /// Prepares for row `first`.
    fn begin(&mut self, job: &Job<'_>, first: usize) {
        let (width, scale) = (job.width(), &job.scale);
        self.stride = width.next_multiple_of(PADDING);
        let field = self.field.reset(field_width(self.stride, scale.window));
        self.jitter.reset(field, scale.window);
        if job.picture.is_some() {
            self.texture.reset(width, &scale.texture);
            self.texture_sums.resize(width, 0);
        }
        for row in first..first + scale.window - 1 {
            let entering = counter(row)..counter(row + 1);
            let numbers = self.field.rows(job.level, &job.jitter, entering, scale.numbers);
            simd::run_at(job.level, self.jitter.slide(numbers, self.stride, &mut []));
        }
        if let Some(picture) = &job.picture {
            for row in first..first + scale.texture.side - 1 {
                (self.texture).slide(job.level, picture, row, &scale.texture, &mut []);
            }
        }
        if scale.dilation > 0 {
            self.dilation.reset(self.stride, scale.dilation);
            for row in 0..2 * scale.dilation {
                self.dilate(job, (first + row).checked_sub(scale.dilation));
            }
        }
    }

    /// Computes the measured disparities of the next rows.
    fn strip(&mut self, job: &Job<'_>, first: usize, rows: usize) {
        let (p, scale, stride) = (job.sensor.parameters(), &job.scale, self.stride);
        self.make_room(rows);
        to_disparities(job, first, stride, &mut self.disparities);
        self.reasons.clear();
        self.reasons
            .resize(if job.explains { self.disparities.len() } else { 0 }, 0);
        self.record(Reason::NoSurface);
        if scale.dilation > 0 {
            self.widen(job, first);
        } else if p.occlusion {
            self.hide(NEARER, scale, job.level);
            self.drop_hidden();
        }
        self.record(Reason::Occluded);
        if job.picture.is_some() {
            self.drop_plain(job, first);
            self.record(Reason::NoTexture);
        }
        if scale.dropout > 0 {
            self.drop_at_random(job, first);
            self.record(Reason::Dropout);
        }
        let last = first + scale.window - 1;
        let entering = counter(last)..counter(last + rows);
        let numbers = self.field.rows(job.level, &job.jitter, entering, scale.numbers);
        simd::run_at(job.level, self.jitter.slide(numbers, stride, &mut self.sums));
        let measure = Measure {
            scale,
            band_px: if p.occlusion { scale.image_px } else { 0.0 },
            columns: &self.columns,
            disparities: &self.disparities,
            sums: &self.sums,
            out: &mut self.fixed,
        };
        simd::run_at(job.level, measure);
        if scale.invalid_edge > 0 {
            for row in self.fixed.chunks_exact_mut(stride) {
                row[..scale.invalid_edge.min(stride)].fill(0);
            }
        }
        self.record_measured(job);
    }

    /// Records the reason why pixels have lost their disparity since the last record.
    fn record(&mut self, reason: Reason) {
        for (code, d) in self.reasons.iter_mut().zip(&self.disparities) {
            *code = match (*d > 0.0, *code) {
                (true, _) => 0,
                (false, 0) => reason.code(),
                (false, known) => known,
            };
        }
    }

    /// Records the reasons why disparities were not measured.
    fn record_measured(&mut self, job: &Job<'_>) {
        let (scale, stride) = (&job.scale, self.stride);
        let pixels = self.columns.iter().zip(&self.disparities).zip(&self.fixed);
        for (place, (code, ((x, d), fixed))) in self.reasons.iter_mut().zip(pixels).enumerate() {
            let is_beyond = d * scale.image_px > *x && job.sensor.parameters().occlusion;
            let reason = match *code {
                _ if *fixed > 0 => Reason::Measured.code(),
                0 if is_beyond => Reason::OutsideOtherView.code(),
                0 if place % stride < scale.invalid_edge => Reason::Border.code(),
                0 if (d + scale.bias - scale.shift) * scale.steps > 1.0 => Reason::TooNear.code(),
                0 => Reason::TooFar.code(),
                known => known,
            };
            *code = reason;
        }
    }

    fn make_room(&mut self, rows: usize) {
        let pixels = rows * self.stride;
        // The last strip may be shorter.
        if self.columns.len() < pixels {
            self.columns.clear();
            for _ in 0..rows {
                self.columns.extend((0..self.stride).map(|x| x as f32));
            }
        }
        self.disparities.resize(pixels, 0.0);
        self.sums.resize(pixels, 0);
        self.fixed.resize(pixels, 0);
    }

    /// Finds the occluded pixels of the strip.
    fn hide(&mut self, nearer: f32, scale: &Scale, level: Level) {
        let rows = Rows {
            columns: &self.columns,
            disparities: &self.disparities,
            stride: self.stride,
            image_px: scale.image_px,
        };
        self.shadow.find(level, rows, nearer, &mut self.hidden);
    }

    fn drop_hidden(&mut self) {
        for pixel in self.hidden.drain(..) {
            if let Some(d) = self.disparities.get_mut(pixel) {
                *d = 0.0;
            }
        }
    }

    /// Adds a row to the window of the dilation.
    fn dilate(&mut self, job: &Job<'_>, y: Option<usize>) {
        let inside = y.filter(|&y| job.depth.row(y).is_some());
        self.dilated.resize(self.stride, 0.0);
        if let Some(y) = inside {
            to_disparities(job, y, self.stride, &mut self.dilated);
        }
        self.dilation
            .push(job.level, inside.map(|_| self.dilated.as_slice()));
    }

    /// Widens the near sides of edges, and drops the pixels that they occlude.
    fn widen(&mut self, job: &Job<'_>, first: usize) {
        let (p, scale, stride) = (job.sensor.parameters(), &job.scale, self.stride);
        self.widened.resize(self.disparities.len(), 0.0);
        for start in (0..self.disparities.len()).step_by(stride) {
            self.dilate(job, Some(first + start / stride + scale.dilation));
            let row = start..start + stride;
            self.dilation
                .widen(job.level, &self.disparities[row.clone()], &mut self.widened[row]);
            // The widening ends at the border.
            self.widened[start + job.width()..start + stride].fill(0.0);
        }
        let widened = std::mem::take(&mut self.widened);
        if p.occlusion {
            // Both cameras see what is widened over the shadow.
            self.hide(NEARER, scale, job.level);
            let narrow = &self.disparities;
            self.hidden
                .retain(|&pixel| narrow.get(pixel) == widened.get(pixel));
        }
        let occluded = self.hidden.len();
        self.widened = std::mem::replace(&mut self.disparities, widened);
        // Objects are as wide in the other direction of matching, where they replace what is beside the shadow.
        if p.occlusion && p.left_right_check {
            let threshold = p.left_right_check_threshold_px as f32 * scale.image_px;
            self.hide(threshold.max(NEARER), scale, job.level);
        }
        for (found, pixel) in self.hidden.iter().enumerate() {
            let is_known = |code: &u8| *code == Reason::Occluded.code();
            if let Some(code) = self.reasons.get_mut(*pixel).filter(|code| !is_known(code)) {
                let is_occluded = found < occluded;
                *code = if is_occluded {
                    Reason::Occluded
                } else {
                    Reason::LeftRightCheck
                }
                .code();
            }
        }
        self.drop_hidden();
    }

    /// Drops pixels with too little texture.
    fn drop_plain(&mut self, job: &Job<'_>, first: usize) {
        let Some(picture) = &job.picture else { return };
        let texture_scale = &job.scale.texture;
        let least = texture_scale.least(job.sensor.parameters().confidence_threshold);
        for (y, disparities) in (first..).zip(self.disparities.chunks_exact_mut(self.stride)) {
            self.texture.slide(
                job.level,
                picture,
                y + texture_scale.side - 1,
                texture_scale,
                &mut self.texture_sums,
            );
            texture::light(
                job.level,
                job.scale.light.as_ref(),
                picture,
                &job.depth,
                y,
                &mut self.texture_sums,
            );
            let textured = Textured {
                least,
                gain: GAIN,
                sums: &self.texture_sums,
                disparities,
            };
            simd::run_at(job.level, textured);
        }
    }

    fn drop_at_random(&mut self, job: &Job<'_>, first: usize) {
        let half = self.stride.next_multiple_of(DROPOUT);
        self.dropout.resize(2 * half, 0);
        for (y, disparities) in (first..).zip(self.disparities.chunks_exact_mut(self.stride)) {
            job.dropout.bytes(counter(y), &mut self.dropout);
            let dropout = Dropout {
                limit: job.scale.dropout,
                bytes: self.dropout.split_at(half),
                disparities,
            };
            simd::run_at(job.level, dropout);
        }
    }
}

/// Converts a row number or a window's area for the generator.
#[expect(clippy::cast_possible_truncation, reason = "images have less than 2³² rows")]
fn counter(row: usize) -> u32 {
    row as u32
}

/// Fills rows of disparities from `first`; the padding has no surface.
fn to_disparities(job: &Job<'_>, first: usize, stride: usize, out: &mut [f32]) {
    for (y, row) in (first..).zip(out.chunks_exact_mut(stride)) {
        let depth = job.depth.row(y).unwrap_or_default();
        let (inside, padding) = row.split_at_mut(depth.len().min(stride));
        inside.copy_from_slice(depth);
        padding.fill(0.0);
    }
    simd::run_at(
        job.level,
        Disparities {
            px_m: job.scale.px_m,
            depth: out,
        },
    );
}
