//! The files in `data/`, which the build script lists.

include!(concat!(env!("OUT_DIR"), "/builtin.rs"));

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    #[test]
    fn every_file_of_the_folder_is_built_in() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let mut found: Vec<String> = Vec::new();
        for folder in ["data/sensors", "data/imus", "data/devices"] {
            for entry in fs::read_dir(root.join(folder)).unwrap() {
                let name = entry.unwrap().file_name();
                found.push(format!("{folder}/{}", name.to_str().unwrap()));
            }
        }
        let mut listed: Vec<&str> = super::FILES.iter().map(|(file, _)| *file).collect();
        listed.sort_unstable();
        found.sort_unstable();
        assert_eq!(listed, found);
        for (file, text) in super::FILES {
            assert_eq!(*text, fs::read_to_string(root.join(file)).unwrap(), "{file}");
        }
    }
}
