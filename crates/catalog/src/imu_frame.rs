//! The axes of inertial units, about which sources disagree.

use oaktwin_base::parameter::choice;
use oaktwin_camera::Axes;
use oaktwin_camera::math::{DMat3, DVec3};

use crate::{Device, Imu, Source};

choice! {
    /// The source of the axes of an inertial unit.
    ImuFrame {
        /// The axes of RTAB-Map's driver, or the board file's if it has none.
        Driver = "driver",
        /// The axes of the vendor's board file.
        BoardFile = "board-file",
    }
}

impl Device {
    /// Returns the device with the axes of a source. Without axes of that source, it is unchanged.
    #[must_use]
    pub fn with_imu_frame(&self, frame: ImuFrame) -> Self {
        let mut device = self.clone();
        if let (ImuFrame::BoardFile, Some(imu)) = (frame, &mut device.imu)
            && let Some(rotation) = imu.board_file_rotation.take()
        {
            imu.rotation = rotation;
            imu.sources.insert("rotation".to_owned(), Source::BoardFile);
        }
        device
    }
}

impl Imu {
    /// Returns the axes in words, `x down, y left, z forward`, or `None` if they are not parallel to those of the body.
    #[must_use]
    pub fn axes(&self) -> Option<String> {
        axes(&self.rotation)
    }

    /// Returns the [axes](Self::axes) of the board file, if they differ.
    #[must_use]
    pub fn board_file_axes(&self) -> Option<String> {
        self.board_file_rotation.as_ref().and_then(axes)
    }
}

fn axes(rows: &[[f64; 3]; 3]) -> Option<String> {
    let body_from_imu = DMat3::from_cols_array_2d(rows).transpose();
    let (words, off_deg) = nearest_directions(Axes::OpenCv.rotation_from(Axes::Ros) * body_from_imu);
    (off_deg < 1e-4).then_some(words)
}

/// Returns the direction of a camera (x right, y down, z forward) that is nearest to each axis of a part, `x down, y left, z forward`,
/// and the largest angle between the two, degrees.
#[must_use]
pub fn nearest_directions(camera_from_part: DMat3) -> (String, f64) {
    let directions = [
        (DVec3::X, "right"),
        (DVec3::NEG_X, "left"),
        (DVec3::Y, "down"),
        (DVec3::NEG_Y, "up"),
        (DVec3::Z, "forward"),
        (DVec3::NEG_Z, "backward"),
    ];
    let axes = [
        camera_from_part.x_axis,
        camera_from_part.y_axis,
        camera_from_part.z_axis,
    ];
    let mut words = Vec::new();
    let mut deviation_deg: f64 = 0.0;
    for (name, axis) in ["x", "y", "z"].into_iter().zip(axes) {
        let angle = |direction: DVec3| axis.cross(direction).length().atan2(axis.dot(direction));
        let nearest = directions
            .iter()
            .map(|(direction, word)| (angle(*direction), word))
            .min_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((angle, word)) = nearest {
            deviation_deg = deviation_deg.max(angle.to_degrees());
            words.push(format!("{name} {word}"));
        }
    }
    (words.join(", "), deviation_deg)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Catalog;

    /// The rows of the rotations in RTAB-Map's `CameraDepthAI.cpp` from a unit with a BNO086 to the left camera (x right, y down,
    /// z forward).
    const DRIVER: [(&str, [[f64; 3]; 3]); 5] = [
        ("oak_d", [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
        ("oak_d_lr", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
        ("oak_d_sr", [[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]),
        ("oak_d_pro", [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]]),
        (
            "oak_d_pro_poe",
            [[0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
        ),
    ];

    fn matrix(rows: &[[f64; 3]; 3]) -> DMat3 {
        DMat3::from_cols_array_2d(rows).transpose()
    }

    #[test]
    fn the_default_axes_are_those_of_the_driver() {
        for (id, rows) in DRIVER {
            let imu = Catalog::builtin().device(id).unwrap().imu.clone().unwrap();
            let body_from_camera = Axes::Ros.rotation_from(Axes::OpenCv);
            assert_eq!(matrix(&imu.rotation), body_from_camera * matrix(&rows), "{id}");
        }
    }

    /// The regularity that supports the driver: one quarter turn explains the difference on every board.
    #[test]
    fn the_axes_of_board_files_differ_by_the_same_turn() {
        let mut found = 0;
        for device in Catalog::builtin().devices() {
            let Some(imu) = &device.imu else { continue };
            let Some(of_board) = &imu.board_file_rotation else {
                continue;
            };
            let turn = matrix(of_board).transpose() * matrix(&imu.rotation);
            assert_eq!(
                turn,
                matrix(&[[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
                "{}",
                device.id
            );
            found += 1;
        }
        assert_eq!(found, 11);
    }

    #[test]
    fn the_board_files_axes_can_be_chosen() {
        let device = Catalog::builtin().device("OAK-D").unwrap();
        let axes = |frame| device.with_imu_frame(frame).imu.unwrap().axes().unwrap();
        assert_eq!(axes(ImuFrame::Driver), "x down, y left, z forward");
        assert_eq!(axes(ImuFrame::BoardFile), "x left, y up, z forward");
        let lite = Catalog::builtin().device("OAK-D Lite").unwrap();
        assert_eq!(&lite.with_imu_frame(ImuFrame::BoardFile), lite);
        let mut imu = lite.imu.clone().unwrap();
        imu.rotation = DMat3::from_rotation_x(0.1).transpose().to_cols_array_2d();
        assert_eq!(imu.axes(), None);
    }
}
