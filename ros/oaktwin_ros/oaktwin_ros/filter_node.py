"""The node: exact depth in, what an OAK would report out."""

from __future__ import annotations

from array import array

import numpy as np
import oaktwin
import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.node import Node
from rclpy.qos import HistoryPolicy, QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import CameraInfo, Image, PointCloud2, PointField

from . import conversion, settings

# Only the newest image: late ones are of no use.
SENSOR_DATA = QoSProfile(history=HistoryPolicy.KEEP_LAST, depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)


class FilterNode(Node):
    def __init__(self) -> None:
        super().__init__("oaktwin_filter")
        text = {"model": "OAK-D-Pro-PoE", "calibration": "", "sensor": "", "encoding": "16UC1"}
        for name, default in {**text, **settings.OPTIONS}.items():
            self.declare_parameter(name, default)
        path, model = self._value("calibration"), self._value("model")
        self.device = oaktwin.Device.from_calibration(path, model) if path else oaktwin.Device(model)
        self.camera: oaktwin.Camera | None = None
        self.arguments = self._arguments({})
        self.sensor = self._sensor(self.arguments)
        self.last_ns = -1
        self.add_on_set_parameters_callback(self._on_parameters)
        kind = self._value("sensor") or ("tof" if "tof" in model.lower() else "stereo")
        # Launch files remap these names.
        self.images = self.create_publisher(Image, f"oak/{kind}/image_raw", SENSOR_DATA)
        self.infos = self.create_publisher(CameraInfo, f"oak/{kind}/camera_info", SENSOR_DATA)
        self.clouds = self.create_publisher(PointCloud2, "oak/points", SENSOR_DATA)
        self.create_subscription(CameraInfo, "camera/camera_info", self._on_info, SENSOR_DATA)
        self.create_subscription(Image, "camera/depth/image_raw", self._on_depth, SENSOR_DATA)

    def _value(self, name: str):
        return self.get_parameter(name).value

    def _arguments(self, changed: dict) -> dict:
        values = {name: self._value(name) for name in settings.OPTIONS}
        return settings.arguments(values | changed)

    def _sensor(self, arguments: dict) -> oaktwin.DepthSensor:
        return oaktwin.DepthSensor(self.device, sensor=self._value("sensor") or None, camera=self.camera, **arguments)

    def _on_parameters(self, parameters) -> SetParametersResult:
        changed = {one.name: one.value for one in parameters if one.name in settings.OPTIONS}
        if not changed:
            return SetParametersResult(successful=True)
        try:
            arguments = self._arguments(changed)
            self.sensor = self._sensor(arguments)
        except (ValueError, OSError) as error:
            return SetParametersResult(successful=False, reason=str(error))
        self.arguments = arguments
        return SetParametersResult(successful=True)

    def _on_info(self, message: CameraInfo) -> None:
        try:
            arguments = conversion.camera(message)
            camera = oaktwin.Camera(**arguments)
            before = self.camera
            if before and before.size == camera.size and np.array_equal(before.K, camera.K):
                return
            self.camera = camera
            self.sensor = self._sensor(self.arguments)
        except ValueError as error:
            self.get_logger().error(f"camera info: {error}", throttle_duration_sec=10.0)

    def _on_depth(self, message: Image) -> None:
        if self.camera is None:
            self.get_logger().warning("no camera info arrived; depth images wait", throttle_duration_sec=10.0)
            return
        try:
            time_ns = conversion.nanoseconds(message.header.stamp)
            if time_ns < self.last_ns:
                self.sensor.reset()
            self.last_ns = time_ns
            exact = conversion.depth(message)
            # The stamp keys the noise, as in `oaktwin bridge`.
            measured = self.sensor(exact, frame=time_ns)
        except ValueError as error:
            self.get_logger().error(f"depth: {error}", throttle_duration_sec=10.0)
            return
        metres = measured if measured.dtype == np.float32 else measured.astype(np.float32) / np.float32(1000)
        out = metres if self._value("encoding") == "32FC1" else conversion.millimetres(metres)
        camera = self.sensor.camera
        self.images.publish(Image(header=message.header, **_typed(conversion.depth_fields(out))))
        fields = conversion.info_fields(camera.size, camera.K)
        self.infos.publish(CameraInfo(header=message.header, **_typed(fields)))
        if self.clouds.get_subscription_count() > 0:
            points = conversion.cloud(metres, camera.K)
            fields = conversion.cloud_fields(points, PointField)
            self.clouds.publish(PointCloud2(header=message.header, **_typed(fields)))


def _typed(fields: dict) -> dict:
    """The fields with the types that rclpy sets without looking at each element."""
    typed = dict(fields)
    if "data" in typed:
        typed["data"] = array("B", typed["data"].tobytes())
    if "d" in typed:
        typed["d"] = array("d", typed["d"].tolist())
    return typed


def main() -> None:
    rclpy.init()
    node = FilterNode()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()
