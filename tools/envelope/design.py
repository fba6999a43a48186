# SPDX-License-Identifier: MIT
"""The open choices of the three slopes, and the study that draws them: [study] mode = "together", one row for each sample and case.

Every choice is one that the source leaves open; what it prints stands in the base case and is not varied. The order of the factors, their
ranges and the seed define the design: a change of any of them gives another design.
"""
import csv
import dataclasses
import pathlib
import re
import typing

from .sampling import Levels, Range, draw_hypercube, to_toml

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
SEED = 1


def make_water_keys(choice, damping):
    """Two velocities: water and grains are damped alike and without the drag (2.5.1, printed)."""
    if choice["water"] == "seeps":
        return {"water": "seeps"}
    return {"water": "flows", "water_damping": damping, "damped_force": "without_drag",
            "pressure_smoothing": choice["pressure_smoothing"] == "on"}


def make_options(choice, smoothing):
    return {"smoothing": smoothing, "objective_rate": choice["rotation"] == "on", "fade_unseen": choice["null_modes"] == "filtered"}


# Section 3.4.2, unsaturated slope.
UNSATURATED = dict(
    water=Levels(flows=2, seeps=1),            # two velocities are printed (3.2); Darcy is Talus' reading
    pressure_smoothing=Levels(off=1, on=1),    # 2.5 "used in this thesis", where is not said; no effect with seeps
    smoothing_start=Levels(none=1, strain=1),  # "mitigated by the strain-smoothing procedure": in which stages?
    smoothing_trials=Levels(none=1, strain=1),
    start=Levels(seepage_fem=1, coupled=1),    # Talus' own; "gravity loading … conductivity by one order … mass scaling"
    start_scaling=Range(10, 100, log=True),    # of the mass, "by applying mass scaling"; coupled start only
    window=Range(1, 10),                       # [s]; 5 s is printed for the dry slope only
    tension=Levels(zero=1, apex=1),            # no tensile strength in Table 3.1
    algorithm=Levels(delaunay=1, meshadapt=1, frontal=1),
    size=Range(0.735, 0.765),                  # [m]; average edge of 0.75 m, 3,067 elements: realisations of the mesh
    rotation=Levels(on=1, off=1),              # of the stress, an option of the reference code
    null_modes=Levels(filtered=1, kept=1),
)


def set_unsaturated(choice, case):
    real = {"name": "real strength", "duration": 5, "damping": 0.05, "courant": 0.98, "reset_displacement": True,
            "smoothing": choice["smoothing_start"]} | make_water_keys(choice, 0.05)
    if choice["start"] == "seepage_fem":
        initial = {"pore_pressure": "seepage", "stress": "k0"}
        first = {"name": "gravity", "duration": 20, "until": "rest", "damping": 0.75, "cohesion": "200 kPa", "water": "held",
                 "geometry": "frozen"}
    else:
        initial = {"pore_pressure": "seepage", "stress": "none"}
        first = {"name": "gravity", "duration": 60, "gravity_ramp": 5, "damping": 0.05, "cohesion": "200 kPa", "conductivity_factor": 10,
                 "mass_scaling": choice["start_scaling"], "smoothing": choice["smoothing_start"]} | make_water_keys(choice, 0.05)
    curve = {"from": 1.0, "to": 1.5, "step": 0.025, "refine": False, "damping": 0.05, "courant": 0.98, "window": choice["window"]}
    return {"initial": initial, "stage": [first, real],
            "strength_reduction.curve": curve | make_options(choice, choice["smoothing_trials"]) | make_water_keys(choice, 0.05),
            "materials.sand.tensile_strength": "0 kPa" if choice["tension"] == "zero" else "3.464 kPa",
            "mesh.algorithm": choice["algorithm"], "mesh.size": choice["size"]}


