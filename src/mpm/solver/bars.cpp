// SPDX-License-Identifier: MIT
// The equilibrium of a bar is the minimum of a convex potential of the slips of its nodes (T25.4), found by Newton's
// method with a line search.
#include "mpm/solver/bars.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "mesh/mesh.hpp"
#include "mpm/kernels/element_search.hpp"

namespace talus::mpm {
namespace {

/// Residual over the largest force of the bar at which it is in equilibrium, the most iterations, and the most halvings
/// of a step in the line search.
constexpr double tolerance = 1e-11;
constexpr int most_iterations = 60, most_halvings = 60;
/// Stiffness added to each node, over that of its pieces: parts that yield altogether do not drift.
constexpr double regularisation = 1e-8;

Vec<2> normalise(const Vec<2>& v) {
  const double length = norm(v);
  return length > 0 ? Vec<2>{v[0] / length, v[1] / length} : Vec<2>{};
}

class BarStep {
 public:
  /// `motion`: of the soil at the nodes in the step; `plate_motion`: of the soil under the plate [m].
  BarStep(Bar& bar, std::vector<Vec<2>> motion, std::optional<Vec<2>> plate_motion, bool is_jacked)
      : bar_(bar), motion_(std::move(motion)), plate_motion_(plate_motion), is_jacked_(is_jacked) {
    const std::size_t n = bar.nodes.size();
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const Vec<2>&a = bar.nodes[i].soil.x, &b = bar.nodes[i + 1].soil.x;
      direction_.push_back(normalise({b[0] - a[0], b[1] - a[1]}));
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Vec<2>&before = direction_[i == 0 ? 0 : i - 1], &after = direction_[std::min(i, n - 2)];
      tangent_.push_back(normalise({before[0] + after[0], before[1] + after[1]}));
    }
    reach_ = sum_deformation();
  }

  /// Finds the slips of the nodes, and returns them.
  std::vector<double> solve() {
    std::vector<double> slips(bar_.nodes.size(), 0.0), change(slips.size());
    evaluate(slips);
    for (int k = 0; k < most_iterations && !is_balanced(); ++k) {
      find_change(change);
      search(change, slips);
    }
    keep(slips);
    return slips;
  }

  const std::vector<Vec<2>>& tangents() const { return tangent_; }

 private:
  /// Sum of the deformations of all parts in the step and before, and at their yield; no slip is larger [m].
  double sum_deformation() const {
    const auto find_yield = [](const SpringLaw& law) { return law.stiffness > 0 ? law.upper / law.stiffness : 0.0; };
    const std::vector<double> none(bar_.nodes.size(), 0.0);
    double sum = std::abs(bar_.plate.elastic) + find_yield(bar_.plate.law);
    if (plate_motion_) sum += norm(Vec<2>{motion_[0][0] - (*plate_motion_)[0], motion_[0][1] - (*plate_motion_)[1]});
    double bond = 0;
    for (const BarNode& node : bar_.nodes) bond = std::max(bond, find_yield(node.bond));
    for (std::size_t j = 0; j < bar_.pieces.size(); ++j)
      sum += bar_.pieces[j].length * (std::abs(bar_.pieces[j].strain) + std::abs(find_strain(j, none)));
    return sum + bond + bar_.pieces[0].length * bar_.prestress / bar_.tension.stiffness;
  }

  /// Strain of a piece in the step.
  double find_strain(std::size_t j, const std::vector<double>& slips) const {
    const auto move = [&](std::size_t i) {
      return dot(direction_[j], motion_[i]) + slips[i] * dot(direction_[j], tangent_[i]);
    };
    return (move(j + 1) - move(j)) / bar_.pieces[j].length;
  }
  SpringAnswer stretch(std::size_t j, const std::vector<double>& slips) const {
    const BarPiece& piece = bar_.pieces[j];
    if (piece.is_torn) return {};
    if (j == 0 && is_jacked_) return {bar_.prestress / bar_.tension.stiffness, bar_.prestress, 0};
    return deform_spring(bar_.tension, piece.strain, find_strain(j, slips));
  }
  /// The bond of a node; none where it has left the soil.
  SpringAnswer slide(std::size_t i, double slip) const {
    const BarNode& node = bar_.nodes[i];
    if (!node.soil.is_joined || !(node.bond.stiffness > 0)) return {};
    SpringLaw law = node.bond;
    law.lower /= bar_.divisor, law.upper /= bar_.divisor;
    return deform_spring(law, node.slip, slip);
  }
  SpringAnswer press(double slip) const {
    if (!plate_motion_) return {};
    const Vec<2> motion{motion_[0][0] - (*plate_motion_)[0], motion_[0][1] - (*plate_motion_)[1]};
    return deform_spring(bar_.plate.law, bar_.plate.elastic, dot(motion, tangent_[0]) + slip);
  }

