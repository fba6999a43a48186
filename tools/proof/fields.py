# SPDX-License-Identifier: MIT
"""What the fields of a bounds.json prove: factor and imbalance of the stresses, power and flow rule of the mechanism."""
import math
from collections import defaultdict

import numpy as np

from .case import NotEvaluated

GAUSS = ((0.5 - math.sqrt(0.15), 5 / 18), (0.5, 8 / 18), (0.5 + math.sqrt(0.15), 5 / 18))


def make_lattice(n):
    """Barycentric weights of points inside a triangle: the centres of n² equal parts."""
    points = []
    for i in range(n):
        for j in range(n - i):
            points.append(((i + 1 / 3) / n, (j + 1 / 3) / n))
            if j < n - i - 1:
                points.append(((i + 2 / 3) / n, (j + 2 / 3) / n))
    points = np.array(points)
    return np.c_[1 - points.sum(axis=1), points]


def make_rule(n):
    """Barycentric weights of three points in each of n² equal parts of a triangle, a rule that is exact for quadratic functions."""
    centres = make_lattice(n)
    points = []
    for w in centres:
        # The corners of a part are its centre and (1, -1/3, …)/n, turned in the parts that stand on their tip.
        upright = np.allclose((w * n) % 1, 1 / 3)
        for c in range(3):
            corner = np.full(3, -1 / 3)
            corner[c] = 2 / 3
            points.append(w + (0.5 if upright else -0.5) * corner / n)
    return np.array(points)


def find_normal(p, q):
    """Outward normal of a side of a counterclockwise triangle."""
    d = (q - p) / np.linalg.norm(q - p)
    return np.array([d[1], -d[0]])


class Mesh:
    """Triangles with their soils, points inside them, and edges."""

    def __init__(self, section, nodes, triangles, lattice):
        self.nodes, self.triangles = np.array(nodes, float), np.array(triangles)
        corners = self.nodes[self.triangles[:, :3]]
        self.corners = corners
        a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
        twice = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (c[:, 0] - a[:, 0]) * (b[:, 1] - a[:, 1])
        if not (twice > 0).all():
            raise NotEvaluated("a triangle without area")
        self.area = twice / 2
        turned = [np.c_[p[:, 1] - q[:, 1], q[:, 0] - p[:, 0]] / twice[:, None] for p, q in ((b, c), (c, a), (a, b))]
        self.gradients = np.stack(turned, axis=1)  # of the shape functions, by triangle and corner [1/m]
        self.soils = section.polygons.find_soils(corners.mean(axis=1))
        if (self.soils < 0).any():
            raise NotEvaluated("a triangle outside the soil")
        self.lattice = lattice
        self.inside = np.einsum("kc,ecd->ekd", self.lattice, corners)
        self.edges = defaultdict(list)
        for e, t in enumerate(self.triangles):
            for i in range(3):
                self.edges[tuple(sorted((int(t[i]), int(t[(i + 1) % 3]))))].append((e, i))

    def evaluate(self, find, section):
        """find(soil, points) of all points inside, by triangle and point."""
        values = np.zeros(self.inside.shape[:2])
        for soil in np.unique(self.soils):
            part = self.soils == soil
            found = find(soil, self.inside[part].reshape(-1, 2))
            if found is None:
                return None
            values[part] = found.reshape(-1, len(self.lattice))
        return values

    def list_border(self, section):
        """Sides with one triangle: (triangle, corner, p, q, normal). Raises where one lies inside the soil."""
        sides = []
        for owners in self.edges.values():
            if len(owners) > 2:
                raise NotEvaluated("an edge of three triangles")
            if len(owners) == 1:
                e, i = owners[0]
                p, q = self.nodes[self.triangles[e, i]], self.nodes[self.triangles[e, (i + 1) % 3]]
                sides.append((e, i, p, q, find_normal(p, q)))
        outside = np.array([(p + q) / 2 + 0.01 * np.linalg.norm(q - p) * n for _, _, p, q, n in sides])
        # Sides shorter than the rounding of polygons are no evidence.
        if (section.polygons.find_soils(outside) >= 0).sum() > 0:
            place = outside[section.polygons.find_soils(outside) >= 0][0]
            raise NotEvaluated(f"the mesh has a cut in the soil at {place[0]:.2f}, {place[1]:.2f} m")
        return sides

    def find_missing_area(self, section):
        """Area of soil without triangles over that of the soil, by points of a raster."""
        raster = np.stack(np.meshgrid(*[np.linspace(section.low[d], section.high[d], 402)[1:-1] for d in (0, 1)]), axis=-1).reshape(-1, 2)
        area = np.prod(section.high - section.low) * (section.polygons.find_soils(raster) >= 0).mean()
        return 1 - self.area.sum() / area


