use super::clip::{AxisRanges, runs};
use super::{Figure, FigureAxis, FigureLayer, FigureShape, image, svg};

fn figure(title: &str, shape: FigureShape) -> Figure {
    let axis = |label: &str| FigureAxis {
        label: label.to_owned(),
        range: [0.0, 1.0],
    };
    Figure {
        title: title.to_owned(),
        subtitle: String::new(),
        x: axis("x"),
        y: axis("y"),
        layers: vec![FigureLayer {
            label: "layer".to_owned(),
            color: [200, 30, 30],
            shape,
        }],
    }
}

#[test]
fn escapes_text() {
    let svg = svg(&[figure("<4 m & more\u{1}", FigureShape::Line(Vec::new()))]).unwrap();
    assert!(svg.contains("&lt;4 m &amp; more"), "{svg}");
    assert!(!svg.contains('\u{1}') && svg.trim_end().ends_with("</svg>"));
    assert!(svg.starts_with("<svg width=\"960\" height=\"560\""), "{svg}");
}

#[test]
fn stacks_figures_and_draws_the_same_bytes_twice() {
    let one = figure("upper", FigureShape::Line(vec![[0.0, 0.0], [1.0, 1.0]]));
    let two = figure("lower", FigureShape::Dots(vec![[0.5, 0.5]]));
    let both = [one.clone(), two];
    let text = svg(&both).unwrap();
    assert!(text.contains("upper") && text.contains("lower") && text.contains("height=\"1120\""));
    assert_eq!(text, svg(&both).unwrap());
    let stacked = image(&both).unwrap();
    let upper = image(&[one]).unwrap();
    assert_eq!(
        (stacked.width(), stacked.height()),
        (upper.width(), 2 * upper.height())
    );
    assert_eq!(stacked.pixels()[..upper.pixels().len()], *upper.pixels());
}

#[test]
fn skips_values_that_are_not_finite_and_clips_the_rest() {
    let wild = vec![[f64::NAN, 0.5], [0.5, f64::INFINITY], [1e300, -1e300], [0.1, 0.2]];
    for shape in [
        FigureShape::Line(wild.clone()),
        FigureShape::Dots(wild),
        FigureShape::Area(vec![[0.0, 0.1, f64::NAN], [0.5, 0.1, 0.2]]),
        FigureShape::Steps(vec![[0.0, 1e300, 0.0, 0.5]]),
    ] {
        let figure = figure("", shape);
        let svg = svg(std::slice::from_ref(&figure)).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        let image = image(&[figure]).unwrap();
        let red = image
            .pixels()
            .iter()
            .filter(|p| p[0] > p[1].saturating_add(30))
            .count();
        assert!(red > 0);
    }
    let mut flat = figure("", FigureShape::Line(vec![[0.0, 0.0], [1.0, 1.0]]));
    flat.y.range = [1.0, 1.0];
    assert!(!svg(&[flat.clone()]).unwrap().contains("NaN"));
    flat.y.range = [f64::NAN, 1.0];
    assert!(image(&[flat]).is_ok());
}

#[test]
fn clips_lines_and_polygons_to_the_axes() {
    let frame = AxisRanges::of(&figure("", FigureShape::Line(Vec::new())));
    let pieces = frame.line(&[[-1.0, 0.5], [0.5, 0.5], [0.5, 2.0], [0.75, 2.0], [0.75, 0.0]]);
    assert_eq!(
        pieces,
        [
            vec![[0.0, 0.5], [0.5, 0.5], [0.5, 1.0]],
            vec![[0.75, 1.0], [0.75, 0.0]],
        ]
    );
    assert!(frame.line(&[[2.0, 0.0], [2.0, 1.0]]).is_empty());
    let clipped = frame.polygon(vec![[-1.0, -1.0], [2.0, -1.0], [2.0, 2.0], [-1.0, 2.0]]);
    assert_eq!(clipped.len(), 4);
    assert!(clipped.iter().all(|corner| frame.contains(*corner)));
}

#[test]
fn gaps_separate_runs() {
    let points = [[0.0, 1.0], [1.0, f64::NAN], [2.0, 1.0], [3.0, 1.0]];
    let lengths: Vec<usize> = runs(&points).map(<[_]>::len).collect();
    assert_eq!(lengths, [1, 2]);
}
