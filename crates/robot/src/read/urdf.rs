//! URDF, as ROS documents it.

use std::collections::{HashMap, HashSet};
use std::path::PathBuf;

use oaktwin_base::diagnostic::{Finding, Level, suggest};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_scene::import;

use super::document::{Element, Vectors, XmlError};
use super::robot::{Joint, JointKind, Link, LinkVisual, Mimic, Robot, Shape};
use super::{locate, turn};

/// The maximum number of links and joints.
const MAX_ELEMENTS: usize = 10_000;

/// A joint of the file.
struct Edge<'a> {
    element: &'a Element,
    child: &'a str,
    parent: &'a str,
}

struct Reader<'a> {
    packages: &'a [PathBuf],
    colors: HashMap<&'a str, [f32; 3]>,
    findings: Vec<Finding>,
}

pub(super) fn read(root: &Element, packages: &[PathBuf]) -> Result<Robot, XmlError> {
    let mut colors = HashMap::new();
    for material in root.all("material") {
        if let (Some(name), Some(color)) = (material.get("name"), color(material)?) {
            colors.insert(name, color);
        }
    }
    let mut reader = Reader {
        packages,
        colors,
        findings: Vec::new(),
    };
    reject_macros(root)?;
    let mut robot = Robot {
        name: root.get("name").unwrap_or("robot").to_owned(),
        ..Robot::default()
    };
    let mut mimics = Vec::new();
    for (element, edge) in ordered(root)? {
        let mut link = Link {
            name: element.required("name")?.to_owned(),
            parent: None,
            parent_from_link: RigidTransform::IDENTITY,
            joints: Vec::new(),
            visuals: reader.visuals(element)?,
            is_world: false,
        };
        if let Some(edge) = edge {
            link.parent = robot.link(edge.parent);
            link.parent_from_link = origin(edge.element)?;
            if let Some(joint) = reader.joint(edge.element)? {
                link.joints.push(robot.joints.len());
                mimics.extend(edge.element.child("mimic"));
                robot.joints.push(joint);
            }
        }
        robot.links.push(link);
    }
    follow(&mut robot, root)?;
    robot.findings = reader.findings;
    Ok(robot)
}

/// Rejects files that xacro has not expanded.
fn reject_macros(root: &Element) -> Result<(), XmlError> {
    match root.children.iter().find(|child| child.tag.starts_with("xacro:")) {
        Some(found) => Err(found.wrong(
            "the file has macros of xacro",
            "expand them: xacro FILE > robot.urdf",
        )),
        None => Ok(()),
    }
}

/// Returns the links, parents first, with the joint that carries each.
fn ordered(root: &Element) -> Result<Vec<(&Element, Option<Edge<'_>>)>, XmlError> {
    let mut links: HashMap<&str, &Element> = HashMap::new();
    if root.children.len() > MAX_ELEMENTS {
        let what = format!("more than {MAX_ELEMENTS} links and joints are too many");
        return Err(root.wrong(what, "give a smaller robot"));
    }
    for link in root.all("link") {
        if links.insert(link.required("name")?, link).is_some() {
            return Err(link.wrong("there are two links of this name", "rename one of them"));
        }
    }
    let mut parents: HashMap<&str, &str> = HashMap::new();
    let mut edges: HashMap<&str, Vec<Edge<'_>>> = HashMap::new();
    let mut names = HashSet::new();
    for element in root.all("joint") {
        let name = element.required("name")?;
        if !names.insert(name) {
            return Err(element.wrong("there are two joints of this name", "rename one of them"));
        }
        let (parent, child) = (end(element, "parent", &links)?, end(element, "child", &links)?);
        if let Some(other) = parents.insert(child, name) {
            return Err(element.wrong(
                format!("the link '{child}' is already the child of the joint '{other}'"),
                "give each link one parent",
            ));
        }
        edges.entry(parent).or_default().push(Edge {
            element,
            child,
            parent,
        });
    }
    let is_base = |link: &&Element| link.get("name").is_some_and(|name| !parents.contains_key(name));
    let bases: Vec<&Element> = root.all("link").filter(is_base).collect();
    let first = match bases[..] {
        [first] => first,
        [] => {
            let joint = root.all("joint").next();
            return Err(joint.unwrap_or(root).wrong(
                "no link is the base, because every link is the child of a joint",
                "remove the joint that closes the circle",
            ));
        }
        [_, second, ..] => {
            return Err(second.wrong("is a second base", "connect it to the other links by a joint"));
        }
    };
    let mut sorted: Vec<(&Element, Option<Edge<'_>>)> = vec![(first, None)];
    let mut at = 0;
    while at < sorted.len() {
        let own = sorted[at].0.get("name").unwrap_or_default();
        let children = edges.remove(own).unwrap_or_default();
        sorted.extend(children.into_iter().map(|edge| (links[edge.child], Some(edge))));
        at += 1;
    }
    let circle = edges.values().flatten().map(|edge| edge.element);
    match circle.min_by_key(|joint| joint.line()) {
        Some(joint) => Err(joint.wrong("is part of a circle of links", "remove one joint of the circle")),
        None => Ok(sorted),
    }
}

/// Returns the link at an end of a joint.
fn end<'a>(
    joint: &'a Element,
    tag: &str,
    links: &HashMap<&'a str, &'a Element>,
) -> Result<&'a str, XmlError> {
    let missing = || joint.wrong(format!("<{tag}> is missing"), format!("add <{tag} link=\"…\"/>"));
    let name = joint.child(tag).ok_or_else(missing)?.required("link")?;
    if links.contains_key(name) {
        return Ok(name);
    }
    let mut known: Vec<&str> = links.keys().copied().collect();
    known.sort_unstable();
    Err(joint.wrong(format!("there is no link '{name}'"), suggest(name, known)))
}