  /// Residual, and its derivative: a symmetric tridiagonal matrix.
  void evaluate(const std::vector<double>& slips) {
    const std::size_t n = bar_.nodes.size();
    residual_.assign(n, 0), diagonal_.assign(n, 0), beside_.assign(n, 0);
    largest_ = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const SpringAnswer bond = slide(i, slips[i]);
      residual_[i] += bond.force, diagonal_[i] += bond.tangent;
      largest_ = std::max(largest_, std::abs(bond.force));
    }
    const SpringAnswer plate = press(slips[0]);
    residual_[0] += plate.force, diagonal_[0] += plate.tangent;
    for (std::size_t j = 0; j + 1 < n; ++j) {
      const SpringAnswer piece = stretch(j, slips);
      const double from = dot(direction_[j], tangent_[j]), to = dot(direction_[j], tangent_[j + 1]),
                   rate = piece.tangent / bar_.pieces[j].length;
      residual_[j] -= piece.force * from, residual_[j + 1] += piece.force * to;
      diagonal_[j] += rate * from * from, diagonal_[j + 1] += rate * to * to;
      beside_[j] -= rate * from * to;
      const double least = regularisation * bar_.tension.stiffness / bar_.pieces[j].length;
      diagonal_[j] += least, diagonal_[j + 1] += least;
      largest_ = std::max(largest_, std::abs(piece.force));
    }
  }

  bool is_balanced() const {
    const double scale = std::max(largest_, 1e-6 * std::max(bar_.tension.upper, 1.0));
    return std::all_of(residual_.begin(), residual_.end(), [&](double r) { return std::abs(r) <= tolerance * scale; });
  }

  /// Moves along `change` to where the potential, with the resistance to the change, is close to its minimum. Its slope
  /// there grows steadily, as it is convex. A step that ends early ends on this side of the minimum: beyond it nothing
  /// may pull any more.
  void search(const std::vector<double>& change, std::vector<double>& slips) {
    const std::vector<double> start = slips;
    const double resistance = compute_resistance();
    const auto move = [&](double step) {
      for (std::size_t i = 0; i < slips.size(); ++i) slips[i] = start[i] + step * change[i];
      evaluate(slips);
      double slope = 0;
      for (std::size_t i = 0; i < change.size(); ++i)
        slope += (residual_[i] + step * resistance * change[i]) * change[i];
      return slope;
    };
    double first = 0;
    for (std::size_t i = 0; i < change.size(); ++i) first += residual_[i] * change[i];
    const double enough = 0.1 * std::abs(first);
    double low = 0, high = 1;
    if (move(high) <= enough) return;
    for (int k = 0; k < most_halvings; ++k) {
      const double step = 0.5 * (low + high), slope = move(step);
      if (slope <= 0 && slope >= -enough) return;
      (slope < 0 ? low : high) = step;
    }
  }

  /// Stiffness against the change of the slips in an iteration. It vanishes with the residual, and keeps the change
  /// within reach where no part of the bar has stiffness.
  double compute_resistance() const {
    double largest = 0;
    for (const double r : residual_) largest = std::max(largest, std::abs(r));
    return largest / reach_;
  }

  /// Newton's change of the slips: elimination in a tridiagonal matrix that is positive definite.
  void find_change(std::vector<double>& change) const {
    const std::size_t n = change.size();
    std::vector<double> pivot = diagonal_;
    const double resistance = compute_resistance();
    for (std::size_t i = 0; i < n; ++i) pivot[i] += resistance, change[i] = -residual_[i];
    for (std::size_t i = 1; i < n; ++i) {
      const double ratio = beside_[i - 1] / pivot[i - 1];
      pivot[i] -= ratio * beside_[i - 1];
      change[i] -= ratio * change[i - 1];
    }
    change[n - 1] /= pivot[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) change[i] = (change[i] - beside_[i] * change[i + 1]) / pivot[i];
  }

  /// Stores the state and the forces on the soil.
  void keep(const std::vector<double>& slips) {
    const std::size_t n = bar_.nodes.size();
    for (std::size_t i = 0; i < n; ++i) {
      BarNode& node = bar_.nodes[i];
      node.force = {};
      node.slip = slide(i, slips[i]).elastic;
      node.all_slip += slips[i];
    }
    const SpringAnswer plate = press(slips[0]);
    bar_.plate.elastic = plate.elastic, bar_.plate.force = plate.force;
    for (std::size_t d = 0; d < 2; ++d) {
      bar_.plate.push[d] = plate.force * tangent_[0][d];
      bar_.nodes[0].force[d] -= bar_.plate.push[d];
    }
    for (std::size_t j = 0; j + 1 < n; ++j) {
      BarPiece& piece = bar_.pieces[j];
      const SpringAnswer answer = stretch(j, slips);
      const double before = piece.strain;
      piece.tension = answer.force;
      for (std::size_t d = 0; d < 2; ++d) {
        bar_.nodes[j].force[d] += answer.force * direction_[j][d];
        bar_.nodes[j + 1].force[d] -= answer.force * direction_[j][d];
      }
      if (piece.is_torn) continue;
      piece.strain = answer.elastic;
      if (j == 0 && is_jacked_) continue;
      piece.plastic += std::max(0.0, before + find_strain(j, slips) - piece.strain);
      piece.is_torn = piece.plastic > bar_.rupture_strain;
    }
  }

