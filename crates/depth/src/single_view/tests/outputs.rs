use super::*;

const ALL: Wanted = Wanted {
    positions: true,
    colors: true,
    imager: true,
    view: true,
    reasons: true,
    confidence: true,
};

struct Inputs {
    depth: Image<f32>,
    rgb: Image<[u8; 4]>,
    positions: Image<[f32; 4]>,
}

impl Inputs {
    fn new() -> Self {
        Self {
            depth: step(200, 1.5, 80, 110),
            rgb: image(200, 40, |x, y| [x as u8, y as u8, (7 * x + 31 * y) as u8, 200]),
            positions: image(200, 40, |x, y| [x as f32, y as f32, 0.5, 1.0]),
        }
    }

    fn sense(&self, parameters: Parameters, assumptions: &[(&str, &str)]) -> SingleViewOutput {
        let mut changed = Assumptions::default();
        for (name, value) in assumptions {
            changed.set(name, *value).unwrap();
        }
        let shot = DepthShot::new((&self.depth).into())
            .with_rgb((&self.rgb).into())
            .unwrap();
        let shot = shot.with_positions((&self.positions).into()).unwrap();
        let sensor = SingleView::new(parameters, changed).unwrap();
        sensor.sense(&shot, &Stream::new(1, "left"), ALL)
    }
}

#[test]
fn colours_and_positions_move_with_their_samples() {
    let inputs = Inputs::new();
    let parameters = Parameters {
        confidence_threshold: 1.0,
        ..oak_d_pro()
    };
    let output = inputs.sense(parameters, &[]);
    let (positions, colors) = (output.positions.unwrap(), output.colors.unwrap());
    let mut measured = 0;
    for (i, &z) in output.distance.0.pixels().iter().enumerate() {
        let (position, color) = (positions.pixels()[i], colors.pixels()[i]);
        if z == 0.0 {
            assert_eq!((position, color), ([0.0; 4], [0; 4]));
            continue;
        }
        measured += 1;
        let (x, y) = (position[0] as u32, position[1] as u32);
        assert_eq!(y as usize, i / 200);
        assert_eq!(Some(&z), inputs.depth.get(x, y));
        assert_eq!(Some(&color), inputs.rgb.get(x, y));
    }
    assert!(measured > 6000, "{measured}");
    // The imager is luma, 1 for white.
    let imager = output.imager.unwrap();
    let [r, g, b, _] = inputs.rgb.get(50, 20).unwrap().map(f32::from);
    let luma = (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255.0;
    assert!((imager.get(50, 20).unwrap() - luma).abs() < 1e-6);
}

#[test]
fn invalid_pixels_follow_the_invalid_option() {
    let inputs = Inputs::new();
    for (name, position, color) in [
        ("zero", [0.0; 4], [0; 4]),
        ("nan", [f32::NAN; 4], [0; 4]),
        ("input", [0.0, 3.0, 0.5, 1.0], [0, 3, 93, 200]),
    ] {
        let output = inputs.sense(oak_d_pro(), &[("invalid", name)]);
        // No sample reaches the left border.
        assert_eq!(output.distance.0.get(0, 3), Some(&0.0));
        assert_eq!(
            format!("{:?}", output.positions.unwrap().get(0, 3)),
            format!("{:?}", Some(position))
        );
        assert_eq!(output.colors.unwrap().get(0, 3), Some(&color));
    }
}

#[test]
fn omits_outputs_that_are_not_requested_or_lack_input() {
    let inputs = Inputs::new();
    let (sensor, stream) = (sensor(oak_d_pro()), Stream::new(1, "left"));
    let bare = sensor.sense(&DepthShot::new((&inputs.depth).into()), &stream, ALL);
    assert!(
        bare.positions.is_none() && bare.colors.is_none() && bare.imager.is_none() && bare.view.is_none()
    );
    let shot = DepthShot::new((&inputs.depth).into())
        .with_rgb((&inputs.rgb).into())
        .unwrap();
    let unwanted = sensor.sense(&shot, &stream, Wanted::default());
    assert!(unwanted.colors.is_none() && unwanted.imager.is_none() && unwanted.view.is_none());
    // Additional outputs do not change the distance.
    assert_eq!(sensor.sense(&shot, &stream, ALL).distance, unwanted.distance);
    let center = *unwanted.distance.0.get(100, 20).unwrap();
    assert_eq!(unwanted.center_m(), Some(center));
}

#[test]
fn renders_all_eight_visualizations() {
    let inputs = Inputs::new();
    let at = |mode: &str, x: u32, y: u32| {
        let mut parameters = Parameters {
            confidence_threshold: 1.0,
            min_distance_m: 1.0,
            max_distance_m: 5.0,
            ..quiet()
        };
        parameters.set("rgbDepthOutputMode", mode).unwrap();
        *inputs.sense(parameters, &[]).view.unwrap().get(x, y).unwrap()
    };
    let grey = |byte: u8| [byte, byte, byte, 255];
    // Disparities at this width: 2.36 px at 4 m, 6.29 px at 1.5 m; column 0 is a hole, column 100 the near object.
    assert_eq!(at("0", 30, 7), *inputs.rgb.get(30, 7).unwrap());
    assert_eq!(
        [at("1", 0, 7), at("1", 100, 7), at("1", 150, 7)],
        [grey(0), grey(128), grey(0)]
    );
    assert_eq!(
        [at("2", 0, 7), at("2", 100, 7), at("2", 150, 7)],
        [grey(0), grey(32), grey(191)]
    );
    assert_eq!(
        [at("3", 0, 7), at("3", 100, 7), at("3", 150, 7)],
        [grey(0), [255, 128, 0, 255], [0, 255, 255, 255]]
    );
    // The object has not moved in the input.
    assert_eq!(
        [at("4", 0, 7), at("4", 81, 7), at("5", 81, 7)],
        [grey(191), grey(32), grey(191)]
    );
    assert_eq!([at("5", 0, 7), at("5", 100, 7)], [grey(0), grey(32)]);
    // Disparities of 6.29 and 2.36 px, of 95.
    assert_eq!(
        [at("7", 0, 7), at("7", 100, 7), at("7", 150, 7)],
        [grey(0), grey(17), grey(6)]
    );
    let [confidence, disparity, blue, alpha] = at("6", 100, 7);
    assert!(confidence > 0 && disparity == 17 && blue == 0 && alpha == 255);
    assert_eq!(at("6", 0, 7), grey(0));
}
