//! Scenes with other reflectances in the infrared than their files state.
//!
//! The id of such a scene is the scene's own with the reflectances: `first;floor=0.5;wood=0.2`, before a time code or a posture. Names are
//! percent-encoded.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use oaktwin::render::{OpenOptions, Renderer};

use super::LoadedScene;
use super::recent::{Recent, keep, used};
use crate::protocol::{Failure, SceneInfo};

/// What separates the id of a scene from each reflectance.
const REFLECTANCE: char = ';';
/// The number of such scenes that are kept: each is read from its file again.
const KEPT: usize = 3;
/// The maximum number of reflectances of a scene.
const MAX_REFLECTANCES: usize = 100;

/// Separates the id of a scene from its reflectances.
pub(crate) fn split(id: &str) -> Option<(&str, &str)> {
    id.split_once(REFLECTANCE)
}

/// Returns the id of a scene with the reflectances of [`split`].
pub(crate) fn reflecting(id: &str, reflectances: &str) -> String {
    format!("{id}{REFLECTANCE}{reflectances}")
}

/// Reads the reflectances of an id.
pub(crate) fn parse(text: &str) -> Result<BTreeMap<String, f64>, Failure> {
    let wrong = |what: &str| Failure::of("infrared", &format!("{what}; open the page without its link"));
    let one = |part: &str| {
        let (name, value) = part.rsplit_once('=')?;
        Some((decoded(name)?, value.parse().ok()?))
    };
    let parts = text.split(REFLECTANCE);
    let read = parts.map(|part| one(part).ok_or_else(|| wrong(&format!("'{part}' is not NAME=REFLECTANCE"))));
    let read: BTreeMap<String, f64> = read.collect::<Result<_, _>>()?;
    match read.len() <= MAX_REFLECTANCES {
        true => Ok(read),
        false => Err(wrong(&format!(
            "more than {MAX_REFLECTANCES} reflectances are too many"
        ))),
    }
}

/// Decodes a percent-encoded name.
fn decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::new();
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        bytes.push(match byte {
            b'%' => {
                let digits = [rest.next()?, rest.next()?];
                u8::from_str_radix(std::str::from_utf8(&digits).ok()?, 16).ok()?
            }
            byte => byte,
        });
    }
    String::from_utf8(bytes).ok()
}

/// Scenes with other reflectances.
#[derive(Debug, Default)]
pub(crate) struct Reflecting(Mutex<Recent>);

impl Reflecting {
    /// Returns a scene with other reflectances, under the id that has them.
    pub(super) fn get(
        &self,
        id: &str,
        scene: &LoadedScene,
        reflectances: &str,
    ) -> Result<Arc<LoadedScene>, Failure> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match used(&mut known, id) {
            Some(found) => Ok(found),
            None => Ok(keep(
                &mut known,
                scene.reflecting(id, parse(reflectances)?)?,
                KEPT,
            )),
        }
    }

    /// Keeps a scene, in place of the same one.
    pub(crate) fn add(&self, scene: LoadedScene) -> Arc<LoadedScene> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.retain(|other| other.info.id != scene.info.id);
        keep(&mut known, scene, KEPT)
    }
}

impl LoadedScene {
    /// Reads the scene again, with other reflectances in the infrared and another id. As on a command line, they do not apply to its robot.
    pub(crate) fn reflecting(&self, id: &str, infrared: BTreeMap<String, f64>) -> Result<Self, Failure> {
        let options = OpenOptions {
            infrared,
            ..self.options.clone()
        };
        let names = (id, self.info.name.as_str(), self.argument.as_str());
        let read = Self::open(&self.path, &options, names)?;
        let info = SceneInfo {
            id: id.to_owned(),
            ..self.info.clone()
        };
        let mut scene = Self {
            info,
            made_by: self.made_by.clone(),
            kept: self.kept.clone(),
            ..read
        };
        if let Some(robot) = &self.robot {
            let mut with_robot = scene.renderer.scene().clone();
            scene.robot = Some(robot.again(&mut with_robot)?);
            scene.renderer = Renderer::new(with_robot);
            scene.moving = None;
        }
        Ok(scene)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_reflectances_are_encoded() {
        let id = reflecting("first", "a%3B%40%7E%20%C3%A9=0.25;Looks%2FRed=1");
        let (own, text) = split(&id).unwrap();
        let read = parse(text).unwrap();
        let expected = [("a;@~ é".to_owned(), 0.25), ("Looks/Red".to_owned(), 1.0)];
        assert_eq!((own, read), ("first", BTreeMap::from(expected)));
        for wrong in ["", "a", "a=", "a=x", "%4=1", "%zz=1", "%ff=1", "a=1;"] {
            let error = parse(wrong).unwrap_err().error;
            assert!(error.contains("is not NAME=REFLECTANCE"), "{wrong}: {error}");
        }
        let many: Vec<String> = (0..=MAX_REFLECTANCES).map(|i| format!("a{i}=0")).collect();
        assert!(parse(&many.join(";")).unwrap_err().error.contains("too many"));
    }
}
