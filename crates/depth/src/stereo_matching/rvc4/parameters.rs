use crate::ParameterError;

/// `confidenceMetrics` of RVC4: what its confidence is made of.
///
/// Published: the names, ranges and defaults, and that weights make one confidence of an occlusion, a variance and a
/// flatness. In all of `DepthAI`'s settings the weights add up to 32; hence the mean that they make here, (Σ weight ·
/// measure) >> 5, at most 255. What the three measures are is not published; here each is 255 where nothing speaks against
/// a pixel, and 0 where all does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ConfidenceMetrics {
    /// `occlusionConfidenceWeight`, 0 to 32. The measure is 255 where the right image's disparity is the same to 1 px, else 0.
    pub occlusion_weight: u8,
    /// `motionVectorConfidenceWeight`, 0 to 32, of how disparities vary around a pixel: 255 less 40.5 for each px² of the
    /// variance in its 3×3 neighbourhood. Differences count up to 16 px.
    pub motion_vector_weight: u8,
    /// `motionVectorConfidenceThreshold`, 0 to 3: 2 to the power of it times as much is taken off; 0 allows the most.
    pub motion_vector_threshold: u8,
    /// `flatnessConfidenceWeight`, 0 to 32, of how flat the sums of costs are: of the share by which the least is below the
    /// least of those not beside it.
    pub flatness_weight: u8,
    /// `flatnessConfidenceThreshold`, 1 to 7: where that share is up to so many eighths the measure is 0, from one more
    /// on 255.
    pub flatness_threshold: u8,
    /// `flatnessOverride`: whether that measure alone is the confidence.
    pub flatness_override: bool,
}

/// `DepthAI`'s.
impl Default for ConfidenceMetrics {
    fn default() -> Self {
        Self {
            occlusion_weight: 20,
            motion_vector_weight: 4,
            motion_vector_threshold: 1,
            flatness_weight: 8,
            flatness_threshold: 2,
            flatness_override: false,
        }
    }
}

/// `holeFilling` of RVC4: what is not sure takes the mean of its superpixel.
///
/// Superpixels are those of SLIC, which Qualcomm's interface to the hardware names. Their size is not published: here one
/// for each 8×8 pixels of the left image, after two rounds, and a grey level of 8 bits counts as much as a pixel. Nor is
/// whether what was filled becomes surer: here it does not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HoleFilling {
    /// `enable`
    pub enable: bool,
    /// `highConfidenceThreshold`, 1 to 255: what is surer makes the mean.
    pub high_confidence_threshold: u8,
    /// `fillConfidenceThreshold`, 1 to 255: what is less sure is filled.
    pub fill_confidence_threshold: u8,
    /// `minValidDisparity`: how much of a superpixel has to be surer: 1 a half, 2 a quarter, 3 an eighth.
    pub min_valid_disparity: u8,
    /// `invalidateDisparities`: whether what would be filled is lost where less of the superpixel is.
    pub invalidate_disparities: bool,
}

/// `DepthAI`'s.
impl Default for HoleFilling {
    fn default() -> Self {
        Self {
            enable: true,
            high_confidence_threshold: 210,
            fill_confidence_threshold: 200,
            min_valid_disparity: 1,
            invalidate_disparities: true,
        }
    }
}

/// `adaptiveMedianFilter` of RVC4: what is not sure takes the median of its neighbours.
///
/// The size of the neighbourhood is not published: here 3×3, beyond the image its border. A neighbour without a disparity
/// counts as the pixel itself, and a pixel without one stays so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AdaptiveMedian {
    /// `enable`
    pub enable: bool,
    /// `confidenceThreshold`, 0 to 255: what is less sure is filtered.
    pub confidence_threshold: u8,
}

/// `DepthAI`'s.
impl Default for AdaptiveMedian {
    fn default() -> Self {
        Self {
            enable: true,
            confidence_threshold: 200,
        }
    }
}

impl ConfidenceMetrics {
    pub(in super::super) fn check(&self) -> Result<(), ParameterError> {
        check([
            ("occlusionConfidenceWeight", self.occlusion_weight, 0, 32),
            ("motionVectorConfidenceWeight", self.motion_vector_weight, 0, 32),
            (
                "motionVectorConfidenceThreshold",
                self.motion_vector_threshold,
                0,
                3,
            ),
            ("flatnessConfidenceWeight", self.flatness_weight, 0, 32),
            ("flatnessConfidenceThreshold", self.flatness_threshold, 1, 7),
        ])
    }
}

impl HoleFilling {
    pub(in super::super) fn check(&self) -> Result<(), ParameterError> {
        let [high, fill] = [self.high_confidence_threshold, self.fill_confidence_threshold];
        check([
            ("holeFilling.highConfidenceThreshold", high, 1, 255),
            ("holeFilling.fillConfidenceThreshold", fill, 1, 255),
            ("holeFilling.minValidDisparity", self.min_valid_disparity, 1, 3),
        ])
    }
}

fn check<const N: usize>(ranges: [(&'static str, u8, u8, u8); N]) -> Result<(), ParameterError> {
    for (name, value, low, high) in ranges {
        if !(low..=high).contains(&value) {
            let what = format!("{value} is out of range");
            return Err(ParameterError::new(name, what, format!("give {low} to {high}")));
        }
    }
    Ok(())
}
