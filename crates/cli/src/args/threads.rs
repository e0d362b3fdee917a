use clap::Args;
use oaktwin::render;

/// On how many threads.
#[derive(Args, Debug)]
pub(crate) struct ThreadArgs {
    /// Threads; by default one a core
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: Option<u32>,
}

impl ThreadArgs {
    /// For all that follows.
    pub(crate) fn apply(&self) {
        if let Some(threads) = self.threads {
            render::use_threads(threads as usize);
        }
    }
}
