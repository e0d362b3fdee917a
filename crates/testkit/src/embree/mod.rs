//! Embree 4 as a peer: its shared library, loaded at run time.
//!
//! The only unsafe code outside vector code; no released crate depends on it.

#![allow(unsafe_code, reason = "a bridge to a library in another language")]

mod ffi;

use std::ffi::c_int;
use std::path::Path;

use ffi::{Handle, IntersectArguments, Library, RayHit};

/// A scene of triangles with Embree's acceleration structure.
pub struct EmbreeScene {
    library: Library,
    device: Handle,
    scene: Handle,
    /// Read by Embree as long as the scene exists; never modified.
    _positions: Vec<[f32; 3]>,
    _triangles: Vec<[u32; 3]>,
}

// SAFETY: Embree's scenes and devices may be used from any thread; after the commit they are only read.
unsafe impl Send for EmbreeScene {}
// SAFETY: as above: intersection queries on a committed scene are thread-safe.
unsafe impl Sync for EmbreeScene {}

impl std::fmt::Debug for EmbreeScene {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("EmbreeScene").finish_non_exhaustive()
    }
}

/// Rays with one origin and `N` directions.
#[derive(Clone, Copy, Debug)]
pub struct Packet<const N: usize> {
    /// The common origin.
    pub origin: [f32; 3],
    /// The x, y and z components of the directions.
    pub directions: [[f32; N]; 3],
    /// The minimum distance of a hit, in lengths of the direction.
    pub near: f32,
}

impl EmbreeScene {
    /// Opens the library at `path` and builds the scene with `threads` threads and Embree's default quality.
    ///
    /// # Errors
    /// Returns an error if the library cannot be opened, lacks a function or rejects the triangles, or if an index is out of
    /// range.
    pub fn build(
        path: &Path,
        mut positions: Vec<[f32; 3]>,
        triangles: Vec<[u32; 3]>,
        threads: usize,
    ) -> Result<Self, String> {
        let vertex_count = positions.len();
        if triangles
            .iter()
            .flatten()
            .any(|&index| index as usize >= vertex_count)
        {
            return Err("a vertex index is out of range".to_owned());
        }
        // Embree reads vertices 16 bytes at a time: the last one needs padding.
        positions.push([0.0; 3]);
        let library = Library::open(path.as_os_str())?;
        let configuration = std::ffi::CString::new(format!("threads={threads}")).unwrap_or_default();
        // SAFETY: the text ends in a zero byte; handles are used as specified by the header, in its order. The buffers hold
        // `itemCount` items of 12 bytes, are padded, are owned by `Self` (moving a `Vec` does not move its buffer)
        // and outlive the scene, which `drop` releases first.
        let (device, scene) = unsafe {
            let device = (library.new_device)(configuration.as_ptr());
            if device.is_null() {
                return Err("Embree could not create a device".to_owned());
            }
            let scene = (library.new_scene)(device);
            let geometry = (library.new_geometry)(device, ffi::GEOMETRY_TYPE_TRIANGLE);
            let buffer = library.set_shared_buffer;
            buffer(
                geometry,
                ffi::BUFFER_TYPE_VERTEX,
                0,
                ffi::FORMAT_FLOAT3,
                positions.as_ptr().cast(),
                0,
                12,
                vertex_count,
            );
            buffer(
                geometry,
                ffi::BUFFER_TYPE_INDEX,
                0,
                ffi::FORMAT_UINT3,
                triangles.as_ptr().cast(),
                0,
                12,
                triangles.len(),
            );
            (library.commit_geometry)(geometry);
            (library.attach_geometry)(scene, geometry);
            (library.release_geometry)(geometry);
            (library.commit_scene)(scene);
            (device, scene)
        };
        let built = Self {
            library,
            device,
            scene,
            _positions: positions,
            _triangles: triangles,
        };
        // SAFETY: the device is alive.
        match unsafe { (built.library.device_error)(built.device) } {
            0 => Ok(built),
            code => Err(format!("Embree error {code}")),
        }
    }

    /// The distance of each ray's first hit in lengths of its direction, `+inf` for a miss (`rtcIntersect1`).
    #[must_use]
    pub fn intersect1(&self, packet: &Packet<1>) -> [f32; 1] {
        let mut rays = ray_hits(packet);
        let mut arguments = coherent();
        // SAFETY: the scene is committed; ray and arguments have the header's layout and live on this stack.
        unsafe { (self.library.intersect1)(self.scene, &raw mut rays, &raw mut arguments) };
        rays.t_far
    }

    /// Like [`Self::intersect1`], for eight rays (`rtcIntersect8`).
    #[must_use]
    pub fn intersect8(&self, packet: &Packet<8>) -> [f32; 8] {
        let mut rays = ray_hits(packet);
        let mut arguments = coherent();
        let valid = Lanes::<8>([-1; 8]);
        // SAFETY: as above; `valid` holds eight aligned integers.
        unsafe {
            (self.library.intersect8)(valid.0.as_ptr(), self.scene, &raw mut rays, &raw mut arguments);
        }
        rays.t_far
    }

    /// Like [`Self::intersect1`], for sixteen rays (`rtcIntersect16`).
    #[must_use]
    pub fn intersect16(&self, packet: &Packet<16>) -> [f32; 16] {
        let mut rays = ray_hits(packet);
        let mut arguments = coherent();
        let valid = Lanes::<16>([-1; 16]);
        // SAFETY: as above; `valid` holds sixteen aligned integers.
        unsafe {
            (self.library.intersect16)(valid.0.as_ptr(), self.scene, &raw mut rays, &raw mut arguments);
        }
        rays.t_far
    }
}

impl Drop for EmbreeScene {
    fn drop(&mut self) {
        // SAFETY: both handles are valid and are not used again; the library itself stays loaded.
        unsafe {
            (self.library.release_scene)(self.scene);
            (self.library.release_device)(self.device);
        }
    }
}

/// A mask of lanes with the alignment that packets require.
#[repr(C, align(64))]
struct Lanes<const N: usize>([c_int; N]);

fn ray_hits<const N: usize>(packet: &Packet<N>) -> RayHit<N> {
    RayHit {
        origin: packet.origin.map(|value| [value; N]),
        t_near: [packet.near; N],
        direction: packet.directions,
        time: [0.0; N],
        t_far: [f32::INFINITY; N],
        mask: [u32::MAX; N],
        id: [0; N],
        flags: [0; N],
        normal: [[0.0; N]; 3],
        uv: [[0.0; N]; 2],
        primitive: [u32::MAX; N],
        geometry: [u32::MAX; N],
        instances: [[u32::MAX; N]; 8],
    }
}

fn coherent() -> IntersectArguments {
    IntersectArguments {
        flags: ffi::RAY_QUERY_FLAG_COHERENT,
        feature_mask: u32::MAX,
        context: std::ptr::null_mut(),
        filter: std::ptr::null_mut(),
        intersect: std::ptr::null_mut(),
        reserved: [0; 4],
    }
}
