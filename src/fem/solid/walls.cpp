// SPDX-License-Identifier: MIT
// Walls as springs and joints. A piece of a wall is an edge of the mesh, with three nodes; the displacement of the beam
// is quadratic along it, as that of the soil is, and the strains of the beam are integrated at two points. Joints stand
// at the nodes, with Simpson's weights: stiff interfaces that are integrated at Gauss's points have oscillating
// stresses.
#include "fem/solid/walls.hpp"

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

constexpr std::array<double, 3> simpson{1.0 / 6, 4.0 / 6, 1.0 / 6};

/// Soil on one side of a piece: an element and its local nodes at both ends and in the middle.
struct Face {
  std::size_t element = 0;
  std::array<std::size_t, 3> local{};  ///< from head to toe: end, middle, end
};

struct Piece {
  Vec<2> from{}, to{}, along{};
  double place = 0, length = 0;                ///< distance of its upper end from the head, length [m]
  std::array<std::optional<Face>, 2> faces{};  ///< left and right
};

class WallBuilder {
 public:
  WallBuilder(const SolidModel<2>& model, const QuadraticMesh<2>& mesh, const std::vector<NodeUnknowns<2>>& nodes,
              int first, SpringSet& set)
      : model_(model), mesh_(mesh), nodes_(nodes), first_(first), set_(set) {
    for (std::size_t k = 0; k < mesh_.elements.size(); ++k)
      for (std::size_t i = 0; i < Quadratic<2>::edges.size(); ++i) {
        const auto [a, b] = Quadratic<2>::edges[i];
        sides_[std::minmax(find_corner(k, a), find_corner(k, b))].push_back({k, i});
      }
  }

  void build() {
    for (std::size_t w = 0; w < model_.walls.size(); ++w) {
      number_ = static_cast<int>(model_.bars.size() + w);
      add_wall(model_.walls[w]);
    }
  }

 private:
  using Rates = std::map<int, double>;

  int find_corner(std::size_t k, std::size_t i) const { return mesh_.find_original(mesh_.elements[k][i]); }
  const Vec<2>& get_place(int node) const { return mesh_.nodes[static_cast<std::size_t>(node)]; }

  /// Unknown of a node of the wall: displacement along x (0) and y (1), or its rotation times the length (2).
  int get_unknown(std::size_t node, std::size_t which) const { return start_ + static_cast<int>(3 * node + which); }