/// Sets the joints that follow others.
fn follow(robot: &mut Robot, root: &Element) -> Result<(), XmlError> {
    let names: Vec<String> = robot.joints.iter().map(|joint| joint.name.clone()).collect();
    let index = |name: &str| names.iter().position(|own| own == name);
    for element in root.all("joint") {
        let (Some(own), Some(mimic)) = (element.get("name").and_then(index), element.child("mimic")) else {
            continue;
        };
        let other = mimic.required("joint")?;
        let Some(joint) = index(other) else {
            let known = names.iter().map(String::as_str);
            return Err(mimic.wrong(format!("no joint '{other}' moves"), suggest(other, known)));
        };
        robot.joints[own].mimic = Some(Mimic {
            joint,
            multiplier: mimic.number("multiplier")?.unwrap_or(1.0),
            offset: mimic.number("offset")?.unwrap_or(0.0),
        });
        let mut next = Some(own);
        for _ in 0..=names.len() {
            next = next
                .and_then(|joint| robot.joints[joint].mimic)
                .map(|mimic| mimic.joint);
        }
        if next.is_some() {
            return Err(mimic.wrong("the joints follow each other in a circle", "remove one <mimic>"));
        }
    }
    Ok(())
}

impl<'a> Reader<'a> {
    fn note(
        &mut self,
        code: &'static str,
        level: Level,
        element: &Element,
        what: String,
        remedy: &'static str,
    ) {
        self.findings
            .push(Finding::new(code, level, element.place(), what, remedy));
    }

    /// Returns a joint that moves; `None` of one that is fixed.
    fn joint(&mut self, element: &Element) -> Result<Option<Joint>, XmlError> {
        let kind = element.required("type")?;
        let kind = match kind {
            "fixed" => return Ok(None),
            "revolute" | "continuous" => JointKind::Revolute,
            "prismatic" => JointKind::Prismatic,
            "floating" | "planar" => {
                let what = format!("{kind} joints are not supported; the link stays at the joint's origin");
                self.note("joint-unsupported", Level::Warning, element, what, "");
                return Ok(None);
            }
            other => {
                let known = [
                    "fixed",
                    "revolute",
                    "continuous",
                    "prismatic",
                    "floating",
                    "planar",
                ];
                return Err(element.wrong(format!("unknown type '{other}'"), suggest(other, known)));
            }
        };
        let axis = match element.child("axis") {
            Some(axis) => axis.vector("xyz")?.unwrap_or(DVec3::X),
            None => DVec3::X,
        };
        let axis = axis
            .try_normalize()
            .ok_or_else(|| element.wrong("the axis has no direction", "give a vector other than 0 0 0"))?;
        let limit = element.child("limit");
        let limits = match limit.filter(|_| element.get("type") != Some("continuous")) {
            Some(limit) => {
                let low = limit.number("lower")?.unwrap_or(0.0);
                let high = limit.number("upper")?.unwrap_or(0.0);
                if low > high {
                    let what = format!("the limit {low} is above {high}");
                    return Err(limit.wrong(what, "give the smaller one as lower"));
                }
                Some([low, high])
            }
            None => None,
        };
        if limit.is_none() && element.get("type") != Some("continuous") {
            let what = "has no <limit>, which its type requires; it may have any position".to_owned();
            self.note("joint-without-limits", Level::Note, element, what, "");
        }
        Ok(Some(Joint {
            name: element.required("name")?.to_owned(),
            kind,
            axis,
            anchor: DVec3::ZERO,
            limits,
            reference: 0.0,
            mimic: None,
        }))
    }

