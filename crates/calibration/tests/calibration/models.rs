//! The models of real calibrations.

use std::fs;
use std::path::Path;

use oaktwin_calibration::{Calibration, Raw, check_against, twin};
use oaktwin_catalog::Catalog;

/// The files of the test data by the start of their names, with their models.
const MODELS: [(&str, &str); 3] = [
    ("oak-d-pro-af_", "OAK-D Pro"),
    ("oak-d-lite_", "OAK-D Lite"),
    ("oak-d_bw1098obc_", "OAK-D"),
];

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn every_calibration_of_a_listed_device_finds_its_model() {
    let data = std::env::var_os("OAKTWIN_TEST_DATA").expect("OAKTWIN_TEST_DATA names the test data");
    let catalog = Catalog::builtin();
    let mut found = 0;
    for entry in fs::read_dir(Path::new(&data).join("data/calibration")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        if !name.ends_with(".json") {
            continue;
        }
        let raw = Raw::parse(&fs::read(&path).unwrap(), name).unwrap();
        let (calibration, _) = Calibration::from_raw(&raw).unwrap();
        let board = &calibration.board;
        let model = catalog.device_of_unit(&board.product_name, &board.board_name);
        let expected = MODELS.iter().find(|(start, _)| name.starts_with(start));
        assert_eq!(
            model.as_ref().ok().map(|device| device.name.as_str()),
            expected.map(|(_, model)| *model),
            "{name}"
        );
        let Ok(device) = model else { continue };
        let nominal = catalog.nominal(device);
        let codes: Vec<&str> = check_against(&calibration, &nominal, catalog)
            .iter()
            .map(|finding| finding.code)
            .collect();
        assert!(!codes.contains(&"product-name"), "{name}: {codes:?}");
        assert!(!codes.contains(&"focal-length-off"), "{name}: {codes:?}");
        assert!(twin(&calibration, &nominal, name).is_ok(), "{name}");
        found += 1;
    }
    assert_eq!(found, 7);
}
