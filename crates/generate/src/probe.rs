#![allow(warnings)]
use crate::arrange::Arrangement;
use crate::context::Context;
use crate::recipe::RecipeFile;
use oaktwin_catalog::Catalog;
use std::path::Path;
use std::time::Instant;

#[test]
fn probe() {
    let Ok(path) = std::env::var("PROBE") else { return };
    let n: u64 = std::env::var("N").map_or(4, |n| n.parse().unwrap());
    let file = RecipeFile::read(Path::new(&path)).unwrap();
    let context = Context::open(file, Catalog::builtin()).unwrap();
    for number in 0..n {
        let start = Instant::now();
        match Arrangement::draw(&context, number) {
            Ok(a) => {
                println!(
                    "arrangement {number}: {} objects {:.3} s",
                    a.objects.len(),
                    start.elapsed().as_secs_f64()
                );
                if !a.findings.is_empty() {
                    println!("  {} findings {}", a.findings.len(), a.findings[0]);
                }
                if let Ok(out) = std::env::var("OUT") {
                    std::fs::write(format!("{out}/{number}.json"), serde_json::to_string(&a).unwrap())
                        .unwrap();
                }
            }
            Err(e) => println!("arrangement {number}: {e} {:.3} s", start.elapsed().as_secs_f64()),
        }
    }
}
