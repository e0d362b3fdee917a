//! Ground-truth frames as NumPy arrays, single or stacked.

use std::collections::BTreeMap;

use numpy::{Element, PyArray1, PyArrayDyn, PyArrayMethods, PyUntypedArray};
use oaktwin::camera::ImageSize;
use oaktwin::image::Image;
use oaktwin::image::annotation::{Annotator, Boxes2d, Frame, Labels, PointCloud};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::array::zeros;
use crate::error::error;

/// Collects the frames of one camera in arrays.
pub(crate) struct Frames<'py> {
    size: ImageSize,
    batch: Option<usize>,
    images: BTreeMap<&'static str, Bound<'py, PyAny>>,
    lists: BTreeMap<&'static str, Vec<Bound<'py, PyAny>>>,
    prim_paths: BTreeMap<u32, String>,
    labels: BTreeMap<u32, Labels>,
}

impl<'py> Frames<'py> {
    /// For one pose, or a batch of several.
    pub(crate) fn new(size: ImageSize, batch: Option<usize>) -> Self {
        Self {
            size,
            batch,
            images: BTreeMap::new(),
            lists: BTreeMap::new(),
            prim_paths: BTreeMap::new(),
            labels: BTreeMap::new(),
        }
    }

    /// Adds the frame of a pose.
    pub(crate) fn put(&mut self, py: Python<'py>, number: usize, frame: Frame) -> PyResult<()> {
        if let Some(z) = frame.distance_to_image_plane {
            self.image(
                py,
                Annotator::DistanceToImagePlane,
                number,
                z.0.into_pixels(),
                &[],
            )?;
        }
        if let Some(range) = frame.distance_to_camera {
            self.image(
                py,
                Annotator::DistanceToCamera,
                number,
                range.0.into_pixels(),
                &[],
            )?;
        }
        if let Some(rgb) = frame.rgb {
            self.image(py, Annotator::Rgb, number, flat(rgb), &[4])?;
        }
        if let Some(normals) = frame.normals {
            self.image(py, Annotator::Normals, number, flat(normals), &[3])?;
        }
        if let Some(seen) = frame.instance_id_segmentation {
            let ids = seen.ids.into_pixels();
            self.image(py, Annotator::InstanceIdSegmentation, number, ids, &[])?;
            self.prim_paths.extend(seen.prim_paths);
        }
        if let Some(seen) = frame.semantic_segmentation {
            self.image(
                py,
                Annotator::SemanticSegmentation,
                number,
                seen.ids.into_pixels(),
                &[],
            )?;
            self.labels.extend(seen.labels);
        }
        if let Some(boxes) = frame.bounding_box_2d_tight {
            self.list(Annotator::BoundingBox2dTight, self::boxes(py, &boxes)?);
            self.labels.extend(boxes.labels);
        }
        if let Some(boxes) = frame.bounding_box_2d_loose {
            self.list(Annotator::BoundingBox2dLoose, self::boxes(py, &boxes)?);
            self.labels.extend(boxes.labels);
        }
        if let Some(PointCloud { points, .. }) = frame.pointcloud {
            let count = points.len();
            let points = PyArray1::from_vec(py, points.into_flattened()).reshape([count, 3])?;
            self.list(Annotator::Pointcloud, points.into_any());
        }
        Ok(())
    }

    /// Returns all arrays by name.
    pub(crate) fn finish(mut self, py: Python<'py>, asked: &[Annotator]) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for annotator in asked {
            let name = annotator.name();
            let is_list = matches!(
                annotator,
                Annotator::BoundingBox2dTight | Annotator::BoundingBox2dLoose | Annotator::Pointcloud
            );
            if is_list {
                let list = self.lists.get(name).cloned().unwrap_or_default();
                match (self.batch, list.first()) {
                    (None, Some(first)) => all.set_item(name, first)?,
                    _ => all.set_item(name, PyList::new(py, list)?)?,
                }
            } else {
                if self.batch == Some(0) {
                    self.nothing(py, *annotator)?;
                }
                if let Some(image) = self.images.get(name) {
                    all.set_item(name, image)?;
                }
            }
        }
        if asked.contains(&Annotator::InstanceIdSegmentation) {
            all.set_item("instance_id_segmentation_prim_paths", self.prim_paths)?;
        }
        let labelled = [
            Annotator::SemanticSegmentation,
            Annotator::BoundingBox2dTight,
            Annotator::BoundingBox2dLoose,
        ];
        if labelled.iter().any(|one| asked.contains(one)) {
            all.set_item("semantic_segmentation_labels", self.labels)?;
        }
        Ok(all)
    }

    fn dims(&self, channels: &[usize]) -> Vec<usize> {
        let rows = [self.size.height as usize, self.size.width as usize];
        self.batch
            .into_iter()
            .chain(rows)
            .chain(channels.iter().copied())
            .collect()
    }

    fn image<T: Element + Copy>(
        &mut self,
        py: Python<'py>,
        annotator: Annotator,
        number: usize,
        pixels: Vec<T>,
        channels: &[usize],
    ) -> PyResult<()> {
        let dims = self.dims(channels);
        let name = annotator.name();
        if self.batch.is_none() {
            let image = PyArray1::from_vec(py, pixels).reshape(dims)?;
            self.images.insert(name, image.into_any());
            return Ok(());
        }
        if !self.images.contains_key(name) {
            self.images.insert(name, zeros::<T>(py, &dims)?.into_any());
        }
        if let Some(stack) = self.images.get(name) {
            let mut stack = stack.cast::<PyArrayDyn<T>>()?.try_readwrite().map_err(error)?;
            let values = stack.as_slice_mut().map_err(error)?;
            let start = number * pixels.len();
            if let Some(room) = values.get_mut(start..start + pixels.len()) {
                room.copy_from_slice(&pixels);
            }
        }
        Ok(())
    }

    fn nothing(&mut self, py: Python<'py>, annotator: Annotator) -> PyResult<()> {
        match annotator {
            Annotator::Rgb => self.image::<u8>(py, annotator, 0, Vec::new(), &[4]),
            Annotator::Normals => self.image::<f32>(py, annotator, 0, Vec::new(), &[3]),
            Annotator::InstanceIdSegmentation | Annotator::SemanticSegmentation => {
                self.image::<u32>(py, annotator, 0, Vec::new(), &[])
            }
            _ => self.image::<f32>(py, annotator, 0, Vec::new(), &[]),
        }
    }

    fn list(&mut self, annotator: Annotator, array: Bound<'py, PyAny>) {
        self.lists.entry(annotator.name()).or_default().push(array);
    }
}

fn flat<T, const C: usize>(image: Image<[T; C]>) -> Vec<T> {
    image.into_pixels().into_flattened()
}

/// A structured array with Replicator's fields.
fn boxes<'py>(py: Python<'py>, boxes: &Boxes2d) -> PyResult<Bound<'py, PyAny>> {
    let fields = [
        ("semanticId", "u4"),
        ("x_min", "i4"),
        ("y_min", "i4"),
        ("x_max", "i4"),
        ("y_max", "i4"),
        ("occlusionRatio", "f4"),
    ];
    let rows: Vec<_> = boxes
        .boxes
        .iter()
        .map(|b| {
            (
                b.semantic_id,
                b.x_min,
                b.y_min,
                b.x_max,
                b.y_max,
                b.occlusion_ratio,
            )
        })
        .collect();
    let array = py
        .import("numpy")?
        .call_method1("array", (rows, PyList::new(py, fields)?))?;
    Ok(array.cast_into::<PyUntypedArray>()?.into_any())
}
