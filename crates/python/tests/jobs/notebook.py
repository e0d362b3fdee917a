"""What a notebook shows."""

import matplotlib

matplotlib.use("Agg")

import oaktwin

device = oaktwin.Device("OAK4-D")
scene = oaktwin.Scene.open("scene.usda", micro_texture=True)
pose = scene.look_at((3, 0, 0.6), (0, 0, 0.5), device)
sensor = oaktwin.DepthSensor(device)
shot = sensor.shoot(scene, pose, size=(320, 200))
report = oaktwin.accuracy(sensor, distances=[1.0, 2.0], devices=3, captures=2)
for item in (device, shot.camera, shot, report):
    assert item._repr_html_().startswith("<table>")  # pyright: ignore[reportPrivateUsage]
assert shot.plot().get_title() and report.plot().get_title()
assert shot.reasons.legend[6] == "no_texture" and shot["depth_sensor_distance"] is shot.depth
