# SPDX-License-Identifier: MIT
"""The runs: the case and its rooted twin, both with a smaller K0 as well, and variants with one choice changed."""

SHORT = ["stage.injection.duration=500"]  # to 520 s
JAKY = ["initial.k0=0.6"]
RUNS = [("fallow", "case.toml", []), ("rooted", "rooted.toml", []),
        ("fallow, K0 = 0.6", "case.toml", JAKY), ("rooted, K0 = 0.6", "rooted.toml", JAKY)]


def fallow(name, *settings):
    return name, "case.toml", SHORT + list(settings)


def rooted(name, *settings):
    return name, "rooted.toml", SHORT + list(settings)


FACE = "roots.0.along=[[0.19, 0], [0.2, 1], [0.6, 1], [0.61, 0]]"  # no roots before the toe and behind the crest
STRAIN = "stage.injection.smoothing=strain"
VARIANTS = [
    ("fallow, K0 = 0.43, elastic", "case.toml", ["initial.k0=0.4286"]),
    ("rooted, K0 = 0.43, elastic", "rooted.toml", ["initial.k0=0.4286"]),
    fallow("K0 = 1", "initial.k0=1"),
    fallow("integration on points", "stage.injection.integration=points", "stage.spin-up.integration=points"),
    fallow("two-velocity formulation", *(f"stage.{stage}.{key}" for stage, damping in (("spin-up", 0.05), ("injection", 0.02))
                                                for key in ("water=flows", f"water_damping={damping}", "damped_force=without_drag"))),
    fallow("strain smoothing", STRAIN),
    fallow("strain smoothing, K0 = 1", STRAIN, "initial.k0=1"),
    fallow("mesh: meshadapt", "mesh.algorithm=meshadapt"),
    fallow("mesh: frontal", "mesh.algorithm=frontal"),
    fallow("spin-up frozen, drained water", "stage.spin-up.water=held", "stage.spin-up.geometry=frozen", "stage.spin-up.until=rest",
           "stage.spin-up.mass_scaling=1", "stage.spin-up.damping=0.75"),
    fallow("real water", "water.bulk_modulus=2.2 GPa"),
    fallow("smallest pressure 5 kPa", "materials.fill.smallest_pressure=5"),
    fallow("largest suction 10 kPa", "initial.largest_suction=10"),
    fallow("drag at 147.15 m/s2", "water.drag_gravity=147.15"),
    ("400 s more of the last hold", "case.toml", ["stage.injection.duration=980"]),
    ("rooted, to 30 mm", "rooted.toml", ["roots.0.depth=0.03"]),
    rooted("rooted, strain smoothing", STRAIN),
    rooted("rooted, face only, strain smoothing", FACE, STRAIN),
]
