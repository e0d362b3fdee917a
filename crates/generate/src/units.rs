use oaktwin_calibration::population::Population;
use oaktwin_catalog::Twin;

/// The units of a model.
#[derive(Debug)]
pub(crate) enum Units {
    /// Always the nominal unit, or the unit of the recipe's calibration.
    One(Box<Twin>),
    /// Units that are drawn.
    Population(Box<Population>),
}

impl Units {
    /// Returns a twin of the model: all units have the same device.
    pub(crate) fn any(&self) -> &Twin {
        match self {
            Self::One(twin) => twin,
            Self::Population(population) => population.nominal(),
        }
    }

    /// Returns the twin with the calibrated values of the unit of this number.
    pub(crate) fn twin(&self, number: Option<u64>) -> Twin {
        match self {
            Self::One(twin) => (**twin).clone(),
            Self::Population(population) => population.unit(number.unwrap_or_default()).twin,
        }
    }
}
