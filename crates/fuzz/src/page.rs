//! The protocol of the page of `oaktwin studio`.

use std::sync::LazyLock;

use oaktwin_studio::Offline;
use serde_json::{Map, Value, json};

use crate::json::change;
use crate::random::Random;

/// What the server says if a computation panicked.
const PANICKED: &str = "please report this";

static SERVER: LazyLock<Offline> = LazyLock::new(|| {
    let folder = tempfile::tempdir().unwrap_or_else(|error| panic!("{error}"));
    let path = folder.path().join("scene.obj");
    // A floor and a wall.
    let text = "o floor\nv -2 0 0\nv 2 0 0\nv 2 4 0\nv -2 4 0\nf 1 2 3 4\no wall\nv -2 2 0\nv 2 2 0\nv 2 2 2\nf 5 6 7\n";
    std::fs::write(&path, text).unwrap_or_else(|error| panic!("{error}"));
    Offline::new(&path).unwrap_or_else(|error| panic!("{error}"))
});

/// The names that the catalog of the page lists.
struct Names {
    models: Vec<String>,
    engines: Vec<String>,
    parameters: Vec<String>,
    filters: Vec<String>,
}

static NAMES: LazyLock<Names> = LazyLock::new(|| {
    let (_, catalog) = SERVER.http("GET", "/api/catalog", Vec::new()).unwrap_or_default();
    let catalog: Value = serde_json::from_slice(&catalog).unwrap_or_default();
    let names = |list: &Value| -> Vec<String> {
        let list = list.as_array().into_iter().flatten();
        list.filter_map(|one| Some(one["name"].as_str()?.to_owned()))
            .collect()
    };
    let engines = catalog["engines"].as_array().into_iter().flatten();
    Names {
        models: names(&catalog["models"]),
        engines: names(&catalog["engines"]),
        parameters: engines.flat_map(|engine| names(&engine["parameters"])).collect(),
        filters: names(&catalog["filters"]),
    }
});

/// Sends the server one request of the page, over its WebSocket or over HTTP. The server must answer without a panic, and an error must
/// state a remedy.
pub(crate) fn check(bytes: &[u8]) {
    let mut random = Random::new(bytes);
    match random.up_to(255) {
        0..=7 => answered(&SERVER.message(&random.text())),
        // Measured with all pixels of a model, so these take longer and are rarer.
        8 => post(&mut random, "/api/coverage", coverage),
        9 => post(&mut random, "/api/coverage/surface", surface),
        10 => post(&mut random, "/api/accuracy", state),
        11..=127 => {
            let message = frame(&mut random);
            answered(&SERVER.message(&changed(&mut random, message)));
            let probe = json!({"type": "probe", "id": 1, "oak": "a", "x": number(&mut random), "y": 0.5});
            answered(&SERVER.message(&changed(&mut random, probe)));
        }
        128..=191 => post(&mut random, "/api/export", export),
        _ => {
            let method = random.pick(&["GET", "POST", "PUT", "HEAD"]);
            let path = random.pick(&[
                "/api/scenes?name=",
                "/api/calibrations?name=",
                "/api/scenes/",
                "/api/scenes/first/mesh?triangles=",
                "/api/models/OAK4-D/body",
                "/api/models/",
                "/api/live",
                "/",
            ]);
            let address = format!("{path}{}", random.text());
            let body = random.text().into_bytes();
            if let Some((status, answer)) = SERVER.http(method, &address, body) {
                assert!(status != 500, "{address}");
                assert!(!contains(&answer, PANICKED), "{address}");
            }
            assert_eq!(SERVER.uploads(), 0, "{address}");
        }
    }
}

fn post(random: &mut Random<'_>, path: &str, document: fn(&mut Random<'_>) -> Value) {
    let document = document(random);
    let text = changed(random, document);
    let answer = SERVER.http("POST", path, text.clone().into_bytes());
    let (status, answer) = answer.unwrap_or_else(|| panic!("{path} is no address"));
    assert!(status == 200 || status == 422, "{path}: {status}: {text}");
    if status == 422 {
        let error: Value = serde_json::from_slice(&answer).unwrap_or_default();
        assert!(error["error"].is_string(), "{path}: {text}");
    }
    assert!(!contains(&answer, PANICKED), "{path}: {text}");
}

/// An answer on the socket: a frame, or JSON.
fn answered(answer: &[u8]) {
    assert!(!answer.is_empty());
    assert!(!contains(answer, PANICKED), "{}", String::from_utf8_lossy(answer));
    let header = match answer.first() {
        Some(b'{') => answer,
        _ => {
            let length = answer
                .first_chunk()
                .map_or(0, |length| u32::from_le_bytes(*length));
            &answer[4..4 + length as usize]
        }
    };
    let header: Value = serde_json::from_slice(header).unwrap_or_else(|error| panic!("{error}"));
    assert!(header["id"].is_u64(), "{header}");
}

fn contains(bytes: &[u8], text: &str) -> bool {
    bytes.windows(text.len()).any(|part| part == text.as_bytes())
}

/// The text of a document, of which a part may be replaced.
fn changed(random: &mut Random<'_>, mut document: Value) -> String {
    if random.up_to(2) == 0 {
        change(&mut document, random);
    }
    if let Some(size) = document.get_mut("size")
        && (size.is_null() || size[0].as_u64() > Some(64) && size[0].as_u64() < Some(1 << 25))
    {
        // A valid size that takes time.
        *size = json!([64, 40]);
    }
    document.to_string()
}

