//! Points to pixels and back, for arrays.

use numpy::{PyArray1, PyArray3, PyArrayDyn, PyArrayMethods};
use oaktwin::camera::math::{DMat3, DVec3};
use oaktwin::camera::{Camera, LensModel, OpenCv, PixelPoint, RigidTransform, undistort_rectify_map};
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::array::{numbers, zeros};
use crate::error::{error, wrong};
use crate::images::Depth;
use crate::pose::Of;
use crate::threads;

/// The number of points that a thread processes at once.
const CHUNK: usize = 4096;

/// Pixels (..., 2) and depths (...).
pub(crate) type Projected<'py> = (Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArrayDyn<f64>>);

pub(crate) fn project<'py>(
    py: Python<'py>,
    camera: &Camera,
    points: &Bound<'py, PyAny>,
    world_from_camera: Option<&Bound<'py, PyAny>>,
) -> PyResult<Projected<'py>> {
    let (shape, points) = numbers("points", points)?;
    let Some((3, rest)) = shape.split_last() else {
        let is = format!("has shape {shape:?}");
        return Err(wrong("points", is, "pass points of shape (..., 3), metres"));
    };
    let camera_from_points = match world_from_camera {
        Some(pose) => Of::Camera.one("world_from_camera", pose)?.inverse(),
        None => RigidTransform::IDENTITY,
    };
    let depth: Bound<'py, PyArrayDyn<f64>> = zeros(py, rest)?;
    let pixels: Bound<'py, PyArrayDyn<f64>> = zeros(py, &[rest, &[2]].concat())?;
    let mut writable = (
        pixels.try_readwrite().map_err(error)?,
        depth.try_readwrite().map_err(error)?,
    );
    let out = (
        writable.0.as_slice_mut().map_err(error)?.as_chunks_mut::<2>().0,
        writable.1.as_slice_mut().map_err(error)?,
    );
    let points = points.as_slice().map_err(error)?.as_chunks::<3>().0;
    let model = *camera;
    threads::run(py, || {
        (out.0.par_iter_mut(), out.1.par_iter_mut(), points)
            .into_par_iter()
            .with_min_len(CHUNK)
            .for_each(|(pixel, depth, point)| {
                let point = camera_from_points.apply(DVec3::from(*point));
                let found = model.project(point).filter(|_| point.is_finite());
                *pixel = found.map_or([f64::NAN; 2], |found| [found.x, found.y]);
                *depth = point.z;
            });
    })?;
    drop(writable);
    Ok((pixels, depth))
}

/// The ray of each pixel of the image; `None` outside the lens's field of view.
fn rays_of(camera: &Camera) -> Vec<Option<DVec3>> {
    let size = camera.intrinsics.size;
    let row = |y: u32| {
        (0..size.width).into_par_iter().with_min_len(CHUNK).map(move |x| {
            let pixel = PixelPoint::<OpenCv>::new(f64::from(x), f64::from(y));
            camera.unproject(pixel)
        })
    };
    (0..size.height).into_par_iter().flat_map(row).collect()
}

#[expect(clippy::cast_possible_truncation, reason = "images have single precision")]
fn single(vector: Option<DVec3>) -> [f32; 3] {
    vector.map_or([f32::NAN; 3], |vector| vector.to_array().map(|x| x as f32))
}

pub(crate) fn rays<'py>(py: Python<'py>, camera: &Camera) -> PyResult<Bound<'py, PyArrayDyn<f32>>> {
    let size = camera.intrinsics.size;
    let array: Bound<'py, PyArrayDyn<f32>> = zeros(py, &[size.height as usize, size.width as usize, 3])?;
    let mut writable = array.try_readwrite().map_err(error)?;
    let out = writable.as_slice_mut().map_err(error)?.as_chunks_mut::<3>().0;
    threads::run(py, || {
        for (out, ray) in out.iter_mut().zip(rays_of(camera)) {
            *out = single(ray);
        }
    })?;
    drop(writable);
    Ok(array)
}

pub(crate) fn unproject<'py>(
    py: Python<'py>,
    camera: &Camera,
    depth: &Bound<'py, PyAny>,
    world_from_camera: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyArrayDyn<f32>>> {
    let (depth, shape) = Depth::read("depth", depth)?;
    let size = camera.intrinsics.size;
    if shape.size != size {
        let is = format!("is {} px, but the camera has {size} px", shape.size);
        return Err(wrong(
            "depth",
            is,
            "use the camera of these images, see resized()",
        ));
    }
    let (poses, _) = match world_from_camera {
        Some(object) => Of::Camera.several("world_from_camera", object)?,
        None => (vec![RigidTransform::IDENTITY], false),
    };
    if poses.len() != 1 && poses.len() != shape.count() {
        let is = format!("has {} poses for {} images", poses.len(), shape.count());
        return Err(wrong(
            "world_from_camera",
            is,
            "pass one pose, or one for each image",
        ));
    }
    let array: Bound<'py, PyArrayDyn<f32>> = zeros(py, &[&shape.rows()[..], &[3]].concat())?;
    let mut writable = array.try_readwrite().map_err(error)?;
    let out = writable.as_slice_mut().map_err(error)?.as_chunks_mut::<3>().0;
    let depth = depth.slice()?;
    threads::run(py, || {
        // Rays of unit depth; those that never reach a plane in front of the camera have none.
        let mut rays = rays_of(camera);
        for ray in &mut rays {
            *ray = ray.filter(|ray| ray.z > 0.0).map(|ray| ray / ray.z);
        }
        let metres = depth.metres();
        let images = metres.chunks(shape.pixels()).zip(out.chunks_mut(shape.pixels()));
        for ((depth, out), pose) in images.zip(poses.iter().cycle()) {
            (out.par_iter_mut(), depth, &rays)
                .into_par_iter()
                .with_min_len(CHUNK)
                .for_each(|(out, &z, ray)| {
                    let point = ray.filter(|_| z.is_finite() && z > 0.0);
                    *out = single(point.map(|ray| pose.apply(ray * f64::from(z))));
                });
        }
    })?;
    drop(writable);
    Ok(array)
}

pub(crate) fn undistortion_maps<'py>(
    py: Python<'py>,
    camera: &Camera,
    target: Option<&Camera>,
) -> PyResult<Bound<'py, PyArray3<f32>>> {
    if let Some(target) = target.filter(|target| target.lens != LensModel::Pinhole) {
        let is = format!("has a lens with distortion, {}", target.lens.names().option);
        return Err(wrong("target", is, "pass a pinhole camera"));
    }
    let target = target.map_or(camera.intrinsics, |target| target.intrinsics);
    let model = *camera;
    let map = threads::run(py, || {
        undistort_rectify_map(&model, DMat3::IDENTITY, &target).collect::<Vec<_>>()
    })?;
    let shape = [target.size.height as usize, target.size.width as usize, 2];
    PyArray1::from_vec(py, map.into_flattened()).reshape(shape)
}
