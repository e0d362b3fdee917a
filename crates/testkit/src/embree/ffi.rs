//! The required part of Embree 4's C interface, and the loading of its shared library. Linux only.
//!
//! Names, orders and values follow `embree4/rtcore_*.h`.

use std::ffi::{CStr, CString, OsStr, c_char, c_int, c_uint, c_void};
use std::os::unix::ffi::OsStrExt;

/// An opaque handle: device, scene or geometry.
pub(super) type Handle = *mut c_void;

pub(super) const GEOMETRY_TYPE_TRIANGLE: c_int = 0;
pub(super) const BUFFER_TYPE_INDEX: c_int = 0;
pub(super) const BUFFER_TYPE_VERTEX: c_int = 1;
pub(super) const FORMAT_UINT3: c_int = 0x5003;
pub(super) const FORMAT_FLOAT3: c_int = 0x9003;
pub(super) const RAY_QUERY_FLAG_COHERENT: c_int = 1 << 16;

/// `RTCIntersectArguments`, with space for a field that some builds append.
#[repr(C)]
pub(super) struct IntersectArguments {
    pub(super) flags: c_int,
    pub(super) feature_mask: c_uint,
    pub(super) context: *mut c_void,
    pub(super) filter: *mut c_void,
    pub(super) intersect: *mut c_void,
    pub(super) reserved: [u64; 4],
}

/// `RTCRayHit`, `RTCRayHit8` and `RTCRayHit16`, which differ only in `N`, with space for fields that some builds
/// append. All three require at most 64-byte alignment.
#[repr(C, align(64))]
pub(super) struct RayHit<const N: usize> {
    pub(super) origin: [[f32; N]; 3],
    pub(super) t_near: [f32; N],
    pub(super) direction: [[f32; N]; 3],
    pub(super) time: [f32; N],
    pub(super) t_far: [f32; N],
    pub(super) mask: [u32; N],
    pub(super) id: [u32; N],
    pub(super) flags: [u32; N],
    pub(super) normal: [[f32; N]; 3],
    pub(super) uv: [[f32; N]; 2],
    pub(super) primitive: [u32; N],
    pub(super) geometry: [u32; N],
    pub(super) instances: [[u32; N]; 8],
}

#[link(name = "dl")]
unsafe extern "C" {
    fn dlopen(path: *const c_char, flags: c_int) -> *mut c_void;
    fn dlsym(library: *mut c_void, name: *const c_char) -> *mut c_void;
    fn dlerror() -> *const c_char;
}

const RTLD_NOW: c_int = 2;
const RTLD_GLOBAL: c_int = 0x100;

/// Defines [`Library`] from the Rust names, C names and types of its functions.
macro_rules! library {
    ($($field:ident = $name:literal: $type:ty;)*) => {
        /// The entry points. The library is never unloaded, so they never dangle.
        #[derive(Clone, Copy)]
        pub(super) struct Library {
            $(pub(super) $field: $type,)*
        }

        impl Library {
            fn of(library: *mut c_void) -> Result<Self, String> {
                Ok(Self {
                    $($field: {
                        let symbol = symbol(library, $name)?;
                        // SAFETY: the type is the header's prototype of this function, and data pointers and
                        // function pointers have the same representation on Linux.
                        unsafe { std::mem::transmute::<*mut c_void, $type>(symbol) }
                    },)*
                })
            }
        }
    };
}

library! {
    new_device = c"rtcNewDevice": unsafe extern "C" fn(*const c_char) -> Handle;
    device_error = c"rtcGetDeviceError": unsafe extern "C" fn(Handle) -> c_int;
    new_scene = c"rtcNewScene": unsafe extern "C" fn(Handle) -> Handle;
    new_geometry = c"rtcNewGeometry": unsafe extern "C" fn(Handle, c_int) -> Handle;
    set_shared_buffer = c"rtcSetSharedGeometryBuffer": SetSharedBuffer;
    commit_geometry = c"rtcCommitGeometry": unsafe extern "C" fn(Handle);
    attach_geometry = c"rtcAttachGeometry": unsafe extern "C" fn(Handle, Handle) -> c_uint;
    release_geometry = c"rtcReleaseGeometry": unsafe extern "C" fn(Handle);
    commit_scene = c"rtcCommitScene": unsafe extern "C" fn(Handle);
    release_scene = c"rtcReleaseScene": unsafe extern "C" fn(Handle);
    release_device = c"rtcReleaseDevice": unsafe extern "C" fn(Handle);
    intersect1 = c"rtcIntersect1": unsafe extern "C" fn(Handle, *mut RayHit<1>, *mut IntersectArguments);
    intersect8 = c"rtcIntersect8": IntersectPacket<8>;
    intersect16 = c"rtcIntersect16": IntersectPacket<16>;
}

/// Geometry, kind, slot, format, data, offset in bytes, stride in bytes, item count.
type SetSharedBuffer = unsafe extern "C" fn(Handle, c_int, c_uint, c_int, *const c_void, usize, usize, usize);

/// Valid lanes, scene, rays, arguments.
type IntersectPacket<const N: usize> =
    unsafe extern "C" fn(*const c_int, Handle, *mut RayHit<N>, *mut IntersectArguments);

impl Library {
    /// Opens the library and never unloads it: its threads would not survive that.
    pub(super) fn open(path: &OsStr) -> Result<Self, String> {
        let c_path = CString::new(path.as_bytes()).map_err(|error| error.to_string())?;
        // SAFETY: the path ends in a zero byte and outlives the call.
        let library = unsafe { dlopen(c_path.as_ptr(), RTLD_NOW | RTLD_GLOBAL) };
        if library.is_null() {
            return Err(last_error());
        }
        Self::of(library)
    }
}

fn symbol(library: *mut c_void, name: &CStr) -> Result<*mut c_void, String> {
    // SAFETY: the library is open and the name ends in a zero byte.
    let symbol = unsafe { dlsym(library, name.as_ptr()) };
    if symbol.is_null() {
        return Err(last_error());
    }
    Ok(symbol)
}

fn last_error() -> String {
    // SAFETY: no arguments; the text is copied before this thread's next call of the loader.
    let text = unsafe { dlerror() };
    if text.is_null() {
        return "unknown loader error".to_owned();
    }
    // SAFETY: not null, and the loader ends its messages with a zero byte.
    unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned()
}
