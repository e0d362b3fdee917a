use super::BodyPart;

/// The inputs of a `UsdPreviewSurface`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyMaterial {
    /// The name, valid as a prim name.
    pub name: &'static str,
    /// `diffuseColor`, linear.
    pub diffuse: [f32; 3],
    /// `metallic`.
    pub metallic: f32,
    /// `roughness`.
    pub roughness: f32,
    /// `opacity`: 1 for all materials, so that renderers need not support translucency.
    pub opacity: f32,
    /// `ior`.
    pub ior: f32,
    /// `clearcoat`.
    pub clearcoat: f32,
}

pub(super) const ALUMINIUM: &str = "anodised_aluminium";
pub(super) const BLACK_ALUMINIUM: &str = "anodised_aluminium_black";
pub(super) const PLASTIC: &str = "black_plastic";
pub(super) const NICKEL: &str = "nickel";
pub(super) const GLASS: &str = "front_glass";
pub(super) const LENS: &str = "lens_glass";
pub(super) const INFRARED: &str = "infrared_window";
pub(super) const LED: &str = "led_dome";

const fn new(
    name: &'static str,
    diffuse: [f32; 3],
    metallic: f32,
    roughness: f32,
    clearcoat: f32,
) -> BodyMaterial {
    BodyMaterial {
        name,
        diffuse,
        metallic,
        roughness,
        opacity: 1.0,
        ior: 1.5,
        clearcoat,
    }
}

/// All materials, sorted by name.
const ALL: [BodyMaterial; 8] = [
    new(ALUMINIUM, [0.19, 0.2, 0.215], 0.75, 0.42, 0.0),
    new(BLACK_ALUMINIUM, [0.045, 0.047, 0.052], 0.6, 0.45, 0.0),
    new(PLASTIC, [0.016, 0.016, 0.017], 0.0, 0.6, 0.0),
    new(GLASS, [0.006, 0.006, 0.008], 0.0, 0.06, 1.0),
    new(INFRARED, [0.05, 0.006, 0.012], 0.0, 0.1, 1.0),
    new(LED, [0.62, 0.58, 0.42], 0.0, 0.2, 0.6),
    new(LENS, [0.012, 0.01, 0.045], 0.0, 0.03, 1.0),
    new(NICKEL, [0.55, 0.54, 0.51], 1.0, 0.3, 0.0),
];

/// Returns the materials that the parts use.
pub(super) fn used(parts: &[BodyPart]) -> Vec<BodyMaterial> {
    ALL.into_iter()
        .filter(|material| parts.iter().any(|part| part.material == material.name))
        .collect()
}
