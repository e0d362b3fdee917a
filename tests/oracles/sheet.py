"""The published parameter sheet of the OAK assets, transcribed by hand: the values that every asset must contain.

Independent of the project's own catalog on purpose.
"""

from dataclasses import dataclass

DEPTH_PREFIX = "omni:rtx:post:depthSensor:"
DEPTH_API = "OmniSensorDepthSensorSingleViewAPI"


@dataclass(frozen=True)
class Camera:
    """One column of a camera table. Millimetres where the sheet has millimetres.

    The place is in the body's frame (x forward, y left, z up, origin midway between left and right). The sheet has the
    baseline only; RGB and ToF places come from the boards' own descriptions.
    """

    prim: str
    focal_length: float
    aperture: tuple[float, float]
    hfov_deg: float
    focus_distance: float
    stereo_role: str
    size: tuple[int, int]
    pixel_um: float
    max_fov: float
    place_mm: tuple[float, float, float]


@dataclass(frozen=True)
class Depth:
    """One depth-sensor table: the pseudo-depth camera's prim, the camera it copies, and the attributes' values."""

    prim: str
    camera: str
    baseline: float
    focal_px: float
    sensor_px: float
    min_m: float
    max_m: float
    noise: tuple[float, float] = (0.25, 0.2)
    extended_min_m: float | None = None

    def attributes(self, isaac: str, extended: bool = False) -> dict[str, tuple[str, float | int | bool]]:
        """Name without prefix: (type, value), for Isaac Sim `5.1` or `6`."""
        smallest = self.extended_min_m if extended and self.extended_min_m is not None else self.min_m
        floats = {
            "baselineMM": self.baseline,
            "focalLengthPixel": self.focal_px,
            "sensorSizePixel": self.sensor_px,
            "maxDisparityPixel": 191.0 if extended else 95.0,
            "minDistance": smallest,
            "maxDistance": self.max_m,
            "noiseMean": self.noise[0],
            "noiseSigma": self.noise[1],
            "noiseDownscaleFactorPixel": 2.0,
            "confidenceThreshold": 0.8,
        }
        outlier = ("int", 3) if isaac == "5.1" else ("bool", True)
        return {name: ("float", value) for name, value in floats.items()} | {"outlierRemovalEnabled": outlier}


@dataclass(frozen=True)
class Model:
    """One asset. Dimensions: width, height, depth in mm, where a source gives them."""

    name: str
    stem: str
    prim: str
    baseline_mm: float
    cameras: tuple[Camera, ...]
    depths: tuple[Depth, ...]
    dimensions_mm: tuple[float, float, float] | None = None
    wide: bool = False

    @property
    def has_extended_disparity(self) -> bool:
        return len(self.depths) == 1

    def camera(self, prim: str) -> Camera:
        return next(camera for camera in self.cameras if camera.prim == prim)


def _pair(sensor: str, focal_length: float, hfov_deg: float, max_fov: float, y_mm: float) -> tuple[Camera, Camera]:
    """The left and right columns, which differ in name, role and side only."""
    size, aperture = (1280, 800), (3.84, 2.4)
    left, right = (
        Camera(f"Camera_{side}_{sensor}", focal_length, aperture, hfov_deg, 196.0, side, size, 3.0, max_fov, (0.0, y, 0.0))
        for side, y in (("left", y_mm), ("right", -y_mm))
    )
    return left, right


IMX378, IMX586 = "Camera_rgb_imx378", "Camera_rgb_imx586"
HD, MP12 = (3840, 2160), (4000, 3000)
RANGE_77 = {"baseline": 75.0, "focal_px": 805.0, "sensor_px": 1280.0, "min_m": 0.6, "max_m": 12.0, "extended_min_m": 0.3}
RANGE_97 = {"baseline": 75.0, "focal_px": 566.0, "sensor_px": 1280.0, "min_m": 0.2, "max_m": 8.0}
LEFT = "Camera_left_ov9282"
PSEUDO = "Camera_pseudo_depth"

