# SPDX-License-Identifier: MIT
"""The calculated variants: the four slopes of the source, and every choice with an alternative."""
import dataclasses

CONTENT, LAYER = "materials.rooted.root_content", "materials.rooted.water.conductivity"
MODULUS, SCALING, WATER = "water.bulk_modulus", "stage.rain.mass_scaling", "stage.rain.water"
CONTENTS = {"bare": 0, "0.51 %": 0.51, "0.94 %": 0.94, "1.29 %": 1.29}
ALL, PAIR = tuple(CONTENTS), ("bare", "1.29 %")
HALVED = {"mesh.size": 0.145, "mesh.refine.0.size": 0.105}
FINER = {"mesh.size": 0.205, "mesh.refine.0.size": 0.148}
COARSER = {"mesh.size": 0.435, "mesh.refine.0.size": 0.315}


@dataclasses.dataclass
class Variant:
    """Settings added to those of each root content."""
    name: str
    settings: dict
    contents: tuple = PAIR
    by_depth: bool = False  # roots_by_depth.toml: no line of the mesh at the base of the layer

    def runs(self):
        """Content, name of the run, settings, case file."""
        for content in self.contents:
            name = f"{self.name}, {content}" if self.name else content
            if self.by_depth:
                roots = {"roots.0.content": CONTENTS[content]} if CONTENTS[content] else {}
            else:  # the layer is more conductive with roots
                roots = {CONTENT: CONTENTS[content], LAYER: "9.81e-4 m/s"} if CONTENTS[content] else {}
            yield content, name, roots | self.settings, "roots_by_depth.toml" if self.by_depth else "case.toml"


SLOPES = Variant("", {}, ALL)

CHOICES = (
    Variant("rain on the face itself", {"hydraulic.0.rain": "normal"}, ALL),
    Variant("rain for 1,200 s", {"stage.rain.duration": 1200}),
    Variant("layer as conductive as the soil", {LAYER: "7.62e-4 m/s"}, ("1.29 %",)),
    Variant("K0 = 0.8", {"initial.k0": 0.8}),
    Variant("roots by depth", {}, ALL, by_depth=True),
    Variant("roots by depth, element size × 0.7", FINER, by_depth=True),
    Variant("roots by depth, element size halved", HALVED, by_depth=True),
    Variant("roots by depth, strain smoothing", {"stage.rain.smoothing": "strain"}, by_depth=True),
    Variant("element size × 1.5", COARSER),
    Variant("element size × 0.7", FINER),
    Variant("element size halved", HALVED, ("bare",)),
    Variant("6 points an element", {"mesh.points_per_element": 6}),
    Variant("integration by points", {"stage.rain.integration": "points"}),
    Variant("strain smoothing", {"stage.rain.smoothing": "strain"}),
    Variant("damping 0.02", {"stage.rain.damping": 0.02}),
    Variant("time step halved", {"stage.rain.courant": 0.45}),
    Variant("two-velocity formulation", {WATER: "flows"}),
)

CRUTCHES = (  # water as stiff as water is; no inertia added
    Variant("50 MPa, β = 80", {MODULUS: "50 MPa"}),
    Variant("500 MPa, β = 80", {MODULUS: "500 MPa"}),
    Variant("2,200 MPa, β = 80", {MODULUS: "2.2 GPa"}),
    Variant("5 MPa, β = 8", {SCALING: 8}),
    Variant("5 MPa, β = 1", {SCALING: 1}),
    Variant("2,200 MPa, β = 1", {MODULUS: "2.2 GPa", SCALING: 1}),
)

# Real stiffness of water and elements of several sizes, with and without a nonlocal length [m].
REAL = {MODULUS: "2.2 GPa", "stage.rain.duration": 700}
SIZES = tuple(
    Variant(f"elements × {size:g}" + (f", nonlocal length {length} m" if length else ""),
            REAL | {"mesh.size": 0.29 * size, "mesh.refine.0.size": 0.21 * size} | ({"mesh.softening_length": length} if length else {}),
            PAIR if length else ("bare",))
    for length in (None, 0.3) for size in (1, 0.7, 0.5, 0.35)
)
