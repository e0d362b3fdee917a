use oaktwin_scene::shape::{self, Axis};
use oaktwin_scene::{Mesh, MeshAttribute};

use super::super::reader::{Reader, Record};
use super::super::value::{boolean, number, text, vec3s};
use super::context::Context;
use super::primvar::primvar;
use oaktwin_scene::polygon::Interpolation;

/// A primitive shape with dimensions in its own frame; unauthored ones have the schema's fallbacks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PrimitiveShape {
    kind: Primitive,
    double_sided: Option<bool>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Primitive {
    Cube { size: f64 },
    Sphere { radius: f64 },
    Cylinder { radius: f64, height: f64, axis: Axis },
    Cone { radius: f64, height: f64, axis: Axis },
    Capsule { radius: f64, height: f64, axis: Axis },
    Plane { width: f64, length: f64, axis: Axis },
}

impl PrimitiveShape {
    /// Reads a shape, and a warning about unsupported attributes; `None` for other types.
    pub(super) fn read(reader: &Reader, prim: &Record) -> Option<(Self, Option<&'static str>)> {
        let measure = |name: &str, fallback: f64| {
            reader
                .value(prim, name)
                .and_then(|value| number(&value))
                .unwrap_or(fallback)
        };
        let axis = match reader.value(prim, "axis").and_then(text).as_deref() {
            Some("X") => Axis::X,
            Some("Y") => Axis::Y,
            _ => Axis::Z,
        };
        let mut warning = None;
        // The newer schemas have a radius for each end.
        let mut ends = |fallback: f64| {
            let (bottom, top) = (measure("radiusBottom", fallback), measure("radiusTop", fallback));
            if bottom.to_bits() != top.to_bits() {
                warning = Some("different radii are not supported; using the larger one");
            }
            bottom.max(top)
        };
        let kind = match prim.type_name.as_str() {
            "Cube" => Primitive::Cube {
                size: measure("size", 2.0),
            },
            "Sphere" => Primitive::Sphere {
                radius: measure("radius", 1.0),
            },
            "Cylinder" => Primitive::Cylinder {
                radius: measure("radius", 1.0),
                height: measure("height", 2.0),
                axis,
            },
            "Cylinder_1" => Primitive::Cylinder {
                radius: ends(1.0),
                height: measure("height", 2.0),
                axis,
            },
            "Cone" => Primitive::Cone {
                radius: measure("radius", 1.0),
                height: measure("height", 2.0),
                axis,
            },
            "Capsule" => Primitive::Capsule {
                radius: measure("radius", 0.5),
                height: measure("height", 1.0),
                axis,
            },
            "Capsule_1" => Primitive::Capsule {
                radius: ends(0.5),
                height: measure("height", 1.0),
                axis,
            },
            "Plane" => Primitive::Plane {
                width: measure("width", 2.0),
                length: measure("length", 2.0),
                axis,
            },
            _ => return None,
        };
        let shape = Self {
            kind,
            double_sided: reader
                .value(prim, "doubleSided")
                .and_then(|value| boolean(&value)),
        };
        Some((shape, warning))
    }

    /// Whether its dimensions are finite.
    pub(super) fn is_finite(&self) -> bool {
        match self.kind {
            Primitive::Cube { size } => size.is_finite(),
            Primitive::Sphere { radius } => radius.is_finite(),
            Primitive::Cylinder { radius, height, .. }
            | Primitive::Cone { radius, height, .. }
            | Primitive::Capsule { radius, height, .. } => radius.is_finite() && height.is_finite(),
            Primitive::Plane { width, length, .. } => width.is_finite() && length.is_finite(),
        }
    }

    /// Returns its triangle mesh.
    pub(super) fn mesh(&self) -> Mesh {
        let mut mesh = match self.kind {
            Primitive::Cube { size } => shape::cube(size),
            Primitive::Sphere { radius } => shape::sphere(radius),
            Primitive::Cylinder { radius, height, axis } => shape::cylinder(radius, height, axis),
            Primitive::Cone { radius, height, axis } => shape::cone(radius, height, axis),
            Primitive::Capsule { radius, height, axis } => shape::capsule(radius, height, axis),
            Primitive::Plane { width, length, axis } => shape::plane(width, length, axis),
        };
        if let Some(double_sided) = self.double_sided {
            mesh.double_sided = double_sided;
        }
        mesh
    }
}

/// Returns the colour of a shape if it has a single one; others would need authored vertices.
pub(super) fn color(reader: &Reader, prim: &Record, context: &Context) -> Option<MeshAttribute<[f32; 3]>> {
    let colors = primvar(reader, prim, context, "primvars:displayColor", vec3s)?;
    (colors.interpolation == Interpolation::Constant || colors.values.len() == 1).then_some(())?;
    colors.values.first().copied().map(MeshAttribute::Constant)
}