# Section 4.4, vegetated slope.
VEGETATED = dict(
    water=Levels(flows=2, seeps=1),
    pressure_smoothing=Levels(off=1, on=1),
    smoothing=Levels(none=1, strain=1),              # 2.5: "used in this thesis"; chapter 4 does not say where
    rain=Levels(vertical=1, normal=1, flux=1),       # "an inward flux q_r prescribed over the whole ground surface"
    stress=Levels(elastic=2, chosen=1, gravity=1),   # "self-weight equilibrium is established first"
    k0=Range(0.45, 0.75),                            # where chosen; elastic: 0.54
    suction_cap=Levels(none=1, cap=1),               # the water table gives 39 kPa, the text "below about 30 kPa"
    largest_suction=Range(25, 35),                   # [kPa], where capped
    layer=Levels(normal=2, vertical=1, no_foot=1),   # "the top 0.5 m of the surface"
    mesh=Range(0.992, 1.008),                        # factor of the sizes that give the printed counts
    algorithm=Levels(delaunay=1, meshadapt=1, frontal=1),
    smallest_pressure=Range(0.2, 3, log=True),       # [kPa], floor of p' in K and in R0 p'
    rotation=Levels(on=1, off=1),
    null_modes=Levels(filtered=1, kept=1),
)
LAYERS = {  # outlines of subsoil and layer
    "normal": ([[0, 0], [11, 0], [11, 0.5], [6.7929, 0.5], [2.7929, 4.5], [0, 4.5]],
               [[0, 5], [3, 5], [7, 1], [11, 1], [11, 0.5], [6.7929, 0.5], [2.7929, 4.5], [0, 4.5]]),
    "vertical": ([[0, 0], [11, 0], [11, 0.5], [7, 0.5], [3, 4.5], [0, 4.5]],
                 [[0, 5], [3, 5], [7, 1], [11, 1], [11, 0.5], [7, 0.5], [3, 4.5], [0, 4.5]]),
    "no_foot": ([[0, 0], [11, 0], [11, 1], [7, 1], [6.6464, 0.6464], [2.7929, 4.5], [0, 4.5]],
                [[0, 5], [3, 5], [7, 1], [6.6464, 0.6464], [2.7929, 4.5], [0, 4.5]]),
}
SURFACE = [[0, 5], [3, 5], [7, 1], [11, 1]]
# Sizes in general and in the layer [m] that give the printed 1,798 triangles, 959 nodes, 1,003 triangles with soil and 330 in the layer to
# within 3 %, the last to within 15 %, in a box of 5.5 m; one of 6 m, or one size for all, cannot.
SIZES = {
    ("normal", "delaunay"): (0.3044, 0.196), ("normal", "meshadapt"): (0.317, 0.173), ("normal", "frontal"): (0.298, 0.2142),
    ("vertical", "delaunay"): (0.3134, 0.1756), ("vertical", "meshadapt"): (0.3204, 0.1682), ("vertical", "frontal"): (0.3, 0.205),
    ("no_foot", "delaunay"): (0.3107, 0.1553), ("no_foot", "meshadapt"): (0.324, 0.1406), ("no_foot", "frontal"): (0.3084, 0.1635),
}
CONTENTS = {"bare": 0, "0.51": 0.51, "0.94": 0.94, "1.29": 1.29}


def set_vegetated(choice, case):
    subsoil, layer = LAYERS[choice["layer"]]
    surface = SURFACE[:3 if choice["layer"] == "no_foot" else 4]
    base = [p for p in reversed(layer) if p not in SURFACE and p[1] <= 4.5]
    coarse, fine = (round(size * choice["mesh"], 4) for size in SIZES[choice["layer"], choice["algorithm"]])
    ground = {"on": "ground", "condition": "flux" if choice["rain"] == "flux" else "rain", "rate": "6e-4 m/s"}
    if choice["rain"] != "flux":
        ground["rain"] = choice["rain"]
    initial = {"pore_pressure": "water_table", "water_table": [[0, 1], [11, 1]],
               "stress": "none" if choice["stress"] == "gravity" else "k0"}
    if choice["stress"] == "chosen":
        initial["k0"] = choice["k0"]
    if choice["suction_cap"] == "cap":
        initial["largest_suction"] = f'{choice["largest_suction"]:g} kPa'
    gravity = {"name": "gravity", "duration": 60, "until": "rest", "water": "held", "geometry": "frozen", "damping": 0.75, "mass_scaling": 80}
    rain = {"name": "rain", "duration": 560, "damping": 0.05, "mass_scaling": 80, "reset_displacement": True}
    floor = f'{choice["smallest_pressure"]:g} kPa'
    return {"geometry.box": [[0, 0], [11, 5.5]],
            "geometry.polygon": [{"name": "subsoil", "points": subsoil}, {"name": "layer", "points": layer}],
            "mesh": {"size": coarse, "points_per_element": 3, "algorithm": choice["algorithm"],
                     "refine": [{"near": line, "size": fine, "distance": 0.5} for line in (surface, base)]},
            "initial": initial, "hydraulic": [ground],
            "stage": [gravity, rain | make_options(choice, choice["smoothing"]) | make_water_keys(choice, 0.05)],
            "materials.loess.smallest_pressure": floor, "materials.rooted.smallest_pressure": floor,
            "materials.rooted.root_content": CONTENTS[case],
            "materials.rooted.water.conductivity": "7.62e-4 m/s" if case == "bare" else "9.81e-4 m/s"}


