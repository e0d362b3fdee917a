//! Every computed number of Luxonis' parameter sheet, copied by hand as printed there, against ours rounded to as many
//! digits.
#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use crate::common::{assert_printed, printed};
use oaktwin_camera::{ApertureOffsets, Usd, UsdOptics};
use oaktwin_catalog::{Catalog, Role, TwinCamera};

/// A camera's section of the sheet.
struct Section {
    model: &'static str,
    roles: &'static [Role],
    hfov_deg: &'static str,
    half_hfov_deg: &'static str,
    width: &'static str,
    height: &'static str,
    pixel_size_um: &'static str,
    fx: &'static str,
    cx: &'static str,
    cy: &'static str,
    focal_length_mm: &'static str,
    horizontal_aperture_mm: &'static str,
    vertical_aperture_mm: &'static str,
    offset_mm: &'static str,
    /// The check of the field of view: atan's argument, half the angle, the angle.
    check: [Printed; 3],
}

/// A number of the sheet, or a slip of its arithmetic beside what it should be.
enum Printed {
    As(&'static str),
    Slip {
        sheet: &'static str,
        right: &'static str,
    },
}
use Printed::{As, Slip};

const STEREO: &[Role] = &[Role::Left, Role::Right];

const SECTIONS: [Section; 10] = [
    Section {
        model: "OAK-D Pro PoE",
        roles: &[Role::Rgb],
        hfov_deg: "64",
        half_hfov_deg: "32",
        width: "3840",
        height: "2160",
        pixel_size_um: "1.55",
        fx: "3072.64",
        cx: "1920.00",
        cy: "1080.00",
        focal_length_mm: "4.7626",
        horizontal_aperture_mm: "5.952",
        vertical_aperture_mm: "3.348",
        offset_mm: "0.0",
        check: [As("0.6249"), As("32.0"), As("64.0")],
    },
    Section {
        model: "OAK-D Pro PoE",
        roles: STEREO,
        hfov_deg: "77",
        half_hfov_deg: "38.5",
        width: "1280",
        height: "800",
        pixel_size_um: "3.0",
        fx: "804.59",
        cx: "640.00",
        cy: "400.00",
        focal_length_mm: "2.4138",
        horizontal_aperture_mm: "3.84",
        vertical_aperture_mm: "2.40",
        offset_mm: "0.0",
        check: [As("0.7954"), As("38.5"), As("77.0")],
    },
    Section {
        model: "OAK-D Pro W PoE",
        roles: &[Role::Rgb],
        hfov_deg: "80",
        half_hfov_deg: "40",
        width: "3840",
        height: "2160",
        pixel_size_um: "1.55",
        fx: "2288.17",
        cx: "1920.00",
        cy: "1080.00",
        focal_length_mm: "3.5467",
        horizontal_aperture_mm: "5.952",
        vertical_aperture_mm: "3.348",
        offset_mm: "0.0",
        check: [As("0.8391"), As("40.0"), As("80.0")],
    },
    Section {
        model: "OAK-D Pro W PoE",
        roles: STEREO,
        hfov_deg: "97",
        half_hfov_deg: "48.5",
        width: "1280",
        height: "800",
        pixel_size_um: "3.0",
        fx: "566.22",
        cx: "640.00",
        cy: "400.00",
        focal_length_mm: "1.6987",
        horizontal_aperture_mm: "3.84",
        vertical_aperture_mm: "2.40",
        offset_mm: "0.0",
        check: [
            Slip {
                sheet: "1.1302",
                right: "1.1303",
            },
            As("48.5"),
            As("97.0"),
        ],
    },
    Section {
        model: "OAK4-D",
        roles: &[Role::Rgb],
        hfov_deg: "68",
        half_hfov_deg: "34",
        width: "4000",
        height: "3000",
        pixel_size_um: "1.6",
        fx: "2965.12",
        cx: "2000.00",
        cy: "1500.00",
        focal_length_mm: "4.7442",
        horizontal_aperture_mm: "6.400",
        vertical_aperture_mm: "4.800",
        offset_mm: "0.0",
        check: [As("0.6745"), As("34.0"), As("68.0")],
    },
    Section {
        model: "OAK4-D",
        roles: STEREO,
        hfov_deg: "77",
        half_hfov_deg: "38.5",
        width: "1280",
        height: "800",
        pixel_size_um: "3.0",
        fx: "804.59",
        cx: "640.00",
        cy: "400.00",
        focal_length_mm: "2.4138",
        horizontal_aperture_mm: "3.84",
        vertical_aperture_mm: "2.40",
        offset_mm: "0.0",
        check: [As("0.7954"), As("38.5"), As("77.0")],
    },
    Section {
        model: "OAK4-D Wide",
        roles: &[Role::Rgb],
        hfov_deg: "88",
        half_hfov_deg: "44",
        width: "4000",
        height: "3000",
        pixel_size_um: "1.6",
        fx: "2071.06",
        cx: "2000.00",
        cy: "1500.00",
        focal_length_mm: "3.3137",
        horizontal_aperture_mm: "6.400",
        vertical_aperture_mm: "4.800",
        offset_mm: "0.0",
        check: [
            Slip {
                sheet: "0.9655",
                right: "0.9657",
            },
            As("44.0"),
            As("88.0"),
        ],
    },
    Section {
        model: "OAK4-D Wide",
        roles: STEREO,
        hfov_deg: "97",
        half_hfov_deg: "48.5",
        width: "1280",
        height: "800",
        pixel_size_um: "3.0",
        fx: "566.22",
        cx: "640.00",
        cy: "400.00",
        focal_length_mm: "1.6987",
        horizontal_aperture_mm: "3.84",
        vertical_aperture_mm: "2.40",
        offset_mm: "0.0",
        check: [
            Slip {
                sheet: "1.1302",
                right: "1.1303",
            },
            As("48.5"),
            As("97.0"),
        ],
    },
    Section {
        model: "OAK-D ToF",
        roles: &[Role::Tof],
        hfov_deg: "70",
        half_hfov_deg: "35",
        width: "640",
        height: "480",
        pixel_size_um: "7",
        fx: "457.01",
        cx: "320.00",
        cy: "240.00",
        focal_length_mm: "3.1991",
        horizontal_aperture_mm: "4.480",
        vertical_aperture_mm: "3.360",
        offset_mm: "0.0",
        check: [
            As("0.7002"),
            Slip {
                sheet: "34.98",
                right: "35.00",
            },
            As("70.0"),
        ],
    },
    Section {
        model: "OAK-D ToF",
        roles: STEREO,
        hfov_deg: "80",
        half_hfov_deg: "40",
        width: "1280",
        height: "800",
        pixel_size_um: "3.0",
        fx: "762.72",
        cx: "640.00",
        cy: "400.00",
        focal_length_mm: "2.2882",
        horizontal_aperture_mm: "3.840",
        vertical_aperture_mm: "2.400",
        offset_mm: "0.0",
        check: [As("0.8391"), As("40.00"), As("80.0")],
    },
];

impl Section {
    fn compare(&self, camera: &TwinCamera) {
        let what = |of: &str| format!("{}, {:?}: {of}", self.model, camera.spec.role);
        let intrinsics = &camera.intrinsics;
        let check = |value: f64, expected: &str, of: &str| assert_printed(value, expected, &what(of));
        check(camera.spec.hfov_deg, self.hfov_deg, "HFOV");
        check(camera.spec.hfov_deg / 2.0, self.half_hfov_deg, "HFOV / 2");
        check(intrinsics.size.width.into(), self.width, "width");
        check(intrinsics.size.height.into(), self.height, "height");
        check(camera.pixel_size_um, self.pixel_size_um, "pixel_size");
        check(intrinsics.fx, self.fx, "fx");
        check(intrinsics.fy, self.fx, "fy, which the sheet takes to be fx");
        let centre = intrinsics.principal_point::<Usd>();
        check(centre.x, self.cx, "cx");
        check(centre.y, self.cy, "cy");
        let optics = UsdOptics::from_intrinsics(intrinsics, camera.pixel_size_um, ApertureOffsets::OpenUsd);
        check(optics.focal_length_mm, self.focal_length_mm, "focal_length");
        check(
            optics.horizontal_aperture_mm,
            self.horizontal_aperture_mm,
            "horizontal_aperture",
        );
        check(
            optics.vertical_aperture_mm,
            self.vertical_aperture_mm,
            "vertical_aperture",
        );
        check(
            optics.horizontal_aperture_offset_mm,
            self.offset_mm,
            "horizontal_aperture_offset",
        );
        check(
            optics.vertical_aperture_offset_mm,
            self.offset_mm,
            "vertical_aperture_offset",
        );

        // The sheet's check of the field of view, from the numbers that it prints and from ours.
        let number = |text: &str| text.parse::<f64>().unwrap();
        let from_printed = number(self.horizontal_aperture_mm) / (2.0 * number(self.focal_length_mm));
        let from_ours = optics.horizontal_aperture_mm / (2.0 * optics.focal_length_mm);
        let [ratio, half, full] = &self.check;
        for value in [from_printed, from_ours] {
            ratio.compare(value, &what("atan's argument"));
            half.compare(value.atan().to_degrees(), &what("half the angle"));
            full.compare(2.0 * value.atan().to_degrees(), &what("the angle"));
        }
        full.compare(optics.hfov().to_degrees(), &what("HFOV of the optics"));
    }
}

impl Printed {
    #[track_caller]
    fn compare(&self, value: f64, what: &str) {
        match self {
            As(expected) => assert_printed(value, expected, what),
            Slip { sheet, right } => {
                assert_ne!(printed(value, sheet), *sheet, "{what}: no slip after all");
                assert_printed(value, right, what);
            }
        }
    }
}

#[test]
fn every_computed_number_of_the_camera_sections() {
    let catalog = Catalog::builtin();
    let mut compared = 0;
    for section in &SECTIONS {
        let twin = catalog.nominal(catalog.device(section.model).unwrap());
        for role in section.roles {
            section.compare(twin.camera(*role).unwrap());
            compared += 1;
        }
    }
    let cameras: usize = catalog.sheet().map(|device| device.cameras.len()).sum();
    assert_eq!(compared, cameras);
}

/// The three slips of the sheet's arithmetic, by name; one of them is printed for both wide stereo pairs.
#[test]
fn the_slips_are_these_three() {
    let mut slips: Vec<&str> = SECTIONS
        .iter()
        .flat_map(|section| &section.check)
        .filter_map(|printed| match printed {
            Slip { sheet, .. } => Some(*sheet),
            As(_) => None,
        })
        .collect();
    slips.sort_unstable();
    slips.dedup();
    assert_eq!(slips, ["0.9655", "1.1302", "34.98"]);
    for (model, slip) in [
        ("OAK-D Pro W PoE", "1.1302"),
        ("OAK4-D Wide", "1.1302"),
        ("OAK4-D Wide", "0.9655"),
        ("OAK-D ToF", "34.98"),
    ] {
        let device = Catalog::builtin().device(model).unwrap();
        let note = device.notes.iter().find(|note| note.topic == "slip").unwrap();
        assert!(note.text.contains(slip), "{model}: the note names {slip}");
    }
}
