//! Fixed-point disparities and their conversion to depth.

use oaktwin_base::parameter::{FieldText, Kind, Value, choice};
use oaktwin_camera::StereoGeometry;
use oaktwin_simd::{self as simd, Kernel};

/// The fractional bits of a disparity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Subpixel {
    /// Whole pixels.
    Off,
    /// Eighths.
    Bits3,
    /// Sixteenths.
    Bits4,
    /// Thirty-seconds.
    #[default]
    Bits5,
}

impl Subpixel {
    /// The number of fractional bits.
    #[must_use]
    pub const fn bits(self) -> u32 {
        match self {
            Self::Off => 0,
            Self::Bits3 => 3,
            Self::Bits4 => 4,
            Self::Bits5 => 5,
        }
    }

    /// The step, px.
    #[must_use]
    pub fn step_px(self) -> f64 {
        1.0 / f64::from(1u32 << self.bits())
    }
}

/// The fractional bits of a disparity as a number.
pub(crate) struct FractionalBits;

impl FieldText<Subpixel> for FractionalBits {
    const KIND: Kind = Kind::Text("0, 3, 4 or 5");

    fn set(field: &mut Subpixel, text: &str) -> Option<()> {
        let all = [Subpixel::Off, Subpixel::Bits3, Subpixel::Bits4, Subpixel::Bits5];
        *field = all.into_iter().find(|subpixel| Self::get(subpixel) == text)?;
        Some(())
    }

    fn get(field: &Subpixel) -> String {
        field.bits().to_string()
    }
}

/// Whether a disparity has fractional bits. Switching them on keeps their number, or takes the default.
pub(crate) struct SubpixelSwitch;

impl FieldText<Subpixel> for SubpixelSwitch {
    const KIND: Kind = Kind::Flag;

    fn set(field: &mut Subpixel, text: &str) -> Option<()> {
        *field = match (bool::parse(text)?, *field) {
            (false, _) => Subpixel::Off,
            (true, Subpixel::Off) => Subpixel::default(),
            (true, bits) => bits,
        };
        Some(())
    }

    fn get(field: &Subpixel) -> String {
        (field.bits() > 0).to_string()
    }
}

choice! {
    /// The rounding of depth to whole millimetres. The device's is not published.
    DepthRounding {
        /// Rounds to the nearest, and halves up.
        Nearest = "nearest",
        /// Rounds down.
        Truncate = "truncate",
    }
}

/// The geometry and the unit of a fixed-point disparity image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Fixed {
    /// The geometry in disparity pixels.
    pub(crate) stereo: StereoGeometry,
    pub(crate) subpixel: Subpixel,
    /// The disparity of the value 0, px; the value 0 itself is invalid.
    pub(crate) shift_px: u32,
    pub(crate) rounding: DepthRounding,
}

/// The number of disparity values.
const ALL: usize = 1 << 16;

/// The depth of each fixed-point disparity, in metres rounded to millimetres.
#[derive(Clone, PartialEq)]
pub(crate) struct DepthTable {
    /// [`ALL`] entries, so that no index is out of bounds.
    metres: Vec<f32>,
    last: u32,
}

impl DepthTable {
    /// Returns the table of disparities 0 to `last`, with `scale` units per step.
    pub(crate) fn new(fixed: &Fixed, scale: f64, last: u32) -> Self {
        let step = fixed.subpixel.step_px() / scale;
        let metres = (0..=last).map(|value| {
            if value == 0 {
                return 0.0;
            }
            let d = f64::from(value) * step + f64::from(fixed.shift_px);
            let exact = fixed.stereo.depth(d) * 1000.0;
            let millimetres = match fixed.rounding {
                DepthRounding::Nearest => (exact + 0.5).floor(),
                DepthRounding::Truncate => exact.floor(),
            };
            if millimetres > f64::from(u16::MAX) {
                return 0.0;
            }
            #[expect(clippy::cast_possible_truncation, reason = "metres are single precision")]
            let metres = (millimetres / 1000.0) as f32;
            metres
        });
        let mut metres: Vec<f32> = metres.collect();
        metres.resize(ALL, 0.0);
        Self { metres, last }
    }

    /// The largest disparity in the table.
    pub(crate) fn last(&self) -> u32 {
        self.last
    }

    /// Converts disparities, none above [`last`](Self::last), to depth.
    pub(crate) fn look_up(&self, fixed: &[u16], out: &mut [f32]) {
        let metres = self.metres.as_slice();
        simd::run(LookUp { metres, fixed, out });
    }
}

struct LookUp<'a> {
    metres: &'a [f32],
    fixed: &'a [u16],
    out: &'a mut [f32],
}

impl Kernel for LookUp<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Some(metres) = self.metres.first_chunk::<ALL>() else {
            return;
        };
        for (out, &fixed) in self.out.iter_mut().zip(self.fixed) {
            *out = metres[usize::from(fixed)];
        }
    }
}