# Section 4.5, centrifuge slope.
CENTRIFUGE = dict(
    water=Levels(flows=2, seeps=1),
    pressure_smoothing=Levels(off=1, on=1),
    smoothing=Levels(none=1, strain=1),
    stress=Levels(k0=4, gravity=1),             # nothing is printed
    k0=Range(0.43, 1.2),                        # elastic ν/(1–ν) to that of compacted soil
    largest_suction=Range(10, 60, log=True),    # [kPa]; hydrostatic suction is 53 kPa at the crest
    smallest_pressure=Range(0.2, 5, log=True),  # [kPa]
    hold=Range(50, 90),                         # [s]; "held until pressures approach a steady state"
    algorithm=Levels(delaunay=1, meshadapt=1, frontal=1),
    size=Range(31.3, 32.7),                     # [mm]; median of 32 mm, 501 elements with soil
    r0_from=Levels(spin_up=1, start=1),         # stress that R0 multiplies
    root_depth=Range(20, 100),                  # [mm], "the surface layer shown in Figure 4.15(a)"
    root_extent=Levels(ground=1, face=1),
    rotation=Levels(on=1, off=1),
    null_modes=Levels(filtered=1, kept=1),
)
START = {"name": "start", "duration": 1e-4, "mass_scaling": 100, "water": "held", "geometry": "frozen"}
PRESSURES = ("43 kPa", "50.6 kPa", "64.5 kPa", "74.5 kPa")
FACE = [[0.19, 0], [0.2, 1], [0.6, 1], [0.61, 0]]  # no roots before the toe and behind the crest


def set_centrifuge(choice, case):
    options = make_options(choice, choice["smoothing"]) | {"mass_scaling": 100}
    hold, last, spin = choice["hold"], 120, 20
    times = [spin + hold * i for i in (1, 2, 3, 4)]
    pressure = [[0, "17.7 kPa"]] + [[t, p] for t, p in zip(times, PRESSURES)]
    initial = {"stress": "none" if choice["stress"] == "gravity" else "k0", "pore_pressure": "water_table",
               "water_table": [[0.2, 0.078], [0.8, 0.118]], "largest_suction": f'{choice["largest_suction"]:g} kPa'}
    if choice["stress"] == "k0":
        initial["k0"] = choice["k0"]
    stages = [{"name": "spin-up", "duration": spin, "damping": 0.05} | options | make_water_keys(choice, 0.05),
              {"name": "injection", "duration": times[-1] + last - spin, "damping": 0.02, "reset_displacement": True}
              | options | make_water_keys(choice, 0.02)]
    # The reader checks every value of a study alone against the base case, so the stage that `equilibrium` names is in all rows.
    initial["equilibrium"] = "start" if choice["stress"] == "k0" and choice["r0_from"] == "start" else "spin-up"
    if choice["stress"] == "gravity":
        stages[0]["gravity_ramp"] = 10
    stages.insert(0, START)
    roots = {"ground": "ground", "depth": f'{choice["root_depth"]:g} mm', "content": 0.5 if case == "rooted" else 0}
    if choice["root_extent"] == "face":
        roots["along"] = FACE
    return {"initial": initial, "stage": stages, "roots": [roots],
            "hydraulic": [{"on": "ground", "condition": "seepage_face"},
                          {"on": "inlet", "condition": "pressure", "pressure": pressure, "series": "steps"}],
            "materials.fill.smallest_pressure": f'{choice["smallest_pressure"]:g} kPa',
            "mesh.algorithm": choice["algorithm"], "mesh.size": f'{choice["size"]:g} mm'}


