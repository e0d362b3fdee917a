//! `cargo xtask bench`: this project beside a peer, in one run, as ratios.

mod assets;
mod depth;
mod load;
mod python;
mod render;
mod stereo;
mod turns;

#[derive(clap::Subcommand)]
pub(crate) enum Bench {
    /// Writing all five assets, against a Python script that does it with OpenUSD
    Assets(assets::Args),
    /// Depth frames, against Embree, Open3D and Mitsuba; `--help` lists what more it takes
    #[command(disable_help_flag = true)]
    Render(render::Args),
    /// The sensor models and DepthAI's filters, against NumPy and DepthAI
    Depth(depth::Args),
    /// The stereo matcher, against OpenCV's
    Stereo(stereo::Args),
    /// Opening USD stages, against OpenUSD in Python; then what colour costs beside depth
    Load(load::Args),
    /// The Python package's calls, against noise of one's own in NumPy
    Python(python::Args),
}

pub(crate) fn run(bench: &Bench) -> Result<(), String> {
    match bench {
        Bench::Assets(args) => assets::run(args),
        Bench::Render(args) => render::run(args),
        Bench::Depth(args) => depth::run(args),
        Bench::Stereo(args) => stereo::run(args),
        Bench::Load(args) => load::run(args),
        Bench::Python(args) => python::run(args),
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    let middle = values.len() / 2;
    match values.get(middle) {
        None => f64::NAN,
        Some(upper) if values.len() % 2 == 1 => *upper,
        Some(upper) => (values[middle - 1] + upper) / 2.0,
    }
}

#[cfg(test)]
mod tests {
    use super::median;

    #[test]
    fn medians() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), 2.5);
        assert!(median(Vec::new()).is_nan());
    }
}
