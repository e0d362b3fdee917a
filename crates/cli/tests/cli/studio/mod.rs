//! `oaktwin studio` without a browser: what it answers, whom it answers, and what survives bad input.

mod client;
mod exports;
mod hard;
mod infrared;
mod models;
mod motion;
mod robot;
mod surface;
mod timeline;
mod units;

use std::net::TcpStream;

use serde_json::{Value, json};
use tungstenite::Message;

use super::program::{EXAMPLE, Program};
use super::render::program;
use client::{Server, frame, request, send, state, text};

fn server(program: &Program) -> Server {
    Server::start(program, &["crate.obj"])
}

#[test]
fn the_catalog_lists_models_engines_and_parameters() {
    let program = program();
    let catalog = server(&program).get("/api/catalog");
    let names = |list: &Value| -> Vec<String> {
        let list = list.as_array().unwrap();
        list.iter()
            .map(|one| one["name"].as_str().unwrap().to_owned())
            .collect()
    };
    assert_eq!(
        names(&catalog["models"])[..2],
        ["OAK-D Pro PoE".to_owned(), "OAK-D Pro W PoE".to_owned()]
    );
    assert_eq!(
        names(&catalog["models"]).len(),
        oaktwin::catalog::Catalog::builtin().devices().len()
    );
    assert_eq!(
        names(&catalog["engines"]),
        ["single-view", "stereo-noise", "stereo-matching", "time-of-flight"]
    );
    assert_eq!(
        catalog["models"][0]["depthSensors"][0]["engines"][0],
        "stereo-noise"
    );
    for filter in catalog["filters"].as_array().unwrap() {
        assert!(!filter["parameters"].as_array().unwrap().is_empty(), "{filter}");
    }
    assert_eq!(catalog["models"][0]["hasProjector"], true);
    for engine in catalog["engines"].as_array().unwrap() {
        for parameter in engine["parameters"].as_array().unwrap() {
            assert!(
                !parameter["documentation"].as_str().unwrap().is_empty(),
                "{parameter}"
            );
        }
    }
}

#[test]
fn frames_follow_the_parameters() {
    let program = program();
    let server = server(&program);
    let mut page = server.page();
    send(&mut page, &request(1, &state()));
    let first = frame(&mut page);
    assert_eq!(
        (&first.header["id"], &first.header["oak"]),
        (&json!(1), &json!("a"))
    );
    let statistics = &first.header["statistics"];
    assert!(statistics["pixels"].as_u64().unwrap() > 0);
    let reasons = statistics["reasons"].as_array().unwrap();
    assert_eq!(
        reasons.iter().map(|count| count.as_u64().unwrap()).sum::<u64>(),
        16_000
    );
    assert_eq!(first.image("color").unwrap().len(), 4 * 16_000);

    let mut biased = state();
    biased["parameters"]["bias"] = json!("0.9");
    send(&mut page, &request(2, &biased));
    let second = frame(&mut page);
    assert_eq!(second.header["parameters"]["bias"], "0.9");
    // The page has the depth already.
    let depth = &second.header["images"][1];
    assert_eq!(
        (&depth["name"], &depth["unchanged"], &depth["length"]),
        (&json!("depth"), &json!(true), &json!(0))
    );
    assert_ne!(first.image("sensor"), second.image("sensor"));
    let error = |frame: &client::Frame| {
        frame.header["statistics"]["medianAbsoluteErrorM"]
            .as_f64()
            .unwrap()
    };
    assert!(error(&second) > error(&first));

    send(&mut page, &request(3, &state()));
    assert_eq!(frame(&mut page).image("sensor"), first.image("sensor"));
}