@dataclasses.dataclass
class Slope:
    """Base case, factors, the settings of a sample and case, the cases of a sample, and what the study adds to the base case.

    `acts`: factor to (other factor, level) where it acts; elsewhere it changes nothing."""
    example: str
    factors: dict
    settings: typing.Callable
    cases: tuple
    samples: int
    frame_interval: int
    acts: dict
    first_stage: dict = None

    def draw(self, samples=None, seed=SEED):
        return draw_hypercube(self.factors, samples or self.samples, seed)

    def list_rows(self, design):
        """(name, settings) of every run, sample by sample."""
        return [(self.get_name(i, case), self.settings(choice, case)) for i, choice in enumerate(design) for case in self.cases]

    def list_mesh_rows(self, i, choice):
        """(name, settings) of sample i with the other mesh generators."""
        others = [a for a in self.factors["algorithm"].names if a != choice["algorithm"]]
        return [(f"{self.get_name(i, case)} {a}", self.settings(choice | {"algorithm": a}, case)) for a in others for case in self.cases]

    @staticmethod
    def get_name(i, case):
        return f"{i + 1:03} {case}".strip()


PAIRED = {"pressure_smoothing": ("water", "flows")}
SLOPES = {
    "unsaturated": Slope("unsaturated_slope/study.toml", UNSATURATED, set_unsaturated, ("",), 200, 10,
                         PAIRED | {"start_scaling": ("start", "coupled")}),
    "vegetated": Slope("vegetated_slope/case.toml", VEGETATED, set_vegetated, tuple(CONTENTS), 100, 40,
                       PAIRED | {"k0": ("stress", "chosen"), "largest_suction": ("suction_cap", "cap")}),
    "centrifuge": Slope("centrifuge_slope/rooted.toml", CENTRIFUGE, set_centrifuge, ("fallow", "rooted"), 60, 10,
                        PAIRED | {"k0": ("stress", "k0"), "r0_from": ("stress", "k0")}, START),
}


def read_base(path, remove=("study", "study.vary", "compare", "output.section")):
    """The case without the tables that a study of many runs does not need."""
    parts = re.split(r"(?m)^(?=\[)", path.read_text())
    heads = [re.match(r"\[+([\w.\"-]+)\]+", part) for part in parts]
    return "".join(part for part, head in zip(parts, heads) if head is None or head.group(1) not in remove)


def make_study(slope, rows):
    """The case file of the study, as text."""
    keys = list(rows[0][1])
    base = read_base(EXAMPLES / slope.example)
    base = re.sub(r"(?m)^frame_interval = .*$", f"frame_interval = {slope.frame_interval}\nrunout_meshes = 1", base)
    if slope.first_stage:
        stage = "\n".join(f"{k} = {to_toml(v)}" for k, v in slope.first_stage.items())
        base = base.replace("[[stage]]", f"[[stage]]\n{stage}\n\n[[stage]]", 1)
    text = [base.rstrip(), "", "[study]", 'mode = "together"', ""]
    for k, key in enumerate(keys):
        text += ["[[study.vary]]", f"key = {to_toml(key)}"]
        if k == 0:
            text.append("names = [" + ", ".join(to_toml(name) for name, _ in rows) + "]")
        text += ["values = [", *(f"  {to_toml(values[key])}," for _, values in rows), "]", ""]
    return "\n".join(text)


def write_design(path, factors, design):
    with open(path, "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["sample", *factors])
        out.writerows([i + 1, *choice.values()] for i, choice in enumerate(design))
