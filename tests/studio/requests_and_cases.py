# SPDX-License-Identifier: MIT
"""Cases of the test of the server, and hostile requests."""
import json

CASE = """title = "Slope of a test"          # é comment

[[geometry.polygon]]
name = "soil"
points = [[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]]

[materials.clay]
model = "mohr_coulomb"
unit_weight = 20
cohesion = "10 kPa"
friction_angle = 20

[regions]
soil = "clay"

[analysis]
methods = ["lem"]

[lem]
methods = ["bishop"]
noncircular = false
referee = false
"""
# Minutes of strength reduction, which is stopped.
LONG = CASE.replace('methods = ["lem"]', 'methods = ["mpm"]').split("[lem]")[0].replace(
    "[[geometry.polygon]]", "[geometry]\nbox = [[0, 0], [44, 17]]\n\n[[geometry.polygon]]").replace(
    "unit_weight = 20\n", "grain_density = 2650\nporosity = 0.4\nyoung_modulus = \"45 MPa\"\npoisson_ratio = 0.3\ndilatancy_angle = 0\ntensile_strength = 0\n") + """
[mesh]
size = 1.5

[[boundary]]
on = "bottom"
fix = "full"

[[stage]]
name = "long"
duration = 30000
damping = 0.05
"""
# All methods that finish in seconds, on coarse meshes.
METHODS = CASE.replace('methods = ["lem"]', 'methods = ["lem", "fem", "bounds"]').replace(
    "[materials.clay]", "[mesh]\nsize = 3\n\n[materials.clay]").replace(
    "unit_weight = 20\n", "unit_weight = 20\nyoung_modulus = \"45 MPa\"\npoisson_ratio = 0.3\ndilatancy_angle = 0\ntensile_strength = 0\n") + """
[fem]
size = 3
meshes = 1
resolution = 0.05

[bounds]
gap = 0.15
"""
STUDY = CASE + """
[[study.vary]]
key = "materials.clay.cohesion"
values = ["8 kPa", "10 kPa", "12 kPa"]
"""


def make_hostile(random_source, token, port):
    """The bytes of a request."""
    pick = random_source.choice
    noise = bytes(random_source.randrange(256) for _ in range(random_source.randrange(1, 200)))
    method = pick(["GET", "POST", "PUT", "DELETE", "HEAD", "OPTIONS", "PATCH", "TRACE", "get", "G\tT", ""])
    path = pick(["/", "/api/check", "/api/solve", "/api/files", "/api/files/slope.toml", "/api/journal/slope.toml", "/api/journal", "/api/runs", "/api/import", "/api/aside/x",
                 "/api/runs/0001/stop", "/api/runs/0001/events", "/api/runs/0001/report", "/api/runs/0001/values", "/api/runs/0001/report-data", "/report.html",
                 "/api/runs/0001/export.xlsx", "/api/check-methods", "/api/export", "/api/compare?first=0001&second=0001", "/api/" + "a" * random_source.randrange(9000),
                 "/" + "%" * 50, "/%ff%fe", "/api/files/" + "../" * 100, "/?" + "a=b&" * 500, "*", "//", "/\x00", "http://evil/"])
    case = CASE.encode()
    at = random_source.randrange(len(case))
    changed = case[:at] + noise[:random_source.randrange(1, 30)] + case[at + random_source.randrange(30):]
    body = pick([b"", noise, changed, json.dumps({"text": CASE, "options": {"circles": random_source.randrange(-5, 3000)}}).encode(),
                 json.dumps({"text": changed.decode("latin-1"), "options": noise.decode("latin-1")}).encode(), b"[" * 50000, b"{\"a\":" * 5000,
                 json.dumps({"path": noise.decode("latin-1"), "settings": {"set": {noise.decode("latin-1"): 1}}}).encode(),
                 json.dumps({"text": noise.decode("latin-1"), "revision": "0"}).encode()])
    length = pick([len(body)] * 6 + [0, len(body) + 5, 10**18, -1])
    host = pick([f"127.0.0.1:{port}"] * 6 + ["evil", "", "a" * 9000])
    lines = [f"{method} {path} HTTP/1.1", f"Host: {host}", f"Content-Length: {length}",
             f"X-Talus-Token: {pick([token] * 6 + ['', 'x' * 5000])}", pick(["Connection: close", "Connection: keep-alive", "Transfer-Encoding: chunked",
             "Expect: 100-continue", "Content-Type: multipart/form-data; boundary=", "Content-Encoding: gzip", "Range: bytes=0-9999999999", "X: " + "y" * 9000])]
    return "\r\n".join(lines).encode("latin-1", "replace") + b"\r\n\r\n" + body
