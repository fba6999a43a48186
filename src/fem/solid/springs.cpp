// SPDX-License-Identifier: MIT
// Bars are cut by the elements of the soil, so that the displacement of the soil is quadratic along each piece, as that
// of the bar is: three nodes per piece, the strains of the bar at two points (which keeps thin beams from locking in
// shear), and the bond at three.
#include "fem/solid/springs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/error.hpp"
#include "fem/solid/line_shape.hpp"
#include "fem/solid/shape.hpp"
#include "fem/solid/system.hpp"

namespace talus::fem {
namespace {

constexpr double shortest_piece = 1e-3;  ///< of a line, over its mean piece: shorter ones join their neighbour
constexpr double outside = 1e-9;         ///< barycentric coordinate at which a point still lies in an element
constexpr int fewest_pieces = 8;         ///< of the length of a bar outside the soil

/// Points and weights of Gauss's rules on [0, 1].
constexpr std::array<std::array<double, 2>, 3> three_points{
    {{0.11270166537925831148, 5.0 / 18}, {0.5, 8.0 / 18}, {0.88729833462074168852, 5.0 / 18}}};

Vec<2> interpolate(const Vec<2>& a, const Vec<2>& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}

class Builder {
 public:
  Builder(const QuadraticMesh<2>& mesh, const std::vector<NodeUnknowns<2>>& nodes, int first)
      : mesh_(mesh), nodes_(nodes), first_(first), gradients_(mesh.elements.size()) {
    for (std::size_t k = 0; k < mesh_.elements.size(); ++k) {
      std::array<Vec<2>, 3> x;
      for (std::size_t i = 0; i < 3; ++i) x[i] = get_corner(k, i);
      find_simplex<2>(x, gradients_[k]);
    }
  }

  SpringSet build(const std::vector<Bar>& bars) {
    for (const Bar& bar : bars) add_bar(bar);
    set_.unknowns = next_;
    return std::move(set_);
  }

 private:
  using Rates = std::map<int, double>;  ///< unknown → derivative

  const Vec<2>& get_corner(std::size_t k, std::size_t i) const {
    return mesh_.nodes[static_cast<std::size_t>(mesh_.elements[k][i])];
  }

  std::array<double, 3> compute_barycentric(std::size_t k, const Vec<2>& x) const {
    std::array<double, 3> l;
    const Vec<2>& origin = get_corner(k, 0);
    for (std::size_t i = 0; i < 3; ++i)
      l[i] = (i == 0 ? 1 : 0) + gradients_[k][i][0] * (x[0] - origin[0]) + gradients_[k][i][1] * (x[1] - origin[1]);
    return l;
  }

  /// Returns the distances from `a`, over the length, at which the line crosses the sides of elements; sorted, with 0
  /// and 1.
  std::vector<double> cut_line(const Vec<2>& a, const Vec<2>& b) const {
    std::vector<double> cuts{0, 1};
    for (std::size_t k = 0; k < mesh_.elements.size(); ++k) {
      double from = 0, to = 1;
      const auto p = compute_barycentric(k, a), q = compute_barycentric(k, b);
      for (std::size_t i = 0; i < 3 && from < to; ++i) {
        const double change = q[i] - p[i];
        if (std::abs(change) < 1e-12) {
          if (p[i] < -outside) to = from;
        } else if (change > 0) {
          from = std::max(from, -p[i] / change);
        } else {
          to = std::min(to, -p[i] / change);
        }
      }
      if (from < to) cuts.push_back(from), cuts.push_back(to);
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end(), [](double s, double t) { return t - s < 1e-9; }), cuts.end());
    const double least = shortest_piece / static_cast<double>(std::max<std::size_t>(cuts.size() - 1, 1));
    std::vector<double> kept{0};
    for (const double s : cuts)
      if (s - kept.back() > least) kept.push_back(s);
    if (kept.size() > 1) kept.back() = 1;
    return kept;
  }

  /// Returns the element that contains a point; nullopt: no soil is there.
  std::optional<std::size_t> find_element(const Vec<2>& x) const {
    std::optional<std::size_t> best;
    double depth = -outside;
    for (std::size_t k = 0; k < mesh_.elements.size(); ++k) {
      const auto l = compute_barycentric(k, x);
      const double least = std::min({l[0], l[1], l[2]});
      if (least > depth) depth = least, best = k;
    }
    return best;
  }

