use oaktwin_camera::{ApertureOffsets, UsdOptics};
use serde::Serialize;

use crate::{AccuracyBand, Catalog, DepthKind, Device, Role, Sensor, Twin, TwinCamera};

/// A table of text. Each row has as many cells as the header.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct TextTable {
    /// The title.
    pub title: String,
    /// The columns.
    pub header: Vec<String>,
    /// The rows.
    pub rows: Vec<Vec<String>>,
}

impl TextTable {
    fn new(title: &str, header: impl IntoIterator<Item = String>) -> Self {
        Self {
            title: title.to_owned(),
            header: header.into_iter().collect(),
            rows: Vec::new(),
        }
    }

    /// Adds a row with a label and a cell for each compared item.
    fn row<T>(&mut self, label: &str, items: &[T], cell: impl Fn(&T) -> String) {
        let mut row = vec![label.to_owned()];
        row.extend(items.iter().map(cell));
        self.rows.push(row);
    }
}

/// Returns the comparison tables of Luxonis' parameter sheet for devices, in its order and wording: the USD camera parameters of
/// each (mm), the depth sensors, the accuracy by range, and the features. A table without contents is left out.
///
/// # Panics
/// Panics if the catalog does not contain a sensor of a device; it contains the sensors of its own devices.
#[must_use]
pub fn compare(catalog: &Catalog, devices: &[&Device]) -> Vec<TextTable> {
    let twins: Vec<Twin> = devices.iter().map(|device| catalog.nominal(device)).collect();
    let mut tables: Vec<TextTable> = twins.iter().map(cameras).collect();
    tables.push(depth_sensors(&twins));
    tables.push(accuracy(devices));
    tables.push(features(catalog, devices));
    tables.retain(|table| table.header.len() > 1 && !table.rows.is_empty());
    tables
}

/// Returns the USD camera parameters of one device, mm.
fn cameras(twin: &Twin) -> TextTable {
    let header = [
        "Camera",
        "focalLength",
        "hAperture",
        "vAperture",
        "hOffset",
        "vOffset",
    ];
    let title = format!("{} ({})", twin.device.name, twin.device.generation);
    let mut table = TextTable::new(&title, header.map(str::to_owned));
    let symmetric = match (twin.camera(Role::Left), twin.camera(Role::Right)) {
        (Some(left), Some(right)) => optics(left) == optics(right) && left.spec.sensor == right.spec.sensor,
        _ => false,
    };
    for camera in &twin.cameras {
        let label = match camera.spec.role {
            Role::Rgb => "RGB",
            Role::Tof => "ToF",
            Role::Left if symmetric => "Stereo",
            Role::Right if symmetric => continue,
            Role::Left => "Left",
            Role::Right => "Right",
        };
        table
            .rows
            .push(optics_row(format!("{label} ({})", camera.spec.sensor), camera));
    }
    for sensor in &twin.depth_sensors {
        let label = match twin.depth_sensors.len() {
            1 => "Pseudo Depth".to_owned(),
            _ => format!("Pseudo Depth ({})", kind_name(sensor.spec.kind)),
        };
        if let Some(camera) = twin.camera(sensor.spec.camera) {
            table.rows.push(optics_row(label, camera));
        }
    }
    table
}

fn optics(camera: &TwinCamera) -> UsdOptics {
    UsdOptics::from_intrinsics(&camera.intrinsics, camera.pixel_size_um, ApertureOffsets::OpenUsd)
}

fn optics_row(label: String, camera: &TwinCamera) -> Vec<String> {
    let optics = optics(camera);
    vec![
        label,
        format!("{:.4}", optics.focal_length_mm),
        short(optics.horizontal_aperture_mm),
        short(optics.vertical_aperture_mm),
        short(optics.horizontal_aperture_offset_mm),
        short(optics.vertical_aperture_offset_mm),
    ]
}

fn depth_sensors(twins: &[Twin]) -> TextTable {
    let sensors: Vec<_> = twins
        .iter()
        .flat_map(|twin| twin.depth_sensors.iter().map(move |sensor| (twin, sensor)))
        .collect();
    let names = sensors
        .iter()
        .map(|(twin, sensor)| match twin.depth_sensors.len() {
            1 => twin.device.name.clone(),
            _ => format!("{} ({})", twin.device.name, kind_name(sensor.spec.kind)),
        });
    let mut table = TextTable::new(
        "Depth sensors",
        std::iter::once("Parameter".to_owned()).chain(names),
    );
    table.row("focalLengthPixel", &sensors, |(_, s)| short(s.focal_length_px));
    table.row("minDistance (m)", &sensors, |(_, s)| short(s.spec.min_distance_m));
    table.row("maxDistance (m)", &sensors, |(_, s)| short(s.spec.max_distance_m));
    table.row("baselineMM", &sensors, |(_, s)| short(s.spec.baseline_mm));
    table
}

