//! Sums of light over the time of a frame.

use oaktwin_base::diagnostic::{Finding, add_new};
use oaktwin_camera::{ImageSize, OpenCv, PixelPoint, RigidTransform};
use oaktwin_image::Image;
use oaktwin_render::{Backend, Renderer, View};

use super::motion::{Moments, motion_px};
use super::plan::{Timing, samples};
use super::smear::{Snapshot, Ways};
use crate::render::RigError;

/// Times that differ by less are the same, s.
const SAME_S: f64 = 1e-12;

/// The mean light of each pixel, and the findings of its samples.
pub(crate) type Exposed<const CHANNELS: usize> = (Image<[f32; CHANNELS]>, Vec<Finding>);

/// Linear light of colours, with coverage, and the findings of its samples.
pub(in crate::render) type Colours = Exposed<4>;

/// Returns the light of the colours of a frame, as [`Renderer::radiance`]; `None` if nothing moves.
pub(in crate::render) fn colours(
    moments: &mut dyn Moments,
    camera: usize,
    timing: Timing,
    backend: Backend,
    view: &dyn Fn(&RigidTransform) -> View,
) -> Result<Option<Colours>, RigError> {
    let render = |renderer: &Renderer, _: &RigidTransform, view: &View| renderer.radiance(view, backend);
    exposed(moments, camera, timing, view, [true; 4], render)
}

/// Returns the mean light of a camera's frame; `None` if nothing moves. `render` makes the light of a view, which has some rows of the
/// camera's, with the mount at a pose. Between samples, the channels in `moves` continue along the ways of the surfaces.
pub(crate) fn exposed<const CHANNELS: usize>(
    moments: &mut dyn Moments,
    camera: usize,
    timing: Timing,
    view: &dyn Fn(&RigidTransform) -> View,
    moves: [bool; CHANNELS],
    mut render: impl FnMut(&Renderer, &RigidTransform, &View) -> Exposed<CHANNELS>,
) -> Result<Option<Exposed<CHANNELS>>, RigError> {
    if timing.span_s() <= 0.0 {
        return Ok(None);
    }
    let motion_px = motion_px(moments, camera, timing, view)?;
    let size = view(&RigidTransform::IDENTITY).camera.intrinsics.size;
    let samples = samples(timing, size.height, motion_px);
    if samples.is_empty() {
        return Ok(None);
    }
    let width = size.width as usize;
    let mut sum = Image::filled(size.width, size.height, [0.0; CHANNELS]);
    let mut findings: Vec<Finding> = Vec::new();
    let snapshot = |moments: &mut dyn Moments, offset_s: f64| {
        let (renderer, mount) = moments.at(offset_s, camera)?;
        Ok::<_, RigError>(Snapshot::new(renderer, view(&mount)))
    };
    let mut last: Option<(f64, Snapshot)> = None;
    for sample in samples {
        let [from, to] = sample.cell;
        // Where exposures are long, a sample begins where the one before ended.
        let first = match last.take() {
            Some((end, snapshot)) if (from - end).abs() < SAME_S => snapshot,
            _ => snapshot(moments, from)?,
        };
        let ends = [first, snapshot(moments, to)?];
        let (renderer, mount) = moments.at(sample.offset_s, camera)?;
        let part = part_of(&view(&mount), sample.rendered.start, sample.rendered.end);
        let (mut light, found) = render(renderer, &mount, &part);
        let ways = (to > from).then(|| Ways::new(renderer, &part, Backend::Auto, ends.each_ref()));
        if let Some(ways) = ways.flatten() {
            ways.smear(&mut light, moves);
        }
        let [_, end] = ends;
        last = Some((to, end));
        add_new(&mut findings, found);
        for (row, weight) in sample.weights {
            let source = (row - sample.rendered.start) as usize * width;
            let target = row as usize * width;
            let pixels = sum.pixels_mut()[target..].iter_mut().take(width);
            for (sum, light) in pixels.zip(&light.pixels()[source..]) {
                for (sum, light) in sum.iter_mut().zip(light) {
                    *sum += light * weight;
                }
            }
        }
    }
    Ok(Some((sum, findings)))
}

/// Returns the view of some rows of a view.
fn part_of(view: &View, start: u32, end: u32) -> View {
    let mut part = *view;
    let size = ImageSize::new(view.camera.intrinsics.size.width, end - start);
    let corner = PixelPoint::<OpenCv>::new(0.0, f64::from(start));
    part.camera.intrinsics = view.camera.intrinsics.cropped(corner, size);
    part
}
