//! The formats of data sets.

mod bop;
mod bop_model;
mod coco;
mod colmap;
mod common;
mod euroc;
mod lens;
mod nerfstudio;
mod rle;
mod stereo;
mod tum;
mod webdataset;

use oaktwin_base::diagnostic::suggest;

use crate::{BasicWriter, Format, WriterOptions};

/// A format that a user chooses by name.
#[derive(Debug)]
pub struct FormatKind {
    /// The name.
    pub name: &'static str,
    /// One line of help.
    pub help: &'static str,
    /// The requirements on its shots.
    pub needs: Needs,
    /// Creates the format with these options, for a data set whose objects have these labels, sorted.
    pub create: fn(WriterOptions, &[String]) -> Box<dyn Format>,
}

/// The requirements of a format on its shots, besides annotations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Needs {
    /// Whether objects are described.
    pub objects: bool,
    /// Whether there is a stereo pair.
    pub stereo: bool,
}

/// Nothing but annotations.
const ANNOTATIONS: Needs = Needs {
    objects: false,
    stereo: false,
};
const OBJECTS: Needs = Needs {
    objects: true,
    ..ANNOTATIONS
};
const STEREO: Needs = Needs {
    stereo: true,
    ..ANNOTATIONS
};

/// All formats; the first is the default.
pub const FORMATS: &[FormatKind] = &[
    FormatKind {
        name: "basic",
        help: "Replicator's BasicWriter",
        needs: ANNOTATIONS,
        create: |options, _| Box::new(BasicWriter::new(options)),
    },
    FormatKind {
        name: "bop",
        help: "BOP: poses, masks and visibility of objects",
        needs: OBJECTS,
        create: |_, _| Box::new(bop::Bop::default()),
    },
    FormatKind {
        name: "coco",
        help: "COCO instances",
        needs: OBJECTS,
        create: |_, labels| {
            Box::new(coco::Coco {
                labels: labels.to_vec(),
            })
        },
    },
    FormatKind {
        name: "tum",
        help: "TUM RGB-D sequences",
        needs: ANNOTATIONS,
        create: |_, _| Box::new(tum::Tum),
    },
    FormatKind {
        name: "euroc",
        help: "EuRoC's sequences",
        needs: ANNOTATIONS,
        create: |_, _| Box::new(euroc::Euroc),
    },
    FormatKind {
        name: "nerfstudio",
        help: "nerfstudio's transforms.json",
        needs: ANNOTATIONS,
        create: |_, _| Box::new(nerfstudio::Nerfstudio),
    },
    FormatKind {
        name: "colmap",
        help: "COLMAP's text model with rigs",
        needs: ANNOTATIONS,
        create: |_, _| Box::new(colmap::Colmap),
    },
    FormatKind {
        name: "webdataset",
        help: "WebDataset's shards, with all files of BasicWriter in a sample",
        needs: ANNOTATIONS,
        create: |options, _| Box::new(webdataset::WebDataset(options)),
    },
    FormatKind {
        name: "middlebury",
        help: "Middlebury 2014 stereo pairs with disparity",
        needs: STEREO,
        create: |_, _| Box::new(stereo::Middlebury),
    },
    FormatKind {
        name: "kitti",
        help: "KITTI 2015 stereo pairs with disparity and depth",
        needs: STEREO,
        create: |_, _| Box::new(stereo::Kitti),
    },
    FormatKind {
        name: "sceneflow",
        help: "Scene Flow's FlyingThings3D: stereo pairs with disparity and occlusion",
        needs: STEREO,
        create: |_, _| Box::new(stereo::SceneFlow),
    },
];

impl FormatKind {
    /// Returns the format of this name.
    ///
    /// # Errors
    /// Returns the remedy, with the nearest name, if there is none.
    pub fn find(name: &str) -> Result<&'static Self, String> {
        let found = FORMATS.iter().find(|format| format.name == name);
        found.ok_or_else(|| suggest(name, FORMATS.iter().map(|format| format.name)))
    }
}
