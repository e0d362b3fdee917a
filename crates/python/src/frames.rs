//! Ground-truth frames as NumPy arrays, single or stacked.

use std::collections::BTreeMap;

use numpy::{Element, PyArray1, PyArrayDyn, PyArrayMethods, PyUntypedArray};
use oaktwin::camera::ImageSize;
use oaktwin::image::annotation::{Annotation, AnnotationKind, Annotator, Boxes2d, Frame, Labels, PointCloud};
use oaktwin::image::{Image, RangeDepth, ZDepth};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::array::zeros;
use crate::error::error;

/// Collects the frames of one camera as arrays.
pub(crate) struct Frames<'py> {
    size: ImageSize,
    batch: Option<usize>,
    images: BTreeMap<&'static str, Bound<'py, PyAny>>,
    lists: BTreeMap<&'static str, Vec<Bound<'py, PyAny>>>,
    prim_paths: BTreeMap<u32, String>,
    labels: BTreeMap<u32, Labels>,
}

impl<'py> Frames<'py> {
    /// Creates the frames of a batch of poses, or of one pose.
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
    pub(crate) fn put(&mut self, py: Python<'py>, number: usize, mut frame: Frame) -> PyResult<()> {
        for annotator in Annotator::all() {
            let name = annotator.name();
            match frame.take(annotator) {
                None => {}
                Some(Annotation::ZDepth(ZDepth(image)) | Annotation::RangeDepth(RangeDepth(image))) => {
                    self.image(py, name, number, image.into_pixels(), &[])?;
                }
                Some(Annotation::Scalar(image)) => self.image(py, name, number, image.into_pixels(), &[])?,
                Some(Annotation::Levels(image)) => self.image(py, name, number, image.into_pixels(), &[])?,
                Some(Annotation::Color(image) | Annotation::PixelColors(image)) => {
                    self.image(py, name, number, flat(image), &[4])?;
                }
                Some(Annotation::Reasons(reasons)) => {
                    self.image(py, name, number, reasons.codes.into_pixels(), &[])?;
                }
                Some(Annotation::PixelPoints(image)) => self.image(py, name, number, flat(image), &[4])?,
                Some(Annotation::Normals(image)) => self.image(py, name, number, flat(image), &[3])?,
                Some(Annotation::InstanceIds(seen)) => {
                    self.image(py, name, number, seen.ids.into_pixels(), &[])?;
                    self.prim_paths.extend(seen.prim_paths);
                }
                Some(Annotation::SemanticIds(seen)) => {
                    self.image(py, name, number, seen.ids.into_pixels(), &[])?;
                    self.labels.extend(seen.labels);
                }
                Some(Annotation::Boxes(boxes)) => {
                    self.list(name, self::boxes(py, &boxes)?);
                    self.labels.extend(boxes.labels);
                }
                Some(Annotation::Points(PointCloud { points, .. })) => {
                    let count = points.len();
                    let points = PyArray1::from_vec(py, points.into_flattened()).reshape([count, 3])?;
                    self.list(name, points.into_any());
                }
            }
        }
        Ok(())
    }

    /// Returns the arrays of the requested annotators by name.
    pub(crate) fn finish(mut self, py: Python<'py>, request: &[Annotator]) -> PyResult<Bound<'py, PyDict>> {
        use AnnotationKind as Kind;
        let all = PyDict::new(py);
        for annotator in request {
            let name = annotator.name();
            if let Some(Kind::Boxes | Kind::Points) = annotator.kind() {
                let list = self.lists.get(name).cloned().unwrap_or_default();
                match (self.batch, list.first()) {
                    (None, Some(first)) => all.set_item(name, first)?,
                    _ => all.set_item(name, PyList::new(py, list)?)?,
                }
            } else {
                if self.batch == Some(0) {
                    self.put_empty(py, *annotator)?;
                }
                if let Some(image) = self.images.get(name) {
                    all.set_item(name, image)?;
                }
            }
        }
        let has = |kinds: &[Kind]| {
            request
                .iter()
                .filter_map(|one| one.kind())
                .any(|kind| kinds.contains(&kind))
        };
        if has(&[Kind::InstanceIds]) {
            all.set_item("instance_id_segmentation_prim_paths", self.prim_paths)?;
        }
        if has(&[Kind::SemanticIds, Kind::Boxes]) {
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
        name: &'static str,
        number: usize,
        pixels: Vec<T>,
        channels: &[usize],
    ) -> PyResult<()> {
        let dims = self.dims(channels);
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
            if let Some(slot) = values.get_mut(start..start + pixels.len()) {
                slot.copy_from_slice(&pixels);
            }
        }
        Ok(())
    }

    fn put_empty(&mut self, py: Python<'py>, annotator: Annotator) -> PyResult<()> {
        use AnnotationKind as Kind;
        let name = annotator.name();
        match annotator.kind() {
            Some(Kind::Levels) => self.image::<u16>(py, name, 0, Vec::new(), &[]),
            Some(Kind::Reasons) => self.image::<u8>(py, name, 0, Vec::new(), &[]),
            Some(Kind::Color | Kind::PixelColors) => self.image::<u8>(py, name, 0, Vec::new(), &[4]),
            Some(Kind::Normals) => self.image::<f32>(py, name, 0, Vec::new(), &[3]),
            Some(Kind::PixelPoints) => self.image::<f32>(py, name, 0, Vec::new(), &[4]),
            Some(Kind::InstanceIds | Kind::SemanticIds) => self.image::<u32>(py, name, 0, Vec::new(), &[]),
            _ => self.image::<f32>(py, name, 0, Vec::new(), &[]),
        }
    }

    fn list(&mut self, name: &'static str, array: Bound<'py, PyAny>) {
        self.lists.entry(name).or_default().push(array);
    }
}

fn flat<T, const C: usize>(image: Image<[T; C]>) -> Vec<T> {
    image.into_pixels().into_flattened()
}

/// Returns a structured array with Replicator's fields.
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
