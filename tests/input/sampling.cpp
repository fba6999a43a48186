// SPDX-License-Identifier: MIT
// [study] with mode = "sample": uncertain parameters and their correlations; and the key of the extrapolation.

#include "methods_slope.hpp"

#include "input/case/uncertain_number.hpp"

namespace talus::input {
namespace {

const std::string sample = slices_alone + "[study]\nmode = \"sample\"\n";
const std::string cohesion = "[[study.random]]\nkey = \"materials.soil.cohesion\"\n";
const std::string friction = "[[study.random]]\nkey = \"materials.soil.friction_angle\"\nvariation = 0.1\n";

std::vector<UncertainNumber> resolve_all(const std::string& text) {
  const LoadedCase loaded = read_case_text(text, "slope.toml");
  std::vector<UncertainNumber> list;
  for (const RandomNumber& number : loaded.data.study.sampling.numbers)
    list.push_back(resolve(number, loaded.data, loaded.echo.get()));
  return list;
}

TEST(Sampling, ReadsItsSettings) {
  const Sampling s =
      read(sample + "samples = 500\nseed = 12345678901\nplan = \"random\"\nconfidence = 0.9\n" + cohesion +
           "deviation = \"0.5 kPa\"\n" + friction +
           "[[study.correlation]]\nkeys = [\"materials.soil.cohesion\", \"materials.soil.friction_angle\"]\n"
           "coefficient = -0.4\n")
          .study.sampling;
  EXPECT_EQ(s.samples, 500);
  EXPECT_EQ(s.seed, 12345678901u);
  EXPECT_EQ(s.plan, SamplePlan::random);
  EXPECT_EQ(s.numbers.size(), 2u);
  EXPECT_EQ(s.correlations.at(0).coefficient, -0.4);
}

TEST(Sampling, GivesFiguresInTheUnitOfTheKey) {
  const auto list = resolve_all(sample + cohesion + "mean = \"2000 Pa\"\ndeviation = 0.5\n" + friction);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].unit, "kPa");
  EXPECT_NEAR(list[0].mean, 2, 1e-12);
  EXPECT_NEAR(list[0].deviation, 0.5, 1e-12);
  EXPECT_EQ(list[0].lowest, 0) << "no cohesion is negative";
  EXPECT_NEAR(list[1].mean, 19.6, 1e-9) << "the case's own value";
  EXPECT_NEAR(list[1].deviation, 1.96, 1e-9);
  EXPECT_EQ(list[1].highest, 90);
  const auto triangle = resolve_all(sample + cohesion + "distribution = \"triangular\"\nlowest = 1\nhighest = 6\n");
  EXPECT_NEAR(triangle.at(0).mode, 3, 1e-12);
}

TEST(Sampling, NumbersNeedAKeyThatHoldsOne) {
  expect_one_fault(sample, "needs at least one [[study.random]]");
  expect_fault(slices_alone + "@@" + cohesion + "deviation = 1\n", "only with mode = \"sample\"");
  expect_one_fault(sample + change(cohesion, "cohesion", "cohesoin") + "mean = 2\ndeviation = 1\n",
                   "did you mean 'cohesion'?");
  expect_one_fault(sample + change(cohesion, "cohesion", "cohesoin") + "deviation = 1\n",
                   "has no number 'materials.soil.cohesoin'");
  expect_one_fault(sample + change(cohesion, "soil.cohesion", "soil.model") + "deviation = 1\n",
                   "is not a single number");
  expect_one_fault(sample + cohesion + "deviation = 1\n" + cohesion + "deviation = 1\n",
                   "two uncertain numbers of the key");
  EXPECT_TRUE(
      find_faults(sample + "[[study.random]]\nkey = \"lem.tension_crack.depth\"\nmean = 1\ndeviation = 0.2\n").empty());
}

