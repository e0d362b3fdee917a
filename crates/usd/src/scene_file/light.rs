use oaktwin_scene::{Light, LightKind};

use super::material::Materials;
use crate::text::{PrimSpec, SpecValue};

/// Creates a light, without its name and transform. The pole of a dome is +y in its own frame, as by default in USD.
pub(super) fn prim(light: &Light, materials: &Materials<'_>) -> PrimSpec {
    let mut prim = PrimSpec::def(
        match light.kind {
            LightKind::Distant { .. } => "DistantLight",
            LightKind::Dome { .. } => "DomeLight",
            LightKind::Sphere { .. } => "SphereLight",
            LightKind::Rect { .. } => "RectLight",
            LightKind::Disk { .. } => "DiskLight",
        },
        "",
    );
    let mut set = |name: &str, number: f32| prim.set(format!("inputs:{name}"), SpecValue::Float(number));
    match light.kind {
        LightKind::Distant { angle } => set("angle", angle.to_degrees()),
        LightKind::Sphere { radius } | LightKind::Disk { radius } => set("radius", radius),
        LightKind::Rect { width, height } => {
            set("width", width);
            set("height", height);
        }
        LightKind::Dome { texture } => {
            if let Some(file) = texture.and_then(|texture| materials.image(texture)) {
                prim.set("inputs:texture:file", SpecValue::Asset(file.to_owned()));
            }
        }
    }
    let brightest = light.radiance.into_iter().fold(0.0, f32::max);
    let scale = if brightest > 0.0 { brightest } else { 1.0 };
    prim.set("inputs:intensity", SpecValue::Float(brightest));
    prim.set(
        "inputs:color",
        SpecValue::Color3f(light.radiance.map(|channel| channel / scale)),
    );
    if light.normalize {
        prim.set("inputs:normalize", SpecValue::Bool(true));
    }
    prim
}
