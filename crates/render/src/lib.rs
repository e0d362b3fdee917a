//! Ground truth from a scene, on a CPU.
//!
//! A [`View`] is a camera with a pose and a clipping range. Two backends, which must agree, find the surface in each pixel: a
//! rasterizer for ideal pinholes and a ray caster for every lens.

mod annotate;
mod backend;
mod barycentric;
mod blocks;
mod cutout;
#[cfg(test)]
mod fixture;
mod infrared;
mod luminance;
mod radiance;
mod raster;
mod ray;
mod rays;
mod renderer;
mod shade;
mod spare;
mod texture_file;
mod through;
mod view;
mod visibility;
mod worlds;

pub use annotate::AnnotateOptions;
pub use backend::Backend;
pub use cutout::Transparent;
pub use luminance::Luminance;
pub use ray::Ray;
pub use renderer::Renderer;
pub use shade::{Beam, BeamPattern, WHITE};
pub use texture_file::texture_pixels;
pub use view::{Clip, View};
pub use visibility::{Hit, Visibility};
pub use worlds::Worlds;
