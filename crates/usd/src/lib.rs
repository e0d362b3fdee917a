//! OpenUSD assets of OAK cameras: author, package, check.

pub mod check;
pub mod stage;