def locate(mesh, x):
    """Triangle and barycentric weights of points in a mesh; triangle -1 outside."""
    owner, weights = np.full(len(x), -1), np.zeros((len(x), 3))
    order = np.argsort(x[:, 0])
    sorted_x = x[order, 0]
    low, high = mesh.corners.min(axis=1), mesh.corners.max(axis=1)
    begin, end = np.searchsorted(sorted_x, low[:, 0] - 1e-9), np.searchsorted(sorted_x, high[:, 0] + 1e-9)
    for e in range(len(mesh.triangles)):
        some = order[begin[e]:end[e]]
        some = some[(x[some, 1] >= low[e, 1] - 1e-9) & (x[some, 1] <= high[e, 1] + 1e-9)]
        if len(some):
            w = (x[some] - mesh.corners[e].mean(axis=0)) @ mesh.gradients[e].T + 1 / 3
            good = w.min(axis=1) > -1e-6
            owner[some[good]], weights[some[good]] = e, w[good]
    return owner, weights


class FileWater:
    """Pressures of seepage, and unit weights that follow from equilibrium, of the stress field of the file."""

    def __init__(self, mesh, pressure, weights):
        self.mesh, self.pressure, self.weights = mesh, pressure, weights

    def find(self, x):
        owner, w = locate(self.mesh, x.reshape(-1, 2))
        if (owner < 0).any():
            raise NotEvaluated("pressures of seepage outside the stress field")
        p = (self.pressure[owner] * w).sum(axis=1)
        return p.reshape(x.shape[:2]), self.weights[owner].reshape(x.shape[:2])


