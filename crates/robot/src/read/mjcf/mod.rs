//! MJCF, the format of `MuJoCo`: as `MuJoCo` saves it, and as people write it, with includes, classes of defaults and frames.

mod classes;
mod compiler;
mod include;
mod shape;

use std::collections::HashMap;

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DVec3;

use super::document::{Element, Vectors, XmlError};
use super::robot::{Joint, JointKind, Link, LinkVisual, Robot};
use classes::Classes;
use compiler::Compiler;
use shape::Assets;

/// The maximum number of bodies.
const MAX_BODIES: usize = 10_000;

/// What the bodies of a file may contain that makes shapes, and is not supported.
const UNSUPPORTED: [&str; 5] = ["attach", "composite", "flexcomp", "replicate", "plugin"];

/// What acts on bodies: their motion is not simulated.
const IGNORED_SECTIONS: [(&str, &str); 2] = [
    (
        "equality",
        "constraints between joints are not applied: give the positions of all joints",
    ),
    (
        "deformable",
        "flexible bodies and skins are not supported and are missing in images",
    ),
];

/// The state of reading.
struct Reader {
    compiler: Compiler,
    classes: Classes,
    assets: Assets,
    robot: Robot,
    /// The visible shapes that are left out because of their group.
    hidden: usize,
    names: HashMap<String, u32>,
}

/// Where an element is: its body, its pose in the body, and its class.
#[derive(Clone)]
struct ElementContext<'a> {
    link: usize,
    link_from_frame: RigidTransform,
    class: Option<&'a str>,
}

pub(super) fn read(root: Element) -> Result<Robot, XmlError> {
    let folder = root.file().parent().map(ToOwned::to_owned).unwrap_or_default();
    let root = include::expanded(root, &folder)?;
    let compiler = Compiler::new(&root, &folder)?;
    let classes = Classes::new(&root)?;
    let mut robot = Robot {
        name: root.get("model").unwrap_or("robot").to_owned(),
        ..Robot::default()
    };
    for (tag, what) in IGNORED_SECTIONS {
        let sections = root.all(tag).filter(|section| !section.children.is_empty());
        for section in sections {
            let level = if tag == "deformable" {
                Level::Warning
            } else {
                Level::Note
            };
            robot
                .findings
                .push(Finding::new("mjcf-ignored", level, section.place(), what, ""));
        }
    }
    let assets = Assets::new(&root, &compiler, &classes)?;
    let mut reader = Reader {
        compiler,
        classes,
        assets,
        robot,
        hidden: 0,
        names: HashMap::new(),
    };
    reader.robot.links.push(Link {
        name: "world".to_owned(),
        parent: None,
        parent_from_link: RigidTransform::IDENTITY,
        joints: Vec::new(),
        visuals: Vec::new(),
        is_world: true,
    });
    reader.names.insert("world".to_owned(), 0);
    let place = ElementContext {
        link: 0,
        link_from_frame: RigidTransform::IDENTITY,
        class: None,
    };
    for world in root.all("worldbody") {
        reader.contents(world, &place)?;
    }
    if reader.hidden > 0 {
        reader.robot.findings.push(Finding::new(
            "geom-groups",
            Level::Note,
            "geoms",
            format!(
                "{} geoms of the groups 3 to 5, which MuJoCo does not show either, are left out",
                reader.hidden
            ),
            "",
        ));
    }
    Ok(reader.robot)
}

impl Reader {
    /// Reads what is in a body, or in a frame of it.
    fn contents(&mut self, parent: &Element, place: &ElementContext<'_>) -> Result<(), XmlError> {
        for element in &parent.children {
            match element.tag.as_str() {
                "frame" => {
                    let inner = ElementContext {
                        link: place.link,
                        link_from_frame: place.link_from_frame * self.compiler.pose(element)?,
                        class: element.get("childclass").or(place.class),
                    };
                    self.contents(element, &inner)?;
                }
                "body" => self.body(element, place)?,
                "geom" => self.geom(element, place)?,
                "joint" => self.joint(element, place)?,
                "freejoint" => self.free(element),
                tag if UNSUPPORTED.contains(&tag) => self.robot.findings.push(Finding::new(
                    "mjcf-unsupported",
                    Level::Warning,
                    element.place(),
                    format!("<{tag}> is not supported: what it makes is missing in images"),
                    "load the model in MuJoCo, save it with mj_saveLastXML, and give that file",
                )),
                _ => {}
            }
        }
        Ok(())
    }

