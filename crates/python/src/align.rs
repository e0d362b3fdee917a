use oaktwin::camera::ImageSize;
use oaktwin::depth::align::{Align, AlignMode};
use oaktwin::image::ImageView;
use pyo3::prelude::*;

use crate::camera::Camera;
use crate::choice::named;
use crate::error::{error, wrong};
use crate::images::{Depth, ImageShape, Out};
use crate::pose::one_pose;
use crate::threads;

/// Aligns depth images to another camera.
pub(crate) fn aligned<'py>(
    py: Python<'py>,
    align: &Align,
    depth: &Depth<'py>,
    shape: ImageShape,
    out: Option<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let target = align.target().intrinsics.size;
    let out_shape = shape.sized(ImageSize::new(target.width, target.height));
    let (result, mut out) = Out::of(py, out, out_shape, depth)?;
    let values = depth.slice()?;
    let mut room = out.slice()?;
    let (pixels, out_pixels) = (shape.pixels(), out_shape.pixels());
    for item in 0..shape.count() {
        py.check_signals()?;
        let one = values.part(item * pixels, pixels);
        threads::run(py, || {
            let metres = one.metres();
            let view = ImageView::new(shape.size.width, shape.size.height, &metres[..])
                .ok_or_else(|| wrong("depth", "is smaller than its shape", "pass complete arrays"))?;
            let seen = align.align(view).map_err(error)?;
            room.fill(item * out_pixels, out_pixels, |room| {
                room.copy_from_slice(seen.0.pixels());
                Ok::<(), PyErr>(())
            })
        })??;
    }
    Ok(result)
}

/// Aligns depth images to another camera; each target pixel gets the nearest sample that falls into it.
///
/// depth: (H, W) or (N, H, W) of the source camera's size, float32 metres or uint16 millimetres along its optical axis;
///     values that are not finite and above 0 are invalid.
/// source, target: the cameras.
/// target_from_source: (4, 4) transform in metres; by default computed from the cameras' poses on their device.
/// z: "geometric" (default): depth along the target's axis; "measured": the samples' own, as RVC2's alignment reports it.
/// fill: "footprint" (default): a sample fills all pixels that it covers; "nearest": only the one that contains its centre.
/// out: the output array, as for a call of DepthSensor.
///
/// Returns an array of depth's dtype, (H, W) or (N, H, W) of the target's size, 0 where invalid.
///
/// Raises oaktwin.Error if the size of depth is not the source's.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "keywords in Python")]
#[pyo3(signature = (depth, source, target, *, target_from_source = None, z = "geometric", fill = "footprint", out = None))]
pub(crate) fn align<'py>(
    py: Python<'py>,
    depth: &Bound<'py, PyAny>,
    source: &Camera,
    target: &Camera,
    target_from_source: Option<&Bound<'py, PyAny>>,
    z: &str,
    fill: &str,
    out: Option<Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let (depth, shape) = Depth::read("depth", depth)?;
    let target_from_source = match target_from_source {
        Some(pose) => one_pose("target_from_source", pose)?,
        None => target.body_from_camera.inverse() * source.body_from_camera,
    };
    let align = Align::new(
        source.camera,
        target.camera,
        target_from_source,
        AlignMode {
            fill: named("fill", fill)?,
            z: named("z", z)?,
        },
    );
    aligned(py, &align, &depth, shape, out)
}