  void add_wall(const Wall& wall) {
    if (!(wall.axial_stiffness > 0) || !(wall.bending_stiffness > 0) || !(wall.shear_stiffness > 0))
      fail_input("wall '{}' has no stiffness", wall.name);
    if (!(wall.normal_stiffness > 0) || !(wall.tangential_stiffness > 0))
      fail_input("wall '{}' has no interface", wall.name);
    if (wall.nodes.size() < 2) fail_input("wall '{}' has no length", wall.name);
    pieces_.clear();
    length_ = 0;
    for (std::size_t i = 0; i + 1 < wall.nodes.size(); ++i) {
      pieces_.push_back(make_piece(wall.nodes[i], wall.nodes[i + 1]));
      length_ += pieces_.back().length;
    }
    start_ = first_ + set_.unknowns;
    set_.unknowns += static_cast<int>(3 * (2 * pieces_.size() + 1));
    bool touches = false;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      for (const auto& [t, weight] : two_points) add_strains(wall, p, t, weight);
      for (const std::size_t side : {0, 1})
        if (pieces_[p].faces[side]) touches = true, add_joints(wall, p, side);
      add_line_load(wall, p);
    }
    if (!touches) fail_input("wall '{}' does not touch the soil", wall.name);
    for (const Strut& strut : wall.struts) add_strut(wall, strut);
    add_surface_loads(wall);
    const int own = number_ - static_cast<int>(model_.bars.size());
    for (std::size_t b = 0; b < model_.bars.size(); ++b)
      if (model_.bars[b].wall == own && model_.bars[b].plate > 0) add_head(b);
  }

  Piece make_piece(int a, int b) const {
    Piece piece;
    piece.from = get_place(a), piece.to = get_place(b);
    piece.place = length_;
    piece.length = std::hypot(piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]);
    for (std::size_t d = 0; d < 2; ++d) piece.along[d] = (piece.to[d] - piece.from[d]) / piece.length;
    const auto found = sides_.find(std::minmax(a, b));
    if (found == sides_.end()) return piece;  // in the air
    for (const auto& [k, edge] : found->second) {
      const auto [i, j] = Quadratic<2>::edges[edge];
      const bool is_forward = find_corner(k, i) == a;
      const Vec<2>& apex = get_place(mesh_.elements[k][3 - i - j]);
      const double across = piece.along[0] * (apex[1] - piece.from[1]) - piece.along[1] * (apex[0] - piece.from[0]);
      piece.faces[across > 0 ? 0 : 1] = Face{k, {is_forward ? i : j, Quadratic<2>::corners + edge, is_forward ? j : i}};
    }
    return piece;
  }

  void add_spring(Spring spring, const Rates& rates) {
    spring.bar = number_;
    for (const auto& [unknown, rate] : rates) {
      spring.unknown.push_back(unknown);
      spring.rate.push_back(rate);
    }
    set_.list.push_back(std::move(spring));
  }

  /// Adds the plate of a bar whose head lies on the wall, between the bar and the nearest place of the wall.
  void add_head(std::size_t b) {
    const Bar& bar = model_.bars[b];
    std::size_t best = 0;
    double nearest = unlimited, place = 0;
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const Piece& piece = pieces_[p];
      const double along = dot({bar.head[0] - piece.from[0], bar.head[1] - piece.from[1]}, piece.along),
                   t = std::clamp(along / piece.length, 0.0, 1.0), s = t * piece.length;
      const double distance = std::hypot(piece.from[0] + s * piece.along[0] - bar.head[0],
                                         piece.from[1] + s * piece.along[1] - bar.head[1]);
      if (distance < nearest) nearest = distance, best = p, place = t;
    }
    const double length = std::hypot(bar.end[0] - bar.head[0], bar.end[1] - bar.head[1]);
    const auto shape = compute_shape(place);
    Rates rates{{set_.heads[b], 1}};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t d = 0; d < 2; ++d)
        rates[get_unknown(2 * best + i, d)] -= shape[i] * (bar.end[d] - bar.head[d]) / length;
    Spring spring{
        .kind = SpringKind::plate, .stiffness = bar.plate_stiffness, .lower = 0, .upper = bar.plate, .slackens = true};
    add_spring(std::move(spring), rates);
    set_.list.back().bar = static_cast<int>(b);
  }

  void add_strains(const Wall& wall, std::size_t p, double t, double weight) {
    const Piece& piece = pieces_[p];
    const auto shape = compute_shape(t), slope = compute_slope(t);
    const Vec<2> across{-piece.along[1], piece.along[0]};
    const double h = piece.length;
    const auto add = [&](SpringKind kind, double stiffness, double strength, const Rates& rates) {
      add_spring({.kind = kind,
                  .place = piece.place + t * h,
                  .weight = weight * h,
                  .stiffness = stiffness,
                  .lower = -strength,
                  .upper = strength},
                 rates);
    };
    Rates axial, shear, bending;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t d = 0; d < 2; ++d) {
        axial[get_unknown(2 * p + i, d)] = piece.along[d] * slope[i] / h;
        shear[get_unknown(2 * p + i, d)] = across[d] * slope[i] / h;
      }
      shear[get_unknown(2 * p + i, 2)] = -shape[i] / length_;
      bending[get_unknown(2 * p + i, 2)] = slope[i] / h / length_;
    }
    if (std::isfinite(wall.axial) && std::isfinite(wall.moment)) {
      add_section(wall, piece.place + t * h, weight * h, axial, bending);
    } else {
      add(SpringKind::axial, wall.axial_stiffness, wall.axial, axial);
      add(SpringKind::bending, wall.bending_stiffness, wall.moment, bending);
    }
    add(SpringKind::shear, wall.shear_stiffness, wall.shear, shear);
  }

  /// Adds axial strain and curvature at a point, whose strengths interact.
  void add_section(const Wall& wall, double place, double weight, const Rates& axial, const Rates& bending) {
    Joint section{.wall = number_,
                  .is_section = true,
                  .axial = wall.axial,
                  .moment = wall.moment,
                  .place = place,
                  .weight = weight,
                  .normal_stiffness = wall.axial_stiffness,
                  .tangential_stiffness = wall.bending_stiffness};
    for (const auto& [unknown, rate] : axial) {
      section.unknown.push_back(unknown);
      section.opening.push_back(rate);
      section.slip.push_back(0);
    }
    for (const auto& [unknown, rate] : bending) {
      section.unknown.push_back(unknown);
      section.opening.push_back(0);
      section.slip.push_back(rate);
    }
    set_.joints.push_back(std::move(section));
  }

  /// Adds the joints of a piece to the soil on one of its sides. Opening and slip are motions of the soil relative to
  /// the wall, away from it and towards its toe.
  void add_joints(const Wall& wall, std::size_t p, std::size_t side) {
    const Piece& piece = pieces_[p];
    const Face& face = *piece.faces[side];
    const double sign = side == 0 ? 1 : -1;
    const Vec<2> normal{-sign * piece.along[1], sign * piece.along[0]};
    const int region = model_.mesh->element_region[static_cast<std::size_t>(mesh_.linear_element[face.element])];
    for (std::size_t i = 0; i < 3; ++i) {
      const int at = mesh_.elements[face.element][face.local[i]];
      Joint joint{.wall = number_,
                  .side = static_cast<int>(side),
                  .place = piece.place + 0.5 * static_cast<double>(i) * piece.length,
                  .weight = simpson[i] * piece.length,
                  .normal_stiffness = wall.normal_stiffness,
                  .tangential_stiffness = wall.tangential_stiffness,
                  .node = at,
                  .element = static_cast<int>(face.element),
                  .normal = normal,
                  .is_rough = !wall.interface,
                  .compression = find_compression(face.element, normal)};
      if (wall.interface) {
        const InterfaceStrength strength = wall.interface(region, get_place(at));
        joint.adhesion = strength.adhesion, joint.friction = strength.friction;
      }
      const auto add = [&](int unknown, double opening, double slip) {
        joint.unknown.push_back(unknown);
        joint.opening.push_back(opening);
        joint.slip.push_back(slip);
      };
      const auto& node = nodes_[static_cast<std::size_t>(at)];
      for (std::size_t d = 0; d < 2; ++d) {
        if (node.unknown[d] >= 0) add(node.unknown[d], dot(node.axes[d], normal), dot(node.axes[d], piece.along));
        add(get_unknown(2 * p + i, d), -normal[d], -piece.along[d]);
      }
      // Pore water presses on wall and soil, beside the effective stress of the joint.
      const double pore = find_pore(face, i) * joint.weight;
      for (std::size_t u = 0; u < joint.unknown.size() && pore != 0; ++u)
        set_.loads.push_back({joint.unknown[u], -pore * joint.opening[u]});
      set_.joints.push_back(std::move(joint));
    }
  }

  /// Returns the initial compression of an element across a direction [Pa].
  double find_compression(std::size_t element, const Vec<2>& normal) const {
    if (model_.initial_stress.empty()) return 0;
    const auto& s = model_.initial_stress[static_cast<std::size_t>(mesh_.linear_element[element])];
    return std::max(0.0,
                    -(s[0] * normal[0] * normal[0] + s[1] * normal[1] * normal[1] + 2 * s[3] * normal[0] * normal[1]));
  }

  /// Returns the pore stress at a node of a face, positive in tension [Pa].
  double find_pore(const Face& face, std::size_t i) const {
    if (model_.pore_stress.empty()) return 0;
    const auto& p = model_.pore_stress[static_cast<std::size_t>(mesh_.linear_element[face.element])];
    return i == 1 ? 0.5 * (p[face.local[0]] + p[face.local[2]]) : p[face.local[i]];
  }

  void add_line_load(const Wall& wall, std::size_t p) {
    if (!(norm(wall.line_load) > 0)) return;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t d = 0; d < 2; ++d)
        set_.loads.push_back({get_unknown(2 * p + i, d), simpson[i] * pieces_[p].length * wall.line_load[d]});
  }

  void add_strut(const Wall& wall, const Strut& strut) {
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      const Piece& piece = pieces_[p];
      const double rise = piece.to[1] - piece.from[1];
      const double t = rise != 0 ? (strut.level - piece.from[1]) / rise : -1;
      if (!(t >= 0 && t <= 1)) continue;
      if (piece.faces[0] && piece.faces[1]) continue;
      // The strut stands on the free side; where both are free, it faces the soil below as at the right of the way.
      const bool is_left = !piece.faces[0];
      const double way = (is_left ? -piece.along[1] : piece.along[1]) > 0 ? 1 : -1;
      const auto shape = compute_shape(t);
      Rates rates;
      for (std::size_t i = 0; i < 3; ++i) rates[get_unknown(2 * p + i, 0)] = way * shape[i];
      add_spring({.kind = SpringKind::strut,
                  .place = piece.place + t * piece.length,
                  .weight = 1,
                  .stiffness = strut.stiffness,
                  .lower = 0,
                  .upper = strut.strength,
                  .slackens = true,
                  .is_jacked = strut.prestress > 0,
                  .prestress = strut.prestress},
                 rates);
      return;
    }
    fail_input("the strut of wall '{}' at y = {} finds no free side of the wall there", wall.name,
               format_coordinate(strut.level, model_.units.length));
  }

  /// Adds the surface loads on sides that the wall covers.
  void add_surface_loads(const Wall& wall) {
    std::map<std::pair<int, int>, std::size_t> own;
    for (std::size_t p = 0; p + 1 < wall.nodes.size(); ++p) own[std::minmax(wall.nodes[p], wall.nodes[p + 1])] = p;
    for (const SurfaceLoad<2>& load : model_.loads)
      for (std::size_t s = 0; s < load.sides.size(); ++s) {
        const auto found = own.find(std::minmax(load.sides[s][0], load.sides[s][1]));
        if (found == own.end()) continue;
        const std::size_t p = found->second;
        const bool is_forward = load.sides[s][0] == wall.nodes[p];
        const Vec<2>&first = load.traction[s][is_forward ? 0 : 1], &last = load.traction[s][is_forward ? 1 : 0];
        for (std::size_t d = 0; d < 2; ++d) {
          const std::array<double, 3> parts{first[d] / 6, (first[d] + last[d]) / 3, last[d] / 6};
          for (std::size_t i = 0; i < 3; ++i)
            set_.loads.push_back({get_unknown(2 * p + i, d), pieces_[p].length * parts[i]});
        }
      }
  }

  const SolidModel<2>& model_;
  const QuadraticMesh<2>& mesh_;
  const std::vector<NodeUnknowns<2>>& nodes_;
  int first_;
  SpringSet& set_;
  std::map<std::pair<int, int>, std::vector<std::array<std::size_t, 2>>> sides_;  ///< corners → elements and edges
  // of the wall
  int number_ = 0, start_ = 0;
  double length_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace

void add_walls(const SolidModel<2>& model, const QuadraticMesh<2>& mesh, const std::vector<NodeUnknowns<2>>& nodes,
               int first, SpringSet& set) {
  WallBuilder(model, mesh, nodes, first, set).build();
}

}  // namespace talus::fem
