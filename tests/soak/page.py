"""A client of `oaktwin studio` that behaves badly: idle and flooding sockets, documents that are none, and uploads that end too early."""

import base64
import contextlib
import json
import os
import random
import socket
import struct
import time
import urllib.error
import urllib.parse
import urllib.request

#: The connections that stay open without a request, and the pages that do.
IDLE, PAGES = 500, 20
#: The sockets of a flood, each with so many requests that nobody waits for.
FLOOD, FLOODED = 50, 20
#: The requests of a page whose answers are compared.
FRAMES = 12
MODELS = ["OAK-D-Pro-PoE", "OAK4-D", "OAK-D-Lite", "OAK-D-ToF"]


class Refused(ConnectionError):
    """The server has too many pages."""


class Socket:
    """A WebSocket of a page, with as much of RFC 6455 as the server uses."""

    def __init__(self, host):
        name, port = host.split(":")
        self.connection = socket.create_connection((name, int(port)), timeout=120)
        key = base64.b64encode(os.urandom(16)).decode()
        lines = ["GET /api/live HTTP/1.1", f"Host: {host}", "Upgrade: websocket", "Connection: Upgrade"]
        lines += [f"Sec-WebSocket-Key: {key}", "Sec-WebSocket-Version: 13", "", ""]
        self.connection.sendall("\r\n".join(lines).encode())
        self.stream = self.connection.makefile("rb")
        status = self.stream.readline()
        if b" 101 " not in status:
            self.close()
            raise Refused(f"the server refused a WebSocket: {status!r}")
        while self.stream.readline().strip():
            pass

    def send(self, text):
        data = text.encode()
        length = bytes([0x80 | len(data)]) if len(data) < 126 else bytes([0xFE]) + struct.pack(">H", len(data))
        # A client masks what it sends; 0 is a mask, too.
        self.connection.sendall(b"\x81" + length + bytes(4) + data)

    def receive(self):
        """The next message."""
        _, length = self.stream.read(2)
        if length >= 126:
            form = ">H" if length == 126 else ">Q"
            (length,) = struct.unpack(form, self.stream.read(struct.calcsize(form)))
        data = self.stream.read(length)
        if len(data) < length:
            raise ConnectionError("the server closed a WebSocket")
        return data

    def close(self):
        self.stream.close()
        self.connection.close()


def frame(number):
    """A request of a small image, by its number."""
    state = {
        "model": MODELS[number % len(MODELS)], "calibration": None, "sensor": "depth_stereo", "lens": "pinhole", "engine": "stereo-noise",
        "pose": {"position": [-3, 0.1 * number, 1], "quaternion": [0, 0, 0, 1]}, "preset": None, "filters": None, "parameters": {},
        "extendedDisparity": False, "seed": number, "deviceSeed": None, "projector": 0, "ambient": 1,
    }  # fmt: skip
    images = ["depth", "sensor", "reason", "color"]
    request = {"type": "frame", "id": number, "oak": f"oak {number % 3}", "scene": "first", "state": state, "size": [64, 40]}
    return json.dumps(request | {"images": images, "region": [0, 0, 1, 1]})


def images_of(answer):
    """The images in an answer: what follows its header, which has times."""
    if answer[:1] == b"{":
        raise ValueError(f"a frame was refused: {answer[:200]!r}")
    (length,) = struct.unpack_from("<I", answer)
    return answer[4 + length :]


def patient(host):
    """A page of a server that still closes others."""
    for _ in range(600):
        with contextlib.suppress(Refused):
            return Socket(host)
        time.sleep(0.1)
    return Socket(host)


def visit(host, load):
    """Asks for some frames as a page does, and compares their images with those of earlier visits."""
    page = patient(host)
    for number in range(FRAMES):
        page.send(frame(number))
        load.compare(number, images_of(page.receive()))
        load.outputs += 1
    page.close()


def flood(host):
    """Opens more pages than the server takes, which ask for frames and leave without reading them."""
    sockets = []
    for _ in range(FLOOD):
        with contextlib.suppress(Refused):
            sockets.append(Socket(host))
    for number in range(FLOODED):
        for one in sockets:
            one.send(frame(number))
    for one in sockets:
        one.close()


def babble(host, choice):
    """Sends documents that are none of the page's, which are answered with an error."""
    page = patient(host)
    valid = frame(choice.randrange(FRAMES))
    for _ in range(30):
        start = choice.randrange(len(valid))
        page.send(valid[:start] + choice.choice(["", "null", "1e999", '"', "[[[[", "\u0000", "-1"]) + valid[start + choice.randrange(9) :])
        page.receive()
    page.close()


def upload(host, choice):
    """Drops files that are no scenes, small ones that are, and ones that end before their announced length."""
    name = choice.choice(["a.obj", "b.stl", "c.usda", "d.glb", "e.ply", "f.json", "../g.obj"])
    data = choice.choice([b"", os.urandom(2000), b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n" + os.urandom(4).hex().encode().join([b"# ", b"\n"])])
    path = f"http://{host}/api/scenes?name={urllib.parse.quote(name)}"
    with contextlib.suppress(urllib.error.HTTPError), urllib.request.urlopen(urllib.request.Request(path, data, method="POST"), timeout=120):
        pass
    address, port = host.split(":")
    with socket.create_connection((address, int(port)), timeout=120) as broken:
        broken.sendall(f"POST /api/scenes?name=a.obj HTTP/1.1\r\nHost: {host}\r\nContent-Length: 100000\r\n\r\nv 0 0".encode())


def harass(host, load):
    """Visits the server and troubles it in between, until the load is over."""
    choice = random.Random(1)
    address, port = host.split(":")
    idle = [socket.create_connection((address, int(port))) for _ in range(IDLE)]
    pages = [Socket(host) for _ in range(PAGES)]
    while not load.is_over:
        visit(host, load)
        for _ in range(10):
            idle.pop(choice.randrange(IDLE)).close()
            idle.append(socket.create_connection((address, int(port))))
        pages.pop(choice.randrange(PAGES)).close()
        pages.append(patient(host))
        choice.choice([flood, lambda host: babble(host, choice), lambda host: upload(host, choice)])(host)
    for one in idle + pages:
        one.close()
