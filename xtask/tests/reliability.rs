//! `RELIABILITY.md` names tests that exist.

use std::fs;
use std::path::Path;

#[test]
fn promises_name_tests_that_exist() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let text = fs::read_to_string(root.join("RELIABILITY.md")).unwrap();
    let mut found = 0;
    for line in text.lines() {
        let mut file = None;
        // Every second part is between backticks.
        for word in line.split('`').skip(1).step_by(2) {
            if [".rs", ".py"].iter().any(|end| word.ends_with(end)) && word.contains('/') {
                let content = fs::read_to_string(root.join(word));
                file = Some(content.unwrap_or_else(|error| panic!("{word}: {error}")));
            } else if let Some(content) = &file
                && word.contains('_')
                && word
                    .bytes()
                    .all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'_')
            {
                let is_test = ["fn", "def"]
                    .iter()
                    .any(|kind| content.contains(&format!("{kind} {word}(")));
                assert!(is_test, "there is no test {word}: {line}");
                found += 1;
            }
        }
    }
    assert!(found > 30, "only {found} tests are named");
}
