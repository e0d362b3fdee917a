//! Checks of a file's contents that go beyond its schema.

mod depth;
mod inertial;
mod values;

use oaktwin_base::diagnostic::{fold_name, nearest};
use oaktwin_camera::math::DVec3;

use crate::document::Document;
use crate::{Camera, Catalog, CatalogError, DepthSensor, Device, Role, Sensor, ShutterKind, Sources};
use values::{ascending, between, not_negative, one_of, positive, prim_name, text, unique_prim};

pub(crate) use inertial::inertial_part;

type Checked = Result<(), CatalogError>;

/// A side of an image beyond which something is wrong.
const LARGEST_SIDE_PX: u32 = 65_535;

pub(crate) fn sensor(doc: &Document<'_>, sensor: &Sensor) -> Checked {
    text(doc, "id", &sensor.id)?;
    for (key, (width, height)) in [
        ("native_resolution", sensor.native_resolution),
        ("used_resolution", sensor.used_resolution),
    ] {
        let sides = 1..=LARGEST_SIDE_PX;
        if !sides.contains(&width) || !sides.contains(&height) {
            return Err(doc.error(
                key,
                format!("a resolution of {width}x{height}"),
                format!("give [width, height] in pixels, each 1 to {LARGEST_SIDE_PX}"),
            ));
        }
    }
    let (native, used) = (sensor.native_resolution, sensor.used_resolution);
    if used.0 > native.0 || used.1 > native.1 {
        return Err(doc.error(
            "used_resolution",
            format!(
                "{}x{} is more than the array's {}x{}",
                used.0, used.1, native.0, native.1
            ),
            "give a mode that the sensor has",
        ));
    }
    positive(doc, "native_pixel_size_um", sensor.native_pixel_size_um)?;
    positive(doc, "pixel_size_um", sensor.pixel_size_um)?;
    if let Some(range) = sensor.depth_range_m {
        ascending(doc, "depth_range_m", range)?;
    }
    for (key, value) in [
        ("megapixels", sensor.megapixels),
        ("wavelength_nm", sensor.wavelength_nm),
    ] {
        if let Some(value) = value {
            positive(doc, key, value)?;
        }
    }
    match (sensor.shutter, sensor.readout_ms) {
        (Some(ShutterKind::Rolling), Some(readout_ms)) => positive(doc, "readout_ms", readout_ms)?,
        (Some(ShutterKind::Rolling), None) => {
            let remedy = "give the time from the first row to the last in ms";
            return Err(doc.error("readout_ms", "is absent of a rolling shutter".to_owned(), remedy));
        }
        (_, Some(_)) => {
            let remedy = "set shutter to \"rolling\", or remove it";
            return Err(doc.error("readout_ms", "is for rolling shutters".to_owned(), remedy));
        }
        (_, None) => {}
    }
    sources(doc, "", &sensor.sources)?;
    evidence(doc, sensor.evidence.iter().map(|e| e.about.as_str()), |about| {
        about.to_owned()
    })
}

pub(crate) fn device(doc: &Document<'_>, device: &Device, catalog: &Catalog) -> Checked {
    text(doc, "name", &device.name)?;
    prim_name(doc, "id", &device.id)?;
    prim_name(doc, "prim", &device.prim)?;
    names_are_free(doc, device, catalog)?;
    body(doc, device)?;
    inertial::imu(doc, device, catalog)?;
    projector(doc, device)?;
    if device.cameras.is_empty() {
        return Err(doc.error("camera", "the device has no cameras", "add a [[camera]]"));
    }
    let mut prims: Vec<&str> = vec!["TemplateRenderProducts", "Imu_Sensor", "visuals", "Looks"];
    for (i, spec) in device.cameras.iter().enumerate() {
        let at = format!("camera.{i}");
        if device.cameras[..i].iter().any(|other| other.role == spec.role) {
            return Err(doc.error(
                &format!("{at}.role"),
                format!("a second camera with the role '{}'", spec.role),
                "give each camera its own",
            ));
        }
        unique_prim(doc, &format!("{at}.prim"), &spec.prim, &mut prims)?;
        camera(doc, &at, spec, catalog)?;
    }
    baseline(doc, device)?;
    for (i, spec) in device.depth_sensors.iter().enumerate() {
        let at = format!("depth_sensor.{i}");
        let same = |other: &&DepthSensor| (other.kind, other.pair()) == (spec.kind, spec.pair());
        if let Some(other) = device.depth_sensors[..i].iter().find(same) {
            return Err(doc.error(
                &format!("{at}.kind"),
                format!(
                    "a second depth sensor of this kind with the cameras of {}",
                    other.prim
                ),
                "remove it, or change its cameras",
            ));
        }
        unique_prim(doc, &format!("{at}.prim"), &spec.prim, &mut prims)?;
        depth::depth_sensor(doc, &at, spec, device)?;
    }
    for (i, table) in device.accuracy.iter().enumerate() {
        let at = format!("accuracy.{i}");
        let is_own = |prim: &String| device.depth_sensors.iter().any(|sensor| sensor.prim == *prim);
        if let Some(prim) = table.depth_sensor.as_ref().filter(|prim| !is_own(prim)) {
            return Err(doc.error(
                &format!("{at}.depth_sensor"),
                format!("the device has no depth sensor {prim:?}"),
                "name the prim of one of its depth sensors",
            ));
        }
        depth::accuracy(doc, &at, table)?;
    }
    sources(doc, "", &device.sources)?;
    sources(doc, "body.", &device.body.sources)?;
    if let Some(imu) = &device.imu {
        sources(doc, "imu.", &imu.sources)?;
    }
    evidence(doc, device.evidence.iter().map(|e| e.about.as_str()), |about| {
        indexed(device, about)
    })
}

