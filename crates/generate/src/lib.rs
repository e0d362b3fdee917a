//! Data sets from recipes: scenes with objects, looks and lights, seen by cameras at random places, as the depth sensor of an OAK
//! reports them.
//!
//! A [`Recipe`](recipe::Recipe) states what frames contain; every quantity is a number or a distribution. Frame *n* is a function of the
//! recipe and *n* only: it can be made alone, in any order and on any machine, with the same bytes.
//!
//! ```
//! use std::ops::ControlFlow;
//! use std::path::Path;
//!
//! use oaktwin_catalog::Catalog;
//! use oaktwin_generate::recipe::{Recipe, RecipeFile};
//! use oaktwin_generate::{GenerateOptions, Generator};
//!
//! # let folder = tempfile::tempdir()?;
//! let path = Path::new("floor.toml");
//! let text = "frames = 2\n[camera]\nresolution = [160, 100]";
//! let recipe = RecipeFile { path: path.to_owned(), recipe: Recipe::parse(path, text)? };
//! let generator = Generator::open(recipe, Catalog::builtin())?;
//! let generated =
//!     generator.generate(folder.path(), &GenerateOptions::default(), &|_| ControlFlow::Continue(()))?;
//! assert_eq!((generated.made, generated.missing), (2, 0));
//! assert!(folder.path().join("distance_to_image_plane_0001.npy").exists());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod aligned;
mod arrange;
mod context;
mod described;
mod error;
mod frame;
mod inertial;
mod models;
mod motion;
mod object_model;
mod random;
pub mod recipe;
mod run;
mod samples;
mod saved;
mod settle;
mod times;
mod unit;
mod units;
mod view;
mod world;

pub use error::GenerateError;
pub use run::{GenerateOptions, Generated, Generation, Generator};