/// Returns the accuracy by range: the first table of each device, which is the sheet's.
fn accuracy(devices: &[&Device]) -> TextTable {
    let names = devices.iter().map(|device| match device.accuracy.first() {
        Some(table) if device.depth_sensors.len() > 1 => {
            format!("{} ({})", device.name, kind_name(table.sensor))
        }
        _ => format!("{} ({})", device.name, device.generation),
    });
    let mut table = TextTable::new(
        "Accuracy by range",
        std::iter::once("Range".to_owned()).chain(names),
    );
    let bands = |device: &Device| {
        device
            .accuracy
            .first()
            .map_or(&[][..], |table| &table.bands)
            .to_vec()
    };
    let mut ranges: Vec<(f64, f64)> = devices
        .iter()
        .flat_map(|device| bands(device))
        .map(|band| (band.from_m, band.to_m))
        .collect();
    ranges.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    ranges.dedup();
    for range in ranges {
        let label = match range {
            (from, to) if from > 0.0 => format!("{from}-{to}m"),
            (_, to) => format!("< {to}m"),
        };
        table.row(&label, devices, |device| {
            let here: Vec<String> = bands(device)
                .iter()
                .filter(|band| (band.from_m, band.to_m) == range)
                .map(band_cell)
                .collect();
            if here.is_empty() {
                not_available()
            } else {
                here.join(", ")
            }
        });
    }
    table
}

fn band_cell(band: &AccuracyBand) -> String {
    let figure = band
        .limit("%")
        .map_or_else(not_available, |limit| format!("< {limit}"));
    with_remark(figure, band.condition.as_deref())
}

fn features(catalog: &Catalog, devices: &[&Device]) -> TextTable {
    let names = devices
        .iter()
        .map(|device| format!("{} ({})", device.name, device.generation));
    let mut table = TextTable::new("Features", std::iter::once("Feature".to_owned()).chain(names));
    let sensor = |device: &Device, role: Role, cell: fn(&Sensor) -> String| {
        let Some(camera) = device.camera(role) else {
            return "None".to_owned();
        };
        let cell = catalog
            .sensor(&camera.sensor)
            .map_or_else(|| camera.sensor.clone(), cell);
        with_remark(cell, camera.remark.as_deref())
    };
    let hfov = |device: &Device, role: Role| {
        device
            .camera(role)
            .map_or_else(not_available, |camera| format!("~{}°", camera.hfov_deg))
    };
    table.row("Platform", devices, |device| {
        device.platform.clone().unwrap_or_else(not_available)
    });
    table.row("RGB Sensor", devices, |device| {
        sensor(device, Role::Rgb, |sensor| {
            let megapixels = sensor.megapixels.map(|megapixels| format!("{megapixels} MP"));
            with_remark(
                match &sensor.manufacturer {
                    Some(manufacturer) => format!("{manufacturer} {}", sensor.id),
                    None => sensor.id.clone(),
                },
                megapixels.as_deref(),
            )
        })
    });
    table.row("Stereo Sensor", devices, |device| {
        sensor(device, Role::Left, |sensor| sensor.id.clone())
    });
    table.row("ToF Sensor", devices, |device| {
        sensor(device, Role::Tof, |sensor| {
            let size = sensor.used_size();
            format!("{} ({size})", sensor.id)
        })
    });
    table.row("RGB HFOV", devices, |device| hfov(device, Role::Rgb));
    table.row("Stereo HFOV", devices, |device| hfov(device, Role::Left));
    table.row("ToF HFOV", devices, |device| hfov(device, Role::Tof));
    table.row("Stereo Baseline", devices, |device| {
        device
            .stereo_baseline_mm
            .map_or_else(not_available, |baseline| format!("{baseline} mm"))
    });
    table.row("Close-Range Accuracy", devices, |device| close_range(device));
    table.row("IMU", devices, |device| {
        device
            .imu
            .as_ref()
            .map_or_else(not_available, |imu| imu.model.clone())
    });
    table.row("Data Source", devices, |device| {
        device.data_source.clone().unwrap_or_else(not_available)
    });
    table
}

/// Returns the sheet's line, or the first band of devices that have none.
fn close_range(device: &Device) -> String {
    if let Some(headline) = &device.accuracy_headline {
        return headline.comparison.clone();
    }
    let band = device.accuracy.first().and_then(|table| table.bands.first());
    band.map_or_else(not_available, |band| match band.limit("%") {
        Some(limit) => with_remark(format!("< {limit} at {}m", band.to_m), band.condition.as_deref()),
        None => not_available(),
    })
}

fn not_available() -> String {
    "N/A".to_owned()
}

fn with_remark(text: String, remark: Option<&str>) -> String {
    match remark {
        Some(remark) => format!("{text} ({remark})"),
        None => text,
    }
}

const fn kind_name(kind: DepthKind) -> &'static str {
    match kind {
        DepthKind::Stereo => "Stereo",
        DepthKind::Tof => "ToF",
    }
}

/// Formats with one to three decimals.
fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    let trimmed = text.trim_end_matches('0');
    if trimmed.ends_with('.') {
        format!("{trimmed}0")
    } else {
        trimmed.to_owned()
    }
}
