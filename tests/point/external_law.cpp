// SPDX-License-Identifier: MIT
// A compiled UMAT: every argument arrives in its place, elasticity in C equals the built-in one, and messages on a UMAT
// that fails or is missing.

#include <gtest/gtest.h>

#include <array>
#include <thread>

#include "base/error.hpp"
#include "material/every_law.hpp"
#include "support/draw.hpp"
#include "support/external_model.hpp"

namespace talus {
namespace {

using material::External;
using support::open_umat;

constexpr double young = 20e6, poisson = 0.3;

template <int NS>
void expect_built_in_elasticity() {
  const External law = open_umat({"elastic", {young, poisson}});
  const auto built_in = material::LinearElastic::from_young(young, poisson);
  support::Draw draw(7);
  for (int n = 0; n < 100; ++n) {
    double one[NS], d_one[NS], q_one[External::state_size] = {};
    Pack s[NS], before[NS], d[NS], q[External::state_size], expected[NS];
    for (int i = 0; i < NS; ++i) {
      for (int l = 0; l < lane_width; ++l) {
        s[i].value[l] = draw(-1e5, 1e5);
        d[i].value[l] = draw(-1e-3, 1e-3);
      }
      one[i] = s[i][0];
      d_one[i] = d[i][0];
      before[i] = expected[i] = s[i];
    }
    for (Pack& x : q) x = Pack(0.0);
    Pack odd(0.0);
    for (int l = 1; l < lane_width; l += 2) odd.value[l] = 1;
    const Mask active = n == 0 ? Mask(true) : odd > Pack(0.5);
    const auto r = law.update<NS>(s, d, q, active);
    EXPECT_TRUE(r.any_plastic) << "or states would not be stored";
    built_in.update<NS>(expected, d, static_cast<Pack*>(nullptr), active);
    for (int i = 0; i < NS; ++i) {
      for (int l = 0; l < lane_width; ++l) {
        if (active[l])
          ASSERT_NEAR(s[i][l], expected[i][l], 1e-12 * 1e5) << "component " << i << ", lane " << l;
        else
          ASSERT_EQ(s[i][l], before[i][l]) << "a lane that is not active";
      }
    }
    law.update<NS>(one, d_one, q_one, true);
    for (int i = 0; i < NS; ++i) ASSERT_NEAR(one[i], expected[i][0], 1e-12 * 1e5) << "component " << i;
  }
}

TEST(ExternalLaw, ElasticityInCIsTheBuiltInOne) {
  expect_built_in_elasticity<4>();
  expect_built_in_elasticity<6>();
}

// Talus counts xx yy zz xy yz zx, Abaqus 11 22 33 12 13 23.
template <int NS>
void expect_every_argument() {
  const External law = open_umat({"arguments", {4, 5, 6.5}, 20, {}, "arguments"});
  double s[NS], d[NS], q[External::state_size] = {};
  for (int i = 0; i < NS; ++i) s[i] = i + 1, d[i] = 0.01 * (i + 1);
  const int points[] = {41};
  for (int call = 1; call <= 2; ++call) {
    std::array<double, NS> expected;
    for (int i = 0; i < NS; ++i) expected[static_cast<std::size_t>(i)] = 10 * s[i] + d[i];
    const auto r = law.update<NS>(s, d, q, true, {0.75, points, call == 1 ? 0.0 : 0.125, 0.125});
    EXPECT_EQ(r.dissipation, 7) << "SPD";
    for (int i = 0; i < NS; ++i)
      EXPECT_DOUBLE_EQ(s[i], expected[static_cast<std::size_t>(i)]) << "every component comes back to its place";
    const double time = call == 1 ? 0 : 0.125;
    // STRAN is the strain before the increment; its last component is 12 in plane strain, 23 = yz in space.
    const double stran = (call - 1) * d[NS == 4 ? 3 : 4];
    const double result[20] = {1.0 * call, 3,     NS - 3, NS,    20, 3,   6.5,
                               0.75,       time,  time,   0.125, 42, 111, call == 1 ? 11.0 : 21.0,
                               80.75,      stran, 0,      1,     0,  1};
    const char* names[20] = {"calls",
                             "NDI",
                             "NSHR",
                             "NTENS",
                             "NSTATV",
                             "NPROPS",
                             "PROPS",
                             "PREDEF",
                             "TIME(1)",
                             "TIME(2)",
                             "DTIME",
                             "NOEL",
                             "NPT, LAYER, KSPT",
                             "KSTEP, KINC",
                             "CMNAME",
                             "STRAN",
                             "DROT, DFGRD0, DFGRD1",
                             "COORDS, CELENT",
                             "zeros",
                             "PNEWDT"};
    for (int i = 0; i < 20; ++i) EXPECT_DOUBLE_EQ(q[1 + i], result[i]) << names[i];
    EXPECT_EQ(q[0], 0) << "deviatoric plastic strain: not known";
  }
}

TEST(ExternalLaw, EveryArgumentArrives) {
  expect_every_argument<4>();
  expect_every_argument<6>();
}

TEST(ExternalLaw, InitialStatesFollowTheFirst) {
  const External law = open_umat({"arguments", {}, 3, {8, 9}, "arguments"});
  double q[External::state_size];
  std::fill_n(q, External::state_size, -1.0);
  law.set_initial_state(q);
  EXPECT_EQ(q[0], 0);
  EXPECT_EQ(q[1], 8);
  EXPECT_EQ(q[2], 9);
  for (int i = 3; i < External::state_size; ++i) EXPECT_EQ(q[i], 0);

  // Results show them under their numbers.
  const auto fields = material::list_state_fields(law);
  ASSERT_EQ(fields.size(), 3u);
  EXPECT_EQ(fields[2].name, "state_3");
  double shown[3] = {-1, -1, -1};
  material::show_state(law, q, 1, shown);
  EXPECT_EQ(shown[0], 8);
  EXPECT_EQ(shown[1], 9);
  EXPECT_EQ(shown[2], 0);
}

/// Returns the message of throw_failure(), or "".
std::string catch_failure(const External& law) {
  try {
    law.throw_failure();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::unstable);
    return error.what();
  }
  return "";
}
void expect_words(const std::string& sentence, const std::vector<std::string>& words) {
  for (const std::string& w : words) EXPECT_NE(sentence.find(w), std::string::npos) << w << "\nin: " << sentence;
}

TEST(ExternalLaw, FailureNamesThePointAndItsInputs) {
  const External law = open_umat({"failing", {13}, 2, {0.5, 2}, "no_number"});
  int points[lane_width];
  for (int l = 0; l < lane_width; ++l) points[l] = 12 - l;  // 12, 11, 10 …: NOEL 13 is point 12
  points[1] = 20;
  Pack s[4], d[4], q[External::state_size];
  for (int i = 0; i < 4; ++i) s[i] = Pack(-1000.0 * (i + 1)), d[i] = Pack(1e-4 * (i + 1));
  for (Pack& x : q) x = Pack(0.0);
  q[1] = Pack(0.5), q[2] = Pack(2.0);
  EXPECT_EQ(catch_failure(law), "");
  law.update<4>(s, d, q, Mask(true), {Pack(0.875), points, 1.5, 0.25});
  for (int l = 0; l < 2; ++l) {
    EXPECT_EQ(s[0][l], -1000) << "a point that failed keeps its stress";
    EXPECT_EQ(q[1][l], 0.5) << "and its state";
    EXPECT_EQ(q[External::first_strain][l], 0);
  }
  if (lane_width > 2) {
    EXPECT_EQ(s[0][2], -999) << "the others continue";
    EXPECT_EQ(q[1][2], 1.5);
  }
  const std::string sentence = catch_failure(law);
  expect_words(sentence,
               {"material 'clay of Oslo'", "no_number in ", "umat_failing.so", "failed in point 12:",
                "a stress that is NaN or infinite", "stress (-1000, -2000, -3000, -4000) Pa (xx yy zz xy)",
                "strain increment (0.0001, 0.0002, 0.0003, 0.0004)", "state variables (0.5, 2)", "saturation 0.875",
                "t = 1.5 s", "step 0.25 s", "answer: stress (-999, ", "state variables (1.5, 2)"});
  EXPECT_EQ(catch_failure(law), "") << "reported once";
}

TEST(ExternalLaw, EveryKindOfFailureIsDetected) {
  const std::vector<std::pair<std::string, std::string>> kinds = {
      {"no_state", "state variables that are no numbers"},
      {"smaller_step", "the step is too long (PNEWDT = 0.25)"},
      {"too_many_states", "it crashed (Segmentation fault), as a UMAT does that writes behind its arguments"},
      {"too_long_stress", "it crashed (Segmentation fault)"},
      {"abort_", "it crashed (Aborted)"}};
  for (const auto& [symbol, words] : kinds) {
    const External law = open_umat({"failing", {0}, 2, {}, symbol});
    double s[6] = {1, 2, 3, 4, 5, 6}, q[External::state_size] = {};
    const double d[6] = {};
    law.update<6>(s, d, q, true);
    EXPECT_EQ(s[0], 1) << symbol;
    expect_words(catch_failure(law), {words, "failed in a point:", "xx yy zz xy yz zx"});
  }
}

// The engine calls from several threads; the message must not depend on their order.
TEST(ExternalLaw, LowestPointIsReportedForAnyThreads) {
  const External law = open_umat({"failing", {100}, 2, {}, "no_number"});
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([copy = law, t] {
      for (int n = 0; n < 500; ++n) {
        double s[4] = {}, q[External::state_size] = {};
        const double d[4] = {};
        const int point = 4 * ((n * 37) % 500) + t;
        copy.update<4>(s, d, q, true, {1.0, &point, 0, 0});
      }
    });
  }
  for (std::thread& t : threads) t.join();
  expect_words(catch_failure(law), {"failed in point 99:"});
}

std::string catch_opening(const support::ExternalCase& c) {
  try {
    open_umat(c);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    return error.what();
  }
  return "nothing was thrown";
}

TEST(ExternalLaw, ALibraryThatCannotBeOpenedIsReported) {
  expect_words(catch_opening({"missing", {}}), {"material 'clay of Oslo'", "umat_missing.so', which does not exist"});
  expect_words(catch_opening({"elastic", {}, 0, {}, "umet_"}),
               {"needs the subroutine 'umet_', which is not in '", "umat_elastic.so'", "name SUBROUTINE UMAT 'umat_'"});
  expect_words(catch_opening({"elastic", {}, 21}), {"has 21 state variables; 0 to 20"});
  expect_words(catch_opening({"elastic", {}, 1, {1, 2}}), {"2 initial values for 1 state variables"});
  // A file that is no library: the reason is the system's.
  material::ExternalParameters p;
  p.material = "clay";
  p.library = std::string(TALUS_SOURCE_DIR) + "/README.md";
  try {
    External law(p);
    ADD_FAILURE() << "README.md was opened as a library";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
    expect_words(error.what(), {"README.md', which cannot be opened: ", "invalid ELF header"});
  }
}

}  // namespace
}  // namespace talus
