use clap::Args;
use oaktwin::render;

/// The number of threads.
#[derive(Args, Debug)]
pub(crate) struct ThreadArgs {
    /// The number of threads [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    threads: Option<u32>,
}

impl ThreadArgs {
    /// Sets the number of threads of the process.
    pub(crate) fn apply(&self) {
        if let Some(threads) = self.threads {
            render::use_threads(threads as usize);
        }
    }
}