#[test]
fn coarse_colours_leave_depth_exact() {
    let program = program();
    let server = server(&program);
    let mut page = server.page();
    send(&mut page, &request(1, &state()));
    let exact = frame(&mut page);
    let mut coarse = request(2, &state());
    coarse["colorStep"] = json!(4);
    send(&mut page, &coarse);
    let coarse = frame(&mut page);
    assert_eq!(coarse.image("depth"), exact.image("depth"));
    let (fine, colors) = (exact.image("color").unwrap(), coarse.image("color").unwrap());
    assert_ne!(fine, colors);
    // Colours are interpolated: along a row, no pixel differs from its neighbours as much as samples do.
    let pixel = |x: usize, y: usize| i32::from(colors[4 * (160 * y + x)]);
    for (x, y) in (6..150).step_by(4).flat_map(|x| (0..100).map(move |y| (x, y))) {
        let [first, second, third] = [x, x + 1, x + 2].map(|x| pixel(x, y));
        let bend = (first - 2 * second + third).abs();
        assert!(bend <= 2, "{x}, {y}: {first} {second} {third}");
    }
    let distance: u64 = (fine.iter().zip(&colors))
        .map(|(a, b)| u64::from(a.abs_diff(*b)))
        .sum();
    assert!(
        distance < 8 * colors.len() as u64,
        "the picture is similar: {distance}"
    );
    // At rest, the page asks for the exact colours again.
    send(&mut page, &request(3, &state()));
    assert_eq!(frame(&mut page).image("color").unwrap(), fine);
}

#[test]
fn all_engines_measure() {
    let program = program();
    let server = server(&program);
    let mut page = server.page();
    for (id, model, sensor, engine) in [
        (1, "OAK4-D", "depth_stereo", "single-view"),
        (2, "OAK-D Pro PoE", "depth_stereo", "stereo-matching"),
        (3, "OAK-D ToF", "depth_tof", "time-of-flight"),
    ] {
        let mut state = state();
        (state["model"], state["sensor"], state["engine"]) = (json!(model), json!(sensor), json!(engine));
        state["parameters"] = json!({});
        let mut request = request(id, &state);
        request["images"] = json!(["sensor", "reference", "left", "right", "confidence"]);
        send(&mut page, &request);
        let frame = frame(&mut page);
        assert!(
            frame.image("sensor").unwrap().iter().any(|byte| *byte != 0),
            "{engine}"
        );
        assert!(frame.image("confidence").is_some(), "{engine}");
        assert_eq!(frame.image("left").is_some(), frame.image("right").is_some());
        assert!(frame.image("left").is_some() || model == "OAK-D ToF");
    }
}

#[test]
fn probes_explain_pixels() {
    let program = program();
    let server = server(&program);
    let mut page = server.page();
    let probe = |x: f64, y: f64| json!({"type": "probe", "id": 9, "oak": "a", "x": x, "y": y});
    send(&mut page, &probe(0.5, 0.5));
    assert_eq!(text(&mut page)["type"], "error");
    send(&mut page, &request(1, &state()));
    let measured = frame(&mut page).image("sensor").unwrap();
    let found = measured.chunks(2).position(|depth| depth != [0, 0]).unwrap();
    let [x, y] = [found % 160, found / 160];
    send(
        &mut page,
        &probe((x as f64 + 0.5) / 160.0, (y as f64 + 0.5) / 100.0),
    );
    let answer = text(&mut page);
    assert_eq!(
        (&answer["type"], &answer["id"], &answer["pixel"]),
        (&json!("probe"), &json!(9), &json!([x, y]))
    );
    let number = |key: &str| answer[key].as_f64().unwrap_or_else(|| panic!("{key}: {answer}"));
    assert!((number("measuredM") - number("trueM") - number("errorM")).abs() < 1e-12);
    assert!(number("disparityPx") > 1.0 && number("stepM") > 0.0);
    // The camera looks along y from y = −2.
    assert!(
        (answer["point"][1].as_f64().unwrap() + 2.0 - number("trueM")).abs() < 1e-3,
        "{answer}"
    );
    assert!(answer["object"].is_string());
}

