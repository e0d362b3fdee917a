//! `cargo xtask bench`: this project beside a peer, in one run, as ratios.

mod assets;
mod render;

#[derive(clap::Subcommand)]
pub(crate) enum Bench {
    /// Writing all five assets, against a Python script that does it with OpenUSD
    Assets(assets::Args),
    /// Depth frames, against Embree, Open3D and Mitsuba; `--help` lists what more it takes
    #[command(disable_help_flag = true)]
    Render(render::Args),
}

pub(crate) fn run(bench: &Bench) -> Result<(), String> {
    match bench {
        Bench::Assets(args) => assets::run(args),
        Bench::Render(args) => render::run(args),
    }
}
