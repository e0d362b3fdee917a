"""The node IMU: the accelerometer and the gyroscope along the motion of the device."""

from __future__ import annotations

from datetime import timedelta
from typing import Any

import depthai as dai
import numpy as np
import numpy.typing as npt

from .._devices import simulate_imu
from .._findings import Error
from ._node import VirtualNode
from ._world import rotation_vector

Sensor = dai.IMUSensor
_ACCELERATION = {Sensor.ACCELEROMETER_RAW, Sensor.ACCELEROMETER_UNCALIBRATED, Sensor.ACCELEROMETER_CALIBRATED}
_ROTATION = {Sensor.GYROSCOPE_RAW, Sensor.GYROSCOPE_UNCALIBRATED, Sensor.GYROSCOPE_CALIBRATED}
_ORIENTATION = {Sensor.ROTATION_VECTOR, Sensor.GAME_ROTATION_VECTOR}
# Samples are made for so many seconds at once, from poses this far apart.
_WINDOW_S, _POSE_STEP_S = 20.0, 0.02
_LONGEST_BATCH = 20


class IMU(VirtualNode):
    """DepthAI's IMU. Its packets have the samples of all sensors at one time."""

    is_source = True
    Properties = getattr(dai.node.IMU, "Properties", None)

    def __init__(self) -> None:
        super().__init__()
        imu = self.twin.report.get("imu")
        if not imu or not imu.get("parts"):
            raise Error(f"IMU: {self.twin.device.name} has no inertial sensor; choose a model with one")
        self.out = self.message_output("out", dai.DatatypeEnum.IMUData)
        self.mockIn = self.message_input("mockIn", dai.DatatypeEnum.IMUData)
        self._rates: dict[dai.IMUSensor, float] = {}
        self._threshold, self._longest = 1, 5

    def enableIMUSensor(self, sensors: Any, reportRate: int | None = None) -> None:
        """Adds sensors with a rate in reports per second, or with their configurations."""
        for one in sensors if isinstance(sensors, (list, tuple)) else [sensors]:
            sensor, rate = (one.sensorId, one.reportRate) if isinstance(one, dai.IMUSensorConfig) else (one, reportRate)
            if sensor not in _ACCELERATION | _ROTATION | _ORIENTATION:
                raise Error(f"IMU: {sensor.name} is not simulated; use an accelerometer, a gyroscope or ROTATION_VECTOR")
            if not rate or rate <= 0:
                raise RuntimeError(f"IMU: the rate of {sensor.name} is {rate}; pass reports per second")
            self._rates[sensor] = float(rate)

    def setBatchReportThreshold(self, batchReportThreshold: int) -> None:
        """The number of packets for which a message waits."""
        self._threshold = max(int(batchReportThreshold), 1)

    def getBatchReportThreshold(self) -> int:
        """The number of packets for which a message waits."""
        return self._threshold

    def setMaxBatchReports(self, maxBatchReports: int) -> None:
        """The largest number of packets in a message."""
        self._longest = max(int(maxBatchReports), 1)

    def getMaxBatchReports(self) -> int:
        """The largest number of packets in a message."""
        return self._longest

    def enableFirmwareUpdate(self, enable: bool) -> None:
        """Has no effect: there is no firmware."""

    def work(self) -> None:
        """Sends packets until the pipeline stops."""
        if not self._rates:
            return
        rate = max(self._rates.values())
        batch = min(self._threshold, self._longest)
        schedule = self.twin.clock.schedule(rate)
        samples = _Samples(self, rate)
        sent, message = 0, 0
        while self.runs():
            # In real time, packets that are late are sent together; none is lost.
            target = sent + batch - 1
            if schedule.is_over(target):
                return
            if self.twin.clock.fast:
                latest = target
            else:
                taken = schedule.next(target - 1, self.runs)
                if taken is None:
                    return
                latest = max(taken, target)
            while sent <= latest and self.runs():
                last = min(sent + self._longest, latest + 1)
                data = dai.IMUData()
                data.packets = [samples.packet(index) for index in range(sent, last)]
                self.twin.clock.stamp(data, (last - 1) / rate, message)
                self.out.send(data)
                sent, message = last, message + 1


