use oaktwin_image::{Image, ImageView};

use super::{image, pair, parameters, step};
use crate::stereo_matching::{LuminanceImage, RectifiedPair, inspect};

fn codes(images: &[Image<u8>; 2]) -> Vec<&'static str> {
    let findings = inspect(&pair(images), &parameters());
    findings.iter().map(|finding| finding.code).collect()
}

#[test]
fn a_good_pair_has_no_findings() {
    assert!(codes(&step(640, 200, 12.0, 40.0, 250.0, 400.0)).is_empty());
    let far = step(640, 200, 0.0, 3.0, 250.0, 400.0);
    assert!(codes(&far).is_empty());
}

#[test]
fn reports_problems_of_a_pair() {
    let [left, right] = step(640, 200, 12.0, 40.0, 250.0, 400.0);
    assert_eq!(codes(&[right.clone(), left.clone()]), ["pair-swapped"]);
    let lower = |rows: usize| {
        let pixels: Vec<u8> = (0..200usize)
            .flat_map(|y| {
                let from = y.saturating_sub(rows) * 640;
                right.pixels()[from..from + 640].to_vec()
            })
            .collect();
        Image::new(640, 200, pixels).unwrap()
    };
    assert_eq!(codes(&[left.clone(), lower(5)]), ["vertical-offset"]);
    assert_eq!(
        codes(&[lower(3), left.clone()]),
        ["pair-swapped", "vertical-offset"]
    );
    let findings = inspect(&pair(&[left.clone(), lower(5)]), &parameters());
    assert_eq!(
        findings[0].to_string(),
        "warning[vertical-offset]: stereo pair: the right image is about 5 px lower than the left one; \
         rectify both with this unit's calibration"
    );
    let blank = image(640, 200, |_, _| (0, 3.0));
    assert_eq!(
        codes(&[Image::filled(640, 200, 90), Image::filled(640, 200, 90)]),
        ["no-texture"]
    );
    assert_eq!(
        codes(&[left.clone(), Image::filled(640, 200, 90)]),
        ["no-texture"]
    );
    assert_eq!(codes(&[left.clone(), left.clone()]), ["same-image"]);
    let rows_only = codes(&[blank.clone(), blank]);
    assert_eq!(rows_only, ["no-texture"]);
    let bright = Image::filled(640, 200, 255);
    assert_eq!(
        codes(&[bright.clone(), bright]),
        ["saturated", "saturated", "no-texture"]
    );
    assert!(codes(&step(90, 200, 3.0, 9.0, 30.0, 50.0)).contains(&"range-beyond-image"));
}

/// Images of different places or of distant moments are unrelated; a repeating pattern or different exposures are not
/// reported.
#[test]
fn reports_unrelated_images() {
    let [left, right] = step(640, 200, 12.0, 40.0, 250.0, 400.0);
    let turned = |image: &Image<u8>| {
        let pixels = image.pixels().iter().rev().copied().collect();
        Image::new(640, 200, pixels).unwrap()
    };
    assert_eq!(codes(&[left.clone(), turned(&right)]), ["unrelated"]);
    assert_eq!(codes(&[left.clone(), turned(&left)]), ["unrelated"]);
    let darker = right.map(|&level| level / 4 * 3);
    assert!(codes(&[left, darker]).is_empty());
    let squares = |moved: u32| {
        let grey = |x: u32, y: u32| {
            if ((x + moved) / 10 + y / 10).is_multiple_of(2) {
                40
            } else {
                200
            }
        };
        let pixels = (0..200).flat_map(|y| (0..640).map(move |x| grey(x, y)));
        Image::new(640, 200, pixels.collect()).unwrap()
    };
    assert!(codes(&[squares(0), squares(7)]).is_empty());
}

#[test]
fn rejects_invalid_pairs() {
    let (a, b) = (Image::filled(4, 3, 0u8), Image::filled(4, 2, 0u8));
    let ten = Image::filled(4, 3, 0u16);
    let error = |left: LuminanceImage<'_>, right: LuminanceImage<'_>| {
        RectifiedPair::new(left, right).unwrap_err().to_string()
    };
    assert_eq!(
        error(ImageView::from(&a).into(), ImageView::from(&b).into()),
        "stereo pair: the left image is 4x3, the right one 4x2; rectify both to one size"
    );
    assert!(
        error(ImageView::from(&a).into(), ImageView::from(&ten).into()).contains("8 bits, the right one 10")
    );
    let none = Image::filled(0, 0, 0u8);
    assert!(error(ImageView::from(&none).into(), ImageView::from(&none).into()).contains("no pixels"));
}
