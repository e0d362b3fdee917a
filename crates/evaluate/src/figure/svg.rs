//! Marks as an SVG document.

use std::fmt::Write;

use super::layout::{Anchor, HEIGHT, Mark, Marks, WIDTH};

/// A font's size to the height of its capitals: that of Helvetica and its kin.
const SIZE_OF_CAPITALS: f32 = 1.0 / 0.72;

/// One document of several, one below the other.
pub(super) fn stacked(all: &[Marks]) -> String {
    let height = HEIGHT * all.len() as f32;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" height=\"{height}\">\n"
    );
    for (number, marks) in all.iter().enumerate() {
        let _ = write!(
            svg,
            "<g transform=\"translate(0 {})\">\n{}</g>\n",
            HEIGHT * number as f32,
            one(marks, number)
        );
    }
    svg + "</svg>\n"
}

pub(super) fn written(marks: &Marks) -> String {
    one(marks, 0)
}

/// The document of one; what several in one file must not share is named by its number.
fn one(marks: &Marks, number: usize) -> String {
    let [left, top, right, bottom] = marks.frame;
    let frame = frame_of(number);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" \
         font-family=\"Helvetica, Arial, 'Liberation Sans', sans-serif\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n\
         <clipPath id=\"{frame}\"><rect x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\"/></clipPath>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        right - left,
        bottom - top,
    );
    for mark in &marks.marks {
        // A `String` takes all that is written.
        let _ = match mark {
            Mark::Area {
                corners,
                color,
                opacity,
                is_cut,
            } => writeln!(
                svg,
                "<path d=\"{}Z\" fill=\"{}\" fill-opacity=\"{opacity}\"{}/>",
                path(corners),
                hex(*color),
                cut(*is_cut, &frame)
            ),
            Mark::Line {
                points,
                color,
                width,
                is_cut,
            } => writeln!(
                svg,
                "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\"{}/>",
                path(points),
                hex(*color),
                cut(*is_cut, &frame)
            ),
            Mark::Text {
                at: [x, y],
                height,
                color,
                anchor,
                is_turned,
                text,
            } => {
                let anchor = match anchor {
                    Anchor::Left => "start",
                    Anchor::Middle => "middle",
                    Anchor::Right => "end",
                };
                let turn = if *is_turned {
                    format!(" transform=\"rotate(-90 {x:.1} {y:.1})\"")
                } else {
                    String::new()
                };
                writeln!(
                    svg,
                    "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{:.1}\" fill=\"{}\" text-anchor=\"{anchor}\"{turn}>{}</text>",
                    height * SIZE_OF_CAPITALS,
                    hex(*color),
                    escaped(text)
                )
            }
        };
    }
    svg + "</svg>\n"
}

fn path(points: &[[f32; 2]]) -> String {
    let mut path = String::new();
    for (i, [x, y]) in points.iter().enumerate() {
        let _ = write!(path, "{}{x:.2} {y:.2}", if i == 0 { "M" } else { "L" });
    }
    path
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn frame_of(number: usize) -> String {
    if number == 0 {
        "frame".to_owned()
    } else {
        format!("frame{number}")
    }
}

fn cut(is_cut: bool, frame: &str) -> String {
    if is_cut {
        format!(" clip-path=\"url(#{frame})\"")
    } else {
        String::new()
    }
}

fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            // XML has no such characters.
            c if c.is_control() => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::super::{Axis, Figure, Layer, Shape};

    fn figure(title: &str, shape: Shape) -> Figure {
        Figure {
            title: title.to_owned(),
            subtitle: String::new(),
            x: Axis {
                label: "x".to_owned(),
                range: [0.0, 1.0],
            },
            y: Axis {
                label: "y".to_owned(),
                range: [0.0, 1.0],
            },
            layers: vec![Layer {
                label: "it".to_owned(),
                color: [200, 30, 30],
                shape,
            }],
        }
    }

    #[test]
    fn text_is_escaped() {
        let svg = figure("<4 m & more\u{1}", Shape::Line(Vec::new())).svg();
        assert!(svg.contains(">&lt;4 m &amp; more </text>"), "{svg}");
        assert!(svg.ends_with("</svg>\n"));
    }

    #[test]
    fn figures_below_one_another_have_frames_of_their_own() {
        let one = figure("upper", Shape::Line(vec![[0.0, 0.0], [1.0, 1.0]]));
        let two = figure("lower", Shape::Dots(vec![[0.5, 0.5]]));
        let svg = super::super::svg_of(&[one.clone(), two.clone()]);
        for once in [
            "id=\"frame\"",
            "id=\"frame1\"",
            ">upper<",
            ">lower<",
            "translate(0 560)",
        ] {
            assert_eq!(svg.matches(once).count(), 1, "{once}");
        }
        assert!(svg.contains("url(#frame1)"));
        assert_eq!(svg.matches("<svg").count(), svg.matches("</svg>").count());
        let picture = super::super::picture_of(&[one.clone(), two.clone()]);
        let (upper, lower) = (one.picture(), two.picture());
        assert_eq!(
            (picture.width(), picture.height()),
            (upper.width(), 2 * upper.height())
        );
        assert_eq!(picture.pixels(), [upper.pixels(), lower.pixels()].concat());
        assert_eq!(super::super::svg_of(std::slice::from_ref(&one)), one.svg());
    }

    #[test]
    fn nothing_that_is_no_number_is_written() {
        let wild = vec![[f64::NAN, 0.5], [0.5, f64::INFINITY], [1e300, -1e300], [0.1, 0.2]];
        for shape in [
            Shape::Line(wild.clone()),
            Shape::Dashes(wild.clone()),
            Shape::Dots(wild),
            Shape::Area(vec![[0.0, 0.1, f64::NAN], [0.5, 0.1, 0.2]]),
            Shape::Steps(vec![[0.0, 1e300, 0.0, 0.5]]),
        ] {
            let figure = figure("", shape);
            let svg = figure.svg();
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
            let red = figure
                .picture()
                .pixels()
                .iter()
                .filter(|p| p[0] > p[1].saturating_add(30))
                .count();
            assert!(red > 0);
        }
        let mut flat = figure("", Shape::Line(vec![[0.0, 0.0], [1.0, 1.0]]));
        flat.y.range = [1.0, 1.0];
        assert!(!flat.svg().contains("NaN"));
        let _ = flat.picture();
    }
}
