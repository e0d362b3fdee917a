use std::path::PathBuf;
use std::sync::Arc;

use numpy::{PyArray1, PyArrayMethods, PyUntypedArrayMethods};
use oaktwin::camera::math::DVec3;
use oaktwin::image::{Image, srgb};
use oaktwin::scene::{self, ColorSpace, Material, MeshAttribute, Texture, TextureSource, TextureUse};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::array::{check_copy, numbers};
use crate::array::{contiguous, is_like, triples, view};
use crate::error::{error, wrong};

/// The positional and keyword arguments of a pickle.
type Arguments<'py> = ((Bound<'py, PyAny>, Bound<'py, PyAny>), Bound<'py, PyDict>);

/// A triangle mesh with a material, for `Scene.from_meshes`.
///
/// vertices: (V, 3) numbers, metres in the mesh's own frame.
/// faces: (F, 3) integers: the vertices of each triangle, counter-clockwise seen from outside. Depth contains both sides.
/// color: the sRGB colour, (3,) for the whole mesh or (V, 3) for each vertex: uint8, or floats from 0 to 1. By default grey.
/// normals: (V, 3), for smooth shading; by default triangles are flat.
/// uvs: (V, 2) texture coordinates, (0, 0) at the lower left of the image.
/// texture: an image (H, W, 3 or 4) uint8 sRGB, or the path of one; requires uvs and is multiplied by the colour.
/// metallic, roughness: from 0 to 1.
/// emissive: the emitted light, linear, (3,) or one number.
///
/// Raises oaktwin.Error for invalid shapes, vertices that are not finite, and vertex indices that are out of range.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct Mesh {
    pub(crate) mesh: scene::Mesh,
    pub(crate) material: Option<Material>,
    pub(crate) texture: Option<Texture>,
    /// The keyword arguments, for pickles.
    options: Py<PyDict>,
}

impl Mesh {
    /// Creates a mesh without a material.
    pub(crate) fn plain(
        py: Python<'_>,
        vertices: &Bound<'_, PyAny>,
        faces: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        Ok(Self {
            mesh: triangles(vertices, faces)?,
            material: None,
            texture: None,
            options: PyDict::new(py).unbind(),
        })
    }
}

#[pymethods]
impl Mesh {
    #[new]
    #[pyo3(signature = (vertices, faces, *, color = None, normals = None, uvs = None, texture = None, metallic = 0.0,
        roughness = 0.5, emissive = None))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
    fn new(
        py: Python<'_>,
        vertices: &Bound<'_, PyAny>,
        faces: &Bound<'_, PyAny>,
        color: Option<&Bound<'_, PyAny>>,
        normals: Option<&Bound<'_, PyAny>>,
        uvs: Option<&Bound<'_, PyAny>>,
        texture: Option<&Bound<'_, PyAny>>,
        metallic: f32,
        roughness: f32,
        emissive: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let options = PyDict::new(py);
        let copy = py.import("copy")?.getattr("deepcopy")?;
        let arrays = [
            ("color", color),
            ("normals", normals),
            ("uvs", uvs),
            ("texture", texture),
            ("emissive", emissive),
        ];
        for (name, array) in arrays
            .into_iter()
            .filter_map(|(name, array)| Some((name, array?)))
        {
            check_copy(name, array, size_of::<f64>())?;
            options.set_item(name, copy.call1((array,))?)?;
        }
        options.set_item("metallic", metallic)?;
        options.set_item("roughness", roughness)?;
        for (name, share) in [("metallic", metallic), ("roughness", roughness)] {
            if !(0.0..=1.0).contains(&share) {
                return Err(wrong(
                    name,
                    format_args!("{share} is out of range"),
                    "pass a number from 0 to 1",
                ));
            }
        }
        let mut mesh = triangles(vertices, faces)?;
        let count = mesh.positions.len();
        let unit = |n: [f32; 3]| {
            DVec3::from(n.map(f64::from))
                .normalize_or_zero()
                .as_vec3()
                .to_array()
        };
        let normals_of = |object| rows::<3>("normals", object, count);
        mesh.normals = normals
            .map(normals_of)
            .transpose()?
            .map(|normals| MeshAttribute::Vertex(normals.into_iter().map(unit).collect()));
        mesh.uvs = uvs
            .map(|object| rows::<2>("uvs", object, count))
            .transpose()?
            .map(MeshAttribute::Vertex);
        let mut material = Material {
            metallic,
            roughness,
            ..Material::default()
        };
        if let Some(color) = color {
            match Color::read(color, count)? {
                Color::One(color) => material.base_color = Some(color),
                Color::Each(colors) => mesh.colors = Some(MeshAttribute::Vertex(colors)),
            }
        }
        if let Some(emissive) = emissive {
            material.emissive = emission(emissive)?;
        }
        let texture = texture.map(self::texture).transpose()?;
        if texture.is_some() {
            if mesh.uvs.is_none() {
                return Err(wrong(
                    "texture",
                    "requires texture coordinates",
                    "pass uvs as well",
                ));
            }
            material.base_color_texture = Some(TextureUse::new(0));
        }
        let is_plain = material == Material::default();
        Ok(Self {
            mesh,
            material: (!is_plain).then_some(material),
            texture,
            options: options.unbind(),
        })
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<Arguments<'py>> {
        let (positions, triangles) = (&self.mesh.positions, &self.mesh.triangles);
        let vertices = PyArray1::from_slice(py, positions.as_flattened());
        let faces = PyArray1::from_slice(py, triangles.as_flattened());
        let arrays = (
            vertices.reshape([positions.len(), 3])?.into_any(),
            faces.reshape([triangles.len(), 3])?.into_any(),
        );
        Ok((arrays, self.options.bind(py).copy()?))
    }

    fn __repr__(&self) -> String {
        let (vertices, triangles) = (self.mesh.positions.len(), self.mesh.triangles.len());
        format!("<oaktwin.Mesh {vertices} vertices, {triangles} triangles>")
    }
}