class Lower:
    """The stress field: `factor` at the worst point `place`, `imbalance` over the largest overburden, `moved` weight over all of it."""

    def __init__(self, section, holds, points, way, bars=None):
        mesh = Mesh(section, holds["nodes"], holds["triangles"], make_lattice(points))
        self.mesh, self.way = mesh, way
        stress = np.array(holds["stress"]).reshape(-1, 3, 3)
        pressure = np.array(holds["pressure"]) if holds.get("pressure") else np.zeros((len(mesh.triangles), 3))
        total = stress.copy()
        total[:, :, :2] -= pressure[:, :, None]
        self.notes, self.taken = [], []
        self.missing = mesh.find_missing_area(section)
        self.check_weights(section, total, pressure)
        self.check_strength(section, stress, pressure)
        self.check_edges(section, total, pressure, bars)

    def check_weights(self, section, total, pressure):
        g = self.mesh.gradients
        force = np.stack([(g[:, :, 0] * total[:, :, 0] + g[:, :, 1] * total[:, :, 2]).sum(axis=1),
                          (g[:, :, 0] * total[:, :, 2] + g[:, :, 1] * total[:, :, 1]).sum(axis=1)], axis=1)
        size = np.ptp(self.mesh.corners, axis=1).max(axis=1)
        weights = self.mesh.evaluate(section.find_soil_weights, section)
        self.file_water = None
        if weights is None:  # seepage: the file has no weights, so that those of equilibrium have to lie between dry and saturated
            own = force[:, 1] / section.vertical
            extremes = np.array([section.find_extreme_weights(s) for s in self.mesh.soils])
            self.imbalance = (np.maximum(np.maximum(extremes[:, 0] - own, own - extremes[:, 1]), 0) * size).max() / section.unit
            self.imbalance = max(self.imbalance, np.abs((force[:, 0] + self.way * section.horizontal * own) * size).max() / section.unit)
            off = np.where(pressure.min(axis=1) > 0, own - extremes[:, 1], 0) * self.mesh.area
            self.moved, self.added = np.abs(off).sum() / (own * self.mesh.area).sum(), off.sum() / (own * self.mesh.area).sum()
            self.file_water = FileWater(self.mesh, pressure, own)
            self.taken += ["pore pressures of seepage", "weights of partly saturated soil"]
            return
        own = force[:, 1] / section.vertical  # the weight with which the field is in equilibrium
        off = own - weights.mean(axis=1)
        # Triangles of the first mesh that a water table crosses have the mean of both weights, and those refined from them too.
        extremes = np.array([section.find_extreme_weights(s) for s in self.mesh.soils])
        stepped = (section.water.table is not None) & (np.abs(extremes[:, 1] - extremes[:, 0]) > 0)
        between = (own > extremes.min(axis=1) - 1) & (own < extremes.max(axis=1) + 1) & stepped
        self.imbalance = (np.abs(off * section.vertical) * size)[~between].max(initial=0) / section.unit
        sideways = force[:, 0] + self.way * section.horizontal * own
        self.imbalance = max(self.imbalance, np.abs(sideways * size).max() / section.unit)
        self.moved = (np.abs(off) * self.mesh.area)[between].sum() / (weights.mean(axis=1) * self.mesh.area).sum()
        self.added = (off * self.mesh.area)[between].sum() / (weights.mean(axis=1) * self.mesh.area).sum()

    def check_strength(self, section, stress, pressure):
        mesh, k = self.mesh, len(self.mesh.lattice)
        own = mesh.evaluate(section.find_pressures, section)
        linear = np.einsum("kc,ec->ek", mesh.lattice, pressure)
        more = (own - linear) if own is not None else np.zeros_like(linear)
        effective = np.einsum("kc,ecd->ekd", mesh.lattice, stress)
        effective[:, :, :2] += more[:, :, None]
        least = 1e-6 * section.unit  # of cohesion and tension: a computed field only approximates stress-free soil
        factor = np.full((len(mesh.triangles), k), np.inf)
        for soil in np.unique(mesh.soils):
            part = mesh.soils == soil
            x, s = mesh.inside[part].reshape(-1, 2), effective[part].reshape(-1, 3)
            radius, mean = np.hypot((s[:, 0] - s[:, 1]) / 2, s[:, 2]), (s[:, 0] + s[:, 1]) / 2
            law = section.laws[soil]
            if hasattr(law, "body"):
                found = np.minimum(law.body.find_factor(x, radius, mean, least), law.find_plane_factor(s, least))
            else:
                found = law.find_factor(x, radius, mean, least)
            factor[part] = found.reshape(-1, k)
        worst = np.unravel_index(np.argmin(factor), factor.shape)
        self.factor, self.place, self.soil = factor[worst], mesh.inside[worst], section.names[mesh.soils[worst[0]]]

    def check_edges(self, section, total, pressure, bars):
        mesh = self.mesh
        jumps, lacks = {}, {}

        def pull(f, node, normal):
            s = total[f][list(mesh.triangles[f]).index(node)]
            return np.array([s[0] * normal[0] + s[2] * normal[1], s[2] * normal[0] + s[1] * normal[1]])

        for (a, b), owners in mesh.edges.items():
            if len(owners) == 2:
                e, i = owners[0]
                normal = find_normal(mesh.nodes[mesh.triangles[e, i]], mesh.nodes[mesh.triangles[e, (i + 1) % 3]])
                jumps[a, b] = [pull(owners[0][0], n, normal) - pull(owners[1][0], n, normal) for n in (a, b)]
        self.water_gap = 0.0
        for e, i, p, q, normal in mesh.list_border(section):
            held = section.find_support(p, q)
            if held == "full":
                continue
            given = section.find_traction(np.array([p, q]), normal, (p + q) / 2)
            nodes = [int(mesh.triangles[e, i]), int(mesh.triangles[e, (i + 1) % 3])]
            lack = [pull(e, n, normal) - t for n, t in zip(nodes, given)]
            if held == "normal":
                lack = [v - (v @ normal) * normal for v in lack]
            elif self.file_water is not None:
                standing = section.water.find_standing(np.array([p, q]), (p + q) / 2)
                self.water_gap = max(self.water_gap, np.abs(np.maximum(pressure[e][[i, (i + 1) % 3]], 0) - standing).max())
            lacks[nodes[0], nodes[1]] = (lack, p, q, held)
        if self.file_water is not None:
            self.notes.append(f"pressure at the free ground within {self.water_gap / 1e3:.3g} kPa of standing water")
        self.bar_factor = math.inf
        if bars:
            self.bar_factor, lack = bars.check_lower(mesh, jumps, lacks)
            self.imbalance = max(self.imbalance, lack / section.unit)
        worst = max([np.abs(v).max() for pair in jumps.values() for v in pair] + [np.abs(v).max() for pair in lacks.values() for v in pair[0]], default=0)
        self.imbalance = max(self.imbalance, worst / section.unit)


