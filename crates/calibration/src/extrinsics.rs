use oaktwin_camera::RigidTransform;

use crate::model::{Calibration, ExtrinsicLink};
use crate::{CalibrationError, Socket};

impl Calibration {
    /// Returns `to_from_from`, the transform from camera `from`'s optical frame to camera `to`'s, m. With `use_spec` the
    /// translations are from the board's design.
    ///
    /// # Errors
    /// Returns an error if a camera is missing, no extrinsics connect the two, or a design translation is missing.
    pub fn transform(
        &self,
        from: Socket,
        to: Socket,
        use_spec: bool,
    ) -> Result<RigidTransform, CalibrationError> {
        self.camera(from)?;
        self.camera(to)?;
        self.between(from, to, use_spec)
    }

    /// Returns [`Self::transform`] of cameras that may lack intrinsics.
    fn between(&self, from: Socket, to: Socket, use_spec: bool) -> Result<RigidTransform, CalibrationError> {
        let (root_of_from, root_from_from) = self.root_from(from, use_spec)?;
        let (root_of_to, root_from_to) = self.root_from(to, use_spec)?;
        if root_of_from != root_of_to {
            return Err(self.disconnected(from.to_string(), to.to_string()));
        }
        Ok(root_from_to.inverse() * root_from_from)
    }

    /// Returns the distance between two optical centres, m.
    ///
    /// # Errors
    /// Returns the same errors as [`Self::transform`].
    pub fn baseline(&self, a: Socket, b: Socket, use_spec: bool) -> Result<f64, CalibrationError> {
        Ok(self.transform(a, b, use_spec)?.translation.length())
    }

    /// Returns the transform from the inertial unit's frame to a camera's optical frame, m.
    ///
    /// # Errors
    /// Returns an error if the file has no extrinsics of the inertial unit, or the errors of [`Self::transform`].
    pub fn camera_from_imu(
        &self,
        camera: Socket,
        use_spec: bool,
    ) -> Result<RigidTransform, CalibrationError> {
        self.camera_from_link(camera, self.imu.as_ref(), "imuExtrinsics", use_spec)
    }

    /// Returns the transform from the housing's frame to a camera's optical frame, m.
    ///
    /// # Errors
    /// Returns an error if the file has no extrinsics of the housing, or the errors of [`Self::transform`].
    pub fn camera_from_housing(
        &self,
        camera: Socket,
        use_spec: bool,
    ) -> Result<RigidTransform, CalibrationError> {
        self.camera_from_link(camera, self.housing.as_ref(), "housingExtrinsics", use_spec)
    }

    fn camera_from_link(
        &self,
        camera: Socket,
        link: Option<&ExtrinsicLink>,
        place: &'static str,
        use_spec: bool,
    ) -> Result<RigidTransform, CalibrationError> {
        self.camera(camera)?;
        let link = link.ok_or_else(|| CalibrationError::NotPlaced {
            file: self.file_name.clone(),
            place,
        })?;
        let camera_from_to = self.between(link.to, camera, use_spec)?;
        let mut to_from_self = link.camera_from_self;
        if use_spec {
            // DepthAI accepts a zero translation here.
            to_from_self.translation = link.spec_translation.unwrap_or_default();
        }
        Ok(camera_from_to * to_from_self)
    }

    /// Returns the root of a camera's chain, and `root_from_camera`.
    fn root_from(
        &self,
        camera: Socket,
        use_spec: bool,
    ) -> Result<(Socket, RigidTransform), CalibrationError> {
        let mut at = camera;
        let mut at_from_camera = RigidTransform::IDENTITY;
        // Cycles are rejected when the file is read, but a caller may have changed the value.
        for _ in 0..=self.cameras.len() + self.uncalibrated.len() {
            let link = match self.link(at) {
                Some(link) => link,
                None => self.camera(at)?.extrinsics.as_ref(),
            };
            let Some(link) = link else {
                return Ok((at, at_from_camera));
            };
            at_from_camera = link.transform(&self.file_name, use_spec)? * at_from_camera;
            at = link.to;
        }
        Err(self.disconnected(camera.to_string(), "a root".to_owned()))
    }

    fn disconnected(&self, from: String, to: String) -> CalibrationError {
        CalibrationError::Disconnected {
            file: self.file_name.clone(),
            from,
            to,
        }
    }
}
