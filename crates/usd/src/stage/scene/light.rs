use oaktwin_camera::math::{DAffine3, DMat3};
use oaktwin_scene::{Light, LightKind, Texture, Up};
use openusd::sdf::Value;

use super::super::reader::{Reader, Record};
use super::super::value::{boolean, color, single, text};
use super::findings::Findings;
use super::material::Materials;

/// Reads a light; `None` for unsupported types.
#[expect(clippy::too_many_arguments, reason = "a dome light reads textures, too")]
pub(super) fn read(
    reader: &Reader,
    prim: &Record,
    path: &str,
    world_from_light: DAffine3,
    up: Up,
    materials: &mut Materials,
    textures: &mut Vec<Texture>,
    findings: &mut Findings,
) -> Option<Light> {
    let input = |name: &str| -> Option<Value> {
        // Before 2021, lights had the same attributes without the prefix.
        reader
            .value(prim, &format!("inputs:{name}"))
            .or_else(|| reader.value(prim, name))
    };
    let number = |name: &str, fallback: f32| input(name).and_then(|v| single(&v)).unwrap_or(fallback);
    let flag = |name: &str| input(name).and_then(|v| boolean(&v)).unwrap_or(false);
    let mut world_from_light = world_from_light;
    let kind = match prim.type_name.as_str() {
        "DistantLight" => LightKind::Distant {
            angle: number("angle", 0.53).to_radians(),
        },
        "SphereLight" => LightKind::Sphere {
            radius: number("radius", 0.5),
        },
        "RectLight" => LightKind::Rect {
            width: number("width", 1.0),
            height: number("height", 1.0),
        },
        "DiskLight" => LightKind::Disk {
            radius: number("radius", 0.5),
        },
        "CylinderLight" => {
            let (radius, length) = (number("radius", 0.5), number("length", 1.0));
            let message = "cylinder lights are not supported; using a sphere light of the same area";
            findings.warn("unsupported-prim", path, message, "");
            // 4 π r² = 2 π radius length
            LightKind::Sphere {
                radius: (0.5 * radius * length).max(0.0).sqrt(),
            }
        }
        "DomeLight" | "DomeLight_1" => {
            let pole = reader.value(prim, "poleAxis").and_then(text);
            let along_z = match pole.as_deref() {
                Some("Z") => true,
                Some("scene") | None => prim.type_name.as_str() == "DomeLight_1" && up == Up::Z,
                Some(_) => false,
            };
            if along_z {
                // The image's +y becomes +z.
                let turn = DMat3::from_rotation_x(std::f64::consts::FRAC_PI_2);
                world_from_light *= DAffine3::from_mat3(turn);
            }
            LightKind::Dome {
                texture: dome_texture(reader, prim, path, materials, textures, findings),
            }
        }
        _ => return None,
    };
    let intensity = match kind {
        LightKind::Distant { .. } => number("intensity", 50_000.0),
        _ => number("intensity", 1.0),
    };
    let strength = intensity * number("exposure", 0.0).exp2();
    let mut radiance = input("color").and_then(|v| color(&v)).unwrap_or([1.0; 3]);
    if flag("enableColorTemperature") {
        let tint = black_body(number("colorTemperature", 6500.0));
        radiance = std::array::from_fn(|i| radiance[i] * tint[i]);
    }
    Some(Light {
        path: path.to_owned(),
        kind,
        radiance: radiance.map(|channel| channel * strength),
        normalize: flag("normalize"),
        world_from_light,
    })
}

fn dome_texture(
    reader: &Reader,
    prim: &Record,
    path: &str,
    materials: &mut Materials,
    textures: &mut Vec<Texture>,
    findings: &mut Findings,
) -> Option<u32> {
    let name = ["inputs:texture:file", "texture:file"]
        .into_iter()
        .find(|name| prim.has(name))?;
    let value = reader.value(prim, name)?;
    if matches!(&value, Value::AssetPath(asset) if asset.is_empty()) {
        return None;
    }
    let attribute = prim.path.append_property(name).ok()?;
    materials
        .textures
        .add(reader, value, &attribute, None, path, textures, findings)
}

/// Returns the linear Rec. 709 colour of a black body, with luminance 1. Its chromaticity is Kim's cubic fit to the Planckian
/// locus (`https://en.wikipedia.org/wiki/Planckian_locus#Approximation`), which holds from 1667 K to 25 000 K.
fn black_body(kelvin: f32) -> [f32; 3] {
    let t = if kelvin.is_nan() {
        6500.0
    } else {
        f64::from(kelvin).clamp(1667.0, 25_000.0)
    };
    let k = 1000.0 / t;
    let x = if t <= 4000.0 {
        ((-0.266_123_9 * k - 0.234_358_9) * k + 0.877_695_6) * k + 0.179_910
    } else {
        ((-3.025_846_9 * k + 2.107_037_9) * k + 0.222_634_7) * k + 0.240_390
    };
    let y = if t <= 2222.0 {
        ((-1.106_381_4 * x - 1.348_110_2) * x + 2.185_558_32) * x - 0.202_196_83
    } else if t <= 4000.0 {
        ((-0.954_947_6 * x - 1.374_185_93) * x + 2.091_370_15) * x - 0.167_488_67
    } else {
        ((3.081_758 * x - 5.873_386_7) * x + 3.751_129_97) * x - 0.370_014_83
    };
    let (big_x, big_z) = (x / y, (1.0 - x - y) / y);
    let linear = [
        3.240_454_2 * big_x - 1.537_138_5 - 0.498_531_4 * big_z,
        -0.969_266 * big_x + 1.876_010_8 + 0.041_556 * big_z,
        0.055_643_4 * big_x - 0.204_025_9 + 1.057_225_2 * big_z,
    ];
    #[expect(clippy::cast_possible_truncation, reason = "colours have single precision")]
    linear.map(|channel| channel.max(0.0) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn black_body_colour_changes_from_red_to_blue() {
        let warm = black_body(2000.0);
        let white = black_body(6500.0);
        let cold = black_body(20_000.0);
        assert!(warm[0] > 2.0 * warm[1] && warm[2] < 0.2);
        assert!(
            white.iter().all(|channel| (channel - 1.0).abs() < 0.06),
            "{white:?}"
        );
        assert!(cold[2] > cold[0]);
        for color in [warm, white] {
            let luminance = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
            assert!((luminance - 1.0).abs() < 0.01);
        }
    }
}
