//! OpenUSD assets of OAK cameras: author, package, check.

pub mod asset;
pub mod body;
pub mod text;
pub mod usdz;
