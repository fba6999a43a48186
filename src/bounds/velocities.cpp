// SPDX-License-Identifier: MIT
// Nodes and degrees of freedom of the velocities, opening fields, and least-squares corrections.
#include "bounds/velocities.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>

#include "bounds/conic/solve.hpp"
#include "bounds/problem.hpp"
#include "bounds/wall_motion.hpp"

namespace talus::bounds {

namespace {

/// Returns the rigid body of each node of the six-node triangles; −1 if it belongs to none.
std::vector<int> find_bodies(const Problem& problem, const Velocities& v, const Units& units) {
  std::vector<int> body(v.nodes.size(), -1), parent(v.nodes.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto find_root = [&](int n) {
    while (parent[static_cast<std::size_t>(n)] != n) n = parent[static_cast<std::size_t>(n)];
    return n;
  };
  for (std::size_t e = 0; e < problem.size(); ++e) {
    if (!is_rigid(problem.strength[e], units)) continue;
    const int root = find_root(v.triangles[e][0]);
    for (const int n : v.triangles[e]) {
      parent[static_cast<std::size_t>(find_root(n))] = root;
      body[static_cast<std::size_t>(n)] = 0;
    }
  }
  for (std::size_t n = 0; n < body.size(); ++n)
    if (body[n] == 0) body[n] = find_root(static_cast<int>(n));
  return body;
}

/// Places the nodes of the six-node triangles. Those around a node that a wall separates have copies of it.
std::vector<std::array<int, 6>> place_nodes(const Problem& problem, Velocities& v) {
  const WallKeys walls(problem);
  std::vector<std::array<int, 6>> triangles(problem.size());
  for (std::size_t e = 0; e < problem.size(); ++e) std::copy_n(problem.triangles[e].begin(), 3, triangles[e].begin());
  const std::vector<Edge> edges = list_edges(problem.triangles);
  separate_at_walls(problem, edges, triangles, v.nodes);
  for (const Edge& edge : edges) {
    const Vec<2>&a = problem.nodes[static_cast<std::size_t>(edge.from)],
          &b = problem.nodes[static_cast<std::size_t>(edge.to)];
    const bool is_cut = edge.other >= 0 && walls.contains(edge.from, edge.to);
    int middle = -1;
    for (const int e : {edge.triangle, edge.other}) {
      if (e < 0) continue;
      if (middle < 0 || is_cut) {
        middle = static_cast<int>(v.nodes.size());
        v.nodes.push_back({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])});
      }
      const Triangle& t = problem.triangles[static_cast<std::size_t>(e)];
      auto& own = triangles[static_cast<std::size_t>(e)];
      const std::size_t i = find_corner(t, edge.from), j = find_corner(t, edge.to);
      own[3 + ((i + 1) % 3 == j ? i : j)] = middle;
      const auto [low, high] = std::minmax(edge.from, edge.to);
      v.edges[{low, high}] = {own[find_corner(t, low)], middle, own[find_corner(t, high)]};
    }
  }
  return triangles;
}

/// Motions that the supports leave to a rigid body. `held`: directions in which some of its nodes are fixed.
struct BodyMotion {
  std::vector<Vec<2>> held;
  Vec<2> centre{};
  int first = -1;  ///< number of the first degree of freedom
};

bool are_parallel(const Vec<2>& a, const Vec<2>& b) {
  return std::abs(a[0] * b[1] - a[1] * b[0]) < 1e-9;
}

/// Returns the degrees of freedom of a node at `x` that moves with its body.
std::vector<Freedom> move_with(const BodyMotion& body, const Vec<2>& x, double length) {
  if (body.held.size() > 1) return {};
  if (body.held.size() == 1) return {{{-body.held[0][1], body.held[0][0]}, body.first}};
  return {{{1, 0}, body.first},
          {{0, 1}, body.first + 1},
          {{-(x[1] - body.centre[1]) / length, (x[0] - body.centre[0]) / length}, body.first + 2}};
}

}  // namespace

