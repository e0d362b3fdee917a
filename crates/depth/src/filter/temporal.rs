use oaktwin_base::parameter::{Numbered, choice, parameters};
use oaktwin_image::Image;
use oaktwin_simd::{Level, Weight};
use rayon::prelude::*;

use super::Pixel;
use super::kernels::kernels;

parameters! {
    /// `TemporalFilter`: smooths each pixel over the frames, and keeps a value that has disappeared for a while.
    pub struct Temporal("temporal filter", platform) {
        /// The weight of the newest frame; 1 disables smoothing.
        alpha: f32 = 0.4 => ("alpha".range(0.0..=1.0)),
        /// The step from which a pixel restarts, in pixel values. `DepthAI` keeps 8 bits of it.
        delta: u8 = 3 => ("delta".range(0.0..=255.0)),
        /// The number of recent frames in which a pixel must have been valid for its last value to be kept.
        persistency_mode: PersistencyMode = PersistencyMode::Valid2InLast4
            => ("persistency" as Numbered.alias("persistencyMode")),
    }
}

choice! {
    /// `PersistencyMode`: the number of recent frames in which a pixel must have been valid for its last value to be kept.
    PersistencyMode {
        /// No value is kept.
        Off = "PERSISTENCY_OFF",
        /// 8 of the last 8 frames.
        Valid8OutOf8 = "VALID_8_OUT_OF_8",
        /// 2 of the last 3 frames.
        Valid2InLast3 = "VALID_2_IN_LAST_3",
        /// 2 of the last 4 frames, `DepthAI`'s default.
        Valid2InLast4 = "VALID_2_IN_LAST_4",
        /// 2 of the last 8 frames.
        Valid2OutOf8 = "VALID_2_OUT_OF_8",
        /// 1 of the last 2 frames.
        Valid1InLast2 = "VALID_1_IN_LAST_2",
        /// 1 of the last 5 frames.
        Valid1InLast5 = "VALID_1_IN_LAST_5",
        /// 1 of the last 8 frames.
        Valid1InLast8 = "VALID_1_IN_LAST_8",
        /// A value is kept until there is a new one.
        Indefinitely = "PERSISTENCY_INDEFINITELY",
    }
}

impl PersistencyMode {
    /// The number of recent frames, and of those in which the pixel must have been valid.
    const fn rule(self) -> (u32, u32) {
        match self {
            Self::Off => (0, 1),
            Self::Valid8OutOf8 => (8, 8),
            Self::Valid2InLast3 => (3, 2),
            Self::Valid2InLast4 => (4, 2),
            Self::Valid2OutOf8 => (8, 2),
            Self::Valid1InLast2 => (2, 1),
            Self::Valid1InLast5 => (5, 1),
            Self::Valid1InLast8 => (8, 1),
            Self::Indefinitely => (0, 0),
        }
    }
}

/// The number of pixels in a unit of work.
const PART: usize = 1 << 14;

/// The memory of a temporal filter.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Memory<P> {
    width: u32,
    height: u32,
    /// The last value of each pixel.
    last: Vec<P>,
    /// The frames, of the last 8, in which the pixel was valid: bit n is frame 8·k + n.
    history: Vec<u8>,
    /// The number of the frame, modulo 8.
    phase: u32,
}

/// The settings of the loop.
#[derive(Clone, Copy, Debug)]
pub(super) struct Settings<P> {
    weight: Weight,
    delta: P,
    /// The bit of the current frame.
    bit: u8,
    /// The bits of the recent frames.
    recent: u8,
    /// The minimum number of recent frames in which the pixel was valid.
    wanted: u32,
}

impl Temporal {
    pub(super) fn run<P: Pixel>(&self, level: Level, image: &mut Image<P>, memory: &mut Memory<P>) {
        if (memory.width, memory.height) != (image.width(), image.height()) {
            *memory = Memory {
                width: image.width(),
                height: image.height(),
                last: vec![P::default(); image.pixels().len()],
                history: vec![0; image.pixels().len()],
                phase: 0,
            };
        }
        let (frames, wanted) = self.persistency_mode.rule();
        // The bit of the current phase still belongs to the frame eight frames ago; the bit below it is the previous
        // frame.
        let recent = u8::try_from(0xff00u32 >> frames & 0xff).unwrap_or_default();
        let settings = Settings {
            weight: Weight::new(self.alpha),
            delta: P::from(self.delta),
            bit: 1 << memory.phase,
            recent: recent.rotate_left(memory.phase),
            wanted,
        };
        let pixels = image.pixels_mut().par_chunks_mut(PART);
        let memories = memory
            .last
            .par_chunks_mut(PART)
            .zip(memory.history.par_chunks_mut(PART));
        pixels.zip(memories).for_each(|(pixels, (last, history))| {
            run_update(level, settings, pixels, last, history);
        });
        memory.phase = (memory.phase + 1) % 8;
    }
}

/// Filters one frame.
#[inline(always)]
pub(super) fn update<P: Pixel>(settings: Settings<P>, pixels: &mut [P], last: &mut [P], history: &mut [u8]) {
    let zero = P::default();
    for ((pixel, last), history) in pixels.iter_mut().zip(last).zip(history) {
        let (new, old, past) = (*pixel, *last, *history);
        let (is_new, was) = (new != zero, old != zero);
        let is_mixed = is_new & was & (new.distance(old) < settings.delta);
        let is_kept = !is_new & ((past & settings.recent).count_ones() >= settings.wanted);
        let mixed = P::cut(settings.weight.mix_truncated(new.into(), old.into()));
        let value = if is_mixed { mixed } else { new };
        *last = if is_new { value } else { old };
        // A missing value that is not kept stays 0.
        *pixel = if is_kept { old } else { value };
        let begun = if is_mixed {
            past | settings.bit
        } else {
            settings.bit
        };
        *history = if is_new { begun } else { past & !settings.bit };
    }
}

kernels! {
    /// [`update`]
    fn run_update<'a> = update => (settings: Settings<P>, pixels: &'a mut [P], last: &'a mut [P], history: &'a mut [u8]);
}
