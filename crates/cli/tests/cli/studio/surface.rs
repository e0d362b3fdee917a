//! The painted surface of a region.

use serde_json::{Value, json};

use super::super::render::program;
use super::client::state;
use super::server;

#[test]
fn surfaces_are_painted_with_outcomes() {
    let program = program();
    let server = server(&program);
    let catalog = server.get("/api/catalog");
    let codes: Vec<u64> = catalog["outcomes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|outcome| outcome["code"].as_u64().unwrap())
        .collect();
    assert!(codes.is_sorted() && codes[0] == 0, "{codes:?}");
    let object = server.get("/api/scenes/first")["objects"][0]["path"].clone();
    let post = |region: Value| {
        let request = json!({"scene": "first", "state": state(), "region": region});
        server.request("POST", "/api/coverage/surface", request.to_string().as_bytes())
    };
    let (status, mesh) = post(json!({"object": object}));
    assert_eq!(status, 200, "{}", String::from_utf8_lossy(&mesh));
    let length = u32::from_le_bytes(mesh[..4].try_into().unwrap()) as usize;
    let header: Value = serde_json::from_slice(&mesh[4..4 + length]).unwrap();
    let triangles = usize::try_from(header["triangles"].as_u64().unwrap()).unwrap();
    assert!(triangles >= 20_000, "{triangles}");
    let painted: Vec<u64> = mesh[mesh.len() - 4 * triangles..]
        .chunks(4)
        .map(|code| u64::from(u32::from_le_bytes(code.try_into().unwrap())))
        .collect();
    assert!(painted.iter().all(|code| codes.contains(code)));
    assert!(painted.contains(&0), "the OAK measures a part");
    assert!(painted.iter().any(|code| *code != 0), "and not the back");
    let (status, _) = post(json!({"object": "/Nothing"}));
    assert_eq!(status, 422);
    let (status, _) = post(json!({"minimum": [1.0, 0.0, 0.0], "maximum": [0.0, 0.0, 0.0]}));
    assert_eq!(status, 422);
}
