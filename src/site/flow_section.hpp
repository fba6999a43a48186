// SPDX-License-Identifier: MIT
#pragma once
// The discharge through a line in a plane flow, as a difference of its stream function (docs/theory/13-seepage.md,
// T13.7).

#include <array>
#include <map>
#include <vector>

#include "base/vec.hpp"
#include "fem/seepage/seepage.hpp"

namespace talus::site {

/// A part of a path in one element: its normal, to the right of the path, times its length [m].
struct FlowPart {
  int element = 0;
  Vec<2> normal{};
};

/// Computes the discharge through lines, Σ q·normal over the parts that find_parts() returns.
class FlowSections {
 public:
  /// `model` must outlive this object.
  explicit FlowSections(const fem::SeepageModel<2>& model);

  /// `line`: points [m]. Returns the path of the discharge to the right of the line; empty if it meets no soil with
  /// pore water.
  std::vector<FlowPart> find_parts(const std::vector<Vec<2>>& line) const;

 private:
  using Path = std::vector<FlowPart>;  ///< with displacements in place of normals
  struct Range {                       ///< of a segment, by places from 0 to 1
    double from = 0, to = 0;
  };
  struct Body {
    std::vector<int> elements;
    std::vector<Range> ranges;  ///< of the segment, in each of them
  };
  struct Walk;

  static std::vector<Range> join(std::vector<Range> ranges);
  std::map<int, Range> find_elements(const Vec<2>& a, const Vec<2>& b) const;
  std::vector<Body> find_bodies(const Vec<2>& a, const Vec<2>& b) const;
  void add_path(const Body& body, const Vec<2>& a, const Vec<2>& b, Path& path) const;
  int find_next(int element, int opposite) const;
  Path find_path(const std::vector<int>& elements, int start, int end) const;
  Walk walk_around(int node, int element, bool forwards) const;
  Path find_node_path(int node, int element) const;
  Path find_place_path(int element, const Vec<2>& x) const;
  double compute_passing(int element, int opposite) const;

  const fem::SeepageModel<2>& model_;
  std::vector<std::array<int, 2>> open_;  ///< sides that water passes, sorted
};

}  // namespace talus::site