/// Two files of one load must not describe the same entry.
pub(crate) fn new_id(doc: &Document<'_>, id: &str, seen: &mut Vec<String>) -> Checked {
    let folded = fold_name(id);
    if seen.contains(&folded) {
        return Err(doc.error(
            "id",
            format!("a second file describes {id:?}"),
            "remove one of them",
        ));
    }
    seen.push(folded);
    Ok(())
}

fn names_are_free(doc: &Document<'_>, device: &Device, catalog: &Catalog) -> Checked {
    let others = || {
        let id = fold_name(&device.id);
        catalog
            .devices()
            .iter()
            .filter(move |other| fold_name(&other.id) != id)
    };
    for (name, place) in device.named_places() {
        let folded = fold_name(name);
        let is_taken = |other: &&Device| other.names().any(|other| fold_name(other) == folded);
        if let Some(other) = others().find(is_taken) {
            return Err(taken(doc, &place, name, other));
        }
    }
    match others().find(|other| fold_name(&other.prim) == fold_name(&device.prim)) {
        Some(other) => Err(taken(doc, "prim", &device.prim, other)),
        None => Ok(()),
    }
}

fn taken(doc: &Document<'_>, place: &str, name: &str, other: &Device) -> CatalogError {
    doc.error(
        place,
        format!("{name:?} already means the {}", other.name),
        format!(
            "choose another, or use the id '{}' to replace that entry",
            other.id
        ),
    )
}

fn body(doc: &Document<'_>, device: &Device) -> Checked {
    for (i, side) in device.body.dimensions_mm.into_iter().enumerate() {
        positive(doc, &format!("body.dimensions_mm.{i}"), side)?;
    }
    positive(doc, "body.mass_g", device.body.mass_g)
}

/// More dots than any projector has.
const MAX_DOTS: u32 = 1_000_000;

fn projector(doc: &Document<'_>, device: &Device) -> Checked {
    let Some(spec) = &device.projector else {
        return Ok(());
    };
    if device.body.projector_mm.is_none() {
        return Err(doc.error(
            "projector",
            "the projector has no position",
            "give its position in the body as body.projector_mm",
        ));
    }
    if !(1..=MAX_DOTS).contains(&spec.dots) {
        return Err(doc.error(
            "projector.dots",
            format!("{} dots", spec.dots),
            format!("give 1 to {MAX_DOTS}"),
        ));
    }
    for (key, value) in [("hfoi_deg", spec.hfoi_deg), ("vfoi_deg", spec.vfoi_deg)] {
        if !(1.0..=170.0).contains(&value) {
            return Err(doc.error(
                &format!("projector.{key}"),
                format!("a field of illumination of {value}°"),
                "give degrees, 1 to 170",
            ));
        }
    }
    for (key, value) in [
        ("wavelength_nm", spec.wavelength_nm),
        ("dot_width_mrad", spec.dot_width_mrad),
        ("brightness", spec.brightness),
    ] {
        positive(doc, &format!("projector.{key}"), value)?;
    }
    sources(doc, "projector.", &spec.sources)
}

