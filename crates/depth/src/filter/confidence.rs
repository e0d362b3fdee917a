use oaktwin_image::Image;
use oaktwin_simd::{self as simd, Kernel, Level, saturating_trunc};

/// `DepthAI`'s `ToFDepthConfidenceFilter`, bit-identical to its host implementation: drops pixels that are too dark for their
/// distance.
///
/// The confidence is 100·a/√(d/2) of amplitude a and depth d in millimetres, in single precision; where either is 0 it
/// is 6 553 500, so that pixels without amplitude are kept. The confidence image has its lowest 16 bits, and 65 535 where
/// either is 0. A threshold of 0 disables the filter; the confidence image is then the amplitude image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DepthConfidence {
    /// The minimum confidence; `DepthAI`'s default is 0.1.
    pub threshold: f32,
}

impl Default for DepthConfidence {
    fn default() -> Self {
        Self { threshold: 0.1 }
    }
}

impl DepthConfidence {
    /// Returns the confidence of a pixel, 65 535 at most; 0 where the amplitude or the depth is 0.
    #[must_use]
    pub fn of(amplitude: u16, depth_mm: u16) -> u16 {
        if amplitude == 0 || depth_mm == 0 {
            return 0;
        }
        let confidence = raw(f32::from(amplitude), f32::from(depth_mm)).min(f32::from(u16::MAX));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it fits")]
        let whole = saturating_trunc(confidence) as u16;
        whole
    }

    /// Drops the pixels of `depth` (millimetres) that are too dark, and returns the confidence image. Where images of different
    /// sizes do not overlap, nothing changes.
    #[must_use]
    pub fn run(&self, depth: &mut Image<u16>, amplitude: &Image<u16>) -> Image<u16> {
        let mut confidence = Image::filled(depth.width(), depth.height(), 0);
        self.run_rows(
            Level::detect(),
            amplitude.pixels(),
            depth.pixels_mut(),
            confidence.pixels_mut(),
        );
        confidence
    }

    /// Runs the filter on rows.
    pub(crate) fn run_rows(
        &self,
        level: Level,
        amplitude: &[u16],
        depth: &mut [u16],
        confidence: &mut [u16],
    ) {
        if self.threshold == 0.0 {
            for (out, &amplitude) in confidence.iter_mut().zip(amplitude) {
                *out = amplitude;
            }
            return;
        }
        simd::run_at(
            level,
            Rows {
                threshold: self.threshold,
                amplitude,
                depth,
                confidence,
            },
        );
    }
}

/// The confidence of a pixel without amplitude or depth.
const WITHOUT: f32 = 6_553_500.0;

#[inline(always)]
fn raw(amplitude: f32, depth: f32) -> f32 {
    100.0 * (amplitude / (depth / 2.0).sqrt())
}

struct Rows<'a> {
    threshold: f32,
    amplitude: &'a [u16],
    depth: &'a mut [u16],
    confidence: &'a mut [u16],
}

impl Kernel for Rows<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let pixels = self.depth.iter_mut().zip(self.confidence).zip(self.amplitude);
        for ((depth, out), &amplitude) in pixels {
            let (a, d) = (f32::from(amplitude), f32::from(*depth));
            let nothing = (amplitude == 0) | (*depth == 0);
            let confidence = raw(a, d);
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "the lowest bits, as in DepthAI"
            )]
            let low = saturating_trunc(confidence) as u16;
            *out = if nothing { u16::MAX } else { low };
            let confidence = if nothing { WITHOUT } else { confidence };
            *depth = if confidence < self.threshold { 0 } else { *depth };
        }
    }
}
