use oaktwin_base::parameter::choice;
use oaktwin_camera::Camera as Optics;

use crate::{Origin, Twin, TwinCamera};

choice! {
    /// The lens to use for cameras that have a [nominal fisheye lens](TwinCamera::nominal_fisheye).
    LensChoice {
        /// The pinhole of the parameter sheet.
        Pinhole = "pinhole",
        /// The nominal fisheye of the wide models, with their full field of view.
        Fisheye = "fisheye",
    }
}

impl Twin {
    /// Returns the intrinsics and lens of one of this twin's cameras at the sensor's used resolution.
    ///
    /// `lens` chooses between the two nominal lenses of a nominal twin's wide cameras. Every camera of a calibrated twin
    /// keeps its own lens. Cameras without distortion and cameras that are missing in the calibration are pinholes.
    #[must_use]
    pub fn optics(&self, camera: &TwinCamera, lens: LensChoice) -> Optics {
        let native_optics = Optics::new(camera.intrinsics, camera.lens);
        if self.origin == Origin::Nominal && lens == LensChoice::Fisheye {
            camera.nominal_fisheye().unwrap_or(native_optics)
        } else {
            native_optics
        }
    }
}

#[cfg(test)]
mod tests {
    use oaktwin_camera::{LensModel, OpenCvFisheye};

    use super::*;
    use crate::{Catalog, Role};

    fn nominal(model: &str) -> Twin {
        let catalog = Catalog::builtin();
        catalog.nominal(catalog.device(model).unwrap())
    }

    /// A wide model whose calibration has this lens for the left camera and lacks the right one.
    fn calibrated(left: LensModel) -> Twin {
        let mut twin = nominal("oak4_d_wide");
        twin.origin = Origin::Calibration {
            product_name: "OAK4-D-W".to_owned(),
            file_name: "unit.json".to_owned(),
        };
        let camera = twin
            .cameras
            .iter_mut()
            .find(|camera| camera.spec.role == Role::Left);
        camera.unwrap().lens = left;
        twin
    }

    fn optics(twin: &Twin, role: Role, lens: LensChoice) -> Optics {
        twin.optics(twin.camera(role).unwrap(), lens)
    }

    fn native_optics(twin: &Twin, role: Role) -> Optics {
        let camera = twin.camera(role).unwrap();
        Optics::new(camera.intrinsics, camera.lens)
    }

    #[test]
    fn nominal_wide_cameras_have_the_chosen_lens() {
        let twin = nominal("oak4_d_wide");
        for role in [Role::Left, Role::Right] {
            let fisheye = twin.camera(role).unwrap().nominal_fisheye().unwrap();
            assert_eq!(optics(&twin, role, LensChoice::Fisheye), fisheye);
            assert_eq!(
                optics(&twin, role, LensChoice::Pinhole),
                native_optics(&twin, role)
            );
        }
    }

    #[test]
    fn nominal_cameras_without_a_fisheye_are_pinholes() {
        let twin = nominal("oak4_d");
        let left = optics(&twin, Role::Left, LensChoice::Fisheye);
        assert_eq!(left, native_optics(&twin, Role::Left));
        assert_eq!(left.lens, LensModel::Pinhole);
    }

    #[test]
    fn calibrated_cameras_keep_their_lens() {
        let fisheye = LensModel::OpenCvFisheye(OpenCvFisheye {
            k: [0.1, 0.0, -0.02, 0.0],
        });
        // All-zero distortion in a calibration is a pinhole.
        for lens in [fisheye, LensModel::Pinhole] {
            let twin = calibrated(lens);
            for choice in [LensChoice::Pinhole, LensChoice::Fisheye] {
                let left = optics(&twin, Role::Left, choice);
                assert_eq!(left, native_optics(&twin, Role::Left));
                assert_eq!(left.lens, lens);
            }
        }
    }

    #[test]
    fn cameras_missing_in_the_calibration_are_pinholes() {
        let twin = calibrated(LensModel::OpenCvFisheye(OpenCvFisheye { k: [0.1; 4] }));
        let right = optics(&twin, Role::Right, LensChoice::Fisheye);
        assert_eq!(right, native_optics(&nominal("oak4_d_wide"), Role::Right));
        assert_eq!(right.lens, LensModel::Pinhole);
    }
}
