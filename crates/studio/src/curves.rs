//! Accuracies that were measured.

use std::collections::VecDeque;
use std::sync::{Mutex, PoisonError};

use crate::protocol::{AccuracyCurve, OakState};

/// The number of curves that are kept.
const KEPT: usize = 32;

/// Curves with their OAKs; the one that was asked for last is the last.
#[derive(Debug, Default)]
pub(crate) struct Curves(Mutex<VecDeque<(OakState, AccuracyCurve)>>);

impl Curves {
    /// Returns the curve of an OAK, if it is known.
    pub(crate) fn get(&self, oak: &OakState) -> Option<AccuracyCurve> {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let place = known.iter().position(|(other, _)| other == oak)?;
        let found = known.remove(place)?;
        known.push_back(found.clone());
        Some(found.1)
    }

    /// Keeps the curve of an OAK.
    pub(crate) fn add(&self, oak: OakState, curve: AccuracyCurve) {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.push_back((oak, curve));
        if known.len() > KEPT {
            known.pop_front();
        }
    }
}
