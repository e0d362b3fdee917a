"""DepthAI's stereo configuration as the parameters and filters of oaktwin's engines."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

import depthai as dai

from .._findings import Error
from .._sensors import StereoMatcher
from ._library import warn_once

if TYPE_CHECKING:
    from ._twin import Twin

Config = dai.StereoDepthConfig
Preset = dai.node.StereoDepth.PresetMode
_PARTIAL = (Preset.ACCURACY, Preset.DENSITY, Preset.FAST_ACCURACY, Preset.FAST_DENSITY)
# The parameters that have the same place in both libraries: the name here, and the path in DepthAI's configuration.
_SAME = {
    "subpixel": "algorithmControl.enableSubpixel",
    "extendedDisparity": "algorithmControl.enableExtended",
    "leftRightCheckThreshold": "algorithmControl.leftRightCheckThreshold",
    "disparityShift": "algorithmControl.disparityShift",
    "numInvalidateEdgePixels": "algorithmControl.numInvalidateEdgePixels",
    "confidenceThreshold": "costMatching.confidenceThreshold",
    "enableCompanding": "costMatching.enableCompanding",
    "alpha": "costMatching.linearEquationParameters.alpha",
    "beta": "costMatching.linearEquationParameters.beta",
    "linearEquationParameters.threshold": "costMatching.linearEquationParameters.threshold",
    "enableMeanMode": "censusTransform.enableMeanMode",
    "censusTransform.threshold": "censusTransform.threshold",
    "divisionFactor": "costAggregation.divisionFactor",
    "horizontalPenaltyCostP1": "costAggregation.horizontalPenaltyCostP1",
    "horizontalPenaltyCostP2": "costAggregation.horizontalPenaltyCostP2",
    "verticalPenaltyCostP1": "costAggregation.verticalPenaltyCostP1",
    "verticalPenaltyCostP2": "costAggregation.verticalPenaltyCostP2",
}
# Those that only the processor of the OAK 4 has.
_SAME_RVC4 = {
    "noiseThresholdOffset": "censusTransform.noiseThresholdOffset",
    "noiseThresholdScale": "censusTransform.noiseThresholdScale",
    "p1Config.enableAdaptive": "costAggregation.p1Config.enableAdaptive",
    "p1Config.defaultValue": "costAggregation.p1Config.defaultValue",
    "p1Config.edgeValue": "costAggregation.p1Config.edgeValue",
    "p1Config.smoothValue": "costAggregation.p1Config.smoothValue",
    "edgeThreshold": "costAggregation.p1Config.edgeThreshold",
    "smoothThreshold": "costAggregation.p1Config.smoothThreshold",
    "p2Config.enableAdaptive": "costAggregation.p2Config.enableAdaptive",
    "p2Config.defaultValue": "costAggregation.p2Config.defaultValue",
    "p2Config.edgeValue": "costAggregation.p2Config.edgeValue",
    "p2Config.smoothValue": "costAggregation.p2Config.smoothValue",
    "occlusionConfidenceWeight": "confidenceMetrics.occlusionConfidenceWeight",
    "motionVectorConfidenceWeight": "confidenceMetrics.motionVectorConfidenceWeight",
    "motionVectorConfidenceThreshold": "confidenceMetrics.motionVectorConfidenceThreshold",
    "flatnessConfidenceWeight": "confidenceMetrics.flatnessConfidenceWeight",
    "flatnessConfidenceThreshold": "confidenceMetrics.flatnessConfidenceThreshold",
    "flatnessOverride": "confidenceMetrics.flatnessOverride",
    "holeFilling.enable": "postProcessing.holeFilling.enable",
    "holeFilling.highConfidenceThreshold": "postProcessing.holeFilling.highConfidenceThreshold",
    "holeFilling.fillConfidenceThreshold": "postProcessing.holeFilling.fillConfidenceThreshold",
    "holeFilling.minValidDisparity": "postProcessing.holeFilling.minValidDisparity",
    "holeFilling.invalidateDisparities": "postProcessing.holeFilling.invalidateDisparities",
    "adaptiveMedianFilter.enable": "postProcessing.adaptiveMedianFilter.enable",
    "adaptiveMedianFilter.confidenceThreshold": "postProcessing.adaptiveMedianFilter.confidenceThreshold",
}
_MEDIANS = {"3": "KERNEL_3x3", "5": "KERNEL_5x5", "7": "KERNEL_7x7"}
_ORDERED = {"MEDIAN": "median", "DECIMATION": "decimation", "SPECKLE": "speckle", "SPATIAL": "spatial", "TEMPORAL": "temporal"}


def _get(config: Config, path: str) -> Any:
    value: Any = config
    for part in path.split("."):
        value = getattr(value, part)
    return value


def _set(config: Config, path: str, value: Any) -> None:
    *parents, name = path.split(".")
    owner: Any = config
    for part in parents:
        owner = getattr(owner, part)
    setattr(owner, name, type(getattr(owner, name))(value))


def parameters_of(config: Config, platform: Literal["rvc2", "rvc4"]) -> dict[str, Any]:
    """The parameters of the engine "stereo-matching"."""
    paths = _SAME | _SAME_RVC4 if platform == "rvc4" else _SAME
    values: dict[str, Any] = {name: _get(config, path) for name, path in paths.items()}
    control, census = config.algorithmControl, config.censusTransform
    values["leftRightCheck"] = bool(control.enableLeftRightCheck or control.enableSwLeftRightCheck)
    values["subpixelFractionalBits"] = str(control.subpixelFractionalBits)
    values["disparityWidth"] = config.costMatching.disparityWidth.name
    values["kernelSize"] = census.kernelSize.name
    values["kernelMask"] = hex(census.kernelMask)
    if config.postProcessing.bilateralSigmaValue:
        warn_once("StereoDepth: the bilateral filter is not simulated and has no effect")
    return values


def filters_of(config: Config) -> list[str]:
    """The filters in the order of the configuration, those that are off left out."""
    post = config.postProcessing
    texts = {}
    if post.median != dai.StereoDepthConfig.MedianFilter.MEDIAN_OFF:
        texts["median"] = f"median:size={post.median.name[-1]}"
    if post.decimationFilter.decimationFactor > 1:
        decimation = post.decimationFilter
        texts["decimation"] = f"decimation:factor={decimation.decimationFactor},mode={decimation.decimationMode.name}"
    if post.speckleFilter.enable:
        texts["speckle"] = f"speckle:range={post.speckleFilter.speckleRange},difference={post.speckleFilter.differenceThreshold}"
    if post.spatialFilter.enable:
        one = post.spatialFilter
        texts["spatial"] = f"spatial:alpha={one.alpha:g},delta={one.delta},radius={one.holeFillingRadius},iterations={one.numIterations}"
    if post.temporalFilter.enable:
        kept = post.temporalFilter
        texts["temporal"] = f"temporal:alpha={kept.alpha:g},delta={kept.delta},persistency={kept.persistencyMode.name}"
    filters = []
    brightness = post.brightnessFilter
    if brightness.minBrightness > 0 or brightness.maxBrightness < 256:
        filters.append(f"brightness:min={max(brightness.minBrightness, 0)},max={brightness.maxBrightness}")
    for kind in post.filteringOrder:
        name = _ORDERED.get(kind.name)
        if name in texts:
            filters.append(texts.pop(name))
    filters += texts.values()
    threshold = post.thresholdFilter
    if threshold.minRange > 0 or threshold.maxRange < 65535:
        filters.append(f"threshold:min={threshold.minRange},max={threshold.maxRange}")
    return filters


def apply_preset(config: Config, preset: Preset, twin: Twin) -> None:
    """Writes a preset of the device's platform into a configuration."""
    name: Any = preset.name.lower().replace("_", "-")
    matcher = StereoMatcher(twin.device, preset=name)
    values = matcher.parameters
    if not twin.is_rvc4 and preset in _PARTIAL:
        # On this processor they leave everything else as it is.
        config.costMatching.confidenceThreshold = int(values["confidenceThreshold"])
        config.algorithmControl.leftRightCheckThreshold = int(values["leftRightCheckThreshold"])
        return
    for parameter, path in (_SAME | _SAME_RVC4 if twin.is_rvc4 else _SAME).items():
        _set(config, path, values[parameter])
    config.algorithmControl.enableLeftRightCheck = bool(values["leftRightCheck"])
    config.algorithmControl.subpixelFractionalBits = int(values["subpixelFractionalBits"])
    _apply_filters(config, matcher.filters)


