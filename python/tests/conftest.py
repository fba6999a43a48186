# SPDX-License-Identifier: MIT
"""A slope so coarse that all of it takes a second, and the program to compare with."""

import os
import subprocess
from pathlib import Path

import pytest

import talus

SOURCE = Path(os.environ.get("TALUS_SOURCE_DIR", Path(__file__).parents[2]))


@pytest.fixture
def source() -> Path:
    return SOURCE


@pytest.fixture
def command_line():
    """Runs the program; returns the completed process."""

    def run(*words, **options) -> subprocess.CompletedProcess:
        words = [os.environ["TALUS_PROGRAM"], *map(str, words)]
        return subprocess.run(words, capture_output=True, text=True, **options)

    return run


def make_slope(**changes) -> talus.Case:
    """The slope of the examples with elements of 3 m, built in code; `changes` by dotted path with __ for the dots."""
    case = talus.Case(
        title="Coarse slope",
        geometry=dict(
            box=[[0, 0], [44, 17]],
            polygon=[dict(name="soil", points=[[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]])],
        ),
        mesh=dict(size=3, points_per_element=3),
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
        stage=[dict(name="gravity", duration=10, until="rest", damping=0.75, cohesion="200 kPa")],
        output=dict(monitor=[dict(name="crest", at=[12, 15])]),
    )
    for path, value in changes.items():
        case[path.replace("__", ".")] = value
    return case


def make_reduction() -> talus.Case:
    """The same with a short strength reduction: four trials of the curve, one mesh of the frozen factor."""
    return make_slope(
        analysis__kind="strength_reduction",
        strength_reduction__curve=dict(from_=1.4, to=2.0, step=0.2, refine=False, window=1),
        strength_reduction__frozen=dict(meshes=1, resolution=0.05),
    )


def make_uncertain(samples) -> talus.Case:
    """Li and Lumb's slope with two uncertain numbers: some hundred samples by LEM take a second."""
    case = talus.Case(
        title="Li and Lumb",
        geometry=dict(
            polygon=[dict(name="soil", points=[[-10, 0], [40, 0], [40, 15], [15, 15], [5, 5], [-10, 5]])],
        ),
        regions=dict(soil="soil"),
        materials=dict(
            soil=dict(
                model="mohr_coulomb", unit_weight="18 kN/m3", cohesion="18 kPa", friction_angle="30 deg", pore_pressure_ratio=0.2
            )
        ),
        analysis=dict(methods=["lem"]),
        lem=dict(methods=["bishop"], noncircular=False, referee=False, entry_exit=dict(exits=9, entries=9, depths=7)),
    )
    case.study = dict(
        mode="sample",
        samples=samples,
        random=[
            dict(key="materials.soil.cohesion", deviation="3.6 kPa"),
            dict(key="materials.soil.friction_angle", deviation="3 deg"),
        ],
    )
    return case


@pytest.fixture
def slope():
    return make_slope


@pytest.fixture
def reduction():
    return make_reduction