TEST(Sampling, NumbersFitTheirDistribution) {
  const auto with = [](const std::string& keys) { return sample + cohesion + keys; };
  expect_one_fault(with(""), "has no deviation");
  expect_one_fault(with("deviation = 1\nvariation = 0.2\n"), "has a deviation and a variation");
  expect_one_fault(with("deviation = 0\n"), "has one above 0");
  expect_one_fault(with("deviation = \"1 m\"\n"), "'1 m' is a length");
  expect_fault(with("mean = @@-1\ndeviation = 1\n"), "it must be at least 0 kPa");
  expect_one_fault(with("distribution = \"triangular\"\nlowest = 4\nhighest = 6\n"), "not between lowest and highest");
  expect_one_fault(with("distribution = \"triangular\"\nlowest = 4\n"), "has no 'highest'");
  expect_one_fault(with("distribution = \"uniform\"\nlowest = 6\nhighest = 4\n"),
                   "the lowest value is the smaller one");
  expect_one_fault(with("distribution = \"uniform\"\nlowest = 4\nhighest = 6\nmean = 5\n"), "has a meaning only with");
  expect_one_fault(with("deviation = 1\nlowest = 4\n"),
                   "the mean of 'materials.soil.cohesion' is 3, which is not between");
  expect_fault(change(slices_alone, "cohesion = 3", "cohesion = 0") + "[study]\nmode = \"sample\"\n@@" + cohesion +
                   "distribution = \"lognormal\"\ndeviation = 1\n",
               "a lognormal number has a mean above 0");
  expect_fault(sample + "samples = @@1\n" + friction, "at least 2");
}

TEST(Sampling, CorrelationsAreOfTwoNumbersAndDoNotContradict) {
  const std::string two = sample + cohesion + "deviation = 1\n" + friction;
  const auto pair = [](const std::string& keys, const std::string& coefficient) {
    return "[[study.correlation]]\nkeys = [" + keys + "]\ncoefficient = " + coefficient + "\n";
  };
  const std::string c = "\"materials.soil.cohesion\"", f = "\"materials.soil.friction_angle\"",
                    w = "\"materials.soil.unit_weight\"";
  EXPECT_TRUE(find_faults(two + pair(c + ", " + f, "0.99")).empty());
  expect_fault(two + pair(c + ", " + f, "@@1"), "above -1 and below 1");
  expect_fault(two + pair(c + ", @@" + w, "0.5"), "is the key of no [[study.random]]");
  expect_one_fault(two + pair(c + ", " + c, "0.5"), "two different keys");
  expect_one_fault(two + pair(c + ", " + f, "0.5") + pair(f + ", " + c, "0.4"), "there are two correlations");
  // c goes with φ and with γ, which go against each other.
  const std::string three = two + "[[study.random]]\nkey = " + w + "\ndeviation = 1\n" + pair(c + ", " + f, "0.9") +
                            pair(c + ", " + w, "0.9");
  EXPECT_TRUE(find_faults(three + pair(f + ", " + w, "0.7")).empty());
  expect_one_fault(three + pair(f + ", " + w, "-0.9"), "the correlations contradict one another");
}

TEST(Sampling, IsCalculatedByAMethodOfTheCase) {
  expect_fault(sample + "method = @@\"mpm\"\n" + friction, "which 'methods' in [analysis] does not name");
  expect_one_fault(sample + friction + "[[study.vary]]\nkey = \"materials.soil.cohesion\"\nvalues = [1]\n",
                   "[[study.vary]] has no meaning with mode = \"sample\"");
}

TEST(Sampling, IsOfTheSoilAsItIs) {
  expect_fault(sample + friction + "[partial_factors]\nset = @@\"DA1-2\"\n",
               "samples use the soil without partial factors");
}

TEST(Study, ExtrapolatesAKeyThatItVaries) {
  const std::string vary = "[[study.vary]]\nkey = \"mesh.size\"\nvalues = [1, 0.5]\n";
  EXPECT_TRUE(find_faults(slope + "[study]\nextrapolate = \"mesh.size\"\n" + vary).empty());
  expect_fault(slope + "[study]\nextrapolate = @@\"mesh.algorithm\"\n" + vary, "no [[study.vary]] varies it");
}

}  // namespace
}  // namespace talus::input
