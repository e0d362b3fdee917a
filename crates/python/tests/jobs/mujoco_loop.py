"""A closed loop in MuJoCo: a box is pushed until the measured depth says that it is near."""

# pyright: basic, reportAttributeAccessIssue=false

import mujoco
import numpy as np

import oaktwin

model = mujoco.MjModel.from_xml_string("""
<mujoco><worldbody>
  <camera name="oak" pos="0 0 0" xyaxes="0 -1 0 0 0 1" resolution="320 200" fovy="50"/>
  <body name="box" pos="3 0 0"><joint type="slide" axis="1 0 0"/><geom type="box" size=".2 2 2" mass="1"/></body>
</worldbody></mujoco>""")
data = mujoco.MjData(model)
camera = oaktwin.Camera.from_mujoco(model, "oak")
sensor = oaktwin.DepthSensor(oaktwin.Device("OAK4-D"), camera=camera)
box = oaktwin.Mesh(np.array([[0, -2, -2], [0, 2, -2], [0, 2, 2], [0, -2, 2]]), np.array([[0, 1, 2], [0, 2, 3]]))
scene = oaktwin.Scene.from_meshes({"box": box})
pose, eye = np.eye(4), scene.look_at((0, 0, 0), (1, 0, 0), camera)

mujoco.mj_forward(model, data)
step, distance = 0, np.inf
while distance >= 1.0 and step < 1000:
    pose[:3, 3] = data.body("box").xpos - [0.2, 0, 0]
    scene.set_pose("box", pose)
    measured = sensor(scene.render(camera, eye)["distance_to_image_plane"])
    step, distance = step + 1, measured[100, 160]
    data.qfrc_applied[0] = -20.0
    mujoco.mj_step(model, data, 10)
assert 0.5 < distance < 1.0 and step > 3
