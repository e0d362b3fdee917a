//! Exports: assets, images, numbers, and the commands that reproduce them.

use oaktwin::depth::parameters::choose;
use oaktwin::image::{Image, millimetres, npy, png};
use oaktwin::robot::{self, Attachment};
use oaktwin::usd::asset::{AssetOptions, Format, asset};
use oaktwin::usd::usdz;

use crate::file::File;
use crate::image::{Data, pixels};
use crate::protocol::{Export, ExportRequest, Failure};
use crate::snippet;
use crate::station::measured;
use crate::statistics;
use crate::studio::Studio;

/// Makes the file of a request.
pub(crate) fn export(studio: &Studio, request: &ExportRequest) -> Result<File, Failure> {
    let format = request.format.as_deref();
    match request.what {
        Export::Asset => usd(studio, request, format.unwrap_or("usd")),
        Export::Robot => robot(studio, request, format.unwrap_or_default()),
        Export::Image => image(studio, request, format.unwrap_or("png")),
        Export::Error => error_image(studio, request),
        Export::Statistics => statistics::file(studio, request, format.unwrap_or("json")),
        Export::Parameters => Ok(File::text("parameters.toml", snippet::toml(&request.state)?)),
        Export::Command => Ok(File::text("render.sh", snippet::command(studio, request)?)),
        Export::Python => Ok(File::text("render.py", snippet::python(studio, request)?)),
    }
}

fn usd(studio: &Studio, request: &ExportRequest, format: &str) -> Result<File, Failure> {
    let format = match format {
        "usd" => Format::Usd,
        "usda" => Format::Usda,
        "usdz" => Format::Usdz,
        _ => return Err(unknown(format, "usd, usda or usdz")),
    };
    let twin = request.state.twin(studio)?;
    let options = AssetOptions {
        lens: request.state.lens()?,
        extended_disparity: request.state.extended_disparity,
        ..AssetOptions::default()
    };
    let failed = |error: oaktwin::usd::asset::AssetError| Failure::from(error.to_string());
    let asset = asset(&twin, &options).map_err(failed)?;
    Ok(File::new(
        asset.file_name(format),
        asset.bytes(format).map_err(failed)?,
    ))
}

/// Makes a zip archive of a description for robots and simulators, because each has several files.
fn robot(studio: &Studio, request: &ExportRequest, format: &str) -> Result<File, Failure> {
    let format: robot::Format = choose("format", format).map_err(|error| Failure::of("format", &error))?;
    let twin = request.state.twin(studio)?;
    let exported = robot::export(&studio.catalog, &twin, &Attachment::default(), format);
    let robot::RobotFiles { files, findings } = exported.map_err(|error| Failure::from(error.to_string()))?;
    let files: Vec<(&str, &[u8])> = files
        .iter()
        .map(|(name, bytes)| (name.as_str(), bytes.as_slice()))
        .collect();
    let bytes = usdz::pack(&files).map_err(|error| Failure::from(error.to_string()))?;
    Ok(File {
        findings,
        ..File::new(format!("{}_{format}.zip", twin.device.id), bytes)
    })
}

fn image(studio: &Studio, request: &ExportRequest, format: &str) -> Result<File, Failure> {
    let name = request
        .image
        .ok_or_else(|| Failure::of("image", "is missing; name an image"))?;
    let seen = measured(studio, &request.scene, &request.state, request.size, vec![name])?;
    let missing = || Failure::of("image", "this engine has no such image; choose another");
    let pixels = pixels(&seen, name).ok_or_else(missing)?;
    let bytes = match (&pixels.data, format) {
        (Data::Color(image), "npy") => array(image, &[4], image.pixels().as_flattened())?,
        (Data::Color(image), "png") => encoded(png::encode(image))?,
        (Data::Metres(metres), "npy") => array(metres, &[], metres.pixels())?,
        (Data::Metres(metres), "png") => encoded(png::encode(&millimetres::from_metres(metres)))?,
        (Data::Bytes(image), "npy") => array(image, &[], image.pixels())?,
        (Data::Bytes(image), "png") => encoded(png::encode(&**image))?,
        _ => return Err(unknown(format, "npy or png")),
    };
    let stem = serde_json::to_value(name).ok();
    let stem = stem.as_ref().and_then(|name| name.as_str()).unwrap_or("image");
    Ok(File::new(format!("{stem}.{format}"), bytes))
}

/// The measured minus the true depth in metres; NaN where there is none of them.
fn error_image(studio: &Studio, request: &ExportRequest) -> Result<File, Failure> {
    let seen = measured(studio, &request.scene, &request.state, request.size, Vec::new())?;
    let image = &seen.capture.distance.0;
    let truth = seen
        .truth()
        .ok_or_else(|| Failure::from("there is no exact depth".to_owned()))?;
    let is_valid = |z: f32| z.is_finite() && z > 0.0;
    let errors: Vec<f32> = (image.pixels().iter().zip(truth.pixels()))
        .map(
            |(&measured, &exact)| match is_valid(measured) && is_valid(exact) {
                true => measured - exact,
                false => f32::NAN,
            },
        )
        .collect();
    Ok(File::new("error.npy", array(image, &[], &errors)?))
}

fn array<P, T: npy::NpyElement>(image: &Image<P>, more: &[usize], values: &[T]) -> Result<Vec<u8>, Failure> {
    let shape = [&[image.height() as usize, image.width() as usize], more].concat();
    encoded(npy::encode(&shape, values))
}

fn encoded(bytes: Result<Vec<u8>, oaktwin::image::CodecError>) -> Result<Vec<u8>, Failure> {
    bytes.map_err(|error| Failure::from(error.to_string()))
}

fn unknown(format: &str, formats: &str) -> Failure {
    Failure::of("format", &format!("unknown format '{format}'; choose {formats}"))
}
