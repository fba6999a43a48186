# SPDX-License-Identifier: MIT
"""Numbers of the vegetated slope that statements of the source are compared with."""
import numpy as np

WETTED = ((2, 4.5), (3, 4.5), (4, 3.5), (5, 2.5))  # x, and the height above which the section is wetted at 230 s [m]
SLID = 0.1  # displacement beyond which a point belongs to the moving mass [m]


def count_parts(r):
    """Triangles, nodes, triangles with soil, material points, and points of the layer at the start."""
    mesh, start = r.summary["mesh"], r.frame(0)
    layer = int((start["material"] == start["material"].max()).sum())
    return mesh["elements"], mesh["nodes"], mesh["soil_elements"], mesh["points"], layer


def read_suction(r):
    """Time from the start of the rain [s] and the largest suction of the slope [kPa]."""
    table = r.table()
    time = table["time"] - r.start
    return time[time > 0], table["largest_suction"][time > 0] / 1e3


def find_wetted(r, time=230):
    """Smallest and largest p'_c of the wetted soil [kPa], and the fraction of it within 30 % of 50 kPa."""
    values = []
    for x, height in WETTED:
        y, value = r.profile(time, "preconsolidation_pressure", x)
        values += list(value[y > height] / 1e3)
    return min(values), max(values), sum(35 <= v <= 65 for v in values) / len(values)


def find_front(r, x=2, time=230, saturation=0.9):
    """Depth to which the section is wetter than this [m]."""
    y, s = r.profile(time, "saturation", x)
    top, dry = y.max(), y[(s < saturation) & (y > 2.5)]
    return top - dry.max() if len(dry) else top


def compare_preconsolidation(bare, rooted):
    """p'_c [kPa] at x = 2 m before the rain: below the table its values and their largest distance from a line, over the value; by height at
    1.5 and 3 m and at the top; the top with roots over the one without."""
    y, value = bare.profile(0, "preconsolidation_pressure", 2)
    wet = y < 0.95
    line = np.polyfit(y[wet], value[wet], 1)
    yr, with_roots = rooted.profile(0, "preconsolidation_pressure", 2)
    crest = value[np.argmax(y)] / 1e3
    return {"wet": value[wet] / 1e3, "off": np.abs(np.polyval(line, y[wet]) / value[wet] - 1).max(), "top": y.max(),
            "low": np.interp(1.5, y, value) / 1e3, "middle": np.interp(3, y, value) / 1e3, "crest": crest,
            "roots": with_roots[np.argmax(yr)] / 1e3 / crest}


def find_lower_face(r, time=200):
    """Largest deviatoric strain in the layer of the lower face, and the displacement of the toe [m]."""
    frame = r.frame(time)
    lower = (frame.points[:, 0] > 5) & (frame.points[:, 0] < 7.5) & (frame["material"] == frame["material"].max())
    return frame["deviatoric_strain"][lower].max(), np.interp(time, *r.history("toe"))


def find_face_strain(r, time=200):
    """Largest deviatoric strain from the crest's edge on."""
    frame = r.frame(time)
    return frame["deviatoric_strain"][frame.points[:, 0] > 3].max()


def find_moving_strain(r, time=560):
    """Medians of the deviatoric strain of the moving mass: all of it, in the layer, below it; NaN where nothing moves."""
    frame = r.frame(time)
    moving = np.linalg.norm(frame["displacement"], axis=1) > SLID
    layer, strain = frame["material"] == frame["material"].max(), frame["deviatoric_strain"]
    return tuple(float(np.median(strain[part])) if part.any() else float("nan") for part in (moving, moving & layer, moving & ~layer))
