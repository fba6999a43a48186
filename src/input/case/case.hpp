// SPDX-License-Identifier: MIT
#pragma once
// The case as plain data, in SI units and radians, with its blocks in the order of the manual. Each block has a header,
// with its struct and the declaration of its keys, and a .cpp with the checks between its keys.

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "input/case/analysis.hpp"
#include "input/case/boundary.hpp"
#include "input/case/calibration.hpp"
#include "input/case/construction.hpp"
#include "input/case/elements_and_bounds.hpp"
#include "input/case/geometry.hpp"
#include "input/case/hydraulic.hpp"
#include "input/case/limit_equilibrium.hpp"
#include "input/case/material.hpp"
#include "input/case/output.hpp"
#include "input/case/partial_factors.hpp"
#include "input/case/point_test.hpp"
#include "input/case/roots.hpp"
#include "input/case/seepage.hpp"
#include "input/case/stage.hpp"
#include "input/case/start.hpp"
#include "input/case/study.hpp"
#include "input/case/timeline.hpp"
#include "input/case/water.hpp"

namespace talus::input {

// Blocks that the case holds in lists: who reads them includes their headers.
struct Compare;
struct Support;

/// Version of the meaning of the keys. It increases when a valid case becomes invalid or changes its meaning.
inline constexpr int newest_format = 1;

struct Case {
  // Out of line, so that the members of their many members are not compiled in every source.
  Case();
  Case(const Case&);
  Case(Case&&) noexcept;
  Case& operator=(const Case&);
  Case& operator=(Case&&) noexcept;
  ~Case();

  int format = 1;  ///< for files without the key
  std::string title;
  std::vector<std::string> unusual;  ///< keys whose warnings are suppressed
  Project project;
  mesh::Plan mesh;
  Layering layering;
  int points_per_element = 3;
  std::optional<double> softening_length{};  ///< nonlocal length [m]
  std::map<std::string, Material> materials;
  std::map<std::string, std::string> regions;  ///< region → material
  std::map<std::string, Support> supports;
  std::vector<Boundary> boundaries;
  std::vector<Traction> tractions;
  std::vector<Hydraulic> hydraulics;
  Water water;
  std::vector<Roots> roots;
  Gravity gravity;
  Initial initial;
  SeepageAnalysis seepage;
  std::optional<Timeline> timeline;
  std::vector<ConstructionStage> construction;
  Consolidation consolidation;
  std::vector<VerticalDrains> drains;
  std::vector<Stage> stages;
  RestCriterion rest;
  AnalysisKind analysis = AnalysisKind::run;
  std::vector<Method> methods{Method::mpm};
  LimitEquilibrium lem;
  FiniteElements fem;
  ProvenBounds bounds;
  std::vector<Surcharge> surcharges;
  std::vector<Slurry> slurries;
  Earthquake earthquake;
  PartialFactors partial_factors;
  StrengthReduction strength_reduction;
  Output output;
  std::vector<Compare> compare;
  std::vector<PointTest> tests;
  std::vector<Material> test_soils;  ///< for each test: its material with the settings of the test
  Study study;
  std::optional<Calibration> calibration;

  /// Returns the units of display, in which messages are written.
  const ShownUnits& units() const { return mesh.units; }
};

/// Returns true if [analysis] methods includes `method`.
inline bool uses(const Case& data, Method method) {
  return std::find(data.methods.begin(), data.methods.end(), method) != data.methods.end();
}

/// Declares all keys to a visitor. A visitor has `key` for one value, `table` for a block, `tables` for a list of
/// blocks (with the number shown in the template), `named` for blocks with user-defined names, and `entries` for single
/// values with such names (both with a sample name and that number). Within a block, keys precede blocks, and a key
/// precedes those whose condition refers to it.
void describe(Visitor& v, Case& c);

}  // namespace talus::input