  /// Adds `share` times the displacement of the soil at a point of an element along a direction.
  void add_soil(std::size_t k, const Vec<2>& x, const Vec<2>& direction, double share, Rates& rates) const {
    const auto l = compute_barycentric(k, x);
    for (std::size_t a = 0; a < Quadratic<2>::nodes; ++a) {
      double n;
      if (a < 3) {
        n = l[a] * (2 * l[a] - 1);
      } else {
        const auto [i, j] = Quadratic<2>::edges[a - 3];
        n = 4 * l[i] * l[j];
      }
      const auto& node = nodes_[static_cast<std::size_t>(mesh_.elements[k][a])];
      for (std::size_t d = 0; d < 2; ++d)
        if (node.unknown[d] >= 0) rates[node.unknown[d]] += share * n * dot(node.axes[d], direction);
    }
  }

  void add_spring(const Bar& bar, Spring spring, const Rates& rates) {
    spring.bar = bar_;
    spring.slackens = spring.slackens || (spring.kind == SpringKind::axial && bar.compressive == 0);
    for (const auto& [unknown, rate] : rates) {
      spring.unknown.push_back(unknown);
      spring.rate.push_back(rate);
    }
    set_.list.push_back(std::move(spring));
  }

  void check(const Bar& bar) const {
    if (!(length_ > 0)) fail_input("support '{}' has no length", bar.name);
    if (!(bar.axial_stiffness > 0)) fail_input("support '{}' has no axial stiffness", bar.name);
    if (is_beam_ && !(bar.shear_stiffness > 0)) fail_input("support '{}' is a beam without shear stiffness", bar.name);
    if (is_beam_ && bar.free_length > 0) fail_input("support '{}' is a beam and cannot have a free length", bar.name);
    if (bar.prestress > 0 && !(bar.free_length > 0))
      fail_input("support '{}' has a prestress but no free length", bar.name);
  }

  void add_bar(const Bar& bar) {
    length_ = std::hypot(bar.end[0] - bar.head[0], bar.end[1] - bar.head[1]);
    is_beam_ = bar.bending_stiffness > 0;
    check(bar);
    along_ = {(bar.end[0] - bar.head[0]) / length_, (bar.end[1] - bar.head[1]) / length_};
    across_ = {-along_[1], along_[0]};
    const std::size_t before = set_.list.size();
    places_.clear();
    start_ = next_;
    const double free = std::min(bar.free_length, length_);
    if (free > 0) add_free_length(bar, free);
    if (free < length_ * (1 - 1e-9)) {
      std::vector<double> places = divide(bar, free);
      for (std::size_t i = 0; i + 1 < places.size(); ++i) add_piece(bar, places[i], places[i + 1]);
    }
    add_ends(bar);
    set_.heads.push_back(get_unknown(0, 0));
    const bool touches = std::any_of(set_.list.begin() + static_cast<std::ptrdiff_t>(before), set_.list.end(),
                                     [](const Spring& s) { return s.kind >= SpringKind::bond && s.stiffness > 0; });
    if (!touches) fail_input("support '{}' is not joined to the soil: it has neither bond nor plate there", bar.name);
    add_loads(bar);
    ++bar_;
  }

  /// Returns the ends of the pieces from a distance to the end of the bar [m].
  std::vector<double> divide(const Bar& bar, double from) const {
    const Vec<2> a = interpolate(bar.head, bar.end, from / length_);
    std::vector<double> places;
    const std::vector<double> cuts = cut_line(a, bar.end);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double s = from + cuts[i] * (length_ - from), t = from + cuts[i + 1] * (length_ - from);
      const bool in_soil = find_element(interpolate(bar.head, bar.end, 0.5 * (s + t) / length_)).has_value();
      const int parts = in_soil ? 1 : fewest_pieces;
      for (int p = 0; p < parts; ++p) places.push_back(s + (t - s) * p / parts);
    }
    places.push_back(length_);
    return places;
  }