def _apply_filters(config: Config, filters: list[str]) -> None:
    post = config.postProcessing
    post.median = dai.StereoDepthConfig.MedianFilter.MEDIAN_OFF
    post.decimationFilter.decimationFactor = 1
    post.spatialFilter.enable = post.temporalFilter.enable = post.speckleFilter.enable = False
    order = []
    for text in filters:
        name, _, settings = text.partition(":")
        values = dict(one.split("=") for one in settings.split(",") if one)
        if name.upper() in _ORDERED:
            order.append(getattr(Config.PostProcessing.Filter, name.upper()))
        _SETTERS[name](post, values)
    kinds = Config.PostProcessing.Filter
    rest = [one for one in (kinds.MEDIAN, kinds.DECIMATION, kinds.SPECKLE, kinds.SPATIAL, kinds.TEMPORAL) if one not in order]
    post.filteringOrder = order + rest


def _median(post: Any, values: dict[str, str]) -> None:
    post.median = getattr(dai.StereoDepthConfig.MedianFilter, _MEDIANS[values["size"]])


def _spatial(post: Any, values: dict[str, str]) -> None:
    one = post.spatialFilter
    one.enable, one.alpha, one.delta = True, float(values["alpha"]), int(values["delta"])
    one.holeFillingRadius, one.numIterations = int(values["radius"]), int(values["iterations"])


