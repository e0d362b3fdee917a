//! The surfaces of a scene that have a texture, for the 3D view. The layout matches `TexturedHeader` in `web/src/protocol.ts`.

use std::collections::BTreeMap;

use oaktwin::camera::math::DVec3;
use oaktwin::image::Image;
use oaktwin::render::texture_pixels;
use oaktwin::scene::{Material, Mesh, Scene, TextureUse, Wrap};
use serde::Serialize;

use crate::protocol::Failure;
use crate::scene::LoadedScene;
use crate::task::Job;
use crate::wire;

/// The number of textured triangles that are drawn; scenes with more have none.
const MAX_TRIANGLES: usize = 200_000;
/// The largest side of a texture that is sent, pixels.
const MAX_SIDE: u32 = 512;
/// The number of textures: 48 MiB of the largest size.
const MAX_TEXTURES: usize = 48;

/// Binary surfaces with textures, over those of the mesh; none if there are too many. Laid out like a mesh: after the header and its
/// padding, for each group the float32 positions (3 per vertex) and coordinates (2 per vertex) of its triangles' corners; then the rgba8
/// pixels of the textures, the lowest row first.
#[derive(Debug, Default, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "TexturedHeader"))]
pub(crate) struct Header {
    groups: Vec<Group>,
    textures: Vec<TextureHeader>,
}

/// Triangles with one material.
#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "TexturedGroup"))]
struct Group {
    vertices: usize,
    texture: usize,
    /// The linear factor of the texture.
    #[cfg_attr(test, ts(type = "Vec3"))]
    color: [f32; 3],
}

#[derive(Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
struct TextureHeader {
    width: u32,
    height: u32,
    #[cfg_attr(test, ts(type = "[TextureWrap, TextureWrap]"))]
    wrap: [&'static str; 2],
}

/// The corners of triangles, with their coordinates in the texture.
#[derive(Debug, Default)]
struct Corners {
    positions: Vec<[f32; 3]>,
    coordinates: Vec<[f32; 2]>,
}

/// Encodes the textured surfaces: none of a scene with too many.
pub(crate) fn of_textures(loaded: &LoadedScene, job: &Job) -> Result<Vec<u8>, Failure> {
    let scene = loaded.renderer.scene();
    let robot = loaded.robot.as_ref().map(|robot| &robot.placed);
    let mut groups: BTreeMap<u32, Corners> = BTreeMap::new();
    for (index, instance) in scene.instances.iter().enumerate() {
        job.check()?;
        // The page moves the robot without its textures.
        if robot.is_some_and(|robot| robot.has(index)) {
            continue;
        }
        let Some(mesh) = scene.meshes.get(instance.mesh as usize) else {
            continue;
        };
        let place = |p: [f32; 3]| {
            let point = DVec3::from(p.map(f64::from));
            instance
                .world_from_mesh
                .transform_point3(point)
                .as_vec3()
                .to_array()
        };
        add(scene, mesh, instance.material_offset, place, &mut groups);
        let corners: usize = groups.values().map(|group| group.positions.len()).sum();
        if corners > 3 * MAX_TRIANGLES {
            groups.clear();
            break;
        }
    }
    let mut header = Header::default();
    let mut made: BTreeMap<(u32, [&str; 2]), usize> = BTreeMap::new();
    let (mut geometry, mut pixels): (Vec<u8>, Vec<u8>) = (Vec::new(), Vec::new());
    for (index, corners) in &groups {
        job.check()?;
        let Some((material, used)) = textured(scene, *index) else {
            continue;
        };
        let wrap = [used.wrap_s, used.wrap_t].map(name);
        let known = made.get(&(used.texture, wrap)).copied();
        let texture = known.or_else(|| {
            let texture = scene.textures.get(used.texture as usize)?;
            // The images report a texture that cannot be read.
            let image = (header.textures.len() < MAX_TEXTURES)
                .then(|| texture_pixels(texture).ok())
                .flatten()?;
            let small = shrunk(&image);
            header.textures.push(TextureHeader {
                width: small.width(),
                height: small.height(),
                wrap,
            });
            // WebGL counts rows from the bottom.
            let rows = small.pixels().chunks(small.width().max(1) as usize).rev();
            pixels.extend(rows.flatten().flatten());
            made.insert((used.texture, wrap), header.textures.len() - 1);
            Some(header.textures.len() - 1)
        });
        let Some(texture) = texture else { continue };
        let tint = material.base_color.unwrap_or([1.0; 3]);
        header.groups.push(Group {
            vertices: corners.positions.len(),
            texture,
            color: std::array::from_fn(|i| tint[i] * used.scale[i]),
        });
        geometry.extend(
            corners
                .positions
                .as_flattened()
                .iter()
                .flat_map(|x| x.to_le_bytes()),
        );
        geometry.extend(
            corners
                .coordinates
                .as_flattened()
                .iter()
                .flat_map(|x| x.to_le_bytes()),
        );
    }
    let mut out = wire::begin(&header);
    out.resize(out.len().next_multiple_of(4), 0);
    out.extend(geometry);
    out.extend(pixels);
    Ok(out)
}

/// Adds the textured triangles of an instance to those of their materials.
fn add(
    scene: &Scene,
    mesh: &Mesh,
    offset: u32,
    place: impl Fn([f32; 3]) -> [f32; 3],
    groups: &mut BTreeMap<u32, Corners>,
) {
    let Some(uvs) = &mesh.uvs else { return };
    for (number, vertices) in (0_u32..).zip(&mesh.triangles) {
        let triangle = number as usize;
        let material = mesh.material(number).map(|material| material + offset);
        let Some((index, (_, used))) = material.and_then(|index| Some((index, textured(scene, index)?)))
        else {
            continue;
        };
        let (Some(corners), Some(own)) = (mesh.corners(triangle), uvs.corners(triangle, *vertices)) else {
            continue;
        };
        let [first, second] = used.image_from_uv;
        let along = |row: [f32; 3], [u, v]: [f32; 2]| row[0] * u + row[1] * v + row[2];
        let group = groups.entry(index).or_default();
        group.positions.extend(corners.map(&place));
        group
            .coordinates
            .extend(own.map(|uv| [along(first, uv), along(second, uv)]));
    }
}

/// A material with a texture that a factor changes at most, and nothing else.
fn textured(scene: &Scene, index: u32) -> Option<(&Material, &TextureUse)> {
    let material = scene.materials.get(index as usize)?;
    let used = material.base_color_texture.as_ref()?;
    let is_plain = material.transmission.is_none() && material.opacity.is_none() && used.bias == [0.0; 4];
    is_plain.then_some((material, used))
}

fn name(wrap: Wrap) -> &'static str {
    match wrap {
        Wrap::Repeat => "repeat",
        Wrap::Mirror => "mirror",
        Wrap::Clamp | Wrap::Black => "clamp",
    }
}