fn camera(doc: &Document<'_>, at: &str, spec: &Camera, catalog: &Catalog) -> Checked {
    let place = |key: &str| format!("{at}.{key}");
    if catalog.sensor(&spec.sensor).is_none() {
        let known: Vec<&str> = catalog.sensors().iter().map(|s| s.id.as_str()).collect();
        let remedy = match nearest(&spec.sensor, known.iter().copied()).first() {
            Some(near) => format!("did you mean '{near}'? To add a sensor, describe it in a file"),
            None => format!(
                "expected one of {}; to add another, describe it in a file",
                known.join(", ")
            ),
        };
        return Err(doc.error(
            &place("sensor"),
            format!("unknown sensor {:?}", spec.sensor),
            remedy,
        ));
    }
    between(
        doc,
        &place("hfov_deg"),
        spec.hfov_deg,
        180.0,
        "a pinhole sees less than 180 degrees",
    )?;
    if let Some(hfov_deg) = spec.fisheye_hfov_deg {
        between(
            doc,
            &place("fisheye_hfov_deg"),
            hfov_deg,
            360.0,
            "a lens sees less than 360 degrees",
        )?;
    }
    if let Some(max_fov_deg) = spec.max_fov_deg {
        between(
            doc,
            &place("max_fov_deg"),
            max_fov_deg,
            360.0,
            "give the field of view in degrees",
        )?;
    }
    if !(-90.0..=90.0).contains(&spec.pitch_deg) {
        return Err(doc.error(
            &place("pitch_deg"),
            format!("a pitch of {} degrees", spec.pitch_deg),
            "give the angle below the x axis, -90 to 90 degrees",
        ));
    }
    positive(doc, &place("focus_distance"), spec.focus_distance)?;
    one_of(
        doc,
        &place("projection"),
        &spec.projection,
        &["perspective", "orthographic"],
    )?;
    one_of(
        doc,
        &place("stereo_role"),
        &spec.stereo_role,
        &["mono", "left", "right"],
    )?;
    not_negative(doc, &place("f_stop"), spec.f_stop)?;
    ascending(doc, &place("clipping_range_m"), spec.clipping_range_m)?;
    sources(doc, &place(""), &spec.sources)
}

fn baseline(doc: &Document<'_>, device: &Device) -> Checked {
    let pair = (device.camera(Role::Left), device.camera(Role::Right));
    let error = |problem: String, remedy: &str| Err(doc.error("stereo_baseline_mm", problem, remedy));
    match (pair, device.stereo_baseline_mm) {
        ((Some(left), Some(right)), Some(baseline_mm)) => {
            positive(doc, "stereo_baseline_mm", baseline_mm)?;
            let apart = DVec3::from(left.position_mm).distance(DVec3::from(right.position_mm));
            if (apart - baseline_mm).abs() <= 1e-6 {
                return Ok(());
            }
            error(
                format!("{baseline_mm} mm, but the left and right cameras are {apart} mm apart"),
                "make the positions and the baseline agree",
            )
        }
        ((Some(_), Some(_)), None) => error(
            "the stereo pair has no baseline".to_owned(),
            "add 'stereo_baseline_mm = ...'",
        ),
        (_, Some(baseline_mm)) => error(
            format!("a baseline of {baseline_mm} mm without a left and a right camera"),
            "remove it, or add the cameras",
        ),
        (_, None) => Ok(()),
    }
}

/// The keys of `sources` must be keys of its table.
fn sources(doc: &Document<'_>, table: &str, sources: &Sources) -> Checked {
    for key in sources.keys() {
        if !doc.contains(&format!("{table}{key}")) {
            return Err(doc.error(
                &format!("{table}sources.{key}"),
                format!("a source for {key:?}, which is not in this table"),
                "name a key of the table, or remove the entry",
            ));
        }
    }
    Ok(())
}

fn evidence<'a>(
    doc: &Document<'_>,
    abouts: impl Iterator<Item = &'a str>,
    place_of: impl Fn(&str) -> String,
) -> Checked {
    for (i, about) in abouts.enumerate() {
        if !doc.contains(&place_of(about)) {
            return Err(doc.error(
                &format!("evidence.{i}.about"),
                format!("evidence about {about:?}, which is not in this file"),
                "name a key as in 'camera.left.hfov_deg' or 'body.mass_g'",
            ));
        }
    }
    Ok(())
}

/// `camera.left.hfov_deg` as a path of indices, `camera.1.hfov_deg`; unchanged where it names no such entry.
fn indexed(device: &Device, about: &str) -> String {
    let parts: Vec<&str> = about.splitn(3, '.').collect();
    let [table, entry, key] = parts[..] else {
        return about.to_owned();
    };
    let index = match table {
        "camera" => device
            .cameras
            .iter()
            .position(|camera| camera.role.as_str() == entry),
        "depth_sensor" => device
            .depth_sensors
            .iter()
            .position(|sensor| sensor.prim == entry || sensor.kind.as_str() == entry),
        _ => None,
    };
    index.map_or_else(|| about.to_owned(), |index| format!("{table}.{index}.{key}"))
}
