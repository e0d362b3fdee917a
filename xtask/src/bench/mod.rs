//! `cargo xtask bench`: this project beside a peer, in one run, as ratios.

mod assets;

#[derive(clap::Subcommand)]
pub(crate) enum Bench {
    /// Writing all five assets, against a Python script that does it with OpenUSD
    Assets(assets::Args),
}

pub(crate) fn run(bench: &Bench) -> Result<(), String> {
    match bench {
        Bench::Assets(args) => assets::run(args),
    }
}