Velocities number_velocities(const Problem& problem, const Units& units) {
  Velocities v;
  v.nodes = problem.nodes;
  v.triangles = place_nodes(problem, v);
  // Fixed directions of each node, at most two different ones.
  std::vector<std::vector<Vec<2>>> held(v.nodes.size());
  auto hold = [&](int node, const Vec<2>& direction) {
    auto& own = held[static_cast<std::size_t>(node)];
    const bool known = std::any_of(own.begin(), own.end(), [&](const Vec<2>& h) { return are_parallel(h, direction); });
    if (!known) own.push_back(direction);
  };
  for (const Side& side : problem.sides) {
    const Vec<2>&from = problem.nodes[static_cast<std::size_t>(side.from)],
          &to = problem.nodes[static_cast<std::size_t>(side.to)];
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    const Vec<2> along{(to[0] - from[0]) / length, (to[1] - from[1]) / length}, normal{along[1], -along[0]};
    for (const int node : v.find_nodes(side.from, side.to)) {
      if (side.holds_normal) hold(node, normal);
      if (side.holds_along) hold(node, along);
    }
  }
  const std::vector<int> bodies = find_bodies(problem, v, units);
  std::map<int, BodyMotion> motions;
  for (std::size_t n = 0; n < v.nodes.size(); ++n) {
    if (bodies[n] < 0) continue;
    BodyMotion& motion = motions[bodies[n]];
    motion.centre = v.nodes[static_cast<std::size_t>(bodies[n])];
    for (const Vec<2>& h : held[n])
      if (motion.held.empty() || !are_parallel(motion.held.front(), h)) motion.held.push_back(h);
  }
  v.freedoms.resize(v.nodes.size());
  std::vector<bool> has_soil(v.nodes.size(), false);  // nodes of a wall may lie in the air
  for (const auto& t : v.triangles)
    for (const int n : t) has_soil[static_cast<std::size_t>(n)] = true;
  for (std::size_t n = 0; n < v.nodes.size(); ++n) {
    if (!has_soil[n]) continue;
    if (bodies[n] >= 0) {
      BodyMotion& motion = motions.at(bodies[n]);
      if (motion.first < 0) {
        motion.first = v.count;
        v.count += motion.held.empty() ? 3 : motion.held.size() == 1 ? 1 : 0;
      }
      v.freedoms[n] = move_with(motion, v.nodes[n], units.length);
    } else if (held[n].empty()) {
      v.freedoms[n] = {{{1, 0}, v.count}, {{0, 1}, v.count + 1}};
      v.count += 2;
    } else if (held[n].size() == 1) {
      v.freedoms[n] = {{{-held[n][0][1], held[n][0][0]}, v.count++}};
    }
  }
  number_walls(problem, units, v);
  return v;
}

// Corners between fixed edges.

namespace {

/// Makes a triangle rigid, with its number of cones.
void make_rigid(std::array<Strength, 3>& corners, double strength) {
  for (Strength& soil : corners) {
    soil.cohesion = strength;
    if (soil.tension) soil.tension = strength;
    if (!soil.planes) continue;
    WeakPlanes planes = *soil.planes;
    planes.cohesion = strength;
    soil.planes = std::make_shared<const WeakPlanes>(planes);
  }
}

/// Angle of the soil that can move between fixed edges around a node, with its largest tan φ.
struct FixedCorner {
  double angle = 0, tan_friction = 0;
  int fixed_edges = 0;
};

/// Returns the corners of the moving soil: `rests` marks the triangles at rest, whose edges are fixed.
std::vector<FixedCorner> list_fixed_corners(const Problem& problem, const std::vector<bool>& rests) {
  std::set<EdgeKey> fixed;
  for (const Side& side : problem.sides)
    if (side.holds_normal && side.holds_along) fixed.insert(make_key(side.from, side.to));
  std::vector<FixedCorner> corners(problem.nodes.size());
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t i = 0; rests[e] && i < 3; ++i)
      fixed.insert(make_key(problem.triangles[e][i], problem.triangles[e][(i + 1) % 3]));
  for (std::size_t e = 0; e < problem.size(); ++e) {
    if (rests[e]) continue;
    const Shape shape = find_shape(problem, e);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec<2>&a = shape.gradient[(i + 1) % 3], &b = shape.gradient[(i + 2) % 3];
      FixedCorner& corner = corners[static_cast<std::size_t>(problem.triangles[e][i])];
      // The gradients are normals of the edges, turned inwards.
      corner.angle += std::numbers::pi - std::acos(std::clamp(dot(a, b) / (norm(a) * norm(b)), -1.0, 1.0));
      corner.tan_friction = std::max(corner.tan_friction, problem.strength[e][i].find_least_friction());
      for (const std::size_t k : {i, (i + 2) % 3})
        if (fixed.contains(make_key(problem.triangles[e][k], problem.triangles[e][(k + 1) % 3]))) ++corner.fixed_edges;
    }
  }
  return corners;
}

}  // namespace

