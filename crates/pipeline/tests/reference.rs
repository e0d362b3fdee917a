//! The files that are generated from the tables of parameters are up to date.

#[path = "../examples/reference.rs"]
#[allow(dead_code, reason = "its main is not called")]
mod reference;

#[test]
fn generated_files_are_up_to_date() {
    for (path, text) in reference::files().unwrap() {
        let on_disk = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(on_disk == text, "{}: run `cargo xtask schema`", path.display());
    }
}
