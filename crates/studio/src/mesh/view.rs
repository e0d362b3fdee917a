//! The mesh of a whole scene, made within a budget whatever the scene repeats.

use std::collections::HashMap;

use oaktwin::camera::math::DVec3;
use oaktwin::memory;
use oaktwin::render::Renderer;
use oaktwin::scene::Scene;

use super::welded::Welded;
use crate::protocol::{Failure, SceneObject};
use crate::task::Job;

/// The number of triangles that are welded at once: of larger scenes, each mesh is thinned before it is placed.
pub(crate) const MAX_WELDED: usize = 1_000_000;

/// The memory that welding and simplifying takes for each triangle if no vertices are shared, bytes.
const TRIANGLE_BYTES: u64 = 500;

/// A triangle of a mesh with its colour.
type Facet = ([[f32; 3]; 3], [u8; 3]);

/// Returns the number of triangles of all instances.
pub(crate) fn triangles(scene: &Scene) -> usize {
    usize::try_from(scene.triangle_count()).unwrap_or(usize::MAX)
}

/// Encodes a scene with about `limit` triangles, of which no more than `welded` (or `limit`) are ever in memory.
pub(crate) fn of_scene(
    renderer: &Renderer,
    objects: &[SceneObject],
    (limit, welded): (usize, usize),
    job: &Job,
) -> Result<Vec<u8>, Failure> {
    let scene = renderer.scene();
    let total = triangles(scene);
    let budget = welded.max(limit).min(total);
    memory::check(TRIANGLE_BYTES.saturating_mul(budget as u64)).map_err(|shortage| {
        let remedy = "drop a scene with fewer triangles";
        Failure::from(format!(
            "the 3D view of {total} triangles: {}; {}",
            shortage.what(),
            shortage.remedy_or(remedy)
        ))
    })?;
    let mut made = Welded::default();
    let mut kept = Share::new(budget, total);
    let mut meshes: HashMap<u32, Vec<Facet>> = HashMap::new();
    for instance in &scene.instances {
        let Some(mesh) = scene.meshes.get(instance.mesh as usize) else {
            continue;
        };
        let count = kept.of(mesh.triangles.len());
        if count == 0 {
            continue;
        }
        job.check()?;
        let object = objects.binary_search_by(|object| object.path.as_str().cmp(&instance.path));
        let object = object.map_or(u32::MAX, |index| u32::try_from(index).unwrap_or(u32::MAX));
        let facets = meshes
            .entry(instance.mesh)
            .or_insert_with(|| facets(renderer, instance.mesh, kept.target(mesh.triangles.len()), budget));
        let place = |p: [f32; 3]| {
            instance
                .world_from_mesh
                .transform_point3(DVec3::from(p.map(f64::from)))
        };
        for (corners, color) in evenly(facets, count) {
            made.add_triangle(corners.map(place), *color, object);
        }
    }
    drop(meshes);
    job.check()?;
    made.simplify(limit);
    Ok(made.encode(total))
}

/// Returns `target` triangles of a mesh, simplified, or all.
fn facets(renderer: &Renderer, index: u32, target: usize, budget: usize) -> Vec<Facet> {
    let Some(mesh) = renderer.scene().meshes.get(index as usize) else {
        return Vec::new();
    };
    let colors = renderer.flat_colors(index as usize);
    let count = mesh.triangles.len();
    let facet = |triangle: usize| {
        let color = colors.get(triangle).copied().unwrap_or_default();
        Some((mesh.corners(triangle)?, color))
    };
    if target >= count {
        return (0..count).filter_map(facet).collect();
    }
    let mut own = Welded::default();
    for triangle in places(count, budget.min(count)) {
        if let Some((corners, color)) = facet(triangle) {
            own.add_triangle(corners.map(|p| DVec3::from(p.map(f64::from))), color, 0);
        }
    }
    own.simplify(target);
    own.facets().collect()
}

/// Returns `count` elements of a list that are evenly distributed over it, or all if it has fewer.
fn evenly<T>(all: &[T], count: usize) -> impl Iterator<Item = &T> {
    places(all.len(), count.min(all.len())).filter_map(|place| all.get(place))
}

/// Returns `count` of `all` indices, evenly distributed.
fn places(all: usize, count: usize) -> impl Iterator<Item = usize> {
    let place = move |index: usize| (index as u128 * all as u128 / count.max(1) as u128) as usize;
    (0..count).map(place)
}

