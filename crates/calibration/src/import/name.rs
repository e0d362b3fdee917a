use oaktwin_base::diagnostic::fold_name;

use crate::Socket;

/// The socket of a camera with a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedCamera {
    /// The name in its file, `M1` or `M2` in OpenCV's stereo files, or the name of the file without its extension.
    pub name: String,
    /// The socket.
    pub socket: Socket,
}

impl NamedCamera {
    /// Creates a name from `NAME=POSITION`, where the position is left, right, rgb, tof, or a socket from `cam_a` to `cam_j`; `None` for
    /// other texts.
    #[must_use]
    pub fn from_text(text: &str) -> Option<Self> {
        let (name, position) = text.split_once('=')?;
        let socket = word(&fold_name(position)).or_else(|| Socket::from_name(position))?;
        (!name.is_empty()).then(|| Self {
            name: name.to_owned(),
            socket,
        })
    }

    pub(super) fn is_any_of(&self, names: &[String]) -> bool {
        names.iter().any(|name| fold_name(name) == fold_name(&self.name))
    }
}

/// Returns the socket of a camera with these names, the most specific first.
pub(super) fn socket(names: &[String], given: &[NamedCamera]) -> Option<Socket> {
    let named = given.iter().find(|camera| camera.is_any_of(names));
    named
        .map(|camera| camera.socket)
        .or_else(|| names.iter().find_map(|name| conventional(name)))
}

/// Returns the socket that a name such as `narrow_stereo/left`, `rgb_camera` or `CAM_D` states.
fn conventional(name: &str) -> Option<Socket> {
    Socket::from_name(name).or_else(|| {
        let lower = name.to_lowercase();
        lower.split(|c: char| !c.is_alphabetic()).find_map(word)
    })
}

fn word(word: &str) -> Option<Socket> {
    match word {
        "left" => Some(Socket::CAM_B),
        "right" => Some(Socket::CAM_C),
        "rgb" | "color" | "colour" | "tof" => Some(Socket::CAM_A),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_state_sockets() {
        for (name, socket) in [
            ("left", Some(Socket::CAM_B)),
            ("narrow_stereo/right", Some(Socket::CAM_C)),
            ("rgb_camera", Some(Socket::CAM_A)),
            ("CAM_D", Some(Socket(3))),
            ("cam_j", Some(Socket::LAST)),
            ("cam0", None),
            ("cam_k", None),
            ("camera", None),
            ("bright", None),
        ] {
            assert_eq!(conventional(name), socket, "{name}");
        }
        let given = NamedCamera::from_text("cam0=Right").unwrap();
        assert_eq!(
            socket(&["CAM0".to_owned(), "left".to_owned()], &[given]),
            Some(Socket::CAM_C)
        );
        assert_eq!(NamedCamera::from_text("cam0=cam_d").unwrap().socket, Socket(3));
        for text in ["cam0", "=left", "cam0=middle", "cam0="] {
            assert_eq!(NamedCamera::from_text(text), None, "{text}");
        }
    }
}