std::optional<Problem> hold_narrow_corners(const Problem& problem, double factor, const Units& units) {
  constexpr double room = 0.01;   ///< [rad], for a margin of the flow rule
  constexpr int most_rounds = 4;  ///< each round makes the angles of the moving soil wider
  std::vector<bool> rests(problem.size(), false);
  std::optional<Problem> held;
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<FixedCorner> corners = list_fixed_corners(problem, rests);
    bool grows = false;
    for (std::size_t e = 0; e < problem.size(); ++e) {
      if (rests[e]) continue;
      const bool is_narrow = std::any_of(problem.triangles[e].begin(), problem.triangles[e].end(), [&](int node) {
        const FixedCorner& corner = corners[static_cast<std::size_t>(node)];
        return corner.fixed_edges == 2 && corner.angle < 2 * std::atan(corner.tan_friction / factor) + room;
      });
      if (!is_narrow) continue;
      if (!held) held = problem;
      make_rigid(held->strength[e], 2 * rigid_strength * units.stress);
      rests[e] = grows = true;
    }
    if (!grows) break;
  }
  return held;
}

// Opening fields: the lifting field, and the program of the largest margin.

namespace {

/// Calls `use` for each degree of freedom with its coefficients in ε_x, ε_y and γ at corner c of triangle e.
void visit_strains(const Problem& problem, const Velocities& mesh, std::size_t e, std::size_t c, auto use) {
  const auto gradients = find_quadratic_gradients(find_shape(problem, e), c);
  for (std::size_t k = 0; k < 6; ++k)
    for (const auto& f : mesh.freedoms[static_cast<std::size_t>(mesh.triangles[e][k])]) {
      const Vec<2>&g = gradients[k], &d = f.direction;
      use(f.number, std::array<double, 3>{g[0] * d[0], g[1] * d[1], g[1] * d[0] + g[0] * d[1]});
    }
}

/// Returns the program of the largest t with ε_v − t ≥ sin φ √(…) at the corners that may open, and as much at the
/// contacts with walls, where the sum of the means of both is one.
ConicProgram make_program(const Problem& problem, const Velocities& mesh, double factor, double length) {
  const std::vector<bool> opens = find_opening_corners(problem, mesh);
  ConicProgram program;
  const int margin = mesh.count;
  program.variables = mesh.count + 1;
  program.cost.assign(static_cast<std::size_t>(program.variables), 0);
  program.cost.back() = -1;
  program.rows = list_openings(problem, mesh, length);
  program.right.assign(static_cast<std::size_t>(program.rows.count()), 0);
  std::vector<std::pair<int, double>> mean, entries;
  double area = 0;
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t c = 0; c < 3; ++c)
      if (opens[3 * e + c]) area += find_shape(problem, e).area / 3;
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t c = 0; c < 3; ++c) {
      if (!opens[3 * e + c]) continue;
      const double share = find_shape(problem, e).area / 3 / area * length;
      visit_strains(problem, mesh, e, c, [&](int n, const auto& row) {
        mean.push_back({n, share * (row[0] + row[1])});
      });
    }
  const std::vector<OpeningLimit> limits = list_opening_limits(problem, mesh);
  for (const OpeningLimit& limit : limits)
    for (const auto& [number, value] : limit.opening)
      mean.push_back({number, value / static_cast<double>(limits.size())});
  program.add_row(mean, 1);
  program.equations = program.rows.count();
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t c = 0; c < 3; ++c) {
      if (!opens[3 * e + c]) continue;
      const double sine = find_sine(problem.strength[e][c], factor);
      visit_strains(problem, mesh, e, c, [&](int n, const auto& row) {
        entries.push_back({n, -length * (row[0] + row[1])});
      });
      entries.push_back({margin, 1});
      program.add_row(entries, 0);
      program.cones.push_back(sine > 0 ? 3 : 1);
      if (!(sine > 0)) continue;
      visit_strains(problem, mesh, e, c, [&](int n, const auto& row) {
        entries.push_back({n, sine * length * (row[0] - row[1])});
      });
      program.add_row(entries, 0);
      visit_strains(problem, mesh, e, c, [&](int n, const auto& row) {
        entries.push_back({n, sine * length * row[2]});
      });
      program.add_row(entries, 0);
    }
  for (const OpeningLimit& limit : limits) {
    for (const auto& [number, value] : limit.opening) entries.push_back({number, -value});
    entries.push_back({margin, 1});
    program.add_row(entries, 0);
    for (const auto& [number, value] : limit.slip) entries.push_back({number, limit.tan_friction / factor * value});
    program.add_row(entries, 0);
    program.cones.push_back(2);
  }
  return program;
}