def _temporal(post: Any, values: dict[str, str]) -> None:
    one = post.temporalFilter
    one.enable, one.alpha, one.delta = True, float(values["alpha"]), int(values["delta"])
    one.persistencyMode = getattr(type(one.persistencyMode), values["persistency"])


def _speckle(post: Any, values: dict[str, str]) -> None:
    one = post.speckleFilter
    one.enable, one.speckleRange, one.differenceThreshold = True, int(values["range"]), int(values["difference"])


def _decimation(post: Any, values: dict[str, str]) -> None:
    one = post.decimationFilter
    one.decimationFactor = int(values["factor"])
    one.decimationMode = getattr(type(one.decimationMode), values["mode"])


def _threshold(post: Any, values: dict[str, str]) -> None:
    post.thresholdFilter.minRange, post.thresholdFilter.maxRange = int(values["min"]), int(values["max"])


def _brightness(post: Any, values: dict[str, str]) -> None:
    post.brightnessFilter.minBrightness, post.brightnessFilter.maxBrightness = int(values["min"]), int(values["max"])


_SETTERS = {
    "median": _median,
    "spatial": _spatial,
    "temporal": _temporal,
    "speckle": _speckle,
    "decimation": _decimation,
    "threshold": _threshold,
    "brightness": _brightness,
}


def depth_scale(config: Config) -> float:
    """The values of a depth image per metre."""
    units = {"METER": 1.0, "CENTIMETER": 100.0, "MILLIMETER": 1000.0, "INCH": 39.3701, "FOOT": 3.28084}
    unit = config.algorithmControl.depthUnit.name
    if unit == "CUSTOM":
        return float(config.algorithmControl.customDepthUnitMultiplier)
    if unit not in units:
        raise Error(f"StereoDepth: the depth unit {unit} is unknown; use millimetres")
    return units[unit]


def disparity_scale(config: Config) -> float:
    """The values of a disparity image per pixel: fixed-point numbers, which filters rescale to 13 bits."""
    search = {"DISPARITY_64": 63, "DISPARITY_96": 95}[config.costMatching.disparityWidth.name]
    if config.costMatching.enableCompanding:
        search = 175
    search += config.algorithmControl.disparityShift
    if config.algorithmControl.enableExtended:
        search *= 2
    return config.getMaxDisparity() / search