    fn body(&mut self, element: &Element, place: &ElementContext<'_>) -> Result<(), XmlError> {
        if self.robot.links.len() >= MAX_BODIES {
            return Err(element.wrong(
                format!("more than {MAX_BODIES} bodies are too many"),
                "give a smaller robot",
            ));
        }
        let link = self.robot.links.len();
        let name = match element.get("name") {
            Some(name) if self.names.contains_key(name) => {
                return Err(element.wrong("there are two bodies of this name", "rename one of them"));
            }
            Some(name) => name.to_owned(),
            None => format!("body_{link}"),
        };
        self.names.insert(name.clone(), 0);
        self.robot.links.push(Link {
            name,
            parent: Some(place.link),
            parent_from_link: place.link_from_frame * self.compiler.pose(element)?,
            joints: Vec::new(),
            visuals: Vec::new(),
            is_world: false,
        });
        let inner = ElementContext {
            link,
            link_from_frame: RigidTransform::IDENTITY,
            class: element.get("childclass").or(place.class),
        };
        self.contents(element, &inner)
    }

    fn free(&mut self, element: &Element) {
        self.robot.findings.push(Finding::new(
            "free-joint",
            Level::Note,
            element.place(),
            "a free joint is not moved: the body is where the file puts it",
            "",
        ));
    }

    fn joint(&mut self, element: &Element, place: &ElementContext<'_>) -> Result<(), XmlError> {
        let joint = self.classes.complete(element, place.class)?;
        let kind = match joint.get("type").unwrap_or("hinge") {
            "hinge" => JointKind::Revolute,
            "slide" => JointKind::Prismatic,
            "free" => {
                self.free(element);
                return Ok(());
            }
            "ball" => {
                self.robot.findings.push(Finding::new(
                    "joint-unsupported",
                    Level::Warning,
                    element.place(),
                    "ball joints are not supported; the body keeps the orientation of the file",
                    "",
                ));
                return Ok(());
            }
            other => {
                let known = ["hinge", "slide", "ball", "free"];
                let remedy = oaktwin_base::diagnostic::suggest(other, known);
                return Err(element.wrong(format!("unknown type '{other}'"), remedy));
            }
        };
        let axis = joint
            .vector("axis")?
            .unwrap_or(DVec3::Z)
            .try_normalize()
            .ok_or_else(|| element.wrong("the axis has no direction", "give a vector other than 0 0 0"))?;
        let unit = match kind {
            JointKind::Revolute => self.compiler.angle,
            JointKind::Prismatic => 1.0,
        };
        let limits = self
            .compiler
            .limits(&joint)?
            .map(|limits| limits.map(|limit| limit * unit));
        let index = self.robot.joints.len();
        let frame = place.link_from_frame;
        self.robot.joints.push(Joint {
            name: joint
                .get("name")
                .map_or_else(|| format!("joint_{index}"), ToOwned::to_owned),
            kind,
            axis: frame.rotation * axis,
            anchor: frame.apply(joint.vector("pos")?.unwrap_or(DVec3::ZERO)),
            limits,
            reference: joint.number("ref")?.unwrap_or(0.0) * unit,
            mimic: None,
        });
        self.robot.links[place.link].joints.push(index);
        Ok(())
    }

    fn geom(&mut self, element: &Element, place: &ElementContext<'_>) -> Result<(), XmlError> {
        let geom = self.classes.complete(element, place.class)?;
        let [r, g, b, alpha] = self.assets.color(&geom)?;
        if alpha <= 0.0 {
            return Ok(());
        }
        if geom.number("group")?.unwrap_or(0.0) > 2.0 {
            self.hidden += 1;
            return Ok(());
        }
        let Some((shape, frame_from_shape)) =
            self.assets
                .shape(&geom, &self.compiler, &mut self.robot.findings)?
        else {
            return Ok(());
        };
        let link = &mut self.robot.links[place.link];
        link.visuals.push(LinkVisual {
            name: format!("geom_{}", link.visuals.len()),
            link_from_shape: place.link_from_frame * frame_from_shape,
            shape,
            color: Some([r, g, b]),
            place: element.place(),
        });
        Ok(())
    }
}
