//! Checks of inertial parts and of their mounting.

use oaktwin_base::diagnostic::nearest;
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DVec3};

use super::values::{not_negative, positive, text};
use super::{Checked, evidence, sources};
use crate::document::Document;
use crate::{Catalog, Device, InertialPart};

pub(super) fn imu(doc: &Document<'_>, device: &Device, catalog: &Catalog) -> Checked {
    let Some(imu) = &device.imu else {
        return Ok(());
    };
    let rotations = [
        ("imu.rotation", Some(&imu.rotation)),
        ("imu.board_file_rotation", imu.board_file_rotation.as_ref()),
    ];
    for (place, rows) in rotations {
        let Some(rows) = rows else { continue };
        let rotation = DMat3::from_cols_array_2d(rows).transpose();
        let off = RigidTransform::new(rotation, DVec3::ZERO).orthonormality_error();
        if off > 1e-6 {
            return Err(doc.error(
                place,
                "not a rotation",
                "give three orthogonal rows of length 1 with determinant +1",
            ));
        }
    }
    for (i, id) in imu.parts.iter().enumerate() {
        if catalog.inertial_part(id).is_none() {
            let known: Vec<&str> = catalog
                .inertial_parts()
                .iter()
                .map(|part| part.id.as_str())
                .collect();
            let remedy = match nearest(id, known.iter().copied()).first() {
                Some(near) => format!("did you mean '{near}'? To add a part, describe it in a file"),
                None => format!(
                    "expected one of {}; to add another, describe it in a file",
                    known.join(", ")
                ),
            };
            return Err(doc.error(
                &format!("imu.parts.{i}"),
                format!("unknown inertial part {id:?}"),
                remedy,
            ));
        }
    }
    Ok(())
}

pub(crate) fn inertial_part(doc: &Document<'_>, part: &InertialPart) -> Checked {
    text(doc, "id", &part.id)?;
    text(doc, "kind", &part.kind)?;
    sources(doc, "", &part.sources)?;
    if let Some(spec) = &part.accelerometer {
        channel(
            doc,
            "accelerometer",
            &[("range_g", Some(spec.range_g)), ("step_ug", Some(spec.step_ug))],
            &spec.rates_hz,
            &[
                ("noise_density_ug", spec.noise_density_ug),
                ("random_walk_ug", spec.random_walk_ug),
            ],
        )?;
        sources(doc, "accelerometer.", &spec.sources)?;
    }
    if let Some(spec) = &part.gyroscope {
        channel(
            doc,
            "gyroscope",
            &[
                ("range_dps", Some(spec.range_dps)),
                ("step_mdps", Some(spec.step_mdps)),
            ],
            &spec.rates_hz,
            &[
                ("noise_density_mdps", spec.noise_density_mdps),
                ("random_walk_mdps", spec.random_walk_mdps),
            ],
        )?;
        sources(doc, "gyroscope.", &spec.sources)?;
    }
    if let Some(spec) = &part.magnetometer {
        let values = [("range_ut", spec.range_ut), ("step_ut", spec.step_ut)];
        channel(doc, "magnetometer", &values, &spec.rates_hz, &[])?;
        sources(doc, "magnetometer.", &spec.sources)?;
    }
    evidence(doc, part.evidence.iter().map(|e| e.about.as_str()), |about| {
        about.to_owned()
    })
}

fn channel(
    doc: &Document<'_>,
    table: &str,
    values: &[(&str, Option<f64>)],
    rates_hz: &[f64],
    densities: &[(&str, Option<[f64; 3]>)],
) -> Checked {
    for (key, value) in values {
        if let Some(value) = value {
            positive(doc, &format!("{table}.{key}"), *value)?;
        }
    }
    for (i, rate) in rates_hz.iter().enumerate() {
        positive(doc, &format!("{table}.rates_hz.{i}"), *rate)?;
    }
    for (key, axes) in densities {
        for (i, value) in axes.iter().flatten().enumerate() {
            not_negative(doc, &format!("{table}.{key}.{i}"), *value)?;
        }
    }
    Ok(())
}