    /// Returns the visual shapes of a link. If one of its meshes cannot be read, its collision shapes replace it.
    fn visuals(&mut self, link: &'a Element) -> Result<Vec<LinkVisual>, XmlError> {
        let mut visuals = Vec::new();
        let mut unread = 0;
        for (number, element) in (0..).zip(link.all("visual")) {
            match self.visual(element, number)? {
                Some(visual) => visuals.push(visual),
                None => unread += 1,
            }
        }
        if unread == 0 {
            return Ok(visuals);
        }
        let mut stand_ins = Vec::new();
        for (number, element) in (0..).zip(link.all("collision")) {
            stand_ins.extend(self.visual(element, number)?);
        }
        let (level, what) = match stand_ins.len() {
            0 => (
                Level::Warning,
                "a mesh cannot be read, and the link has no other shape: it is missing in images",
            ),
            _ => (
                Level::Note,
                "a mesh cannot be read; the link's collision shapes are shown instead",
            ),
        };
        let remedy = "convert the mesh to glTF, Collada, OBJ or STL for its true shape";
        self.note("mesh-format", level, link, what.to_owned(), remedy);
        Ok(if stand_ins.is_empty() { visuals } else { stand_ins })
    }

    /// Returns a shape; `None` of a mesh in a format that is not supported.
    fn visual(&mut self, element: &'a Element, number: u32) -> Result<Option<LinkVisual>, XmlError> {
        let shape = element
            .child("geometry")
            .and_then(|geometry| geometry.children.first())
            .ok_or_else(|| element.wrong("<geometry> is missing or empty", "add a shape"))?;
        let positive = |name: &str| {
            let value = shape.number(name)?;
            value.filter(|value| *value > 0.0).ok_or_else(|| {
                shape.wrong(
                    format!("{name} must be a number above 0"),
                    format!("give {name} in metres"),
                )
            })
        };
        let shape = match shape.tag.as_str() {
            "box" => {
                let size = shape.vector("size")?.filter(|size| size.cmpgt(DVec3::ZERO).all());
                let remedy = "give three lengths in metres";
                Shape::Box(size.ok_or_else(|| shape.wrong("size must be three numbers above 0", remedy))?)
            }
            "sphere" => Shape::Ellipsoid(DVec3::splat(positive("radius")?)),
            "cylinder" => Shape::Cylinder {
                radius: positive("radius")?,
                length: positive("length")?,
            },
            "capsule" => Shape::Capsule {
                radius: positive("radius")?,
                length: positive("length")?,
            },
            "mesh" => {
                let name = shape.required("filename")?;
                if !import::is_importable(name.as_ref()) {
                    return Ok(None);
                }
                let scale = shape.vector("scale")?.unwrap_or(DVec3::ONE);
                if scale.cmpeq(DVec3::ZERO).any() {
                    return Err(shape.wrong("the scale is 0", "give another scale"));
                }
                Shape::Mesh {
                    file: locate::file(shape, name, self.packages)?,
                    shape_from_file: DAffine3::from_scale(scale),
                }
            }
            tag => {
                let known = ["box", "sphere", "cylinder", "capsule", "mesh"];
                return Err(shape.wrong(format!("unknown shape <{tag}>"), suggest(tag, known)));
            }
        };
        Ok(Some(LinkVisual {
            name: format!("{}_{number}", element.tag),
            link_from_shape: origin(element)?,
            shape,
            color: self.color(element)?,
            place: element.place(),
        }))
    }

    fn color(&mut self, element: &'a Element) -> Result<Option<[f32; 3]>, XmlError> {
        let Some(material) = element.child("material") else {
            return Ok(None);
        };
        if material.child("texture").is_some() {
            let what = "the texture of a material is not supported; its colour is used".to_owned();
            self.note("material-texture", Level::Note, material, what, "");
        }
        let Some(name) = material.get("name") else {
            return color(material);
        };
        let own = color(material)?;
        // A material that is defined in a link can be used in the links that follow.
        if let Some(own) = own {
            self.colors.entry(name).or_insert(own);
        }
        Ok(own.or_else(|| self.colors.get(name).copied()))
    }
}

fn color(material: &Element) -> Result<Option<[f32; 3]>, XmlError> {
    let Some(color) = material.child("color") else {
        return Ok(None);
    };
    let rgba = color.exactly::<4>("rgba")?;
    #[expect(clippy::cast_possible_truncation, reason = "a colour")]
    let narrow = |[r, g, b, _]: [f64; 4]| [r, g, b].map(|share| share.clamp(0.0, 1.0) as f32);
    Ok(rgba.map(narrow))
}

/// The pose of an element in its parent's frame.
fn origin(element: &Element) -> Result<RigidTransform, XmlError> {
    let Some(origin) = element.child("origin") else {
        return Ok(RigidTransform::IDENTITY);
    };
    Ok(RigidTransform::new(
        turn::roll_pitch_yaw(origin.vector("rpy")?.unwrap_or(DVec3::ZERO)),
        origin.vector("xyz")?.unwrap_or(DVec3::ZERO),
    ))
}
