# SPDX-License-Identifier: MIT
# %% [markdown]
# # A slope in Python
#
# The dry slope of the examples, coarse enough for a few seconds: built in code, its mistakes found, its factor of safety
# calculated, and the results drawn. Run it cell by cell in Jupyter or VS Code, or as a whole: `python3 tutorial.py`.
# [The Python package](python.md) has the rest.

# %%
import sys
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import talus

folder = Path(sys.argv[1] if len(sys.argv) > 1 and not sys.argv[1].startswith("-") else tempfile.mkdtemp())

# %% [markdown]
# ## The case
#
# Blocks and keys have the names of `talus manual`. A number is in the unit of the manual, a text brings its own.

# %%
case = talus.Case(
    title="Dry slope, coarse",
    geometry=dict(
        box=[[0, 0], [44, 17]],
        polygon=[dict(name="soil", points=[[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]])],
    ),
    mesh=dict(size=2, algorithm="delaunay"),
    materials=dict(
        sand=dict(
            model="mohr_coulomb",
            grain_density=2650,
            porosity=0.4,
            young_modulus="45 MPa",
            poisson_ratio=0.3,
            cohesion="2 kPa",
            friction_angle="30 deg",
            dilatancy_angle=0,
            tensile_strength=0,
        )
    ),
    regions=dict(soil="sand"),
    boundary=[dict(on="bottom", fix="full"), dict(on="left", fix="normal"), dict(on="right", fix="normal")],
    stage=[dict(name="gravity", duration=20, until="rest", damping=0.75, cohesion="200 kPa")],
    analysis=dict(kind="strength_reduction"),
)

# Meaning, unit, range and default of a key:
print(talus.describe("stage.damping"))

# %% [markdown]
# Every block can be changed afterwards: by attribute, by name or by a dotted path. `from` is a word of Python, so the key is
# written `from_`.

# %%
case.stage.append(name="real strength", duration=18, damping=0.05, reset_displacement=True)
case.strength_reduction.curve.from_ = 1.2
case.strength_reduction.curve.to = 2.0
case["strength_reduction.curve.step"] = 0.1
case["strength_reduction.curve.refine"] = False
case.output.monitor = [dict(name="crest", at=[12, 15])]

# %% [markdown]
# A name that does not exist is refused at once. Everything else is checked by `validate()` and by `talus.run`, which report
# all faults together, in the words of the command line.

# %%
try:
    case.materials["sand"].cohesoin = "3 kPa"
except talus.InputError as error:
    print(error)

wrong = case.copy()
wrong.mesh.size = -2
wrong.materials["sand"].porosity = 1.4
try:
    wrong.validate()
except talus.InputError as error:
    for finding in error.findings:
        print(finding.sentence)

case.validate()
print(case.echo()["stage"][0]["courant"])  # what a calculation uses, and whether it was given

# %% [markdown]
# ## The run
#
# It writes the same folder as `talus run`, with the same numbers. `progress` may stop it by returning False; so does Ctrl-C.
# Either way the state is saved, and `resume=True` continues from there.

# %%
try:
    talus.run(case, folder / "slope", progress=lambda progress: progress.stage == "gravity")
except talus.Interrupted as error:
    print(error)

results = talus.run(case, folder / "slope", resume=True)
print(results.status, results.warnings)
print(f"factor of safety {results.factor_of_safety:.3f}")
print(results.criteria)

# %% [markdown]
# ## The results
#
# Frames hold SI units, stress positive in tension. Arrays are the program's own memory, not copies, and cannot be written to.

# %%
frame = results.trials[1.8].frame()
moved = np.linalg.norm(frame.field("displacement"), axis=1)
first = moved.argmax()
print(f"{frame}: point {frame.ids[first]} moved most, {moved[first]:.2f} m")

crest = results.monitors
print(f"crest settled {-crest['crest.displacement_y'][-1]:.2f} {crest.units['crest.displacement_y']}")

# %% [markdown]
# Every number of the report has a name, a value and a unit.

# %%
for name in ("factor_of_safety", "stage[gravity].displacement"):
    print(results.results[name])

# %%
figure, (above, below) = plt.subplots(2, figsize=(8, 10), constrained_layout=True)
talus.plot.plot_curve(results, ax=above)
talus.plot.plot_section(frame, "deviatoric_strain", ax=below)
figure.savefig(folder / "slope.png", dpi=150)

# %% [markdown]
# ## A check by hand
#
# Do not trust a number that you cannot check. Far behind the crest the ground is level, so the vertical stress at a depth
# below it is the weight above: $\sigma_{yy} = -\rho\,(1-n)\,g\,d$, with the grain density, the porosity and $d$ from
# the surface at $y = 15$ m.

# %%
sand = case.materials["sand"]
weight = sand.grain_density * (1 - sand.porosity) * 9.81  # [N/m³]
ground = results[-1]
behind = (ground.positions[:, 0] < 4) & (ground.positions[:, 1] < 12)
depth = 15 - ground.positions[behind, 1]
ratio = ground.field("stress")[behind, 1] / (-weight * depth)
print(f"unit weight {weight / 1000:.2f} kN/m³")
print(f"vertical stress over weight above: {ratio.mean():.3f} on average at {behind.sum()} points")

# %% [markdown]
# ## Variants
#
# How much does a kilopascal of cohesion bring? A study calculates a case for every value of a key, here beside each other, and
# ends in one table. (For a single variant: `case.copy()`, change it, `talus.run`.)

# %%
stronger = case.copy()
stronger.strength_reduction.curve.enabled = False  # the factor of safety alone
study = talus.study(stronger, folder / "study", {"materials.sand.cohesion": ["3 kPa", "4 kPa"]})
cohesions, factors = study.table["materials.sand.cohesion"], study.table["FoS, frozen"]
for cohesion, factor in zip(cohesions, factors):
    print(f"with {cohesion:.0f} kPa: {factor:.3f}")
