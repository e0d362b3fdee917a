//! The program `oaktwin`.

fn main() {}
