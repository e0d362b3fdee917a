use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use rayon::{ThreadPool, ThreadPoolBuilder};

/// Something that renders depth frames of triangles that it was given.
pub(crate) trait Engine {
    /// Ways to render that are timed apart.
    fn modes(&self) -> Vec<String>;

    /// Depth of each pixel, row by row, metres, `+inf` for a miss; in the current thread pool.
    fn frame(&self, mode: &str) -> Vec<f32>;
}

/// A pool of threads for each number of them that was asked for.
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