/// Reads the vertices and faces of a mesh.
fn triangles(vertices: &Bound<'_, PyAny>, faces: &Bound<'_, PyAny>) -> PyResult<scene::Mesh> {
    let positions = triples::<f32>("vertices", vertices, "float32")?;
    let faces = triples::<i64>("faces", faces, "int64")?;
    if positions.as_flattened().iter().any(|number| !number.is_finite()) {
        return Err(wrong(
            "vertices",
            "contains non-finite values",
            "remove those vertices",
        ));
    }
    let count = u32::try_from(positions.len())
        .map_err(|_| wrong("vertices", "too many vertices", "pass fewer than 2^32"))?;
    let corner = |index: i64| {
        u32::try_from(index)
            .ok()
            .filter(|index| *index < count)
            .ok_or_else(|| {
                let is = format!("{index} is out of range: there are {count} vertices");
                wrong("faces", is, "count vertices from 0")
            })
    };
    let triangle = |[a, b, c]: &[i64; 3]| Ok([corner(*a)?, corner(*b)?, corner(*c)?]);
    Ok(scene::Mesh {
        triangles: faces.iter().map(triangle).collect::<PyResult<_>>()?,
        positions,
        ..scene::Mesh::default()
    })
}

/// Reads (V, N) finite numbers, one row for each vertex.
#[expect(clippy::cast_possible_truncation, reason = "meshes store single precision")]
fn rows<const N: usize>(name: &str, object: &Bound<'_, PyAny>, vertices: usize) -> PyResult<Vec<[f32; N]>> {
    let (shape, array) = numbers(name, object)?;
    if shape != [vertices, N] {
        let is = format!("has shape {shape:?}");
        return Err(wrong(
            name,
            is,
            format_args!("pass one row per vertex, shape ({vertices}, {N})"),
        ));
    }
    let values = array.as_slice().map_err(error)?;
    if values.iter().any(|number| !number.is_finite()) {
        return Err(wrong(name, "contains non-finite values", "replace them"));
    }
    Ok(values
        .as_chunks::<N>()
        .0
        .iter()
        .map(|row| row.map(|x| x as f32))
        .collect())
}

/// Linear colours.
enum Color {
    One([f32; 3]),
    Each(Vec<[f32; 3]>),
}