/// Returns true if the flow rule is satisfied with a margin. Corners that may not open must have constant volume, to
/// `rounding_of_volume` of the largest strain.
bool opens_everywhere(const Problem& problem, const Velocities& mesh, double factor, double length,
                      const std::vector<double>& numbers) {
  constexpr double least = 1e-6;  ///< margin over the mean
  constexpr double rounding_of_volume = 1e-11;
  const std::vector<bool> opens = find_opening_corners(problem, mesh);
  const std::vector<Strain> strains = find_strains(problem, mesh, numbers);
  double largest = 0;
  for (const Strain& s : strains) largest = std::max({largest, std::abs(s.opening), s.find_shear()});
  for (std::size_t i = 0; i < strains.size(); ++i) {
    const Strength& soil = problem.strength[i / 3][i % 3];
    const double margin = length * (strains[i].opening - find_sine(soil, factor) * strains[i].find_shear());
    if (opens[i] ? margin < least : std::abs(strains[i].opening) > rounding_of_volume * largest) return false;
  }
  for (const OpeningLimit& limit : list_opening_limits(problem, mesh))
    if (evaluate(limit.opening, numbers) - limit.tan_friction / factor * std::abs(evaluate(limit.slip, numbers)) <
        least)
      return false;
  return true;
}

/// Returns the lifting field, in which each node moves up by its height above the lowest one.
std::vector<double> lift(const Problem& problem, const Velocities& mesh, double length) {
  double lowest = problem.nodes.front()[1];
  for (const Vec<2>& x : problem.nodes) lowest = std::min(lowest, x[1]);
  std::vector<double> numbers(static_cast<std::size_t>(mesh.count), 0);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    for (const auto& f : mesh.freedoms[n])
      numbers[static_cast<std::size_t>(f.number)] = f.direction[1] * (mesh.nodes[n][1] - lowest) / length;
  return numbers;
}

/// Returns the field of the largest margin; nothing if the solver finds none.
std::optional<std::vector<double>> open_most(const Problem& problem, const Velocities& mesh, double factor,
                                             double length) {
  const ConicProgram program = make_program(problem, mesh, factor, length);
  const ConicSolution found = solve(program, {});
  if (found.end != ConicEnd::solved) return std::nullopt;
  std::vector<double> numbers(found.x.begin(), found.x.begin() + mesh.count);
  const SparseRows closed = list_openings(problem, mesh, length);
  fulfil(closed, closed.count(), std::vector<double>(static_cast<std::size_t>(closed.count()), 0), numbers);
  return numbers;
}

}  // namespace

std::vector<Strain> find_strains(const Problem& problem, const Velocities& mesh, const std::vector<double>& numbers) {
  std::vector<Strain> strains;
  strains.reserve(3 * problem.size());
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<double, 3> sum{};
      visit_strains(problem, mesh, e, c, [&](int n, const auto& row) {
        for (std::size_t d = 0; d < 3; ++d) sum[d] += row[d] * numbers[static_cast<std::size_t>(n)];
      });
      strains.push_back({sum[0] + sum[1], sum[0] - sum[1], sum[2]});
    }
  return strains;
}

std::vector<bool> find_opening_corners(const Problem& problem, const Velocities& mesh) {
  const Units units = find_units(problem);
  std::vector<bool> opens(3 * problem.size(), false);
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t c = 0; c < 3; ++c) {
      if (!may_open(problem, e, c, units)) continue;
      visit_strains(problem, mesh, e, c, [&](int, const std::array<double, 3>& row) {
        if (row[0] != 0 || row[1] != 0 || row[2] != 0) opens[3 * e + c] = true;
      });
    }
  return opens;
}

