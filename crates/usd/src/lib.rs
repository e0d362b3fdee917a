//! OpenUSD assets of OAK cameras: author, package, check.

pub mod asset;
pub mod body;
pub mod check;
pub mod stage;
pub mod text;
pub mod usdz;
