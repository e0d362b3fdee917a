use clap::Args;
use clap::builder::BoolishValueParser;
use oaktwin::render::OpenOptions;
use oaktwin::scene::Up;
use oaktwin::usd::stage::SceneLimit;

use super::choice::parser;
use super::limit;
use crate::context::Result;

/// The options for opening a scene.
#[derive(Args, Debug)]
pub(crate) struct SceneArgs {
    /// The time code of a USD stage
    #[arg(long, value_name = "T")]
    pub(crate) time: Option<f64>,

    /// The subdivision level of a USD stage's meshes (Isaac Sim renders level 0)
    #[arg(
        long,
        value_name = "N",
        default_value_t = 0,
        value_parser = clap::value_parser!(u32).range(0..=8)
    )]
    pub(crate) subdivide: u32,

    /// The up axis of a glTF, Collada, OBJ, STL or PLY file [default: the file's or its format's]
    #[arg(long, value_parser = parser::<Up>())]
    pub(crate) up: Option<Up>,

    /// Metres per unit of a mesh file, or per unit that it states [default: 1]
    #[arg(long, value_name = "METRES")]
    pub(crate) scale: Option<f64>,

    /// Let a glTF file name files outside its folder; only for trusted files
    #[arg(long)]
    pub(crate) allow_outside: bool,

    /// Give plain surfaces the fine texture of paint, wood or cloth [default: off; coverage: on]
    ///
    /// Stereo cameras match surfaces by their texture. Surfaces with a texture of their own keep it.
    #[arg(
        long,
        value_name = "on|off",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "on",
        hide_possible_values = true,
        value_parser = BoolishValueParser::new()
    )]
    pub(crate) micro_texture: Option<bool>,

    /// The reflectance at 940 nm of a material or a label, 0 to 1; repeatable [default: its colour's]
    ///
    /// The stereo pair, its dots and time of flight see it, and rgb does not. It is even: textures are not seen.
    #[arg(long, value_name = "NAME=VALUE", value_parser = reflectance)]
    pub(crate) infrared: Vec<(String, f64)>,

    #[arg(
        long,
        value_name = "FACTOR",
        default_value = "1",
        value_parser = limit::parse,
        help = limit::HELP
    )]
    pub(crate) scene_limit: SceneLimit,
}

impl SceneArgs {
    pub(crate) fn open_options(&self) -> Result<OpenOptions> {
        if let Some(time) = self.time.filter(|time| !time.is_finite()) {
            return Err(format!("--time: must be a finite number (got {time})").into());
        }
        Ok(OpenOptions {
            time: self.time,
            subdivide: self.subdivide,
            limit: self.scene_limit,
            up: self.up,
            scale: checked_scale(self.scale)?,
            allow_outside: self.allow_outside,
            texture_coordinates: false,
            micro_texture: self.micro_texture.unwrap_or(false),
            infrared: self.infrared.iter().cloned().collect(),
        })
    }
}

/// `NAME=VALUE`
fn reflectance(text: &str) -> std::result::Result<(String, f64), String> {
    let parts = text.rsplit_once('=').filter(|(name, _)| !name.is_empty());
    let (name, value) = parts.ok_or("expected NAME=VALUE")?;
    let value = value
        .trim()
        .parse()
        .map_err(|_| format!("{value} is not a number"))?;
    Ok((name.to_owned(), value))
}

/// Checks the metres per unit of a mesh file.
pub(crate) fn checked_scale(scale: Option<f64>) -> Result<Option<f64>> {
    match scale.filter(|scale| !(scale.is_finite() && *scale > 0.0)) {
        Some(scale) => Err(format!("--scale: must be a finite number > 0 (got {scale})").into()),
        None => Ok(scale),
    }
}
