//! Pixels to shade, by what they see, with their geometry requested before it is needed.

use oaktwin_scene::{Mesh, MeshAttribute, Scene};
use oaktwin_simd::{LaneKernel, Lanes, Level, run_lanes_at};

use crate::Hit;

/// The number of pixels whose corners are requested at once.
const BATCH: usize = 32;

/// A pixel that sees a triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct VisiblePixel {
    /// What the caller identifies the pixel by.
    pub(super) tag: usize,
    pub(super) place: [u32; 2],
    pub(super) hit: Hit,
    /// The z-depth.
    pub(super) z: f32,
}

/// Sorts pixels by instance, and calls `with` for each.
pub(super) fn each_visible_pixel(
    targets: &mut [VisiblePixel],
    scene: &Scene,
    level: Level,
    mut with: impl FnMut(VisiblePixel),
) {
    let key = |target: &VisiblePixel| target.hit.instance;
    if !targets.is_sorted_by_key(key) {
        targets.sort_by_key(key);
    }
    let request = |what, targets| {
        let kernel = Request { scene, what, targets };
        run_lanes_at(level, kernel);
    };
    request(What::Indices, targets);
    let mut batches = targets.chunks(BATCH).peekable();
    request(What::Corners, batches.peek().copied().unwrap_or_default());
    while let Some(batch) = batches.next() {
        request(What::Corners, batches.peek().copied().unwrap_or_default());
        batch.iter().for_each(|target| with(*target));
    }
}

/// The data to bring into the cache.
#[derive(Clone, Copy)]
enum What {
    /// The indices of vertices and of the values at corners.
    Indices,
    /// Positions, normals and texture coordinates, once their indices are there.
    Corners,
}

/// Brings the data of triangles into the cache.
struct Request<'a> {
    scene: &'a Scene,
    what: What,
    targets: &'a [VisiblePixel],
}

impl LaneKernel for Request<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        for target in self.targets {
            let Some(instance) = self.scene.instances.get(target.hit.instance as usize) else {
                continue;
            };
            let Some(mesh) = self.scene.meshes.get(instance.mesh as usize) else {
                continue;
            };
            let triangle = target.hit.triangle as usize;
            match self.what {
                What::Indices => request_indices::<L>(mesh, triangle),
                What::Corners => request_corners::<L>(mesh, triangle),
            }
        }
    }
}

#[inline(always)]
fn request_indices<L: Lanes>(mesh: &Mesh, triangle: usize) {
    if let Some(vertices) = mesh.triangles.get(triangle) {
        L::prefetch(vertices);
    }
    request_indices_of::<L, _>(mesh.normals.as_ref(), triangle);
    request_indices_of::<L, _>(mesh.uvs.as_ref(), triangle);
}

#[inline(always)]
fn request_indices_of<L: Lanes, T>(of: Option<&MeshAttribute<T>>, triangle: usize) {
    if let Some(MeshAttribute::Corner { indices, .. }) = of
        && let Some(indices) = indices.get(triangle)
    {
        L::prefetch(indices);
    }
}

#[inline(always)]
fn request_corners<L: Lanes>(mesh: &Mesh, triangle: usize) {
    let Some(vertices) = mesh.triangles.get(triangle).copied() else {
        return;
    };
    request_values::<L, _>(&mesh.positions, vertices);
    request_values_of::<L, _>(mesh.normals.as_ref(), triangle, vertices);
    request_values_of::<L, _>(mesh.uvs.as_ref(), triangle, vertices);
}

#[inline(always)]
fn request_values_of<L: Lanes, T>(of: Option<&MeshAttribute<T>>, triangle: usize, vertices: [u32; 3]) {
    match of {
        Some(MeshAttribute::Vertex(values)) => request_values::<L, T>(values, vertices),
        Some(MeshAttribute::Corner { values, indices }) => {
            if let Some(indices) = indices.get(triangle) {
                request_values::<L, T>(values, *indices);
            }
        }
        Some(MeshAttribute::Triangle(values)) => {
            if let Some(value) = values.get(triangle) {
                L::prefetch(value);
            }
        }
        Some(MeshAttribute::Constant(_)) | None => {}
    }
}

#[inline(always)]
fn request_values<L: Lanes, T>(values: &[T], indices: [u32; 3]) {
    for index in indices {
        if let Some(value) = values.get(index as usize) {
            L::prefetch(value);
        }
    }
}