#[test]
fn rejections_name_the_field() {
    let program = program();
    let server = server(&program);
    let mut page = server.page();
    let mut check = |change: &dyn Fn(&mut Value), field: &str| {
        let mut state = state();
        change(&mut state);
        send(&mut page, &request(5, &state));
        let answer = text(&mut page);
        assert_eq!(
            (&answer["type"], &answer["id"], &answer["field"]),
            (&json!("error"), &json!(5), &json!(field)),
            "{answer}"
        );
        assert!(answer["error"].as_str().unwrap().contains(';'), "{answer}");
    };
    check(&|state| state["model"] = json!("OAK5"), "model");
    check(&|state| state["engine"] = json!("stereo"), "engine");
    check(&|state| state["engine"] = json!("time-of-flight"), "engine");
    check(&|state| state["parameters"] = json!({"bias": "far"}), "bias");
    check(&|state| state["parameters"] = json!({"bia": "1"}), "bia");
    check(&|state| state["preset"] = json!("fast"), "preset");
    check(&|state| state["lens"] = json!("fisheye"), "lens");
    check(&|state| state["drift"] = json!({"yaw": "1e9"}), "drift.yaw");
    check(&|state| state["drift"] = json!({"yav": "1"}), "drift.yav");
    check(&|state| state["pose"]["quaternion"] = json!([0, 0, 0, 0]), "pose");
    check(
        &|state| state["calibration"] = json!("calibration-9"),
        "calibration",
    );
    check(
        &|state| {
            state["calibration"] = json!("calibration-9");
            state["populationSeed"] = json!(1);
        },
        "populationSeed",
    );
}

#[test]
fn dropped_files_are_read() {
    let program = program();
    let server = server(&program);
    let room = std::fs::read(program.path("crate.obj")).unwrap();
    let (status, info) = server.post("/api/scenes?name=my%20crate.obj", &room);
    assert_eq!((status, &info["name"]), (200, &json!("my crate.obj")), "{info}");
    let mut page = server.page();
    let mut request = request(1, &state());
    request["scene"] = info["id"].clone();
    send(&mut page, &request);
    assert!(frame(&mut page).header["statistics"]["pixels"].as_u64().unwrap() > 0);

    let calibration = std::fs::read(EXAMPLE).unwrap();
    let (status, info) = server.post("/api/calibrations?name=unit.json", &calibration);
    assert_eq!((status, &info["model"]), (200, &json!("OAK-D Pro PoE")), "{info}");
    let mut state = state();
    (state["model"], state["calibration"]) = (info["model"].clone(), info["id"].clone());
    send(&mut page, &client::request(2, &state));
    assert_eq!(frame(&mut page).header["id"], 2);
}

#[test]
fn broken_files_are_reported_and_change_nothing() {
    let program = program();
    let server = server(&program);
    for (path, body) in [
        ("/api/scenes?name=a.usda", &b"#usda 1.0\ndef {"[..]),
        ("/api/scenes?name=a.glb", b"\x00\x01\x02"),
        ("/api/scenes?name=empty.obj", b""),
        ("/api/scenes?name=a.txt", b"text"),
        ("/api/scenes?name=..", b"text"),
        ("/api/calibrations?name=a.json", b"{"),
        ("/api/accuracy", b"{}"),
        ("/api/export", b"[]"),
    ] {
        let (status, answer) = server.post(path, body);
        assert_eq!(status, 422, "{path}: {answer}");
        let error = answer["error"].as_str().unwrap();
        assert!(!error.contains("/tmp"), "{error}");
    }
    // The body does not follow: its announced length is enough.
    let head = format!(
        "POST /api/scenes?name=a.glb HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nContent-Length: 9000000000\r\n\r\n",
        server.port
    );
    assert_eq!(server.raw(&(head.clone() + "Connection: close\r\n"), &[]).0, 413);
    assert_eq!(server.get("/api/scenes/first")["name"], "crate.obj");
}

#[test]
fn other_sites_and_hosts_are_not_answered() {
    let program = program();
    let server = server(&program);
    let port = server.port;
    let status = |path: &str, lines: &str| {
        let request = format!("GET {path} HTTP/1.1\r\n{lines}Connection: close\r\n\r\n");
        server.raw(&request, &[]).0
    };
    for path in [
        "/",
        "/studio.js",
        "/api/catalog",
        "/api/scenes/first/mesh",
        "/api/live",
        "/nothing",
    ] {
        assert_eq!(status(path, "Host: evil.test\r\n"), 403, "{path}");
        let foreign = format!("Host: 127.0.0.1:{port}\r\nOrigin: http://evil.test\r\n");
        assert_eq!(status(path, &foreign), 403, "{path}");
    }
    let upgrade =
        "Upgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
    let lines = format!("Host: 127.0.0.1:{port}\r\nOrigin: null\r\nConnection: close, Upgrade\r\n{upgrade}");
    assert_eq!(
        server
            .raw(&format!("GET /api/live HTTP/1.1\r\n{lines}\r\n"), &[])
            .0,
        403
    );
    let (_, head, _) = server.raw(
        &format!("GET / HTTP/1.1\r\nHost: localhost:{port}\r\nConnection: close\r\n\r\n"),
        &[],
    );
    assert!(
        head.to_lowercase()
            .contains("content-security-policy: default-src 'self'"),
        "{head}"
    );
}

