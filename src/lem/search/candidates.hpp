// SPDX-License-Identifier: MIT
#pragma once
// Slip surfaces whose geometry is cut once and evaluated for many samples of soils and earthquake (probabilistic
// analysis).

#include "lem/search/search.hpp"
#include "lem/slices/mass.hpp"

namespace talus::lem {

class Candidates {
 public:
  /// Searches the mean slope and each of `corners` (sections of the same geometry and water with other soils) by
  /// `method`, and keeps the local minima and the best trial circles. Throws Error when no search finds a surface.
  Candidates(const Slope& mean, const std::vector<Section>& corners, const SearchOptions& options, Method method,
             int threads);
  /// Takes given surfaces; leaves out those that cannot be cut.
  Candidates(const Slope& mean, const std::vector<Surface>& surfaces, const SearchOptions& options, Method method);

  int count() const { return static_cast<int>(kept_.size()); }
  const Surface& surface(int i) const { return kept_[static_cast<std::size_t>(i)].cut.surface; }

  /// Memory of one thread. Results do not depend on its contents.
  struct Workspace {
    CutSurface cut;
    Mass mass;
    std::vector<double> tan_friction;  ///< per soil
    std::vector<std::pair<double, int>> order;
    int smallest = -1;  ///< index of the surface with the smallest factor; -1: none
  };

  /// Returns the smallest factor over all surfaces for other soils (in the order of the section's) and accelerations
  /// over g; 0 when all surfaces are rejected. The soils may differ in weights, c, φ, gradient of c, r_u and φ_b, but
  /// not in the water level, and have no
  /// law.
  double find_factor(const std::vector<Soil>& soils, double horizontal, double vertical, Workspace& work) const;
  /// Returns F of one surface; 0 when it is rejected.
  double find_factor(int surface, const std::vector<Soil>& soils, double horizontal, double vertical, Method method,
                     Workspace& work) const;

 private:
  /// Areas of one soil above the base of a slice, above and below the water table, and their moments about y = 0.
  struct Part {
    int soil = 0;
    double dry = 0, wet = 0, dry_moment = 0, wet_moment = 0;
  };
  struct Kept {
    CutSurface cut;
    std::vector<Part> parts;
    std::vector<int> first;   ///< index in `parts` of the first part of each slice; one more at the end
    Mass mass;                ///< the geometry; weights and strengths are set for each sample
    double fixed_moment = 0;  ///< moment of loads and water [N m]
    double ratio = 1;         ///< factor of the method over the quick factor, with the mean soils
  };

  void keep(const std::vector<Surface>& surfaces);
  void keep_areas();
  void compare_methods();
  struct Strength {
    double cohesion = 0, pore_pressure = 0;  ///< [Pa]
  };
  Strength find_strength(const Soil& soil, double tan_friction, double weight, const Slice& slice) const;
  void fill(const Kept& kept, const std::vector<Soil>& soils, double vertical, Workspace& work) const;
  static void find_tangents(const std::vector<Soil>& soils, Workspace& work);
  static Part sum_weight(const Kept& kept, std::size_t slice, const std::vector<Soil>& soils);
  /// Returns the factor without any check: by the method itself if it is a simplified one, else by Bishop's simplified
  /// method (circles) or Janbu's (polylines).
  double find_quick(const Kept& kept, const std::vector<Soil>& soils, double horizontal, double vertical,
                    Workspace& work) const;

  const Slope* slope_;
  Method method_;
  Checks checks_;
  int slices_;
  std::vector<Kept> kept_;
};

}  // namespace talus::lem
