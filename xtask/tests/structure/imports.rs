//! The modules of a crate, and what they import from each other.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use syn::visit::{self, Visit};
use syn::{Attribute, Item, ItemUse, UseTree};

/// The path of a module from the root of its crate.
pub(crate) type Module = Vec<String>;

/// The modules of a crate, except for its tests.
pub(crate) struct Modules {
    files: BTreeMap<Module, PathBuf>,
}

impl Modules {
    /// Finds the modules below a folder `src`.
    pub(crate) fn read(src: &Path) -> Self {
        let mut files = BTreeMap::new();
        find(src, &mut Vec::new(), &mut files);
        Self { files }
    }

    /// Returns the modules that each module imports from, except its ancestors and descendants.
    pub(crate) fn arrows(&self) -> BTreeMap<Module, BTreeSet<Module>> {
        let of = |module: &Module, file: &PathBuf| {
            let text = fs::read_to_string(file).unwrap();
            let syntax = syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            let mut paths = Paths::default();
            paths.visit_file(&syntax);
            let imported = paths.found.iter().filter_map(|path| self.resolve(module, path));
            imported
                .filter(|other| !other.starts_with(module) && !module.starts_with(other))
                .collect()
        };
        let all = self.files.iter();
        all.map(|(module, file)| (module.clone(), of(module, file)))
            .collect()
    }

    /// Returns the module that a path in a module leads into, unless it is of another crate.
    fn resolve(&self, module: &Module, path: &[String]) -> Option<Module> {
        let mut at = module.clone();
        let mut rest = path;
        match path.first()?.as_str() {
            "crate" => {
                at.clear();
                rest = &path[1..];
            }
            "self" => rest = &path[1..],
            "super" => {
                while rest.first().is_some_and(|name| name == "super") {
                    at.pop();
                    rest = &rest[1..];
                }
            }
            first => {
                let child = [module.as_slice(), &[first.to_owned()]].concat();
                self.files.contains_key(&child).then_some(())?;
            }
        }
        for name in rest {
            at.push(name.clone());
            if !self.files.contains_key(&at) {
                at.pop();
                break;
            }
        }
        Some(at)
    }

    /// Returns the files of a cycle as text.
    pub(crate) fn shown(&self, cycle: &[Module]) -> String {
        let files = cycle.iter().chain(cycle.first());
        let files = files.filter_map(|module| self.files.get(module));
        files
            .map(|file| file.display().to_string())
            .collect::<Vec<_>>()
            .join(" -> ")
    }
}

fn find(folder: &Path, module: &mut Module, files: &mut BTreeMap<Module, PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    for entry in entries {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        if matches!(name.as_str(), "tests" | "fixture" | "bin") {
            continue;
        }
        let is_root = matches!(name.as_str(), "mod" | "lib" | "main");
        if !is_root {
            module.push(name);
        }
        if path.is_dir() {
            find(&path, module, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.insert(module.clone(), path);
        }
        if !is_root {
            module.pop();
        }
    }
}

/// The paths in a file outside of tests. Those inside of macros are not found.
#[derive(Default)]
struct Paths {
    found: BTreeSet<Vec<String>>,
}

impl Paths {
    fn add_tree(&mut self, tree: &UseTree, path: &mut Vec<String>) {
        match tree {
            UseTree::Path(part) => {
                path.push(part.ident.to_string());
                self.add_tree(&part.tree, path);
                path.pop();
            }
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.add_tree(tree, path)),
            UseTree::Name(name) => self.add(path, Some(name.ident.to_string())),
            UseTree::Rename(name) => self.add(path, Some(name.ident.to_string())),
            UseTree::Glob(_) => self.add(path, None),
        }
    }

    fn add(&mut self, path: &[String], last: Option<String>) {
        self.found.insert(path.iter().cloned().chain(last).collect());
    }
}

impl<'ast> Visit<'ast> for Paths {
    fn visit_item(&mut self, item: &'ast Item) {
        if !is_test(attributes(item)) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        self.add_tree(&item.tree, &mut Vec::new());
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let names = path.segments.iter().map(|segment| segment.ident.to_string());
        self.add(&names.collect::<Vec<_>>(), None);
        visit::visit_path(self, path);
    }
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        let is_cfg_test = || {
            attribute
                .parse_args::<syn::Path>()
                .is_ok_and(|path| path.is_ident("test"))
        };
        attribute.path().is_ident("cfg") && is_cfg_test()
    })
}
