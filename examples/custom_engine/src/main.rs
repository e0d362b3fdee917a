//! An engine of one's own in the depth sensor of an OAK: a block matcher, with its own parameters, that oaktwin does not know.
//!
//! ```sh
//! cargo run --release -- ../depth_sensor/depth_sensor.usda
//! ```

use std::borrow::Cow;
use std::sync::Arc;

use oaktwin::depth::stereo_matching::RectifiedPair;
use oaktwin::parameter::{Platform, parameters};
use oaktwin::prelude::*;

parameters! {
    /// The parameters of the block matcher.
    pub struct Parameters("block-matching", platform) {
        /// Half the side of a block, without the pixel at its centre.
        radius_px: u32 = 3 => ("radius".unit("px").range(1.0..=16.0).estimate()),
        /// The largest disparity.
        max_px: u32 = 95 => ("maxDisparity".unit("px").range(1.0..=512.0).estimate()),
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct BlockMatching {
    parameters: Parameters,
    /// The geometry at this width of the images.
    stereo: StereoGeometry,
    width_px: u32,
}

pub static BLOCK_MATCHING: EngineKind = EngineKind {
    name: Cow::Borrowed("block-matching"),
    help: Cow::Borrowed("The least sum of absolute differences of square blocks"),
    input: EngineInput::Pair,
    models: Some(Technology::Stereo),
    is_default: false,
    parameters: Parameters::names,
    factory: Factory::Function(|setup| {
        let mut parameters = Parameters::defaults(Platform::Rvc2);
        for (name, value) in &setup.parameters {
            parameters.set(name, value)?;
        }
        let (stereo, width_px) = (setup.stereo(), setup.width_px);
        Ok(Arc::new(BlockMatching {
            parameters,
            stereo,
            width_px,
        }))
    }),
};

impl Engine for BlockMatching {
    fn kind(&self) -> &EngineKind {
        &BLOCK_MATCHING
    }

    fn capture(
        &self,
        input: &Input<'_>,
        _random: &Stream,
        _request: &[Annotator],
        filters: &mut Chain,
    ) -> Result<Capture, ParameterError> {
        let pair = input.pair(&BLOCK_MATCHING)?;
        let scale = f64::from(pair.width()) / f64::from(self.width_px);
        let focal_length_px = self.stereo.focal_length_px * scale;
        let stereo = StereoGeometry {
            focal_length_px,
            ..self.stereo
        };
        let disparity = self.disparity(pair);
        Ok(Capture::of_disparity(
            &disparity,
            stereo,
            self.parameters.max_px,
            input,
            filters,
        ))
    }
}

impl BlockMatching {
    /// The disparity of each pixel of the left image, 0 where its blocks leave an image.
    fn disparity(&self, pair: &RectifiedPair<'_>) -> Image<f32> {
        let (width, height) = (pair.width() as usize, pair.height() as usize);
        let (left, right) = (pair.left().levels(), pair.right().levels());
        let radius = self.parameters.radius_px as usize;
        let mut best = vec![(u32::MAX, 0.0); width * height];
        let largest = (self.parameters.max_px as usize).min(width.saturating_sub(2 * radius + 1));
        for d in 1..=largest {
            // Sums over the columns of a block, which move down one row at a time.
            let mut columns = vec![0u32; width];
            for y in 0..height {
                for x in d..width {
                    let cost = |y: usize| left[y * width + x].abs_diff(right[y * width + x - d]).into();
                    let above = if y > 2 * radius {
                        cost(y - 2 * radius - 1)
                    } else {
                        0
                    };
                    columns[x] = columns[x] + cost(y) - above;
                }
                for x in (d + radius..width - radius).filter(|_| y >= 2 * radius) {
                    let cost = columns[x - radius..=x + radius].iter().sum();
                    let pixel = &mut best[(y - radius) * width + x];
                    *pixel = if cost < pixel.0 { (cost, d as f32) } else { *pixel };
                }
            }
        }
        let disparities = best.into_iter().map(|(_, disparity)| disparity).collect();
        Image::new(pair.width(), pair.height(), disparities).expect("as many pixels as the left image has")
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = std::env::args().nth(1).ok_or("usage: custom_engine SCENE")?;
    let scene = SceneFile::open(scene.as_ref(), &OpenOptions::default())?;
    let spec = RigSpec {
        size: Some(ImageSize::new(640, 400)),
        annotators: vec![Annotator::DepthSensorDistance],
        sensor: SensorOptions {
            engine: Some((&BLOCK_MATCHING).into()),
            ..SensorOptions::default()
        },
        ..RigSpec::default()
    };
    let (mut rig, _) = Rig::new(&Catalog::builtin().twin("OAK-D Pro PoE")?, &spec)?;
    let eye = DVec3::new(3.0, 0.0, 0.6);
    let world_from_body = look_at(eye, eye - DVec3::X, DVec3::Z)?;
    let (shots, _) = rig.shoot(&Renderer::new(scene.scene), Some(&world_from_body), 0)?;
    let measured = shots[0]
        .frame
        .depth_sensor_distance
        .as_ref()
        .ok_or("nothing was measured")?;
    let count = measured.0.pixels().iter().filter(|z| **z > 0.0).count();
    println!("{count} of {} pixels have a depth", measured.0.pixels().len());
    Ok(())
}
