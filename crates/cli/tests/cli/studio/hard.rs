//! What a hostile page, file or name does to the server and to what is taken away from it.

use std::io::Write;
use std::net::TcpStream;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};
use std::{fs, thread};

use serde_json::{Value, json};

use super::super::program::Program;
use super::super::render::program;
use super::client::{Server, frame, request, send, state, text};
use super::server;

#[test]
fn every_answer_has_the_headers_that_restrict_a_page() {
    let program = program();
    let server = server(&program);
    let host = format!("Host: 127.0.0.1:{}\r\nConnection: close\r\n", server.port);
    for (line, lines, status) in [
        ("GET /", host.as_str(), 200),
        ("GET /studio.js", &host, 200),
        ("GET /api/catalog", &host, 200),
        ("GET /api/scenes/first/mesh", &host, 200),
        ("GET /api/scenes/first/mesh?triangles=x", &host, 400),
        ("GET /nothing", &host, 404),
        ("PUT /", &host, 405),
        ("POST /api/export", &host, 422),
        ("GET /", "Host: evil.test\r\nConnection: close\r\n", 403),
    ] {
        let (found, head, _) = server.raw(&format!("{line} HTTP/1.1\r\n{lines}\r\n"), &[]);
        assert_eq!(found, status, "{line}: {head}");
        let head = head.to_lowercase();
        for header in [
            "content-security-policy: default-src 'self'; ",
            "x-content-type-options: nosniff\r\n",
            "referrer-policy: no-referrer\r\n",
            "cache-control: no-store\r\n",
            "cross-origin-resource-policy: same-origin",
        ] {
            assert!(head.contains(header), "{line}: {header}: {head}");
        }
        assert!(!head.contains("unsafe-"), "{head}");
    }
}

