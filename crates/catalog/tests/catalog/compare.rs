//! The comparison tables against the cells that the sheet prints, copied by hand.

use oaktwin_catalog::{Catalog, Device, TextTable, compare};

fn all() -> Vec<TextTable> {
    let catalog = Catalog::builtin();
    let devices: Vec<&Device> = catalog.sheet().collect();
    compare(catalog, &devices)
}

/// The sheet writes 3.84 as 3.840 in some places: numbers compare without the zeros at their end.
fn plain(cell: &str) -> String {
    match cell.parse::<f64>() {
        Ok(number) => number.to_string(),
        Err(_) => cell.to_owned(),
    }
}

#[track_caller]
fn assert_rows(rows: &[Vec<String>], printed: &[&[&str]]) {
    let rows: Vec<Vec<String>> = rows
        .iter()
        .map(|row| row.iter().map(|cell| plain(cell)).collect())
        .collect();
    let printed: Vec<Vec<String>> = printed
        .iter()
        .map(|row| row.iter().map(|cell| plain(cell)).collect())
        .collect();
    assert_eq!(rows, printed);
}

#[test]
fn camera_parameters() {
    let tables = all();
    assert_eq!(
        tables[0].header,
        [
            "Camera",
            "focalLength",
            "hAperture",
            "vAperture",
            "hOffset",
            "vOffset"
        ]
    );
    assert_eq!(tables[0].title, "OAK-D Pro PoE (RVC2)");
    assert_rows(
        &tables[0].rows,
        &[
            &["RGB (IMX378)", "4.7626", "5.952", "3.348", "0.0", "0.0"],
            &["Stereo (OV9282)", "2.4138", "3.84", "2.4", "0.0", "0.0"],
            &["Pseudo Depth", "2.4138", "3.84", "2.4", "0.0", "0.0"],
        ],
    );
    assert_eq!(tables[1].title, "OAK-D Pro W PoE (RVC2)");
    assert_rows(
        &tables[1].rows,
        &[
            &["RGB (IMX378)", "3.5467", "5.952", "3.348", "0.0", "0.0"],
            &["Stereo (OV9282)", "1.6987", "3.84", "2.4", "0.0", "0.0"],
            &["Pseudo Depth", "1.6987", "3.84", "2.4", "0.0", "0.0"],
        ],
    );
    assert_eq!(tables[2].title, "OAK4-D (RVC4)");
    assert_rows(
        &tables[2].rows,
        &[
            &["RGB (IMX586)", "4.7442", "6.400", "4.800", "0.0", "0.0"],
            &["Stereo (OV9282)", "2.4138", "3.84", "2.4", "0.0", "0.0"],
            &["Pseudo Depth", "2.4138", "3.84", "2.4", "0.0", "0.0"],
        ],
    );
    assert_eq!(tables[3].title, "OAK4-D Wide (RVC4)");
    assert_rows(
        &tables[3].rows,
        &[
            &["RGB (IMX586)", "3.3137", "6.400", "4.800", "0.0", "0.0"],
            &["Stereo (OV9282)", "1.6987", "3.84", "2.4", "0.0", "0.0"],
            &["Pseudo Depth", "1.6987", "3.84", "2.4", "0.0", "0.0"],
        ],
    );
    assert_eq!(tables[4].title, "OAK-D ToF (RVC2)");
    assert_rows(
        &tables[4].rows,
        &[
            &["ToF (33D)", "3.1991", "4.480", "3.360", "0.0", "0.0"],
            &["Stereo (OV9782)", "2.2882", "3.840", "2.400", "0.0", "0.0"],
            &["Pseudo Depth (Stereo)", "2.2882", "3.840", "2.400", "0.0", "0.0"],
            &["Pseudo Depth (ToF)", "3.1991", "4.480", "3.360", "0.0", "0.0"],
        ],
    );
}

#[test]
fn depth_sensors() {
    let table = &all()[5];
    assert_eq!(
        table.header,
        [
            "Parameter",
            "OAK-D Pro PoE",
            "OAK-D Pro W PoE",
            "OAK4-D",
            "OAK4-D Wide",
            "OAK-D ToF (Stereo)",
            "OAK-D ToF (ToF)"
        ]
    );
    let printed: [&[&str]; 4] = [
        &[
            "focalLengthPixel",
            "805.0",
            "566.0",
            "805.0",
            "566.0",
            "763.0",
            "457.0",
        ],
        &["minDistance (m)", "0.6", "0.2", "0.6", "0.2", "0.2", "0.2"],
        &["maxDistance (m)", "12.0", "8.0", "12.0", "8.0", "5.0", "5.0"],
        &["baselineMM", "75.0", "75.0", "75.0", "75.0", "20.0", "0.5"],
    ];
    assert_eq!(table.rows, printed);
}

