//! What `cargo xtask fuzz` checks, as plain functions; for development only.
//!
//! [`TARGETS`] lists them. The binaries in `fuzz/` pass bytes from libFuzzer to one of them, and the tests of this crate those
//! of the corpora. A new target needs a function, a line in [`TARGETS`], and a binary in `fuzz/`.

mod calibration;
mod codec;
mod engine;
mod file;
mod filter;
mod foreign;
mod import;
mod json;
mod list;
mod message;
mod page;
mod random;
mod recipe;
mod renderer;
mod robot;
mod scene;
mod text;
mod usd;

use std::panic::{AssertUnwindSafe, catch_unwind, set_hook};
use std::sync::{LazyLock, Mutex, Once, PoisonError};

use rayon::{ThreadPool, ThreadPoolBuilder};

/// The functions of the targets. A binary names its own, so that it contains nothing of the others, whose counters of coverage would be read
/// after every input.
pub mod check {
    macro_rules! checks {
        ($($name:ident = $function:path),* $(,)?) => {
            $(
                #[doc = concat!("Checks an input of the target `", stringify!($name), "`.")]
                pub fn $name(bytes: &[u8]) {
                    $function(bytes);
                }
            )*
        };
    }

    checks! {
        calibration = crate::calibration::check,
        catalog = crate::text::catalog,
        curve = crate::list::curve,
        dae = crate::import::dae,
        depth_image = crate::codec::depth_image,
        engines = crate::engine::depth,
        filters = crate::filter::check,
        foreign_calibration = crate::foreign::check,
        gltf = crate::import::gltf,
        materialx = crate::usd::materialx,
        messages = crate::message::check,
        npy = crate::codec::npy,
        obj = crate::import::obj,
        page = crate::page::check,
        parameters = crate::text::parameters,
        ply = crate::import::ply,
        recipe = crate::recipe::check,
        renderers = crate::renderer::check,
        robot = crate::robot::check,
        stereo = crate::engine::stereo,
        stl = crate::import::stl,
        texture = crate::codec::texture,
        track = crate::list::track,
        trajectory = crate::list::trajectory,
        usd_emitter = crate::usd::emitter,
        usda = crate::usd::usda,
        usdc = crate::usd::usdc,
        usdz = crate::usd::usdz,
    }
}

/// A function to fuzz.
#[derive(Clone, Copy, Debug)]
pub struct FuzzTarget {
    /// The name of the target, its binary and its corpus.
    pub name: &'static str,
    /// What it checks, in one line.
    pub about: &'static str,
    /// The maximum length of an input.
    pub max_len: usize,
    /// Panics if the bytes break a promise; rejecting them is fine.
    pub check: fn(&[u8]),
    /// Valid inputs to start from.
    pub seeds: fn() -> Vec<Vec<u8>>,
}

