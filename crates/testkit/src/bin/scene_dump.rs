//! Dumps a USD stage or a mesh file as imported by oaktwin, for oracles in other languages: `scene-dump FILE FOLDER [--time CODE]
//! [--subdivide LEVELS]` writes `FOLDER/scene.json` and `FOLDER/arrays.bin`, little-endian numbers that the JSON
//! refers to as `{"dtype", "shape", "offset"}`.

use std::fs;
use std::path::Path;

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DAffine3;
use oaktwin_scene::import::{self, ImportOptions, ImportedScene};
use oaktwin_scene::{
    Instance, Light, LightKind, Material, Mesh, MeshAttribute, Scene, Texture, TextureMask, TextureSource,
    TextureUse,
};
use oaktwin_usd::stage::{SceneOptions, StageScene, open_scene};
use serde_json::{Value, json};

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let mut arguments = std::env::args().skip(1);
    let usage = "scene-dump FILE FOLDER [--time CODE] [--subdivide LEVELS]";
    let (stage, folder) = (arguments.next().ok_or(usage)?, arguments.next().ok_or(usage)?);
    let mut options = SceneOptions::default();
    while let Some(flag) = arguments.next() {
        let value = arguments.next().ok_or(usage)?;
        match flag.as_str() {
            "--time" => options.time = Some(value.parse()?),
            "--subdivide" => options.subdivide = value.parse()?,
            _ => return Err(usage.into()),
        }
    }
    let mut arrays = Arrays::default();
    let described = if import::is_importable(stage.as_ref()) {
        describe_file(
            &import::open(stage.as_ref(), &ImportOptions::default())?,
            &mut arrays,
        )
    } else {
        describe_stage(&open_scene(&stage, &options)?, &mut arrays)
    };
    let folder = Path::new(&folder);
    fs::create_dir_all(folder)?;
    fs::write(folder.join("arrays.bin"), arrays.0)?;
    fs::write(folder.join("scene.json"), serde_json::to_vec(&described)?)?;
    Ok(())
}

/// The concatenated bytes of many arrays.
#[derive(Default)]
struct Arrays(Vec<u8>);

impl Arrays {
    fn floats(&mut self, values: impl IntoIterator<Item = f32>, width: usize) -> Value {
        self.push("<f4", values.into_iter().map(f32::to_le_bytes), width)
    }

    fn ints(&mut self, values: impl IntoIterator<Item = i32>, width: usize) -> Value {
        self.push("<i4", values.into_iter().map(i32::to_le_bytes), width)
    }

    fn push(&mut self, dtype: &str, values: impl Iterator<Item = [u8; 4]>, width: usize) -> Value {
        let offset = self.0.len();
        self.0.extend(values.flatten());
        let rows = (self.0.len() - offset) / (4 * width);
        json!({ "dtype": dtype, "shape": [rows, width], "offset": offset })
    }
}

fn describe_stage(read: &StageScene, arrays: &mut Arrays) -> Value {
    let mut described = describe(&read.scene, arrays);
    described["cameras"] = read
        .cameras
        .iter()
        .map(|camera| {
            json!({
                "path": camera.prim.path,
                "world_from_camera": rows(&affine(&camera.world_from_camera)),
            })
        })
        .collect();
    described["products"] = read
        .products
        .iter()
        .map(|product| {
            json!({
                "path": product.prim.path,
                "cameras": product.cameras.iter().map(|target| &target.path).collect::<Vec<_>>(),
            })
        })
        .collect();
    described["findings"] = read.findings.iter().map(ToString::to_string).collect();
    described
}

fn describe_file(read: &ImportedScene, arrays: &mut Arrays) -> Value {
    let mut described = describe(&read.scene, arrays);
    described["cameras"] = read
        .cameras
        .iter()
        .map(|camera| {
            json!({
                "path": camera.path,
                "world_from_camera": rows(&affine(&camera.world_from_camera)),
                "vfov": camera.vfov,
                "aspect": camera.aspect,
            })
        })
        .collect();
    described["findings"] = read.findings.iter().map(ToString::to_string).collect();
    described
}

fn describe(scene: &Scene, arrays: &mut Arrays) -> Value {
    json!({
        "up": scene.up.direction().to_array(),
        "meters_per_unit": scene.meters_per_unit.0,
        "meshes": scene.meshes.iter().map(|of| mesh(of, arrays)).collect::<Vec<_>>(),
        "instances": scene.instances.iter().map(instance).collect::<Vec<_>>(),
        "materials": scene.materials.iter().map(material).collect::<Vec<_>>(),
        "textures": scene.textures.iter().map(texture).collect::<Vec<_>>(),
        "lights": scene.lights.iter().map(light).collect::<Vec<_>>(),
    })
}