/// A part of a number that is given out without a remainder.
struct Share {
    part: usize,
    of: usize,
    /// What was not given out yet, as a multiple of `of`.
    rest: u128,
}

impl Share {
    fn new(part: usize, of: usize) -> Self {
        Self {
            part,
            of: of.max(1),
            rest: 0,
        }
    }

    /// Returns the next part of a count: in total never more than the part of all counts.
    fn of(&mut self, count: usize) -> usize {
        self.rest += count as u128 * self.part as u128;
        let whole = self.rest / self.of as u128;
        self.rest %= self.of as u128;
        usize::try_from(whole).unwrap_or(usize::MAX)
    }

    /// Returns the part of one count, rounded up.
    fn target(&self, count: usize) -> usize {
        let part = (count as u128 * self.part as u128).div_ceil(self.of as u128);
        usize::try_from(part).unwrap_or(usize::MAX)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::LoadedScene;

    use oaktwin::render::OpenOptions;
    use serde_json::{Value, json};

    /// A glTF file whose nodes share a mesh, whose primitives share nine triangles.
    fn repeated(nodes: usize, primitives: usize) -> String {
        let corners = (0..9u8).flat_map(|i| {
            let x = f32::from(i);
            [[x, 0.0, 0.0], [x + 1.0, 0.0, 0.0], [x, 1.0, 0.0]].concat()
        });
        let bytes: Vec<u8> = corners.flat_map(f32::to_le_bytes).collect();
        let escaped: String = bytes.iter().map(|byte| format!("%{byte:02x}")).collect();
        let document = json!({
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": (0..nodes).collect::<Vec<_>>()}],
            "nodes": vec![json!({"mesh": 0}); nodes],
            "meshes": [{"primitives": vec![json!({"attributes": {"POSITION": 0}}); primitives]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 27, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteLength": bytes.len()}],
            "buffers": [{"byteLength": bytes.len(), "uri": format!("data:application/octet-stream,{escaped}")}],
        });
        document.to_string()
    }

    fn open(text: &str) -> LoadedScene {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("repeated.gltf");
        std::fs::write(&path, text).unwrap();
        let opened = LoadedScene::open(&path, &OpenOptions::default(), ("first", "a", "a"));
        opened.unwrap_or_else(|failure| panic!("{}", failure.error))
    }

    fn header(scene: &LoadedScene, limit: usize, welded: usize) -> Value {
        let waiting = std::sync::Arc::new(());
        let job = Job {
            waits: std::sync::Arc::downgrade(&waiting),
            stop: tokio::sync::watch::Sender::new(false).subscribe(),
        };
        let mesh = of_scene(&scene.renderer, &scene.info.objects, (limit, welded), &job).unwrap();
        let length = u32::from_le_bytes(mesh[..4].try_into().unwrap()) as usize;
        serde_json::from_slice(&mesh[4..4 + length]).unwrap()
    }

    #[test]
    fn a_small_file_of_many_triangles_has_a_small_mesh() {
        let text = repeated(10_000, 10_000);
        assert!(text.len() < 600_000, "{}", text.len());
        let scene = open(&text);
        assert_eq!(scene.info.triangles, 900_000_000);
        let header = header(&scene, 1000, 20_000);
        assert_eq!(header["ofTriangles"], 900_000_000);
        let shown = header["triangles"].as_u64().unwrap();
        assert!((1..=1000).contains(&shown), "{header}");
    }

    #[test]
    fn small_scenes_are_complete_and_larger_ones_are_thinned() {
        let scene = open(&repeated(10, 100));
        assert_eq!(header(&scene, 9000, 9000)["triangles"], 9000);
        let thin = header(&scene, 500, 900)["triangles"].as_u64().unwrap();
        assert!((1..=500).contains(&thin), "{thin}");
    }

    #[test]
    fn shares_add_up() {
        let mut share = Share::new(10, 1000);
        let parts: Vec<usize> = (0..100).map(|_| share.of(10)).collect();
        assert_eq!(parts.iter().sum::<usize>(), 10);
        assert!(parts.iter().all(|part| *part <= 1));
        let mut all = Share::new(7, 7);
        assert_eq!([all.of(3), all.of(4)], [3, 4]);
        assert_eq!(places(10, 3).collect::<Vec<_>>(), [0, 3, 6]);
        assert_eq!(places(0, 0).count(), 0);
    }
}
