//! `cargo xtask bench`: compares speed with peers in one run, as ratios.

mod assets;
mod bridge;
mod depth;
mod depthai;
mod generate;
mod load;
mod python;
mod record;
mod render;
mod scaling;
mod shutter;
mod stereo;
mod studio;
mod turns;
mod worlds;

#[derive(clap::Subcommand)]
pub(crate) enum Bench {
    /// Writing all five assets, compared with a Python script that uses OpenUSD
    Assets(assets::Args),
    /// The live filter between topics of ROS 2: delivery, latency and memory
    Bridge(bridge::Args),
    /// Depth frames, compared with Embree, Open3D and Mitsuba; then colour frames that take time
    #[command(disable_help_flag = true)]
    Render(render::Args),
    /// The engines and filters, compared with NumPy and DepthAI
    Depth(depth::Args),
    /// A virtual OAK for DepthAI programs: frames per second of the pipeline of its stereo example
    Depthai(depthai::Args),
    /// Data sets from a recipe, compared with Open3D and NumPy
    Generate(generate::Args),
    /// The stereo matcher, compared with OpenCV's
    Stereo(stereo::Args),
    /// Opening USD stages, compared with OpenUSD in Python; then the cost of colour relative to depth
    Load(load::Args),
    /// Calls of the Python package, compared with noise written in NumPy
    Python(python::Args),
    /// Recordings with point clouds as MCAP, compared with `mcap` in Python writing the same messages
    Record(record::Args),
    /// How costs grow with triangles, pixels, instances, disparities, frames and threads
    Scaling(scaling::Args),
    /// The page of `oaktwin studio` in a headless browser; requires npm and Chromium
    Studio(studio::Args),
    /// Depth of many worlds at once, compared with MuJoCo and Open3D
    Worlds(worlds::Args),
}

pub(crate) fn run(bench: &Bench) -> Result<(), String> {
    match bench {
        Bench::Assets(args) => assets::run(args),
        Bench::Bridge(args) => bridge::run(args),
        Bench::Render(args) => render::run(args),
        Bench::Depth(args) => depth::run(args),
        Bench::Depthai(args) => depthai::run(args),
        Bench::Generate(args) => generate::run(args),
        Bench::Stereo(args) => stereo::run(args),
        Bench::Load(args) => load::run(args),
        Bench::Python(args) => python::run(args),
        Bench::Record(args) => record::run(args),
        Bench::Scaling(args) => scaling::run(args),
        Bench::Studio(args) => studio::run(args),
        Bench::Worlds(args) => worlds::run(args),
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
