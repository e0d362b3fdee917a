use crate::choice;

choice! {
    /// The processor of a device.
    Platform {
        /// The Myriad X of the OAK-D series.
        Rvc2 = "RVC2",
        /// The processor of the OAK 4 series.
        Rvc4 = "RVC4",
    }
}