#[test]
fn accuracy_by_range() {
    let table = &all()[6];
    // The sheet heads the first two columns with "OAK-D Pro (RVC2)" and "OAK-D Pro W (RVC2)".
    assert_eq!(
        table.header,
        [
            "Range",
            "OAK-D Pro PoE (RVC2)",
            "OAK-D Pro W PoE (RVC2)",
            "OAK4-D (RVC4)",
            "OAK4-D Wide (RVC4)",
            "OAK-D ToF (ToF)"
        ]
    );
    let printed: [&[&str]; 4] = [
        &["< 3.5m", "< 2%", "< 2%", "< 1.5%", "< 2%", "< 1% (indoors)"],
        &["3.5-6.5m", "< 4%", "< 4%", "< 3%", "< 4%", "< 2% (outdoors)"],
        &["6.5-9m", "< 6%", "< 6%", "< 6%", "< 6%", "N/A (5m max)"],
        &["9-12m", "< 6%", "N/A (8m max)", "< 6%", "N/A (8m max)", "N/A"],
    ];
    assert_eq!(table.rows, printed);
}

#[test]
fn features() {
    let table = &all()[7];
    let columns = [
        "OAK-D Pro PoE (RVC2)",
        "OAK4-D (RVC4)",
        "OAK4-D Wide (RVC4)",
        "OAK-D ToF (RVC2)",
    ];
    // The sheet has one column for both Pro models, where the fields of view read "~64° (standard) / ~80° (wide)" and
    // "~77° (standard) / ~97° (wide)"; here each model has its own.
    let printed: [(&str, [&str; 4]); 11] = [
        (
            "Platform",
            [
                "Myriad X (Intel VPU)",
                "QCS8550 (Qualcomm AI SoC)",
                "QCS8550 (Qualcomm AI SoC)",
                "Myriad X (Intel VPU)",
            ],
        ),
        (
            "RGB Sensor",
            [
                "Sony IMX378 (12.3 MP)",
                "Sony IMX586 (48 MP)",
                "Sony IMX586 (48 MP)",
                "None",
            ],
        ),
        (
            "Stereo Sensor",
            ["OV9282", "OV9282", "OV9282 (wide optics)", "OV9782 (color)"],
        ),
        ("ToF Sensor", ["None", "None", "None", "33D (640x480)"]),
        ("RGB HFOV", ["~64°", "~68°", "~88°", "N/A"]),
        ("Stereo HFOV", ["~77°", "~77°", "~97°", "~80°"]),
        ("ToF HFOV", ["N/A", "N/A", "N/A", "~70°"]),
        ("Stereo Baseline", ["75 mm", "75 mm", "75 mm", "20 mm"]),
        (
            "Close-Range Accuracy",
            [
                "< 2% at 3.5m",
                "< 1.5% at 4m",
                "< 2% at 3.5m",
                "< 1% (ToF, indoors)",
            ],
        ),
        (
            "IMU",
            [
                "BNO086 (9-axis)",
                "ICM-42688-P + AK09919C",
                "ICM-42688-P + AK09919C",
                "Yes",
            ],
        ),
        ("Data Source", ["Theoretical (spec sheet)"; 4]),
    ];
    let column = |name: &str| table.header.iter().position(|header| header == name).unwrap();
    assert_eq!(table.rows.len(), printed.len());
    for (row, (feature, cells)) in table.rows.iter().zip(printed) {
        assert_eq!(row[0], feature);
        for (name, cell) in columns.iter().zip(cells) {
            assert_eq!(row[column(name)], cell, "{feature}, {name}");
        }
    }
    let wide = column("OAK-D Pro W PoE (RVC2)");
    assert_eq!(table.rows[4][wide], "~80°");
    assert_eq!(table.rows[5][wide], "~97°");
}

#[test]
fn any_choice_of_models_and_every_row_as_wide_as_its_header() {
    let catalog = Catalog::builtin();
    let pick =
        |names: &[&str]| -> Vec<&Device> { names.iter().map(|name| catalog.device(name).unwrap()).collect() };
    // Tables without contents are left out: depth sensors and accuracy of models that have none, and all tables of no models.
    for (names, count) in [
        (&[][..], 0),
        (&["OAK-D ToF"], 4),
        (&["OAK4-D", "OAK-D ToF"], 5),
        (&["OAK4-D", "OAK4-D"], 5),
        (&["OAK-D CM4"], 3),
        (&["OAK Thermal", "OAK4-CS"], 3),
    ] {
        let tables = compare(catalog, &pick(names));
        assert_eq!(tables.len(), count, "{names:?}");
        for table in &tables {
            assert!(
                table.rows.iter().all(|row| row.len() == table.header.len()),
                "{}",
                table.title
            );
        }
    }
}

#[test]
fn unequal_stereo_cameras_have_a_row_each() {
    let catalog = Catalog::builtin();
    let mut device = catalog.device("OAK4-D").unwrap().clone();
    device.cameras[2].hfov_deg = 70.0;
    let rows: Vec<String> = compare(catalog, &[&device])[0]
        .rows
        .iter()
        .map(|row| row[0].clone())
        .collect();
    assert_eq!(
        rows,
        ["RGB (IMX586)", "Left (OV9282)", "Right (OV9282)", "Pseudo Depth"]
    );
}