/// Surface values at the three corners of each triangle, or null.
fn mesh(mesh: &Mesh, arrays: &mut Arrays) -> Value {
    let materials = (0..mesh.triangles.len()).map(|triangle| {
        let material = u32::try_from(triangle)
            .ok()
            .and_then(|triangle| mesh.material(triangle));
        material
            .and_then(|material| i32::try_from(material).ok())
            .unwrap_or(-1)
    });
    json!({
        "positions": arrays.floats(mesh.positions.iter().copied().flatten(), 3),
        "triangles": arrays.ints(mesh.triangles.iter().flatten().map(|index| index.cast_signed()), 3),
        "uvs": corners(mesh, mesh.uvs.as_ref()).map(|uvs| arrays.floats(uvs, 6)),
        "normals": corners(mesh, mesh.normals.as_ref()).map(|normals| arrays.floats(normals, 9)),
        "colors": corners(mesh, mesh.colors.as_ref()).map(|colors| arrays.floats(colors, 9)),
        "materials": arrays.ints(materials, 1),
        "double_sided": mesh.double_sided,
    })
}

fn corners<const N: usize>(mesh: &Mesh, values: Option<&MeshAttribute<[f32; N]>>) -> Option<Vec<f32>> {
    let values = values?;
    let mut flat = Vec::with_capacity(mesh.triangles.len() * 3 * N);
    for (triangle, vertices) in mesh.triangles.iter().enumerate() {
        let corners = values.corners(triangle, *vertices)?;
        flat.extend(corners.into_iter().flatten());
    }
    Some(flat)
}

fn instance(instance: &Instance) -> Value {
    json!({
        "mesh": instance.mesh,
        "path": instance.path,
        "world_from_mesh": rows(&instance.world_from_mesh),
        "labels": instance
            .labels
            .iter()
            .map(|label| [&label.prim, &label.taxonomy, &label.name])
            .collect::<Vec<_>>(),
    })
}

fn material(material: &Material) -> Value {
    json!({
        "name": material.name,
        "base_color": material.base_color,
        "texture": material.base_color_texture.as_ref().map(texture_use),
        "emissive": material.emissive,
        "metallic": material.metallic,
        "roughness": material.roughness,
        "opacity": material.opacity.map(|opacity| json!({
            "value": opacity.value,
            "threshold": opacity.threshold,
            "mask": opacity.mask.as_ref().map(mask),
        })),
        "transmission": material.transmission.map(|transmission| json!({
            "share": transmission.share,
            "mask": transmission.mask.as_ref().map(mask),
        })),
    })
}

fn mask(mask: &TextureMask) -> Value {
    json!({
        "texture": texture_use(&mask.texture),
        "channel": mask.channel,
    })
}

fn texture_use(texture: &TextureUse) -> Value {
    json!({
        "texture": texture.texture,
        "image_from_uv": texture.image_from_uv,
        "scale": texture.scale,
        "bias": texture.bias,
        "wrap": [format!("{:?}", texture.wrap_s), format!("{:?}", texture.wrap_t)],
    })
}

fn texture(texture: &Texture) -> Value {
    let (source, bytes) = match &texture.source {
        TextureSource::File(path) => (path.display().to_string(), None),
        TextureSource::Encoded { name, bytes } => (name.clone(), Some(bytes.len())),
        TextureSource::Pixels(_) => (String::new(), None),
    };
    json!({ "source": source, "bytes": bytes, "color_space": format!("{:?}", texture.color_space) })
}

fn light(light: &Light) -> Value {
    let (kind, measures) = match light.kind {
        LightKind::Distant { angle } => ("distant", vec![angle]),
        LightKind::Dome { .. } => ("dome", Vec::new()),
        LightKind::Sphere { radius } => ("sphere", vec![radius]),
        LightKind::Rect { width, height } => ("rect", vec![width, height]),
        LightKind::Disk { radius } => ("disk", vec![radius]),
    };
    let texture = match light.kind {
        LightKind::Dome { texture } => texture,
        _ => None,
    };
    json!({
        "path": light.path,
        "kind": kind,
        "measures": measures,
        "texture": texture,
        "radiance": light.radiance,
        "normalize": light.normalize,
        "world_from_light": rows(&light.world_from_light),
    })
}

fn affine(transform: &RigidTransform) -> DAffine3 {
    DAffine3::from_mat3_translation(transform.rotation, transform.translation)
}

/// The upper three rows of the 4×4 matrix for column vectors.
fn rows(transform: &DAffine3) -> [[f64; 4]; 3] {
    let m = transform.matrix3.transpose();
    let t = transform.translation;
    let row = |axis: oaktwin_camera::math::DVec3, shift: f64| [axis.x, axis.y, axis.z, shift];
    [row(m.x_axis, t.x), row(m.y_axis, t.y), row(m.z_axis, t.z)]
}
