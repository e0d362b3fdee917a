//! Frames of every model of the catalog.

use serde_json::{Value, json};

use super::super::render::program;
use super::client::{frame, request, send, state, text};
use super::server;

#[test]
fn every_model_has_frames_with_each_of_its_sensors_and_engines() {
    let program = program();
    let server = server(&program);
    let catalog = server.get("/api/catalog");
    let mut page = server.page();
    let (mut id, mut without_depth) = (0, Vec::new());
    for model in catalog["models"].as_array().unwrap() {
        let name = model["name"].as_str().unwrap();
        let sensors = model["depthSensors"].as_array().unwrap();
        if sensors.is_empty() {
            without_depth.push(name);
        }
        for sensor in sensors {
            for engine in sensor["engines"].as_array().unwrap() {
                id += 1;
                let mut wanted = state();
                (wanted["model"], wanted["parameters"]) = (model["name"].clone(), json!({}));
                (wanted["sensor"], wanted["engine"]) = (sensor["id"].clone(), engine.clone());
                let mut request = request(id, &wanted);
                request["size"] = json!([64, 40]);
                // Another OAK for each: images that the page has already are not sent again.
                request["oak"] = json!(id.to_string());
                send(&mut page, &request);
                let frame = frame(&mut page);
                let place = format!("{name}, {}, {engine}", sensor["id"]);
                assert_eq!(frame.header["id"], json!(id), "{place}");
                // Images that the page has already are named without their pixels.
                let images = frame.header["images"].as_array().unwrap();
                for wanted in ["depth", "sensor", "reason"] {
                    let image = images.iter().find(|image| image["name"] == wanted);
                    let image = image.unwrap_or_else(|| panic!("{place}: no {wanted}"));
                    let size = (&image["width"], &image["height"]);
                    assert_eq!(size, (&json!(64), &json!(40)), "{place}: {wanted}");
                }
                let reasons: u64 = frame.header["statistics"]["reasons"]
                    .as_array()
                    .unwrap()
                    .iter()
                    .map(|count| count.as_u64().unwrap())
                    .sum();
                assert_eq!(reasons, 64 * 40, "{place}");
            }
        }
    }
    assert!(id > 50, "{id}");
    assert_eq!(
        without_depth,
        [
            "OAK4-CS",
            "OAK4-S",
            "OAK-1",
            "OAK-1 Lite",
            "OAK-1 MAX",
            "OAK-1 W",
            "OAK Thermal"
        ]
    );
    for name in without_depth {
        let mut wanted = state();
        wanted["model"] = json!(name);
        send(&mut page, &request(1000, &wanted));
        let answer: Value = text(&mut page);
        assert_eq!(
            (&answer["type"], &answer["field"]),
            (&json!("error"), &json!("sensor")),
            "{answer}"
        );
    }
}
