use std::collections::BTreeMap;
use std::path::PathBuf;

use oaktwin_files::{AtomicFile, OutputFiles};

use crate::file::{Content, write_all};
use crate::listing::{SENSOR_PARAMS, list};
use crate::{Shot, WriteError, Writer, WriterOptions};

/// Names files after the [input](crate::InputName) that a frame was made from. The arrays of a batch become one file with a
/// leading axis, and its other files get the index of the image.
#[derive(Debug, Default)]
pub struct FlatWriter {
    options: WriterOptions,
    /// The arrays of a batch, which grow until the batch is complete.
    arrays: BTreeMap<PathBuf, AtomicFile>,
}

impl FlatWriter {
    /// Creates a writer.
    #[must_use]
    pub fn new(options: WriterOptions) -> Self {
        Self {
            options,
            arrays: BTreeMap::new(),
        }
    }
}

impl Writer for FlatWriter {
    fn write(&mut self, shot: &Shot, output: &mut OutputFiles) -> Result<(), WriteError> {
        let input = &shot.input;
        let mut whole = Vec::new();
        for file in list(shot, &self.options) {
            let Some((count, Content::Array(array))) = input.batch.map(|count| (count, &file.content)) else {
                let is_of_batch = file.folder == SENSOR_PARAMS;
                let path = match is_of_batch {
                    true => input.path(file.folder, &file.name, file.extension),
                    false => input.item_path(file.folder, &file.name, file.extension),
                };
                if input.item == 0 || !is_of_batch {
                    whole.push((path, file));
                }
                continue;
            };
            let path = input.path(file.folder, &file.name, file.extension);
            let growing = match self.arrays.remove(&path) {
                Some(growing) => growing,
                None => {
                    let mut growing = output.create(&path)?;
                    let shape: Vec<usize> = [count].into_iter().chain(array.shape.clone()).collect();
                    growing.append(&(array.begin)(&shape))?;
                    growing
                }
            };
            let growing = self.arrays.entry(path).or_insert(growing);
            (array.put)(growing).map_err(|error| growing.failed(&error))?;
        }
        write_all(&whole, output)
    }

    fn finish(&mut self, output: &mut OutputFiles) -> Result<(), WriteError> {
        for file in std::mem::take(&mut self.arrays).into_values() {
            output.finish(file)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use oaktwin_image::annotation::Frame;
    use oaktwin_image::{Image, ZDepth, npy};

    use super::*;
    use crate::{CloudAxes, Extras, InputName, LayerData, ShotLayer};

    fn shot(batch: Option<usize>, item: usize) -> Shot {
        let depth = Image::filled(2, 1, 1.0 + item as f32);
        let frame = Frame {
            depth_sensor_distance: Some(ZDepth(depth)),
            ..Frame::default()
        };
        let cloud = LayerData::Cloud {
            positions: Image::filled(2, 1, [1.0, 2.0, -3.0, 1.0]),
            colors: None,
            axes: CloudAxes::Ros,
        };
        Shot {
            layers: vec![ShotLayer {
                folder: "cloud",
                name: "cloud".to_owned(),
                data: cloud,
            }],
            input: InputName {
                prefix: "env_".to_owned(),
                batch,
                item,
                ..InputName::default()
            },
            ..Shot::new(frame, 0)
        }
    }

    fn written(shots: &[Shot], finishes: bool) -> Vec<String> {
        let folder = tempfile::tempdir().unwrap();
        let mut output = OutputFiles::in_folder(folder.path()).unwrap();
        let extras = Extras {
            millimetres: true,
            ..Extras::default()
        };
        let mut writer = FlatWriter::new(WriterOptions {
            extras,
            ..WriterOptions::default()
        });
        for shot in shots {
            writer.write(shot, &mut output).unwrap();
        }
        if finishes {
            writer.finish(&mut output).unwrap();
            let array = fs::read(folder.path().join("env_depth_sensor_distance.npy")).unwrap();
            let shape: &[usize] = if shots.len() == 1 { &[1, 2] } else { &[2, 1, 2] };
            assert_eq!(npy::decode(&array).unwrap().shape, shape);
        }
        drop(writer);
        let mut names: Vec<String> = fs::read_dir(folder.path())
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn names_files_after_the_input() {
        assert_eq!(
            written(&[shot(None, 0)], true),
            [
                "env_cloud.ply",
                "env_depth_sensor_distance.npy",
                "env_depth_sensor_distance_millimetres.png"
            ]
        );
    }

    #[test]
    fn stacks_the_arrays_of_a_batch() {
        let files = [
            "env_cloud_0000.ply",
            "env_cloud_0001.ply",
            "env_depth_sensor_distance_millimetres_0000.png",
            "env_depth_sensor_distance_millimetres_0001.png",
        ];
        let shots = [shot(Some(2), 0), shot(Some(2), 1)];
        assert_eq!(written(&shots, false), files);
        let mut all = files.to_vec();
        all.push("env_depth_sensor_distance.npy");
        all.sort_unstable();
        assert_eq!(written(&shots, true), all);
    }
}