/// All targets, in the order in which they run.
pub const TARGETS: &[FuzzTarget] = &[
    FuzzTarget {
        name: "calibration",
        about: "reads a calibration; the document round-trips, exports and twins are finite",
        max_len: 16384,
        check: check::calibration,
        seeds: calibration::seeds,
    },
    FuzzTarget {
        name: "foreign-calibration",
        about: "imports calibrations of ROS, Kalibr and OpenCV; the document is finite and round-trips",
        max_len: 16384,
        check: check::foreign_calibration,
        seeds: foreign::seeds,
    },
    FuzzTarget {
        name: "trajectory",
        about: "reads a trajectory; poses are rotations at finite places",
        max_len: 4096,
        check: check::trajectory,
        seeds: list::trajectory_seeds,
    },
    FuzzTarget {
        name: "curve",
        about: "reads a measured curve of errors; numbers are in the ranges of the manual",
        max_len: 4096,
        check: check::curve,
        seeds: list::curve_seeds,
    },
    FuzzTarget {
        name: "track",
        about: "reads positions over time; numbers are finite, and times increase",
        max_len: 4096,
        check: check::track,
        seeds: list::track_seeds,
    },
    FuzzTarget {
        name: "filters",
        about: "runs chains of filters on two frames; sizes are as documented, the same bytes twice",
        max_len: 4096,
        check: check::filters,
        seeds: filter::seeds,
    },
    FuzzTarget {
        name: "npy",
        about: "decodes an array; its shape fits its values, and it round-trips",
        max_len: 4096,
        check: check::npy,
        seeds: codec::npy_seeds,
    },
    FuzzTarget {
        name: "depth-image",
        about: "decodes PNG, EXR and PFM; images round-trip",
        max_len: 4096,
        check: check::depth_image,
        seeds: codec::depth_image_seeds,
    },
    FuzzTarget {
        name: "texture",
        about: "decodes textures of all formats; colours are as large as the image",
        max_len: 8192,
        check: check::texture,
        seeds: codec::texture_seeds,
    },
    FuzzTarget {
        name: "stl",
        about: "imports STL; every index and transform is valid",
        max_len: 4096,
        check: check::stl,
        seeds: import::stl_seeds,
    },
    FuzzTarget {
        name: "ply",
        about: "imports PLY, also with drawn headers; every index is valid",
        max_len: 4096,
        check: check::ply,
        seeds: import::ply_seeds,
    },
    FuzzTarget {
        name: "obj",
        about: "imports OBJ and MTL; every index is valid",
        max_len: 4096,
        check: check::obj,
        seeds: import::obj_seeds,
    },
    FuzzTarget {
        name: "dae",
        about: "imports Collada; every index and transform is valid",
        max_len: 8192,
        check: check::dae,
        seeds: import::dae_seeds,
    },
    FuzzTarget {
        name: "gltf",
        about: "imports glTF and GLB, also with changed documents; every index and transform is valid",
        max_len: 8192,
        check: check::gltf,
        seeds: import::gltf_seeds,
    },
    FuzzTarget {
        name: "parameters",
        about: "reads parameters, filters and drifts as text; filters and drifts round-trip",
        max_len: 1024,
        check: check::parameters,
        seeds: text::parameters_seeds,
    },
    FuzzTarget {
        name: "engines",
        about: "measures depth with every engine and drawn parameters; no NaN, the same bytes twice",
        max_len: 4096,
        check: check::engines,
        seeds: engine::depth_seeds,
    },
    FuzzTarget {
        name: "stereo",
        about: "matches drawn pairs with drawn parameters; no NaN, the same bytes twice",
        max_len: 4096,
        check: check::stereo,
        seeds: engine::stereo_seeds,
    },
    FuzzTarget {
        name: "renderers",
        about: "renders drawn triangles with both backends; both agree with the reference",
        max_len: 1024,
        check: check::renderers,
        seeds: renderer::seeds,
    },
    FuzzTarget {
        name: "usda",
        about: "reads text stages, also drawn ones; every index and transform is valid",
        max_len: 4096,
        check: check::usda,
        seeds: usd::usda_seeds,
    },
    FuzzTarget {
        name: "usdc",
        about: "reads binary stages; every index and transform is valid",
        max_len: 8192,
        check: check::usdc,
        seeds: usd::usdc_seeds,
    },
    FuzzTarget {
        name: "usdz",
        about: "reads packages, also of drawn layers; every index and transform is valid",
        max_len: 8192,
        check: check::usdz,
        seeds: usd::usdz_seeds,
    },
    FuzzTarget {
        name: "materialx",
        about: "converts MaterialX documents to layers",
        max_len: 4096,
        check: check::materialx,
        seeds: usd::materialx_seeds,
    },
    FuzzTarget {
        name: "usd-emitter",
        about: "emits layers of drawn values; they read back the same",
        max_len: 1024,
        check: check::usd_emitter,
        seeds: usd::emitter_seeds,
    },
    FuzzTarget {
        name: "catalog",
        about: "adds a file to the catalog; nominal twins are finite",
        max_len: 16384,
        check: check::catalog,
        seeds: text::catalog_seeds,
    },
    FuzzTarget {
        name: "recipe",
        about: "reads a recipe and draws a frame; it round-trips, the same numbers twice",
        max_len: 4096,
        check: check::recipe,
        seeds: recipe::seeds,
    },
    FuzzTarget {
        name: "robot",
        about: "reads URDF and MJCF, and moves the joints; links stay at finite places",
        max_len: 8192,
        check: check::robot,
        seeds: robot::seeds,
    },
    FuzzTarget {
        name: "messages",
        about: "reads images and camera info of ROS 2 and measures them; messages round-trip, sizes fit",
        max_len: 4096,
        check: check::messages,
        seeds: message::seeds,
    },
    FuzzTarget {
        name: "page",
        about: "answers drawn requests of Studio's page, on its socket and over HTTP; none panics",
        max_len: 1024,
        check: check::page,
        seeds: page::seeds,
    },
];

/// One thread, so that nothing waits for another, with the stack that reading stages needs.
static POOL: LazyLock<ThreadPool> = LazyLock::new(|| {
    let pool = ThreadPoolBuilder::new().num_threads(1).stack_size(256 << 20);
    pool.build().unwrap_or_else(|error| panic!("{error}"))
});

static LAST_PANIC: Mutex<String> = Mutex::new(String::new());

/// Runs a target under libFuzzer: aborts if the target panics, but not on panics that the library catches.
#[expect(clippy::print_stderr, reason = "for the log of the fuzzer")]
pub fn run(check: fn(&[u8]), bytes: &[u8]) {
    static HOOK: Once = Once::new();
    // libFuzzer's own hook aborts on every panic.
    HOOK.call_once(|| {
        set_hook(Box::new(|info| {
            *LAST_PANIC.lock().unwrap_or_else(PoisonError::into_inner) = info.to_string();
        }));
    });
    if catch_unwind(AssertUnwindSafe(|| POOL.install(|| check(bytes)))).is_err() {
        eprintln!("{}", LAST_PANIC.lock().unwrap_or_else(PoisonError::into_inner));
        std::process::abort();
    }
}
