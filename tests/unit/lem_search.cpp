// SPDX-License-Identifier: MIT
// Parts of the search: arcs, minimiser, local minima, findings, candidates; threads and reflections.

#include "lem/search/search.hpp"

#include <algorithm>
#include <random>

#include "base/error.hpp"
#include "lem/search/arcs.hpp"
#include "lem/search/candidates.hpp"
#include "lem/search/optimise.hpp"
#include "lem/search/search_findings.hpp"
#include "support/lem_sections.hpp"

namespace talus::lem {
namespace {

const std::vector<Point> plain{{0, 10}, {30, 10}, {50, 20}, {90, 20}};

/// Two benches of the same height, the upper one a little steeper.
Section make_benches() {
  return make_section({{0, 0}, {20, 0}, {30, 8}, {60, 8}, {69.5, 16}, {100, 16}}, make_soil(5, 25, 19), -5);
}

SearchOptions make_quick() {
  SearchOptions options;
  options.entry_exit.emplace();
  options.entry_exit->entries = options.entry_exit->exits = 14;
  options.entry_exit->depths = 8;
  options.slices = 30;
  options.vertices = 8;
  return options;
}

void expect_same(const Surface& a, const Surface& b) {
  ASSERT_EQ(a.circle.has_value(), b.circle.has_value());
  EXPECT_EQ(a.from, b.from);
  EXPECT_EQ(a.to, b.to);
  EXPECT_EQ(a.line, b.line);
  if (a.circle) {
    EXPECT_EQ(a.circle->centre, b.circle->centre);
  }
}

TEST(LemArcs, StayUnderTheGroundAndTouchTheirLimits) {
  const Slope slope(make_section({{0, 10}, {30, 10}, {36, 16}, {40, 16}, {50, 24}, {90, 24}}, make_soil(5, 25, 19), 2));
  const Arcs arcs(slope, 0, false);
  std::mt19937_64 random(3);
  int bottoms = 0;
  for (int i = 0; i < 300; ++i) {
    double left = 90 * static_cast<double>(random() >> 11) * 0x1p-53,
           right = 90 * static_cast<double>(random() >> 11) * 0x1p-53;
    if (left > right) std::swap(left, right);
    const auto range = arcs.find_range(left, right);
    if (!range) continue;
    for (const double t : {0.0, 0.3, 1.0}) {
      const Surface s = arcs.make_arc(left, right, range->from + t * (range->to - range->from));
      EXPECT_NEAR(Arcs::measure_half_angle(s), range->from + t * (range->to - range->from), 1e-6);
      double deepest = 0;
      for (int k = 0; k <= 1000; ++k) {
        const double x = left + (right - left) * k / 1000, off = x - s.circle->centre[0];
        const double y =
            s.circle->centre[1] - std::sqrt(std::max(0.0, s.circle->radius * s.circle->radius - off * off));
        EXPECT_LE(y, slope.ground(x) + 1e-7);
        EXPECT_GE(y, 2 - 1e-7);
        deepest = std::max(deepest, slope.ground(x) - y);
      }
      EXPECT_NEAR(arcs.find_depth(left, right, range->from + t * (range->to - range->from)), deepest,
                  1e-3 * (right - left));
    }
    const Surface deepest = arcs.make_arc(left, right, range->to);
    if (range->to_base) {
      EXPECT_NEAR(deepest.circle->centre[1] - deepest.circle->radius, 2, 1e-6);
      ++bottoms;
    }
  }
  EXPECT_GT(bottoms, 20);
}

TEST(LemArcs, HaveTheSmallestDepthWhereItBinds) {
  const Slope slope(make_section(plain, make_soil(0, 35, 19), 0));
  const auto range = Arcs(slope, 1.5, false).find_range(32, 48);
  ASSERT_TRUE(range);
  EXPECT_NEAR(Arcs(slope, 1.5, false).find_depth(32, 48, range->from), 1.5, 1e-6);
}

TEST(LemArcs, TouchRegionsFromAbove) {
  const Slope slope(make_section(plain, make_soil(5, 25, 19), -20));
  const Arcs arcs(slope, 0, false);
  const Region inclined{0, {{-10, 2}, {100, 13}, {100, -50}, {-10, -50}}};
  const auto touch = arcs.find_touch(25, 60, inclined);
  ASSERT_TRUE(touch);
  const Circle c = *arcs.make_arc(25, 60, *touch).circle;
  const double distance = (c.centre[1] - (2 + 0.1 * (c.centre[0] + 10))) / std::hypot(1, 0.1);
  EXPECT_NEAR(distance, c.radius, 1e-6 * c.radius);  // tangent to its upper side
  const Region lens{0, {{40, 4}, {44, 7}, {48, 4}}};
  const auto corner = arcs.find_touch(25, 60, lens);
  ASSERT_TRUE(corner);
  const Circle d = *arcs.make_arc(25, 60, *corner).circle;
  EXPECT_NEAR(std::hypot(d.centre[0] - 44, d.centre[1] - 7), d.radius, 1e-6 * d.radius);
  EXPECT_FALSE(arcs.find_touch(25, 60, {0, {{70, 4}, {74, 7}, {78, 4}}}));
}

TEST(LemMinimise, FindsMinimaBetweenBoundsAndPassesExceptions) {
  for (const Minimiser kind : {Minimiser::simplex, Minimiser::subspaces, Minimiser::quadratic}) {
    auto valley = [](const std::vector<double>& x) { return std::pow(x[0] - 2, 2) + 3 * std::pow(x[1] + 1, 2); };
    const Minimum m = minimise(valley, {0.5, 0.5}, {0.2, 0.2}, {0, 0}, {1, 1}, {kind, 1e-12, 2000});
    EXPECT_NEAR(m.at[0], 1, 1e-4);
    EXPECT_NEAR(m.at[1], 0, 1e-4);
    auto broken = [](const std::vector<double>& x) -> double {
      if (x[0] != 0.5) throw std::runtime_error("no");
      return 0;
    };
    EXPECT_THROW(minimise(broken, {0.5}, {0.2}, {0}, {1}, {kind, 1e-6, 50}), std::runtime_error);
  }
}

TEST(LemSearch, IsTheSameForAnyNumberOfThreads) {
  const Slope slope(make_benches());
  SearchOptions options = make_quick();
  const SearchResult one = search(slope, options);
  for (const int threads : {2, 3}) {
    options.threads = threads;
    const SearchResult more = search(slope, options);
    ASSERT_EQ(one.trials.size(), more.trials.size());
    for (std::size_t i = 0; i < one.trials.size(); ++i) ASSERT_EQ(one.trials[i].factors, more.trials[i].factors);
    ASSERT_EQ(one.circular.size(), more.circular.size());
    ASSERT_EQ(one.noncircular.size(), more.noncircular.size());
    for (std::size_t m = 0; m < one.circular.size(); ++m) {
      EXPECT_EQ(one.circular[m].solution.factor, more.circular[m].solution.factor);
      expect_same(one.circular[m].surface, more.circular[m].surface);
    }
    for (std::size_t m = 0; m < one.noncircular.size(); ++m)
      expect_same(one.noncircular[m].surface, more.noncircular[m].surface);
    EXPECT_EQ(one.refused, more.refused);
  }
}

TEST(LemSearch, AMirroredSlopeHasTheMirroredSurface) {
  Section section = make_section(plain, make_soil(5, 25, 19), 0), mirrored = section;
  section.water_table = {{0, 9}, {30, 9}, {90, 15}};
  mirrored.water_table = {{0, 15}, {60, 9}, {90, 9}};
  for (Point& p : mirrored.ground) p[0] = 90 - p[0];
  std::reverse(mirrored.ground.begin(), mirrored.ground.end());
  mirrored.regions = {make_region_below(mirrored, 0, mirrored.ground)};
  const auto a = search(Slope(section), make_quick()), b = search(Slope(mirrored), make_quick());
  for (std::size_t m = 0; m < a.circular.size(); ++m) {
    EXPECT_NEAR(a.circular[m].solution.factor, b.circular[m].solution.factor, 2e-4);
    EXPECT_NEAR(a.circular[m].surface.from, 90 - b.circular[m].surface.to, 0.3);
    EXPECT_NEAR(a.circular[m].surface.to, 90 - b.circular[m].surface.from, 0.3);
  }
  ASSERT_EQ(a.noncircular.size(), b.noncircular.size());
  for (std::size_t m = 0; m < a.noncircular.size(); ++m)
    EXPECT_NEAR(a.noncircular[m].solution.factor, b.noncircular[m].solution.factor,
                0.01 * a.noncircular[m].solution.factor);
}

TEST(LemSearch, FindsAMinimumOnEachBench) {
  SearchOptions options = make_quick();
  options.entry_exit->entries = options.entry_exit->exits = 25;
  options.optimise_surface = false;
  const Slope slope(make_benches());
  const SearchResult result = search(slope, options);
  for (const auto& minima : result.minima) {
    ASSERT_GE(minima.size(), 2U);
    auto on = [&](double from, double to) {
      return std::any_of(minima.begin(), minima.end(), [&](const Critical& c) {
        return c.surface.from > from && c.surface.to < to && c.solution.factor < 1.15 * minima.front().solution.factor;
      });
    };
    EXPECT_TRUE(on(10, 45));
    EXPECT_TRUE(on(55, 90));
    for (std::size_t i = 0; i < minima.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) EXPECT_LE(measure_overlap(slope, minima[i].surface, minima[j].surface), 0.6);
  }
}

TEST(LemSearch, SearchesBothFacesOfADam) {
  // The right face is steeper.
  const Slope slope(make_section({{0, 0}, {20, 0}, {50, 15}, {56, 15}, {78, 0}, {100, 0}}, make_soil(5, 28, 19), -4));
  SearchOptions options = make_quick();
  options.entry_exit->entries = options.entry_exit->exits = 20;
  const SearchResult result = search(slope, options);
  EXPECT_FALSE(result.circular[0].cut.slides_left);
  EXPECT_TRUE(std::any_of(result.minima[0].begin(), result.minima[0].end(),
                          [](const Critical& c) { return c.cut.slides_left; }));
  options.kind = SearchKind::grid;
  EXPECT_NEAR(search(slope, options).circular[0].solution.factor, result.circular[0].solution.factor, 0.005);
}

TEST(LemSearch, TheMapHoldsTheSmallestFactorOfAllTrials) {
  SearchOptions options = make_quick();
  options.optimise_surface = options.optimise_circle = false;
  for (const SearchKind kind : {SearchKind::entry_exit, SearchKind::grid}) {
    options.kind = kind;
    const SearchResult result = search(Slope(make_section(plain, make_soil(5, 25, 19), 0)), options);
    for (std::size_t m = 0; m < result.maps.size(); ++m) {
      float trials = 1e9f, map = 1e9f;
      for (const TriedCircle& t : result.trials)
        if (t.factors[m] > 0) trials = std::min(trials, t.factors[m]);
      for (const float f : result.maps[m].factor)
        if (f < map) map = f;
      EXPECT_EQ(trials, map);
      long refused = 0, zero = 0;
      for (const auto& [reason, count] : result.refused[m]) refused += count;
      for (const TriedCircle& t : result.trials) zero += t.factors[m] == 0 ? 1 : 0;
      EXPECT_EQ(refused, zero);
      EXPECT_EQ(result.tried, static_cast<long>(result.trials.size()));
    }
  }
}

TEST(LemSearch, NoAdmissibleSurfaceIsOneSentenceWithCounts) {
  SearchOptions options = make_quick();
  options.checks.smallest_depth = 3;
  options.checks.smallest_m_alpha = 5;  // nothing can meet that
  try {
    search(Slope(make_section(plain, make_soil(5, 25, 19), 0)), options);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ExitCode::wrong_input);
    const std::string sentence = e.what();
    EXPECT_NE(sentence.find("no admissible slip surface was found"), std::string::npos);
    EXPECT_NE(sentence.find(name_refusal(Refusal::m_alpha)), std::string::npos);
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
  }
}

TEST(LemSearch, ReportsTheLimitsThatWereReached) {
  auto hit = [](const SearchResult& r, const std::string& words) {
    return std::any_of(r.limit_hits.begin(), r.limit_hits.end(),
                       [&](const LimitHit& h) { return h.limit.find(words) != std::string::npos; });
  };
  SearchOptions options = make_quick();
  options.optimise_surface = false;
  options.methods = {Method::bishop};
  const Slope slope(make_section(plain, make_soil(5, 25, 19), 0));
  EXPECT_TRUE(search(slope, options).limit_hits.empty());
  options.entry_exit = EntryExitSearch{{20, 45}, {60, 80}, 10, 10, 8};  // the crest side begins too far back
  EXPECT_TRUE(hit(search(slope, options), "widen [lem.entry_exit] entry"));
  options.entry_exit->exit = {35, 45};
  EXPECT_TRUE(hit(search(slope, options), "widen [lem.entry_exit] exit"));
  // Deep in uniform clay: the base stops the circle, and the ground is too short.
  options.entry_exit = make_quick().entry_exit;
  const SearchResult deep =
      search(Slope(make_section({{26, 10}, {30, 10}, {50, 20}, {58, 20}}, make_soil(30, 0, 19), 5)), options);
  EXPECT_TRUE(hit(deep, "touches the base"));
  EXPECT_TRUE(hit(deep, "edge of the model"));
  options.kind = SearchKind::grid;
  options.grid = GridSearch{{60, 25}, {70, 30}, 5, 5, 8, {}, {}};
  EXPECT_TRUE(hit(search(slope, options), "border of the grid"));
}

TEST(LemSearch, CompositeCirclesSlideOnTheBase) {
  // A soft base layer's bottom stops circles: cut level they are longer and no stronger.
  const Slope slope(make_section({{0, 10}, {30, 10}, {50, 20}, {90, 20}}, make_soil(30, 0, 19), 7));
  SearchOptions options = make_quick();
  options.methods = {Method::bishop, Method::morgenstern_price_constant};
  options.optimise_surface = false;
  const SearchResult plain_circles = search(slope, options);
  options.composite = true;
  const SearchResult composite = search(slope, options);
  EXPECT_LE(composite.circular[1].solution.factor, 1.0005 * plain_circles.circular[1].solution.factor);
  EXPECT_TRUE(std::any_of(composite.trials.begin(), composite.trials.end(), [](const TriedCircle& t) {
    return t.surface.circle->centre[1] - t.surface.circle->radius < 6 && t.factors[1] > 0;
  }));
}

TEST(LemOptimise, IsNeverWorseThanItsStart) {
  Section section = make_section(plain, make_soil(8, 22, 19), 0);
  section.soils.push_back(make_soil(2, 12, 19));
  section.regions.push_back(make_region_below(section, 1, {{0, 8}, {90, 12}}));
  const Slope slope(section);
  const SearchOptions options = make_quick();
  std::mt19937_64 random(7);
  auto draw = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
  const Arcs arcs(slope, 0, false);
  for (const Method method : {Method::bishop, Method::spencer, Method::janbu}) {
    int tried = 0;
    while (tried < 6) {
      const double left = draw(15, 38), right = draw(45, 75);
      const auto range = arcs.find_range(left, right);
      if (!range) continue;
      Surface start = arcs.make_arc(left, right, draw(range->from, range->to));
      for (const bool polyline : {false, true}) {
        if (polyline && method == Method::bishop) continue;
        if (polyline) start = make_polyline(slope, start, 8);
        CutSurface cut = cut_surface(slope, start, options.slices, options.checks);
        const Solution before = solve(slope, cut, method, options.checks, false);
        if (before.refusal != Refusal::none) continue;
        const Critical after = optimise(slope, start, method, options);
        EXPECT_EQ(after.solution.refusal, Refusal::none);
        EXPECT_LE(after.solution.factor, before.factor * (1 + 1e-9));
        if (polyline) {  // corners of the ground may join
          EXPECT_LE(after.surface.line.size(), 8U + 2U);
        }
      }
      ++tried;
    }
  }
}

TEST(LemCandidates, GiveTheFactorOfTheChangedSection) {
  Section section = make_section(plain, make_soil(8, 24, 18.5), 0);
  section.soils[0].saturated_unit_weight = 20.5;
  section.soils.push_back(make_soil(12, 18, 19));
  section.soils[1].cohesion_gradient = 0.4, section.soils[1].cohesion_level = 8;
  section.soils[1].pore_pressure_ratio = 0.1;
  section.regions.push_back(make_region_below(section, 1, {{0, 7}, {90, 11}}));
  section.water_table = {{0, 9}, {30, 9}, {90, 15}};
  section.surcharges = {{{{55, 10}, {65, 10}}}};
  section.horizontal_acceleration = 0.05;
  const Slope slope{Section(section)};
  SearchOptions options = make_quick();
  options.optimise_surface = false;
  for (const Method method : {Method::fellenius, Method::bishop, Method::janbu_corrected, Method::spencer}) {
    const Candidates candidates(slope, {}, options, method, 2);
    ASSERT_GT(candidates.count(), 10);
    Section other = section;
    other.soils[0].unit_weight = 17, other.soils[0].saturated_unit_weight = 21, other.soils[0].cohesion = 5;
    other.soils[1].friction_angle = 21 * degree, other.soils[1].pore_pressure_ratio = 0.25;
    other.soils[1].cohesion_gradient = 0.1;
    other.horizontal_acceleration = 0.08;
    other.vertical_acceleration = -0.03;
    const Slope changed{Section(other)};
    Candidates::Workspace work;
    double smallest = 1e9;
    for (int i = 0; i < candidates.count(); ++i) {
      CutSurface cut = cut_surface(changed, candidates.surface(i), options.slices, options.checks);
      const double direct = solve(changed, cut, method, options.checks, false).factor;
      EXPECT_NEAR(candidates.find_factor(i, other.soils, 0.08, -0.03, method, work), direct, 1e-9);
      if (direct > 0) smallest = std::min(smallest, direct);
    }
    EXPECT_NEAR(candidates.find_factor(other.soils, 0.08, -0.03, work), smallest, 1e-9);
    const double searched = search(changed,
                                   [&] {
                                     SearchOptions o = options;
                                     o.methods = {method};
                                     return o;
                                   }())
                                .circular[0]
                                .solution.factor;
    EXPECT_NEAR(smallest, searched, 0.02 * searched);
  }
}

}  // namespace
}  // namespace talus::lem
