// SPDX-License-Identifier: MIT
#pragma once
// Supports in limit analysis: bars in tension, whose largest force along their length is that of LEM.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bounds/problem.hpp"
#include "bounds/program_of.hpp"
#include "lem/section/bars.hpp"
#include "mesh/mesh.hpp"
#include "mesh/plan.hpp"
#include "site/site.hpp"

namespace talus::run {

class BarsOfCase {
 public:
  explicit BarsOfCase(const site::Site& site);

  /// Returns the plan with a line along each bar, a point on it wherever its force changes its gradient, and corners on
  /// the ground at the ends of the metre on which its head presses.
  mesh::Plan conform(mesh::Plan plan) const;
  /// Adds bars and heads on a mesh of that plan to a problem with its walls; `number`: of its nodes in the problem.
  /// Throws Error (wrong_input) for a bar along a wall.
  void add(const mesh::Mesh<2>& mesh, const std::vector<int>& number, bounds::Problem& problem) const;
  /// Returns true if the largest force of a bar is not linear between its nodes, as where bond grows with the
  /// overburden.
  bool are_bent(const bounds::Problem& problem) const;
  /// Sets the forces at the nodes of all bars and at their heads so that between the nodes they are nowhere above the
  /// largest force for the lower bound, and nowhere below it for the upper one; at nine points of each edge.
  void enclose(bounds::Problem& problem, bounds::Bound bound) const;

 private:
  struct Line {
    lem::Bar bar;
    lem::BarDiagram diagram;
    std::string name;
    double length = 0;
    Vec<2> direction{};
    std::optional<std::size_t> wall{};  ///< on which the head lies

    Vec<2> at(double s) const { return {bar.head[0] + s * direction[0], bar.head[1] + s * direction[1]}; }
    /// Tensile strength, resistance in front and behind [N/m].
    std::array<double, 3> list_limits(double s) const;
    double find_force(double s) const;
  };
  std::vector<double> list_kinks(const Line& line) const;
  /// Returns the largest force at the points of an edge between its nodes [N/m].
  std::vector<double> sample(const bounds::Problem& problem, const bounds::BarEdge& edge) const;
  double measure(const bounds::Problem& problem, std::size_t bar, int node) const;
  std::vector<site::Point> list_head_ends() const;
  bounds::BarHead make_head(const Line& line, int node, const bounds::Problem& problem) const;

  site::Polyline ground_;  ///< empty without bars
  std::vector<Line> lines_;
};

}  // namespace talus::run