MODELS = (
    Model(
        "OAK-D Pro PoE", "oak_d_pro_poe", "oak_d_pro", 75.0,
        (
            Camera(IMX378, 4.7626, (5.952, 3.348), 64.0, 500.0, "mono", HD, 1.55, 82.0, (0.0, 0.0, 0.0)),
            *_pair("ov9282", 2.4138, 77.0, 89.5, 37.5),
        ),
        (Depth(PSEUDO, LEFT, **RANGE_77),),
        dimensions_mm=(111.0, 40.0, 31.3),
    ),
    Model(
        "OAK-D Pro W PoE", "oak_d_pro_w_poe", "oak_d_pro_w", 75.0,
        (
            Camera(IMX378, 3.5467, (5.952, 3.348), 80.0, 500.0, "mono", HD, 1.55, 108.0, (0.0, 0.0, 0.0)),
            *_pair("ov9282", 1.6987, 97.0, 127.0, 37.5),
        ),
        (Depth(PSEUDO, LEFT, **RANGE_97),),
        dimensions_mm=(111.0, 40.0, 31.3),
        wide=True,
    ),
    Model(
        "OAK4-D", "oak4_d", "oak4_d", 75.0,
        (
            Camera(IMX586, 4.7442, (6.4, 4.8), 68.0, 500.0, "mono", MP12, 1.6, 80.3, (3.2, 0.0, 0.0)),
            *_pair("ov9282", 2.4138, 77.0, 86.3, 37.5),
        ),
        (Depth(PSEUDO, LEFT, **RANGE_77),),
    ),
    Model(
        "OAK4-D Wide", "oak4_d_wide", "oak4_d_wide", 75.0,
        (
            Camera(IMX586, 3.3137, (6.4, 4.8), 88.0, 500.0, "mono", MP12, 1.6, 100.7, (1.87, 0.0, 0.0)),
            *_pair("ov9282", 1.6987, 97.0, 106.2, 37.5),
        ),
        (Depth(PSEUDO, LEFT, **RANGE_97),),
        wide=True,
    ),
    Model(
        "OAK-D ToF", "oak_d_tof", "oak_d_tof", 20.0,
        (
            Camera("Camera_tof_33d", 3.1991, (4.48, 3.36), 70.0, 500.0, "mono", (640, 480), 7.0, 70.0, (0.0, -27.382, 0.0)),
            *_pair("ov9782", 2.2882, 80.0, 80.0, 10.0),
        ),
        (
            Depth("Camera_pseudo_depth_stereo", "Camera_left_ov9782", 20.0, 763.0, 1280.0, 0.2, 5.0),
            Depth("Camera_pseudo_depth_tof", "Camera_tof_33d", 0.5, 457.0, 640.0, 0.2, 5.0, noise=(0.1, 0.1)),
        ),
        # From the vendor's page of the device, not from the sheet.
        dimensions_mm=(80.0, 52.0, 46.0),
    ),
)

CLIPPING_RANGE = (0.01, 100.0)

# The distortion rows of every camera table, under the attributes' own names.
LEGACY_FIXED = {
    "fthetaPolyA": 0.0,
    "fthetaPolyB": 0.00245,
    "fthetaPolyC": 0.0,
    "fthetaPolyD": 0.0,
    "fthetaPolyE": 0.0,
    "fthetaPolyF": 0.0,
    "p0": -0.00037,
    "p1": -0.00074,
    "s0": -0.00058,
    "s1": -0.00022,
    "s2": 0.00019,
    "s3": -0.0002,
}


def legacy(camera: Camera) -> dict[str, float]:
    """The distortion rows of one camera's column."""
    width, height = camera.size
    return LEGACY_FIXED | {
        "fthetaWidth": float(width),
        "fthetaHeight": float(height),
        "fthetaCx": width / 2,
        "fthetaCy": height / 2,
        "fthetaMaxFov": camera.max_fov,
    }
