use oaktwin_image::ImageView;

use crate::ShotError;
use crate::stereo_matching::Pair;

/// What a sensor looks at: one ground-truth image, and what belongs to it. All images but a stereo pair have one size.
#[derive(Clone, Copy, Debug)]
pub struct Shot<'a> {
    depth: ImageView<'a, f32>,
    rgb: Option<ImageView<'a, [u8; 4]>>,
    positions: Option<ImageView<'a, [f32; 4]>>,
    radial_velocity: Option<ImageView<'a, f32>>,
    pair: Option<Pair<'a>>,
    /// Its number in the sequence: noise is new in every frame.
    pub frame: u64,
    /// Its number in a batch of images of one frame, which have noise of their own: the environments of a simulator.
    pub item: u32,
}

impl<'a> Shot<'a> {
    /// Of a depth image, metres along the optical axis: frame 0, item 0.
    #[must_use]
    pub fn new(depth: ImageView<'a, f32>) -> Self {
        Self {
            depth,
            rgb: None,
            positions: None,
            radial_velocity: None,
            pair: None,
            frame: 0,
            item: 0,
        }
    }

    /// With the picture that the same camera took, sRGB; alpha is not looked at.
    ///
    /// # Errors
    /// It has another size.
    pub fn with_rgb(mut self, rgb: ImageView<'a, [u8; 4]>) -> Result<Self, ShotError> {
        self.check("colour image", rgb.width(), rgb.height())?;
        self.rgb = Some(rgb);
        Ok(self)
    }

    /// With the point that each pixel sees, in the camera's frame as whoever asks wants it back.
    ///
    /// # Errors
    /// It has another size.
    pub fn with_positions(mut self, positions: ImageView<'a, [f32; 4]>) -> Result<Self, ShotError> {
        self.check("image of positions", positions.width(), positions.height())?;
        self.positions = Some(positions);
        Ok(self)
    }

    /// With how fast what each pixel sees moves away along its ray, m/s.
    ///
    /// # Errors
    /// It has another size.
    pub fn with_radial_velocity(mut self, velocity: ImageView<'a, f32>) -> Result<Self, ShotError> {
        self.check("image of velocities", velocity.width(), velocity.height())?;
        self.radial_velocity = Some(velocity);
        Ok(self)
    }

    /// With the rectified pair that a stereo camera took. It may have a size of its own, which the measured depth then has.
    #[must_use]
    pub fn with_pair(mut self, pair: Pair<'a>) -> Self {
        self.pair = Some(pair);
        self
    }

    /// Metres along the optical axis.
    #[must_use]
    pub fn depth(&self) -> ImageView<'a, f32> {
        self.depth
    }

    /// sRGB.
    #[must_use]
    pub fn rgb(&self) -> Option<ImageView<'a, [u8; 4]>> {
        self.rgb
    }

    /// The point that each pixel sees.
    #[must_use]
    pub fn positions(&self) -> Option<ImageView<'a, [f32; 4]>> {
        self.positions
    }

    /// m/s away along each ray.
    #[must_use]
    pub fn radial_velocity(&self) -> Option<ImageView<'a, f32>> {
        self.radial_velocity
    }

    /// The rectified pair.
    #[must_use]
    pub fn pair(&self) -> Option<Pair<'a>> {
        self.pair
    }

    fn check(&self, what: &'static str, width: u32, height: u32) -> Result<(), ShotError> {
        let (depth_width, depth_height) = (self.depth.width(), self.depth.height());
        if (width, height) == (depth_width, depth_height) {
            return Ok(());
        }
        Err(ShotError {
            what,
            width,
            height,
            depth_width,
            depth_height,
        })
    }
}
