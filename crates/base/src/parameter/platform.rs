use crate::parameter::choice;

choice! {
    /// The processor of a device.
    Platform {
        /// The Myriad X of the OAK-D series.
        Rvc2 = "rvc2",
        /// The processor of the OAK 4 series.
        Rvc4 = "rvc4",
    }
}

impl Platform {
    /// The name in prose: `RVC2`.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Rvc2 => "RVC2",
            Self::Rvc4 => "RVC4",
        }
    }
}