/// Shrinks an image by whole factors to sides that are sent.
fn shrunk(image: &Image<[u8; 4]>) -> Image<[u8; 4]> {
    let factor = image.width().max(image.height()).div_ceil(MAX_SIDE).max(1);
    let (width, height) = (image.width().div_ceil(factor), image.height().div_ceil(factor));
    let mut small = Image::filled(width, height, [0; 4]);
    for (place, pixel) in (0_u32..).zip(small.pixels_mut()) {
        let (left, top) = (place % width * factor, place / width * factor);
        let mut sum = [0_u32; 5];
        for y in top..(top + factor).min(image.height()) {
            for x in left..(left + factor).min(image.width()) {
                let value = image.get(x, y).copied().unwrap_or_default();
                (sum.iter_mut().zip(value)).for_each(|(sum, value)| *sum += u32::from(value));
                sum[4] += 1;
            }
        }
        *pixel = std::array::from_fn(|i| u8::try_from(sum[i] / sum[4].max(1)).unwrap_or(u8::MAX));
    }
    small
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_textures_shrink_to_their_means() {
        let image = Image::new(
            1025,
            2,
            (0..2050)
                .map(|i| [u8::from(i % 2 == 0) * 200, 7, 0, 255])
                .collect(),
        );
        let small = shrunk(&image.unwrap());
        assert_eq!((small.width(), small.height()), (342, 1));
        let mean = small.get(0, 0).unwrap();
        assert!(
            (80..=120).contains(&mean[0]) && mean[1] == 7 && mean[3] == 255,
            "{mean:?}"
        );
        assert_eq!(shrunk(&small), small);
    }
}
