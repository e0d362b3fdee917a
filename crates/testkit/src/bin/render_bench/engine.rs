use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use rayon::{ThreadPool, ThreadPoolBuilder};

/// Renders depth frames of a triangle mesh.
pub(crate) trait Engine {
    /// The rendering modes, which are timed separately.
    fn modes(&self) -> Vec<String>;

    /// The depth of each pixel in metres, row by row, `+inf` for a miss; runs in the current thread pool.
    fn frame(&self, mode: &str) -> Vec<f32>;
}

/// The thread pools by their number of threads.
#[derive(Default)]
pub(crate) struct Pools(BTreeMap<usize, ThreadPool>);

impl Pools {
    pub(crate) fn run<T: Send>(
        &mut self,
        threads: usize,
        work: impl FnOnce() -> T + Send,
    ) -> Result<T, String> {
        let pool = match self.0.entry(threads) {
            Entry::Occupied(entry) => entry.into_mut(),
            Entry::Vacant(entry) => {
                let pool = ThreadPoolBuilder::new().num_threads(threads).build();
                entry.insert(pool.map_err(|error| error.to_string())?)
            }
        };
        Ok(pool.install(work))
    }
}
