//! A running `oaktwin studio` and a client without a browser.

use std::f64::consts::FRAC_1_SQRT_2;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use serde_json::{Value, json};
use tungstenite::{Message, WebSocket};

use super::super::program::Program;

/// The time after which a test fails rather than waits.
const PATIENCE: Duration = Duration::from_secs(120);

pub(super) struct Server {
    child: Child,
    pub(super) port: u16,
    pub(super) link: String,
}

/// A decoded frame.
pub(super) struct Frame {
    pub(super) header: Value,
    images: Vec<u8>,
}

impl Frame {
    /// The pixels of an image.
    pub(super) fn image(&self, name: &str) -> Option<Vec<u8>> {
        let images = self.header["images"].as_array().unwrap();
        let image = images.iter().find(|image| image["name"] == name)?;
        let number = |key: &str| usize::try_from(image[key].as_u64().unwrap()).unwrap();
        let bytes = match image["format"].as_str().unwrap() {
            "rgba8" => 4,
            "u16mm" => 2,
            "u8" => 1,
            other => panic!("{other}"),
        };
        let compressed = &self.images[number("offset")..number("offset") + number("length")];
        Some(lz4_flex::block::decompress(compressed, number("width") * number("height") * bytes).unwrap())
    }
}

impl Server {
    /// Starts the program in a folder and waits for its link.
    pub(super) fn start(program: &Program, arguments: &[&str]) -> Self {
        Self::start_with(program, arguments, &[])
    }

    /// The same with variables of the environment.
    pub(super) fn start_with(program: &Program, arguments: &[&str], variables: &[(&str, &Path)]) -> Self {
        let all = [&["studio", "--no-open"], arguments].concat();
        Self::of(program.command(&all).envs(variables.iter().copied()))
    }

    /// Starts the server with a command.
    pub(super) fn of(command: &mut Command) -> Self {
        let mut child = command
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut link = String::new();
        BufReader::new(child.stdout.take().unwrap())
            .read_line(&mut link)
            .unwrap();
        let port = link
            .split(':')
            .nth(2)
            .and_then(|rest| rest.split('/').next()?.parse().ok());
        let port = port.unwrap_or_else(|| panic!("no link: {link}"));
        Self {
            child,
            port,
            link: link.trim().to_owned(),
        }
    }

    /// Sends a request with these lines and returns the status, the headers and the body.
    pub(super) fn raw(&self, request: &str, body: &[u8]) -> (u16, String, Vec<u8>) {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        stream.write_all(request.as_bytes()).unwrap();
        // The server may answer before it has read everything.
        let _ = stream.write_all(body);
        let mut answer = Vec::new();
        let _ = stream.read_to_end(&mut answer);
        let end = answer
            .windows(4)
            .position(|four| four == b"\r\n\r\n")
            .unwrap_or_else(|| panic!("no answer to {request}"));
        let head = String::from_utf8(answer[..end].to_vec()).unwrap();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        (status, head, answer[end + 4..].to_vec())
    }

    pub(super) fn request(&self, method: &str, path: &str, body: &[u8]) -> (u16, Vec<u8>) {
        let head = format!(
            "{method} {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nConnection: close\r\nContent-Length: {}\r\n\r\n",
            self.port,
            body.len()
        );
        let (status, _, body) = self.raw(&head, body);
        (status, body)
    }

    pub(super) fn get(&self, path: &str) -> Value {
        let (status, body) = self.request("GET", path, &[]);
        assert_eq!(status, 200, "{path}");
        serde_json::from_slice(&body).unwrap()
    }

    /// Posts a body and returns the status and the JSON of the answer.
    pub(super) fn post(&self, path: &str, body: &[u8]) -> (u16, Value) {
        let (status, body) = self.request("POST", path, body);
        (
            status,
            serde_json::from_slice(&body).unwrap_or_else(|error| panic!("{path}: {error}")),
        )
    }

    /// Opens a WebSocket as the page does.
    pub(super) fn page(&self) -> WebSocket<TcpStream> {
        let stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        let (page, _) =
            tungstenite::client(format!("ws://127.0.0.1:{}/api/live", self.port), stream).unwrap();
        page
    }

    /// Interrupts the program and returns its exit code and what it wrote to standard error.
    #[cfg(unix)]
    pub(super) fn interrupted(mut self) -> (Option<i32>, String) {
        let id = self.child.id().to_string();
        assert!(
            Command::new("kill")
                .args(["-INT", &id])
                .status()
                .unwrap()
                .success()
        );
        let mut said = String::new();
        self.child
            .stderr
            .take()
            .unwrap()
            .read_to_string(&mut said)
            .unwrap();
        (self.child.wait().unwrap().code(), said)
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The state of an OAK in front of the room of the tests.
pub(super) fn state() -> Value {
    json!({
        "model": "OAK4-D",
        "calibration": null,
        "pose": {"position": [0.0, -2.0, 0.5], "quaternion": [0.0, 0.0, FRAC_1_SQRT_2, FRAC_1_SQRT_2]},
        "sensor": "depth_stereo",
        "lens": "pinhole",
        "engine": "stereo-noise",
        "preset": null,
        "filters": null,
        // The room has no texture.
        "parameters": {"confidenceThreshold": "255"},
        "extendedDisparity": false,
        "seed": 0,
        "deviceSeed": null,
        "populationSeed": null,
        "drift": {},
        "projector": 0.0,
        "ambient": 1.0,
    })
}

/// A request for a small frame.
pub(super) fn request(id: u64, state: &Value) -> Value {
    json!({
        "type": "frame",
        "id": id,
        "oak": "a",
        "scene": "first",
        "state": state,
        "size": [160, 100],
        "images": ["color", "depth", "sensor", "reason"],
        "region": [0.0, 0.0, 1.0, 1.0],
    })
}

pub(super) fn send(page: &mut WebSocket<TcpStream>, message: &Value) {
    page.send(Message::text(message.to_string())).unwrap();
}

/// The next frame; a rejection fails the test.
pub(super) fn frame(page: &mut WebSocket<TcpStream>) -> Frame {
    match page.read().unwrap() {
        Message::Binary(bytes) => {
            let length = u32::from_le_bytes(bytes[..4].try_into().unwrap()) as usize;
            Frame {
                header: serde_json::from_slice(&bytes[4..4 + length]).unwrap(),
                images: bytes[4 + length..].to_vec(),
            }
        }
        other => panic!("{other}"),
    }
}

/// The next answer in text.
pub(super) fn text(page: &mut WebSocket<TcpStream>) -> Value {
    match page.read().unwrap() {
        Message::Text(text) => serde_json::from_str(&text).unwrap(),
        other => panic!("{} bytes", other.len()),
    }
}