SparseRows list_openings(const Problem& problem, const Velocities& mesh, double length) {
  const Units units = find_units(problem);
  SparseRows rows;
  std::vector<std::pair<int, double>> entries;
  for (std::size_t e = 0; e < problem.size(); ++e)
    for (std::size_t c = 0; c < 3; ++c) {
      if (may_open(problem, e, c, units) || is_rigid(problem.strength[e], units)) continue;
      entries.clear();
      visit_strains(problem, mesh, e, c, [&](int n, const auto& row) {
        entries.push_back({n, length * (row[0] + row[1])});
      });
      std::sort(entries.begin(), entries.end());
      for (const auto& [number, value] : entries) rows.add(number, value);
      rows.end_row();
    }
  return rows;
}

const std::vector<double>* OpeningSearch::find(const Problem& problem, const Velocities& mesh, double factor,
                                               double length) {
  if (found_ && found_->size() == static_cast<std::size_t>(mesh.count) &&
      opens_everywhere(problem, mesh, factor, length, *found_))
    return &*found_;
  found_ = lift(problem, mesh, length);
  if (opens_everywhere(problem, mesh, factor, length, *found_)) return &*found_;
  found_ = open_most(problem, mesh, factor, length);
  if (found_ && !opens_everywhere(problem, mesh, factor, length, *found_)) found_.reset();
  return found_ ? &*found_ : nullptr;
}

// Least-squares correction, with refinement of its linear system.

namespace {

constexpr int most_rounds = 8;
/// Small diagonals in place of the zeros of the rows, tried in turn: with too small a one, redundant rows cannot be
/// factorised.
constexpr double shifts[] = {1e-10, 1e-8, 1e-6};

using Matrix = Eigen::SparseMatrix<double>;

Matrix make_matrix(const SparseRows& a, int rows, const std::vector<double>& weights, double shift) {
  const int n = static_cast<int>(weights.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, weights[static_cast<std::size_t>(i)]);
  for (int r = 0; r < rows; ++r) {
    entries.emplace_back(n + r, n + r, -shift);
    for (std::size_t k = a.begin(r); k < a.begin(r + 1); ++k) entries.emplace_back(n + r, a.column[k], a.value[k]);
  }
  Matrix matrix(n + rows, n + rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Returns right − A x.
Eigen::VectorXd find_left(const SparseRows& a, int rows, const std::vector<double>& right, const Eigen::VectorXd& x) {
  Eigen::VectorXd left(rows);
  for (int r = 0; r < rows; ++r) {
    double own = right[static_cast<std::size_t>(r)];
    for (std::size_t k = a.begin(r); k < a.begin(r + 1); ++k) own -= a.value[k] * x[a.column[k]];
    left[r] = own;
  }
  return left;
}

}  // namespace

void fulfil(const SparseRows& a, int rows, const std::vector<double>& right, std::vector<double>& x,
            const std::vector<double>& weights) {
  if (rows == 0) return;
  const int n = static_cast<int>(x.size());
  const Eigen::VectorXd start = Eigen::Map<const Eigen::VectorXd>(x.data(), n);
  double least = std::numeric_limits<double>::infinity();
  for (const double shift : shifts) {
    const Eigen::SimplicialLDLT<Matrix, Eigen::Lower> factors(
        make_matrix(a, rows, weights.empty() ? std::vector<double>(x.size(), 1) : weights, shift));
    if (factors.info() != Eigen::Success) continue;
    Eigen::VectorXd at = start;
    for (int round = 0; round <= most_rounds; ++round) {
      const Eigen::VectorXd left = find_left(a, rows, right, at);
      const double most = left.lpNorm<Eigen::Infinity>();
      if (!std::isfinite(most) || most >= least) break;
      least = most;
      std::copy_n(at.data(), n, x.begin());
      Eigen::VectorXd sides = Eigen::VectorXd::Zero(n + rows);
      sides.tail(rows) = left;
      at += factors.solve(sides).head(n);
    }
    constexpr double rounding_of_rows = 1e-12;
    if (least < rounding_of_rows) return;
  }
}

}  // namespace talus::bounds