  Bar& bar_;
  const std::vector<Vec<2>> motion_;
  const std::optional<Vec<2>> plate_motion_;
  const bool is_jacked_;
  std::vector<Vec<2>> direction_, tangent_;  ///< of the pieces, and of the nodes
  std::vector<double> residual_, diagonal_, beside_;
  double largest_ = 0;
  double reach_ = 0;  ///< [m]
};

/// Displacement of the nodes of a bar with the soil in a step; empty if no node is in soil.
std::vector<Vec<2>> find_motion(const Body<2>& body, const Bar& bar, double dt) {
  std::vector<Vec<2>> motion;
  for (const JoinedNodes& joined : find_joined(bar)) {
    Vec<2> u{};
    for (std::size_t k = 0; k < 2; ++k) {
      if (joined.weight[k] == 0) continue;
      const Vec<2> v = move_place(body, bar.nodes[static_cast<std::size_t>(joined.node[k])].soil);
      for (std::size_t d = 0; d < 2; ++d) u[d] += joined.weight[k] * dt * v[d];
    }
    motion.push_back(u);
  }
  return motion;
}

/// Mean displacement of the soil under the plate; nullopt if there is none.
std::optional<Vec<2>> find_plate_motion(const Body<2>& body, const BarPlate& plate, double dt) {
  Vec<2> sum{};
  int count = 0;
  for (const SoilPlace& place : plate.places) {
    if (!place.is_joined) continue;
    const Vec<2> v = move_place(body, place);
    for (std::size_t d = 0; d < 2; ++d) sum[d] += dt * v[d];
    ++count;
  }
  if (count == 0) return std::nullopt;
  return Vec<2>{sum[0] / count, sum[1] / count};
}

/// Moves a place, and finds its element. A place outside the grid keeps the last one, by which it may return.
void move(const mesh::Mesh<2>& mesh, SoilPlace& place, const Vec<2>& u) {
  for (std::size_t d = 0; d < 2; ++d) place.x[d] += u[d];
  if (place.element < 0) return;
  place.xi = mesh::find_local(mesh, place.element, place.x);
  find_new_element<2>(mesh, place.element, place.xi.data());
}

/// Takes the force off a bar that has left the soil.
void release(Bar& bar) {
  for (BarNode& node : bar.nodes) node.force = {}, node.slip = 0;
  for (BarPiece& piece : bar.pieces) piece.strain = piece.tension = 0;
  bar.plate.push = {}, bar.plate.elastic = bar.plate.force = 0;
}

}  // namespace

void settle_bar(Bar& bar) {
  // At rest in the soil: every node counts as joined.
  for (BarNode& node : bar.nodes) node.soil.is_joined = true;
  std::optional<Vec<2>> plate;
  if (!bar.plate.places.empty()) plate = Vec<2>{};
  BarStep(bar, std::vector<Vec<2>>(bar.nodes.size()), plate, bar.prestress > 0).solve();
}

void advance_bars(Body<2>& body, const StepOptions<2>& o) {
  for (Bar& bar : body.bars) {
    const std::vector<Vec<2>> motion = find_motion(body, bar, o.dt);
    if (motion.empty()) {
      release(bar);
      continue;
    }
    const std::optional<Vec<2>> plate = find_plate_motion(body, bar.plate, o.dt);
    double work = plate ? dot(bar.plate.push, *plate) : 0;
    for (std::size_t i = 0; i < motion.size(); ++i) work += dot(bar.nodes[i].force, motion[i]);
    body.work.supports -= work;
    body.work.external -= work;

    BarStep step(bar, motion, plate, o.jacks && bar.prestress > 0);
    const std::vector<double> slips = step.solve();
    if (!o.moving) continue;
    const auto find_shift = [&](std::size_t i) {
      const Vec<2>& t = step.tangents()[i];
      return Vec<2>{motion[i][0] + slips[i] * t[0], motion[i][1] + slips[i] * t[1]};
    };
    for (std::size_t i = 0; i < motion.size(); ++i) move(body.mesh(), bar.nodes[i].soil, find_shift(i));
    // A part of the plate without soil follows the head.
    for (SoilPlace& place : bar.plate.places) {
      const Vec<2> v = place.is_joined ? move_place(body, place) : Vec<2>{};
      move(body.mesh(), place, place.is_joined ? Vec<2>{o.dt * v[0], o.dt * v[1]} : find_shift(0));
    }
  }
}

}  // namespace talus::mpm
