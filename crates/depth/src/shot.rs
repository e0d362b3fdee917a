use oaktwin_image::ImageView;
use oaktwin_image::annotation::Returns;

use crate::ShotError;

/// A ground-truth depth image and the images that belong to it, all of one size.
#[derive(Clone, Copy, Debug)]
pub struct DepthShot<'a> {
    depth: ImageView<'a, f32>,
    rgb: Option<ImageView<'a, [u8; 4]>>,
    positions: Option<ImageView<'a, [f32; 4]>>,
    radial_velocities: Option<[ImageView<'a, f32>; 2]>,
    returns: Option<&'a Returns>,
    /// The number in the sequence: noise is new in every frame.
    pub frame: u64,
    /// The number in a batch of images of one frame, for instance a simulator's environments: each has its own noise.
    pub item: u32,
    /// How many pixels of a row apart colours are independent; those between are interpolated. 1 in a full colour image.
    pub color_step: u32,
}

impl<'a> DepthShot<'a> {
    /// Creates a shot of a depth image in metres along the optical axis: frame 0, item 0.
    #[must_use]
    pub fn new(depth: ImageView<'a, f32>) -> Self {
        Self {
            depth,
            rgb: None,
            positions: None,
            radial_velocities: None,
            returns: None,
            frame: 0,
            item: 0,
            color_step: 1,
        }
    }

    /// Replaces the depth by one of the same size.
    pub(crate) fn with_depth<'b>(self, depth: ImageView<'b, f32>) -> DepthShot<'b>
    where
        'a: 'b,
    {
        debug_assert_eq!(
            (depth.width(), depth.height()),
            (self.depth.width(), self.depth.height())
        );
        DepthShot { depth, ..self }
    }

    /// Adds the colour image of the same camera, sRGB; alpha is ignored.
    ///
    /// # Errors
    /// Returns an error if its size differs from the depth image's.
    pub fn with_rgb(mut self, rgb: ImageView<'a, [u8; 4]>) -> Result<Self, ShotError> {
        self.check("colour image", rgb.width(), rgb.height())?;
        self.rgb = Some(rgb);
        Ok(self)
    }

    /// Adds the point that each pixel sees, in the frame in which outputs shall have it.
    ///
    /// # Errors
    /// Returns an error if its size differs from the depth image's.
    pub fn with_positions(mut self, positions: ImageView<'a, [f32; 4]>) -> Result<Self, ShotError> {
        self.check("image of positions", positions.width(), positions.height())?;
        self.positions = Some(positions);
        Ok(self)
    }

    /// Adds the radial velocity of the surface in each pixel, m/s, positive away from the camera.
    ///
    /// # Errors
    /// Returns an error if its size differs from the depth image's.
    pub fn with_radial_velocity(self, velocity: ImageView<'a, f32>) -> Result<Self, ShotError> {
        self.with_radial_velocities([velocity; 2])
    }

    /// Adds the mean radial velocity in each pixel since each of the two measurements of a time-of-flight camera, m/s: at the edges of what
    /// moves, they see different surfaces.
    ///
    /// # Errors
    /// Returns an error if a size differs from the depth image's.
    pub fn with_radial_velocities(mut self, velocities: [ImageView<'a, f32>; 2]) -> Result<Self, ShotError> {
        for velocity in velocities {
            self.check("image of velocities", velocity.width(), velocity.height())?;
        }
        self.radial_velocities = Some(velocities);
        Ok(self)
    }

    /// Replaces the depth by what a time-of-flight camera receives in each pixel, of two surfaces where there are two.
    ///
    /// # Errors
    /// Returns an error if the size of an image differs from the depth image's.
    pub fn with_returns(mut self, returns: &'a Returns) -> Result<Self, ShotError> {
        for image in returns.depths.iter().chain(&returns.strengths) {
            self.check("image of returns", image.width(), image.height())?;
        }
        let [first, _] = &returns.depths;
        self.depth = first.into();
        self.returns = Some(returns);
        Ok(self)
    }

    /// The depth in metres along the optical axis.
    #[must_use]
    pub fn depth(&self) -> ImageView<'a, f32> {
        self.depth
    }

    /// The colour image, sRGB.
    #[must_use]
    pub fn rgb(&self) -> Option<ImageView<'a, [u8; 4]>> {
        self.rgb
    }

    /// The point that each pixel sees.
    #[must_use]
    pub fn positions(&self) -> Option<ImageView<'a, [f32; 4]>> {
        self.positions
    }

    /// The radial velocity since each of two measurements in m/s, positive away from the camera.
    #[must_use]
    pub fn radial_velocities(&self) -> Option<[ImageView<'a, f32>; 2]> {
        self.radial_velocities
    }

    /// What a time-of-flight camera receives in each pixel.
    #[must_use]
    pub fn returns(&self) -> Option<&'a Returns> {
        self.returns
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
