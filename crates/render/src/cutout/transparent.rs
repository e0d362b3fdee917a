use oaktwin_base::parameter::choice;

choice! {
    /// What the ground truth of a transparent surface is.
    Transparent {
        /// The surface itself, however clear it is.
        Surface = "surface",
        /// What lies behind surfaces that transmit more than half of the light.
        Through = "through",
    }
}
