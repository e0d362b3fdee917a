//! Counter-based random numbers: a function of only (seed, camera, stage, frame, item, pixel).
//!
//! The generator is Philox4x32-10 (Salmon, Moraes, Dror, Shaw: *Parallel random numbers: as easy as 1, 2, 3*, SC 2011).
//! Its key is made of the seed, the camera's name and the stage; its counter is (block of the row, row, frame, item).
//! Uniform and normal numbers come from its words by exactly rounded operations only: the same bits on every machine.

mod normal;
mod numbers;
mod philox;
mod row;

pub(crate) use normal::box_muller;
pub use normal::standard_normal;
pub use numbers::Numbers;
pub use philox::philox4x32_10;

/// The use of a random number; no two uses share numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum NoiseStage {
    /// The calibration bias of a device.
    DeviceBias = 0,
    /// The jitter of disparity.
    Jitter = 1,
    /// Dropped pixels.
    Dropout = 2,
    /// Errors of an image sensor.
    Exposure = 3,
    /// The grain of a rendered image.
    Grain = 4,
    /// The samples of a time-of-flight sensor.
    Correlation = 5,
    /// The constant errors of a time-of-flight sensor's pixels.
    FixedPattern = 6,
    /// The errors of an inertial sensor.
    Inertial = 7,
    /// The quantities of a data set's recipe.
    Recipe = 8,
    /// The units of a population.
    Population = 9,
    /// The seeds that engines outside this crate are called with.
    Engine = 10,
    /// The delays and losses of frames on their way to a host.
    Delivery = 11,
    /// Errors of a colour camera's image sensor.
    Color = 12,
    /// The positions of a projector's dots.
    Dots = 16,
}

/// The random numbers of one camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stream {
    key: u64,
}

impl Stream {
    /// Creates the random numbers of a camera from a seed and its name.
    #[must_use]
    pub fn new(seed: u64, camera: &str) -> Self {
        // FNV-1a of the name's bytes, then SplitMix64's finalizer over both.
        let name = camera.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
        });
        Self {
            key: mix(mix(seed) ^ name),
        }
    }

    /// Returns the random numbers of an episode, in which frames count from 0 again. Episode 0 has this stream's own.
    #[must_use]
    pub const fn episode(&self, number: u64) -> Self {
        if number == 0 {
            return *self;
        }
        Self {
            key: mix(self.key ^ mix(!number)),
        }
    }

    /// Returns the random numbers of one stage of one image. Frame numbers are taken modulo 2³².
    #[must_use]
    #[expect(
        clippy::cast_possible_truncation,
        reason = "frame numbers and keys are cut to words"
    )]
    pub fn plane(&self, stage: NoiseStage, frame: u64, item: u32) -> RandomPlane {
        let key = mix(self.key ^ mix(stage as u64 + 1));
        RandomPlane {
            key: [key as u32, (key >> 32) as u32],
            frame: frame as u32,
            item,
        }
    }
}

/// The random numbers of one stage of one image: four words per block of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RandomPlane {
    key: [u32; 2],
    frame: u32,
    item: u32,
}

impl RandomPlane {
    /// Returns four independent words.
    #[must_use]
    pub fn words(&self, block: u32, row: u32) -> [u32; 4] {
        philox4x32_10([block, row, self.frame, self.item], self.key)
    }
}

/// `SplitMix64`'s finalizer (Steele, Lea, Flood 2014).
const fn mix(value: u64) -> u64 {
    let value = value.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let value = (value ^ (value >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let value = (value ^ (value >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    value ^ (value >> 31)
}