  /// Unknown of a node of the bar: its displacement along (0) or across (1) the axis, or its rotation times the length
  /// of the bar (2), which has the unit of the others.
  int get_unknown(std::size_t node, int which) const {
    return first_ + start_ + static_cast<int>(node) * (is_beam_ ? 3 : 1) + which;
  }
  std::size_t add_node(double place) {
    places_.push_back(place);
    next_ += is_beam_ ? 3 : 1;
    return places_.size() - 1;
  }

  void add_free_length(const Bar& bar, double free) {
    const std::size_t a = add_node(0), b = add_node(free);
    Spring spring{.kind = SpringKind::axial,
                  .place = 0.5 * free,
                  .weight = free,
                  .stiffness = bar.axial_stiffness,
                  .lower = -bar.compressive,
                  .upper = bar.tensile,
                  .is_jacked = bar.prestress > 0,
                  .prestress = bar.prestress};
    add_spring(bar, std::move(spring), {{get_unknown(a, 0), -1 / free}, {get_unknown(b, 0), 1 / free}});
  }

  void add_piece(const Bar& bar, double from, double to) {
    const std::size_t first = places_.empty() ? add_node(from) : places_.size() - 1;
    add_node(0.5 * (from + to));
    add_node(to);
    const double h = to - from;
    for (const auto& [t, weight] : two_points) add_strains(bar, first, from + t * h, t, weight * h, h);
    for (const auto& [t, weight] : three_points) add_contact(bar, first, from + t * h, t, weight * h);
  }

  /// Adds the springs of the bar itself at a point of a piece of length `h`.
  void add_strains(const Bar& bar, std::size_t first, double place, double t, double weight, double h) {
    const auto shape = compute_shape(t), slope = compute_slope(t);
    const auto collect = [&](int which, double scale) {
      Rates rates;
      for (std::size_t i = 0; i < 3; ++i) rates[get_unknown(first + i, which)] = scale * slope[i] / h;
      return rates;
    };
    add_spring(bar,
               {.kind = SpringKind::axial,
                .place = place,
                .weight = weight,
                .stiffness = bar.axial_stiffness,
                .lower = -bar.compressive,
                .upper = bar.tensile},
               collect(0, 1));
    if (!is_beam_) return;
    add_spring(bar,
               {.kind = SpringKind::bending,
                .place = place,
                .weight = weight,
                .stiffness = bar.bending_stiffness,
                .lower = -bar.moment,
                .upper = bar.moment},
               collect(2, 1 / length_));
    Rates rates = collect(1, 1);
    for (std::size_t i = 0; i < 3; ++i) rates[get_unknown(first + i, 2)] -= shape[i] / length_;
    add_spring(bar,
               {.kind = SpringKind::shear,
                .place = place,
                .weight = weight,
                .stiffness = bar.shear_stiffness,
                .lower = -bar.shear,
                .upper = bar.shear},
               rates);
  }

  /// Adds bond and lateral spring at a point of a piece, if there is soil.
  void add_contact(const Bar& bar, std::size_t first, double place, double t, double weight) {
    const Vec<2> x = interpolate(bar.head, bar.end, place / length_);
    const auto element = find_element(x);
    if (!element) return;
    const auto shape = compute_shape(t);
    // The deformation is the motion of the soil relative to the bar, so that a positive force pulls the bar along.
    const auto add = [&](SpringKind kind, int which, const Vec<2>& direction, double stiffness, const auto& strength) {
      if (!(stiffness > 0)) return;
      const double limit = strength ? strength(x) : unlimited;
      Rates rates;
      for (std::size_t i = 0; i < 3; ++i) rates[get_unknown(first + i, which)] = -shape[i];
      add_soil(*element, x, direction, 1, rates);
      add_spring(bar,
                 {.kind = kind,
                  .place = place,
                  .weight = weight,
                  .stiffness = stiffness,
                  .lower = -limit,
                  .upper = limit,
                  .is_reduced = bar.reduces_bond},
                 rates);
    };
    add(SpringKind::bond, 0, along_, bar.bond_stiffness, bar.bond);
    if (is_beam_) add(SpringKind::lateral, 1, across_, bar.lateral_stiffness, bar.lateral);
  }