/// Waits until a folder has some files, or none.
fn wait_for(folder: &Path, is_there: impl Fn(usize) -> bool) {
    let begin = Instant::now();
    let count = || fs::read_dir(folder).map_or(0, Iterator::count);
    while !is_there(count()) {
        assert!(begin.elapsed() < Duration::from_secs(60), "{} files", count());
        thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn uploads_that_stop_half_way_leave_nothing() {
    let program = program();
    let temporary = program.path("temporary");
    fs::create_dir(&temporary).unwrap();
    let server = Server::start_with(&program, &["crate.obj"], &[("TMPDIR", &temporary)]);
    let uploads = fs::read_dir(&temporary).unwrap().next().unwrap().unwrap().path();
    let mut stream = TcpStream::connect(("127.0.0.1", server.port)).unwrap();
    let head = format!(
        "POST /api/scenes?name=a.obj HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nContent-Length: 1000\r\n\r\nv 0 0 0",
        server.port
    );
    stream.write_all(head.as_bytes()).unwrap();
    wait_for(&uploads, |count| count == 1);
    drop(stream);
    wait_for(&uploads, |count| count == 0);
    let (status, _) = server.post("/api/scenes?name=a.obj", b"no triangles");
    assert_eq!(status, 422);
    wait_for(&uploads, |count| count == 0);
}

#[test]
#[cfg(target_os = "linux")]
fn uploads_that_do_not_fit_on_the_disk_leave_nothing() {
    let program = program();
    let temporary = program.path("temporary");
    fs::create_dir(&temporary).unwrap();
    let mut command = program.command_with_small_files(&["studio", "--no-open", "crate.obj"]);
    let server = Server::of(command.env("TMPDIR", &temporary));
    let uploads = fs::read_dir(&temporary).unwrap().next().unwrap().unwrap().path();
    let large = "v 0 0 0\n".repeat(10_000);
    let (status, answer) = server.post("/api/scenes?name=a.obj", large.as_bytes());
    let error = answer["error"].as_str().unwrap_or_default();
    assert_eq!(status, 422, "{answer}");
    assert!(
        error.contains("cannot be kept") && error.contains("free some space"),
        "{error}"
    );
    wait_for(&uploads, |count| count == 0);
    // The server lives.
    let small = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    assert_eq!(server.post("/api/scenes?name=b.obj", small.as_bytes()).0, 200);
}

#[test]
fn numbers_are_in_the_ranges_of_the_command_line() {
    let program = program();
    let server = server(&program);
    for (engine, name) in [
        ("single-view", "baselineMM"),
        ("single-view", "focalLengthPixel"),
        ("single-view", "sensorSizePixel"),
        ("single-view", "maxDisparityPixel"),
        ("single-view", "noiseMean"),
        ("stereo-noise", "baseline"),
        ("stereo-noise", "focalLength"),
        ("stereo-noise", "jitter"),
        ("stereo-matching", "focalLength"),
    ] {
        for value in ["1e300", "-1e300", "nan", "inf", "-inf", "1e999", ""] {
            let mut state = state();
            state["engine"] = json!(engine);
            state["parameters"] = json!({name: value});
            let (status, answer) = server.post("/api/accuracy", state.to_string().as_bytes());
            let error = answer["error"].as_str().unwrap_or_default();
            assert_eq!(status, 422, "{name}={value}: {answer}");
            assert!(
                error.contains(name) && error.contains("; "),
                "{name}={value}: {error}"
            );
        }
    }
    // In its range, but nothing can be measured.
    let mut state = state();
    state["engine"] = json!("single-view");
    state["parameters"] =
        json!({"baselineMM": "1000000", "focalLengthPixel": "1000000", "maxDisparityPixel": "0.001"});
    let (status, answer) = server.post("/api/accuracy", state.to_string().as_bytes());
    assert_eq!(status, 422, "{answer}");
    assert!(
        answer["error"].as_str().unwrap().starts_with("distances: "),
        "{answer}"
    );
    assert_eq!(server.get("/api/scenes/first")["name"], "crate.obj");
}

#[test]
fn requests_that_ask_for_too_much_are_refused_or_shortened() {
    let program = program();
    let server = server(&program);
    let mut page = server.page();
    let mut refused = |change: &dyn Fn(&mut Value), field: &str| {
        let mut request = request(5, &state());
        change(&mut request);
        send(&mut page, &request);
        let answer = text(&mut page);
        assert_eq!(
            (&answer["type"], &answer["field"]),
            (&json!("error"), &json!(field)),
            "{answer}"
        );
    };
    refused(&|request| request["size"] = json!([60_000, 60_000]), "size");
    refused(
        &|request| request["size"] = json!([4_294_967_295u32, 4_294_967_295u32]),
        "size",
    );
    refused(
        &|request| request["state"]["filters"] = json!(vec!["spatial"; 1000]),
        "filters",
    );
    let mut repeated = request(6, &state());
    repeated["images"] = json!(vec!["sensor"; 5000]);
    send(&mut page, &repeated);
    let images = frame(&mut page).header["images"].clone();
    assert_eq!(images.as_array().unwrap().len(), 1, "{images}");
    // OAKs that were never requested.
    for number in 0..100 {
        let probe = json!({"type": "probe", "id": 1, "oak": format!("unknown {number}"), "x": 0.5, "y": 0.5});
        send(&mut page, &probe);
        assert_eq!(text(&mut page)["type"], "error");
    }
    let states = vec![state(); 1001];
    let asked = json!({"scene": "first", "states": states, "region": {"object": "/"}});
    let (status, answer) = server.post("/api/coverage", asked.to_string().as_bytes());
    assert_eq!((status, &answer["field"]), (422, &json!("states")), "{answer}");
}

/// A file of 0.4 MB with 900 million triangles: 10 000 nodes share a mesh of 10 000 primitives.
#[test]
fn a_small_file_of_many_triangles_is_refused_and_the_server_lives() {
    let program = program();
    let server = server(&program);
    let corners = (0..9u8).flat_map(|i| {
        let x = f32::from(i);
        [x, 0.0, 0.0, x + 1.0, 0.0, 0.0, x, 1.0, 0.0]
    });
    let bytes: String = corners
        .flat_map(f32::to_le_bytes)
        .map(|byte| format!("%{byte:02x}"))
        .collect();
    let document = json!({
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": (0..10_000).collect::<Vec<u32>>()}],
        "nodes": vec![json!({"mesh": 0}); 10_000],
        "meshes": [{"primitives": vec![json!({"attributes": {"POSITION": 0}}); 10_000]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 27, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 324}],
        "buffers": [{"byteLength": 324, "uri": format!("data:application/octet-stream,{bytes}")}],
    });
    let (status, answer) = server.post("/api/scenes?name=a.gltf", document.to_string().as_bytes());
    assert_eq!(status, 422, "{answer}");
    let error = answer["error"].as_str().unwrap();
    assert!(
        error.starts_with("a.gltf: ") && error.contains("has 900000000 triangles"),
        "{error}"
    );
    let mut page = server.page();
    send(&mut page, &request(1, &state()));
    assert_eq!(frame(&mut page).header["id"], 1);
}

/// A name that a shell, Python or a page might run.
const NAME: &str = "-$(touch made) `touch made` 'it' \"is\" <img src=x onerror=alert(1)> ; ${HOME} é.obj";

/// Asks for a file of the state in a scene.
fn export(server: &Server, scene: &Value, what: &str) -> String {
    let asked = json!({"what": what, "scene": scene, "state": state(), "size": [160, 100]});
    let (status, body) = server.request("POST", "/api/export", asked.to_string().as_bytes());
    assert_eq!(status, 200);
    String::from_utf8(body).unwrap()
}

fn escaped(name: &str) -> String {
    name.bytes().map(|byte| format!("%{byte:02x}")).collect()
}

#[cfg(unix)]
#[test]
fn names_are_text_in_commands_and_scripts() {
    use std::os::unix::fs::PermissionsExt;

    let program = program();
    let server = server(&program);
    let crate_file = fs::read(program.path("crate.obj")).unwrap();
    let (status, info) = server.post(&format!("/api/scenes?name={}", escaped(NAME)), &crate_file);
    assert_eq!((status, &info["name"]), (200, &json!(NAME)), "{info}");

    // A program in the place of oaktwin prints its arguments.
    let own = program.put("oaktwin", "#!/bin/sh\nprintf '%s\\0' \"$@\"\n");
    fs::set_permissions(&own, fs::Permissions::from_mode(0o755)).unwrap();
    program.put("render.sh", export(&server, &info["id"], "command"));
    let path = format!(
        "{}:{}",
        program.folder().display(),
        std::env::var("PATH").unwrap()
    );
    let mut shell = Command::new("sh");
    shell
        .arg("render.sh")
        .current_dir(program.folder())
        .env("PATH", path);
    let printed = String::from_utf8(shell.output().unwrap().stdout).unwrap();
    let words: Vec<&str> = printed.split('\0').collect();
    assert_eq!(words[..2], ["render", &format!("./{NAME}")], "{printed}");
    assert!(!program.path("made").exists());

    program.put("render.py", export(&server, &info["id"], "python"));
    let listing = "import ast; print(*[n.value for n in ast.walk(ast.parse(open('render.py', encoding='utf-8').read())) \
                   if isinstance(n, ast.Constant)], sep='\\0')";
    let mut python = Command::new("python3");
    python
        .args(["-X", "utf8", "-c", listing])
        .current_dir(program.folder());
    match python.output() {
        Ok(listed) => {
            let listed = String::from_utf8(listed.stdout).unwrap();
            assert!(listed.split('\0').any(|constant| constant == NAME), "{listed}");
        }
        Err(_) => println!("skipped: there is no python3"),
    }
}

#[test]
fn names_with_line_breaks_are_refused() {
    let program: Program = program();
    let server = server(&program);
    for name in ["a\nb.obj", "a\r.obj", "a\0.obj", "\u{1b}[31m.obj"] {
        let (status, answer) = server.post(&format!("/api/scenes?name={}", escaped(name)), b"");
        assert_eq!((status, &answer["field"]), (422, &json!("name")), "{name:?}");
    }
}
