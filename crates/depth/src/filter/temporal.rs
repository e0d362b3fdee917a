use oaktwin_image::Image;
use oaktwin_simd::{Level, Weight};
use rayon::prelude::*;

use super::Pixel;
use super::simd;

/// `TemporalFilter`: smooths a pixel over the frames, and keeps a value that is gone for a while.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Temporal {
    /// `alpha`, 0 to 1: the weight of the newest frame; 1 smooths nothing.
    pub alpha: f32,
    /// `delta`: the step from which on a pixel begins anew. In pixel values; `DepthAI` keeps 8 bits of it.
    pub delta: u8,
    /// `persistencyMode`
    pub persistency_mode: PersistencyMode,
}

impl Default for Temporal {
    fn default() -> Self {
        Self {
            alpha: 0.4,
            delta: 3,
            persistency_mode: PersistencyMode::default(),
        }
    }
}

/// `PersistencyMode`: how often a pixel must have had a value lately for its last one to be kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub enum PersistencyMode {
    /// `PERSISTENCY_OFF`: nothing is kept.
    Off = 0,
    /// `VALID_8_OUT_OF_8`
    Valid8OutOf8 = 1,
    /// `VALID_2_IN_LAST_3`
    Valid2InLast3 = 2,
    /// `VALID_2_IN_LAST_4`
    #[default]
    Valid2InLast4 = 3,
    /// `VALID_2_OUT_OF_8`
    Valid2OutOf8 = 4,
    /// `VALID_1_IN_LAST_2`
    Valid1InLast2 = 5,
    /// `VALID_1_IN_LAST_5`
    Valid1InLast5 = 6,
    /// `VALID_1_IN_LAST_8`
    Valid1InLast8 = 7,
    /// `PERSISTENCY_INDEFINITELY`: it is kept until there is a new one.
    Indefinitely = 8,
}

impl PersistencyMode {
    /// All, by their numbers.
    pub const ALL: [Self; 9] = [
        Self::Off,
        Self::Valid8OutOf8,
        Self::Valid2InLast3,
        Self::Valid2InLast4,
        Self::Valid2OutOf8,
        Self::Valid1InLast2,
        Self::Valid1InLast5,
        Self::Valid1InLast8,
        Self::Indefinitely,
    ];

    /// `DepthAI`'s name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Off => "PERSISTENCY_OFF",
            Self::Valid8OutOf8 => "VALID_8_OUT_OF_8",
            Self::Valid2InLast3 => "VALID_2_IN_LAST_3",
            Self::Valid2InLast4 => "VALID_2_IN_LAST_4",
            Self::Valid2OutOf8 => "VALID_2_OUT_OF_8",
            Self::Valid1InLast2 => "VALID_1_IN_LAST_2",
            Self::Valid1InLast5 => "VALID_1_IN_LAST_5",
            Self::Valid1InLast8 => "VALID_1_IN_LAST_8",
            Self::Indefinitely => "PERSISTENCY_INDEFINITELY",
        }
    }

    /// Of how many last frames how many must have had a value.
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

/// Pixels that a thread takes at a time.
const PART: usize = 1 << 14;

/// What a temporal filter remembers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Memory<P> {
    width: u32,
    height: u32,
    /// The last value of each pixel.
    last: Vec<P>,
    /// In which of the last 8 frames it had one: bit n is that of frames 8·k + n.
    history: Vec<u8>,
    /// The number of the frame, modulo 8.
    phase: u32,
}

/// What the loop needs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Settings<P> {
    weight: Weight,
    delta: P,
    /// Of the frame.
    bit: u8,
    /// Of the frames that count.
    recent: u8,
    /// How many of them must have had a value.
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
        // Behind the phase's own bit, which is still that of eight frames ago, lies the frame before this one.
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
            simd::temporal(level, settings, pixels, last, history);
        });
        memory.phase = (memory.phase + 1) % 8;
    }
}

/// One frame.
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
        // Where there was none, what is kept is 0.
        *pixel = if is_kept { old } else { value };
        let begun = if is_mixed {
            past | settings.bit
        } else {
            settings.bit
        };
        *history = if is_new { begun } else { past & !settings.bit };
    }
}