fn frame(random: &mut Random<'_>) -> Value {
    json!({
        "type": "frame",
        "id": 1,
        "oak": random.pick(&["a", "b"]),
        "scene": random.pick(&["first", "second"]),
        "state": state(random),
        "size": size(random),
        "images": ["color", "depth", "sensor", "reason", "left", "confidence", "left"],
        "region": [number(random), 0.0, 1.0, number(random)],
        "colorStep": random.up_to(9),
    })
}

/// A small size, or one that is refused: frames of others take time.
fn size(random: &mut Random<'_>) -> Value {
    match random.up_to(7) {
        0 => json!([random.up_to(u32::MAX) | 1 << 25, 1 + random.up_to(u32::MAX - 1)]),
        1 => json!([0, random.byte()]),
        _ => json!([16 + random.up_to(48), 16 + random.up_to(48)]),
    }
}

fn state(random: &mut Random<'_>) -> Value {
    let mut parameters = Map::new();
    for _ in 0..random.up_to(3) {
        let name = name(random, &NAMES.parameters);
        parameters.insert(name, Value::from(written(random)));
    }
    let filters = (0..random.up_to(2)).map(|_| name(random, &NAMES.filters));
    let filters: Vec<String> = filters.collect();
    let mut drift = Map::new();
    if random.up_to(3) == 0 {
        let part = random.pick(&["yaw", "pitch", "roll", "baseline", "focal", "temperature"]);
        drift.insert(part.to_owned(), Value::from(written(random)));
    }
    // Engines that match pairs take longer.
    let engine = match random.up_to(7) {
        0 => name(random, &NAMES.engines),
        _ => random
            .pick(&["stereo-noise", "single-view", "time-of-flight"])
            .to_owned(),
    };
    json!({
        "model": name(random, &NAMES.models),
        "calibration": null,
        "pose": {
            "position": [number(random), number(random), 0.5],
            "quaternion": [0.0, 0.0, std::f64::consts::FRAC_1_SQRT_2, std::f64::consts::FRAC_1_SQRT_2],
        },
        "sensor": random.pick(&["depth_stereo", "depth_tof", "color"]),
        "lens": random.pick(&["pinhole", "fisheye"]),
        "engine": engine,
        "preset": random.pick(&[None, None, Some("default"), Some("FAST_DENSITY"), Some("x")]),
        "filters": filters,
        "parameters": parameters,
        "extendedDisparity": random.up_to(1) == 1,
        "seed": random.up_to(9),
        "deviceSeed": random.pick(&[Some(1), Some(2), None]),
        "populationSeed": random.pick(&[None, None, None, Some(5)]),
        "drift": drift,
        "projector": number(random),
        "ambient": number(random),
    })
}

/// A name of a list, or any text.
fn name(random: &mut Random<'_>, all: &[String]) -> String {
    match random.up_to(15) {
        0 => random.text(),
        _ => match all.len() {
            0 => String::new(),
            count => all[random.up_to(u32::try_from(count - 1).unwrap_or(0)) as usize].clone(),
        },
    }
}

/// A number as the page writes it, or any text.
fn written(random: &mut Random<'_>) -> String {
    match random.up_to(7) {
        0 => random.text(),
        1 => random
            .pick(&["true", "nan", "inf", "-inf", "1e999", "", "0x10"])
            .to_owned(),
        _ => random.number().to_string(),
    }
}

/// A number of JSON, which has none that is not finite.
fn number(random: &mut Random<'_>) -> f64 {
    match random.up_to(2) {
        0 => random.number(),
        _ => f64::from(random.byte()) / 128.0,
    }
}

fn export(random: &mut Random<'_>) -> Value {
    let what = [
        "asset",
        "robot",
        "image",
        "error",
        "statistics",
        "parameters",
        "command",
        "python",
    ];
    json!({
        "what": random.pick(&what),
        "scene": "first",
        "state": state(random),
        "size": size(random),
        "image": random.pick(&[None, Some("sensor"), Some("right"), Some("color")]),
        "format": random.pick(&[None, Some("usda"), Some("urdf"), Some("png"), Some("npy"), Some("csv"), Some("json"), Some("x")]),
    })
}

fn region(random: &mut Random<'_>) -> Value {
    match random.up_to(2) {
        0 => json!({"object": random.pick(&["/wall", "/floor", "", "/"])}),
        1 => json!({"minimum": [number(random), -9.0, -9.0], "maximum": [9.0, number(random), 9.0]}),
        _ => json!({"minimum": [-9.0, -9.0, -9.0], "maximum": [9.0, 9.0, 9.0]}),
    }
}

fn coverage(random: &mut Random<'_>) -> Value {
    json!({"scene": "first", "states": [state(random)], "region": region(random)})
}

fn surface(random: &mut Random<'_>) -> Value {
    json!({"scene": "first", "state": state(random), "region": region(random)})
}

pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let filled = |first: u8, step: u8| {
        let rest = (0..255u8).map(|index| index.wrapping_mul(step).wrapping_add(first));
        [vec![first], rest.collect()].concat()
    };
    // Several of each kind of request.
    [0, 8, 9, 10, 11, 40, 70, 100, 128, 150, 180, 192, 220, 250]
        .into_iter()
        .flat_map(|first| [filled(first, 0), filled(first, 37)])
        .collect()
}