class Upper:
    """The mechanism at a printed factor: `ratio` of work to dissipation, `lack` of the flow rule over the mean shear rate, `moved` fixed sides."""

    def __init__(self, section, moves, points, way, printed, bars=None, file_water=None):
        mesh = Mesh(section, moves["nodes"], moves["triangles"], make_rule(points))
        if len(mesh.triangles[0]) != 6:
            raise NotEvaluated("a mechanism without midside nodes")
        velocity = np.array(moves["velocity"], float)
        self.check_continuity(mesh)
        w, g = mesh.lattice, mesh.gradients
        slopes = np.concatenate([np.stack([(4 * w[:, i] - 1)[None, :, None] * g[:, None, i] for i in range(3)], axis=2),
                                 np.stack([4 * (w[:, (i + 1) % 3][None, :, None] * g[:, None, i] + w[:, i][None, :, None] * g[:, None, (i + 1) % 3])
                                           for i in range(3)], axis=2)], axis=2)  # triangle, point, shape function, axis
        shapes = np.c_[w * (2 * w - 1), 4 * w[:, 0] * w[:, 1], 4 * w[:, 1] * w[:, 2], 4 * w[:, 2] * w[:, 0]]
        of = velocity[mesh.triangles]
        rate = np.einsum("end,eknf->ekdf", of, slopes)
        opening, difference = rate[..., 0, 0] + rate[..., 1, 1], rate[..., 0, 0] - rate[..., 1, 1]
        distortion = rate[..., 0, 1] + rate[..., 1, 0]
        shear = np.hypot(difference, distortion)
        v = np.einsum("kn,end->ekd", shapes, of)
        part = np.broadcast_to((mesh.area / len(w))[:, None], shear.shape)
        weights, pressure = mesh.evaluate(section.find_soil_weights, section), mesh.evaluate(section.find_pressures, section)
        if weights is None or pressure is None:
            if file_water is None:
                raise NotEvaluated("seepage without the pressures of a stress field")
            from_file = file_water.find(mesh.inside)
            total_stress = np.array([section.find_pressures(s, np.zeros((1, 2))) is not None for s in range(len(section.laws))])
            pressure = np.where(total_stress[mesh.soils][:, None], 0, from_file[0]) if pressure is None else pressure
            weights = from_file[1] if weights is None else weights
        work = (part * (weights * (way * section.horizontal * v[..., 0] - section.vertical * v[..., 1]) + pressure * opening)).sum()
        whole, lack = np.zeros_like(shear), np.zeros_like(shear)
        for soil in np.unique(mesh.soils):
            some = mesh.soils == soil
            x, law = mesh.inside[some].reshape(-1, 2), section.laws[soil]
            args = [a[some].reshape(-1) for a in (opening, difference, distortion, shear)]
            found = law.divide(x, args[:3], printed) if hasattr(law, "body") else law.dissipate(x, args[0], args[3], printed)
            whole[some], lack[some] = [f.reshape(-1, len(w)) for f in found]
        border, self.moved = self.check_border(section, mesh, velocity)
        work += border
        dissipation = (part * whole).sum()
        if bars:
            dissipation += bars.find_dissipation(mesh, velocity, printed)
        self.ratio = work / dissipation if dissipation > 0 else math.inf if work > 0 else 0.0
        self.lack = (part * lack).sum() / (part * shear).sum()

    @staticmethod
    def check_continuity(mesh):
        """An edge has one midside node, half way, for both of its triangles."""
        for owners in mesh.edges.values():
            middles = {int(mesh.triangles[e, 3 + i]) for e, i in owners}
            e, i = owners[0]
            half = (mesh.nodes[mesh.triangles[e, i]] + mesh.nodes[mesh.triangles[e, (i + 1) % 3]]) / 2
            if len(middles) > 1 or np.abs(mesh.nodes[middles.pop()] - half).max() > 1e-5:
                raise NotEvaluated("a mechanism that is not continuous")

    @staticmethod
    def check_border(section, mesh, velocity):
        """Power of the loads, and the largest motion of a fixed side."""
        work, moved = 0.0, 0.0
        for e, i, p, q, normal in mesh.list_border(section):
            nodes = mesh.triangles[e, [i, (i + 1) % 3, 3 + i]]
            held = section.find_support(p, q)
            for v in velocity[nodes]:
                moved = max(moved, {"full": np.abs(v).max(), "normal": abs(v @ normal)}.get(held, 0.0))
            if held == "full":
                continue
            x = np.array([p + s * (q - p) for s, _ in GAUSS])
            traction = section.find_traction(x, normal, (p + q) / 2)
            if held == "normal":
                traction = traction - (traction @ normal)[:, None] * normal
            for (s, part), t in zip(GAUSS, traction):
                v = np.array([(1 - s) * (1 - 2 * s), s * (2 * s - 1), 4 * s * (1 - s)]) @ velocity[nodes]
                work += part * np.linalg.norm(q - p) * (t @ v)
        return work, moved