impl Color {
    fn read(object: &Bound<'_, PyAny>, vertices: usize) -> PyResult<Self> {
        let array = object.py().import("numpy")?.call_method1("asarray", (object,))?;
        let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
        // A sequence such as (1, 0, 0) is ambiguous; only bytes have the range of bytes.
        let is_bytes = array.getattr("dtype")?.getattr("itemsize")?.extract::<usize>()? == 1 && kind == "u";
        let one = if is_bytes { 255.0 } else { 1.0 };
        let (shape, values) = numbers("color", &array)?;
        let values = values.as_slice().map_err(error)?;
        if values.iter().any(|value| !(0.0..=one).contains(value)) {
            let remedy = "pass uint8, or floats from 0 to 1";
            return Err(wrong("color", "contains values out of range", remedy));
        }
        #[expect(clippy::cast_possible_truncation, reason = "colours have single precision")]
        let linear = |row: &[f64; 3]| row.map(|value| srgb::linear((value / one) as f32));
        let (rows, _) = values.as_chunks::<3>();
        match (&shape[..], rows) {
            ([3], [row]) => Ok(Self::One(linear(row))),
            ([count, 3], rows) if *count == vertices => Ok(Self::Each(rows.iter().map(linear).collect())),
            _ => {
                let remedy = format!("pass one colour, shape (3,), or one per vertex, ({vertices}, 3)");
                Err(wrong("color", format_args!("has shape {shape:?}"), remedy))
            }
        }
    }
}

#[expect(clippy::cast_possible_truncation, reason = "colours have single precision")]
fn emission(object: &Bound<'_, PyAny>) -> PyResult<[f32; 3]> {
    let (shape, array) = numbers("emissive", object)?;
    let values = array.as_slice().map_err(error)?;
    let emissive = match *values {
        [grey] => [grey; 3],
        [r, g, b] => [r, g, b],
        _ => {
            return Err(wrong(
                "emissive",
                format_args!("has shape {shape:?}"),
                "pass one number, or three",
            ));
        }
    };
    if emissive.iter().all(|x| x.is_finite() && *x >= 0.0) {
        Ok(emissive.map(|x| x as f32))
    } else {
        Err(wrong(
            "emissive",
            "contains values out of range",
            "pass finite numbers, 0 or greater",
        ))
    }
}

/// Reads a texture: an array, or the path of an image file.
fn texture(object: &Bound<'_, PyAny>) -> PyResult<Texture> {
    let source = if let Ok(path) = object.extract::<PathBuf>() {
        if !path.is_file() {
            let is = format!("{} does not exist", path.display());
            return Err(wrong(
                "texture",
                is,
                "pass an image array, or the path of an image file",
            ));
        }
        TextureSource::File(std::path::absolute(&path).unwrap_or(path))
    } else {
        let array = view("texture", object)?;
        let shape = array.shape().to_vec();
        let (&[height, width, channels @ (3 | 4)], true) = (&shape[..], is_like::<u8>(&array)) else {
            let is = format!("has shape {shape:?} and dtype {}", array.dtype());
            return Err(wrong(
                "texture",
                is,
                "pass an image (H, W, 3 or 4) of uint8, sRGB",
            ));
        };
        let array = contiguous::<u8>("texture", &array)?;
        let values = array.as_slice().map_err(error)?;
        let pixels = if channels == 4 {
            values.as_chunks::<4>().0.to_vec()
        } else {
            values
                .as_chunks::<3>()
                .0
                .iter()
                .map(|&[r, g, b]| [r, g, b, 255])
                .collect()
        };
        let side = |length: usize| u32::try_from(length).unwrap_or(0);
        let image = Image::new(side(width), side(height), pixels)
            .filter(|image| !image.pixels().is_empty())
            .ok_or_else(|| {
                wrong(
                    "texture",
                    format_args!("has shape {shape:?}"),
                    "pass an image with pixels",
                )
            })?;
        TextureSource::Pixels(Arc::new(image))
    };
    Ok(Texture {
        source,
        color_space: ColorSpace::Srgb,
    })
}