  /// Adds plate and anchorage.
  void add_ends(const Bar& bar) {
    if (bar.plate > 0 && bar.wall < 0) {
      Rates rates{{get_unknown(0, 0), 1}};
      if (add_patch(bar.plate_line.empty() ? std::vector<Vec<2>>{bar.head} : bar.plate_line, rates))
        add_spring(bar,
                   {.kind = SpringKind::plate,
                    .place = 0,
                    .stiffness = bar.plate_stiffness,
                    .lower = 0,
                    .upper = bar.plate,
                    .slackens = true},
                   rates);
    }
    if (bar.anchorage > 0) {
      Rates rates{{get_unknown(places_.size() - 1, 0), -1}};
      if (const auto element = find_element(bar.end)) {
        add_soil(*element, bar.end, along_, 1, rates);
        add_spring(bar,
                   {.kind = SpringKind::anchorage,
                    .place = length_,
                    .stiffness = bar.anchorage_stiffness,
                    .lower = -bar.anchorage,
                    .upper = bar.anchorage},
                   rates);
      }
    }
  }

  /// Subtracts the mean displacement of the soil on a polyline, along the bar. Returns false if no soil is there.
  bool add_patch(const std::vector<Vec<2>>& line, Rates& rates) const {
    struct Place {
      std::size_t element;
      Vec<2> x;
      double weight;
    };
    std::vector<Place> places;
    double whole = 0;
    const auto take = [&](const Vec<2>& x, double weight) {
      const auto element = find_element(x);
      if (!element || !(weight > 0)) return;
      places.push_back({*element, x, weight});
      whole += weight;
    };
    if (line.size() == 1) take(line[0], 1);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const double length = std::hypot(line[i + 1][0] - line[i][0], line[i + 1][1] - line[i][1]);
      const std::vector<double> cuts = cut_line(line[i], line[i + 1]);
      for (std::size_t c = 0; c + 1 < cuts.size(); ++c)
        for (const auto& [t, weight] : three_points) {
          const double h = cuts[c + 1] - cuts[c];
          take(interpolate(line[i], line[i + 1], cuts[c] + t * h), weight * h * length);
        }
    }
    for (const Place& place : places) add_soil(place.element, place.x, along_, -place.weight / whole, rates);
    return !places.empty();
  }

  void add_loads(const Bar& bar) {
    const auto add = [&](std::size_t node, const Vec<2>& force) {
      set_.loads.push_back({get_unknown(node, 0), dot(force, along_)});
      if (is_beam_) set_.loads.push_back({get_unknown(node, 1), dot(force, across_)});
    };
    if (norm(bar.head_load) > 0) add(0, bar.head_load);
    if (!(norm(bar.line_load) > 0)) return;
    const auto add_length = [&](std::size_t node, double length) {
      add(node, {bar.line_load[0] * length, bar.line_load[1] * length});
    };
    std::size_t first = 0;
    if (bar.free_length > 0) {
      for (std::size_t node : {0, 1}) add_length(node, places_[1] / 2);
      first = 1;
    }
    for (; first + 2 < places_.size(); first += 2) {
      const double h = places_[first + 2] - places_[first];
      for (std::size_t i = 0; i < 3; ++i) add_length(first + i, h * (i == 1 ? 4.0 : 1.0) / 6);
    }
  }

  const QuadraticMesh<2>& mesh_;
  const std::vector<NodeUnknowns<2>>& nodes_;
  int first_;
  std::vector<std::array<Vec<2>, 3>> gradients_;  ///< of the barycentric coordinates, per element
  SpringSet set_;
  int bar_ = 0, next_ = 0;  ///< numbers of the bar and of the next unknown
  // of the bar
  int start_ = 0;
  bool is_beam_ = false;
  double length_ = 0;
  Vec<2> along_{}, across_{};
  std::vector<double> places_;  ///< distances of its nodes from the head [m]
};

}  // namespace

SpringSet make_springs(const std::vector<Bar>& bars, const QuadraticMesh<2>& mesh,
                       const std::vector<NodeUnknowns<2>>& nodes, int first) {
  return Builder(mesh, nodes, first).build(bars);
}

}  // namespace talus::fem
