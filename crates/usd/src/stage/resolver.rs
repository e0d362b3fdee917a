use std::io::{self, Cursor};
use std::path::Path;

use openusd::ar::{self, Asset, DefaultResolver, ResolvedPath, Resolver};

use super::inspect;

/// OpenUSD's default resolver, with every file looked over before the library reads it.
pub(super) struct InspectingResolver(DefaultResolver);

impl InspectingResolver {
    pub(super) fn new() -> Self {
        Self(DefaultResolver::new())
    }
}

impl Resolver for InspectingResolver {
    fn create_identifier(&self, asset_path: &str, anchor: Option<&ResolvedPath>) -> String {
        self.0.create_identifier(asset_path, anchor)
    }

    fn resolve(&self, asset_path: &str) -> Option<ResolvedPath> {
        // Resolving a path into a package opens the package.
        if let Some((package, _)) = ar::split_package_relative_path_outer(asset_path)
            && inspect::file(Path::new(&package)).is_err()
        {
            return None;
        }
        self.0.resolve(asset_path)
    }

    fn resolve_for_new_asset(&self, asset_path: &str) -> Option<ResolvedPath> {
        self.0.resolve_for_new_asset(asset_path)
    }

    fn open_asset(&self, resolved: &ResolvedPath) -> io::Result<Box<dyn Asset>> {
        let refuse =
            |problem: inspect::Problem| io::Error::new(io::ErrorKind::InvalidData, problem.to_string());
        let text = resolved.to_string();
        if let Some((package, inner)) = ar::split_package_relative_path_outer(&text) {
            inspect::file(Path::new(&package)).map_err(refuse)?;
            let bytes = self.0.open_asset(resolved)?.read_all()?;
            inspect::layer(&inner, &bytes).map_err(refuse)?;
            return Ok(Box::new(Cursor::new(bytes)));
        }
        let layer = inspect::file(resolved).map_err(refuse)?;
        Ok(Box::new(Cursor::new(layer.bytes)))
    }
}