class _Samples:
    """The samples of all sensors at the rate of the fastest one; slower ones repeat theirs."""

    def __init__(self, node: IMU, rate: float) -> None:
        self.node, self.rate = node, rate
        self.twin = node.twin
        self._window = -1
        self._data: Any = None
        self._body_from_imu = self.twin.device.extrinsics("imu", "body")

    def packet(self, index: int) -> dai.IMUPacket:
        """The reports of one time."""
        packet = dai.IMUPacket()
        for sensor, rate in self.node._rates.items():
            step = max(round(self.rate / rate), 1)
            own = index // step
            seconds = own * step / self.rate
            if sensor in _ORIENTATION:
                packet.rotationVector = self._stamped(self._orientation(seconds), seconds, own)
            else:
                kind = "linear_acceleration" if sensor in _ACCELERATION else "angular_velocity"
                values = self._sample(kind, own * step)
                if sensor in _ACCELERATION:
                    packet.acceleroMeter = self._stamped(_vector(dai.IMUReportAccelerometer(), values), seconds, own)
                else:
                    packet.gyroscope = self._stamped(_vector(dai.IMUReportGyroscope(), values), seconds, own)
        return packet

    def _sample(self, kind: str, index: int) -> npt.NDArray[np.float64]:
        per_window = round(_WINDOW_S * self.rate)
        window, offset = divmod(index, per_window)
        if window != self._window:
            self._data, self._window = self._simulate(window), window
        values: npt.NDArray[np.float64] = self._data[kind]
        sample: npt.NDArray[np.float64] = values[min(offset, len(values) - 1)]
        return sample

    def _simulate(self, window: int) -> Any:
        """The samples of one window. Each window has noise of its own, so that a bias is a new one after it."""
        times = np.arange(-1, round(_WINDOW_S / _POSE_STEP_S) + 2) * _POSE_STEP_S
        start = window * _WINDOW_S
        poses = np.stack([np.asarray(self.twin.world.body_pose(max(start + one, 0.0))) for one in times])
        up = self.twin.world.scene.up
        seed = self.twin.settings.seed + window
        data = simulate_imu(self.twin.device, times + _POSE_STEP_S, poses, rate=self.rate, seed=seed, up=up)
        skipped = round(_POSE_STEP_S * self.rate)
        return {kind: data[kind][skipped:] for kind in ("linear_acceleration", "angular_velocity")}

    def _orientation(self, seconds: float) -> dai.IMUReportRotationVectorWAcc:
        """The true orientation of the sensor in the world, as a quaternion."""
        rotation = np.asarray(self.twin.world.body_pose(seconds))[:3, :3] @ self._body_from_imu[:3, :3]
        vector = rotation_vector(rotation)
        angle = float(np.linalg.norm(vector))
        axis = vector / angle if angle > 1e-12 else np.zeros(3)
        report = dai.IMUReportRotationVectorWAcc()
        report.real = float(np.cos(angle / 2))
        report.i, report.j, report.k = (float(one) for one in np.sin(angle / 2) * axis)
        return report

    def _stamped(self, report: Any, seconds: float, sequence: int) -> Any:
        report.sequence = sequence
        report.accuracy = dai.IMUReport.Accuracy.HIGH
        for name, value in (("tsDevice", timedelta(seconds=seconds)), ("timestamp", self.twin.clock.host_time(seconds))):
            setattr(report, name, _timestamp(value))
        return report


def _vector(report: Any, values: npt.NDArray[np.float64]) -> Any:
    report.x, report.y, report.z = (float(one) for one in values)
    return report


def _timestamp(value: timedelta) -> dai.Timestamp:
    stamp = dai.Timestamp()
    microseconds = round(value.total_seconds() * 1e6)
    stamp.sec, stamp.nsec = microseconds // 1_000_000, microseconds % 1_000_000 * 1000
    return stamp