#[test]
fn a_link_for_other_machines_has_a_token() {
    let program = program();
    let server = Server::start(&program, &["crate.obj", "--host", "0.0.0.0"]);
    let (_, token) = server.link.split_once("?token=").unwrap();
    assert_eq!(token.len(), 32);
    let get = |path: &str, more: &str| {
        let request = format!(
            "GET {path} HTTP/1.1\r\nHost: robot:{}\r\n{more}Connection: close\r\n\r\n",
            server.port
        );
        server.raw(&request, &[])
    };
    assert_eq!(get("/api/catalog", "").0, 403);
    assert_eq!(get("/?token=0", "").0, 403);
    let (status, head, _) = get(&format!("/?token={token}"), "");
    assert_eq!(status, 303);
    assert!(
        head.to_lowercase().contains("httponly; samesite=strict"),
        "{head}"
    );
    assert_eq!(
        get("/api/catalog", &format!("Cookie: oaktwin-studio={token}\r\n")).0,
        200
    );
}

#[test]
fn garbage_and_idle_connections_do_no_harm() {
    let program = program();
    let server = server(&program);
    let idle: Vec<TcpStream> = (0..100)
        .map(|_| TcpStream::connect(("127.0.0.1", server.port)).unwrap())
        .collect();
    let mut page = server.page();
    for garbage in ["", "{", "null", "{\"type\":\"frame\"}", "[[[[[[[[[[[[[[[["] {
        page.send(Message::text(garbage)).unwrap();
        assert_eq!(text(&mut page)["type"], "error", "{garbage}");
    }
    let mut long = server.page();
    let _ = long.send(Message::text("x".repeat(1 << 20)));
    while let Ok(answer) = long.read() {
        assert!(!answer.is_binary());
    }
    let mut binary = server.page();
    binary.send(Message::binary(vec![1, 2, 3])).unwrap();
    while let Ok(answer) = binary.read() {
        assert!(!answer.is_binary());
    }
    send(&mut page, &request(1, &state()));
    assert_eq!(frame(&mut page).header["id"], 1);
    drop(idle);
}

#[test]
fn the_newest_request_of_an_oak_wins() {
    let program = program();
    let server = server(&program);
    let mut page = server.page();
    for id in 1..=50 {
        send(&mut page, &request(id, &state()));
    }
    let mut ids = Vec::new();
    while ids.last() != Some(&50) {
        ids.push(frame(&mut page).header["id"].as_u64().unwrap());
    }
    assert!(ids.is_sorted(), "{ids:?}");
    assert!(ids.len() < 50, "{ids:?}");
}

#[cfg(unix)]
#[test]
fn ctrl_c_stops_the_server() {
    let program = program();
    let server = server(&program);
    let mut page = server.page();
    let (code, said) = server.interrupted();
    assert_eq!((code, said.as_str()), (Some(130), "Press Ctrl-C to stop.\n"));
    while page.read().is_ok() {}
}

#[test]
fn bad_arguments_are_reported_at_once() {
    let program = program();
    for arguments in [
        &["studio", "nothing.usd", "--no-open"][..],
        &["studio", "crate.obj", "--no-open", "--model", "OAK5"],
        &["studio", "crate.obj", "--no-open", "--host", "192.0.2.1"],
    ] {
        let ended = program.run(arguments);
        assert_eq!((ended.code, ended.stdout.as_str()), (2, ""), "{}", ended.stderr);
        assert!(
            ended.stderr.starts_with("error: ") && ended.stderr.contains("; "),
            "{}",
            ended.stderr
        );
    }
    let server = server(&program);
    let port = server.port.to_string();
    let ended = program.run(&["studio", "crate.obj", "--no-open", "--port", &port]);
    assert_eq!(ended.code, 2);
    assert!(ended.stderr.contains("choose another port"), "{}", ended.stderr);
}
