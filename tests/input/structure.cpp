// SPDX-License-Identifier: MIT
// Unknown and missing keys, tables of the wrong kind, and files that are not a case.

#include <fmt/format.h>

#include "slope.hpp"
#include "support/scratch.hpp"

namespace talus::input {
namespace {

TEST(UnknownKey, IsReportedWithTheNearestKnownOne) {
  expect_fault(slope + "[gravity]\n@@acceleraton = 9.81\n",
               "unknown key 'acceleraton' in [gravity]; did you mean 'acceleration'?");
  expect_fault(slope + "@@fricton = 1\n", "unknown key 'fricton' in [[stage]]");
  expect_fault("title =", "@@titel =", "unknown key 'titel' at the top of the file; did you mean 'title'?");
  expect_fault(slope + "[@@strength_reducton.curve]\nfrom = 1\n", "did you mean 'strength_reduction'?");
  expect_fault(slope + "[strength_reduction.frozen.rest]\n@@force = 1\n",
               "in [strength_reduction.frozen.rest]; known are");
}

TEST(UnknownKey, InAMaterialComesWithTheMissingOne) {
  const Marked marked = take_mark(change(slope, "cohesion = 2", "@@cohesoin = 2"));
  const auto faults = find_faults(marked.text);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].line, 18) << "the missing key is reported at its table";
  EXPECT_EQ(faults[0].sentence,
            "missing key 'cohesion' in [materials.sand], for example cohesion = 10; model = \"mohr_coulomb\" needs it");
  EXPECT_EQ(faults[1].line, marked.line);
  EXPECT_EQ(faults[1].sentence, "unknown key 'cohesoin' in [materials.sand]; did you mean 'cohesion'?");
}

TEST(MissingKey, IsReportedAtItsTable) {
  for (const char* key : {"grain_density = 2500", "porosity = 0.2", "young_modulus = \"45 MPa\"", "poisson_ratio = 0.3",
                          "cohesion = 2", "friction_angle = \"30 deg\"", "dilatancy_angle = 0", "tensile_strength = 0"})
    expect_fault(change(change(slope, key, ""), "[materials.sand]", "@@[materials.sand]"),
                 "missing key '" + std::string(key).substr(0, std::string(key).find(' ')) + "' in [materials.sand]");
  expect_fault(change(change(slope, "duration = \"3 s\"", ""), "[[stage]]\nname = \"failure\"",
                      "@@[[stage]]\nname = \"failure\""),
               "missing key 'duration' in [[stage]]");
  expect_fault(change(change(slope, "box = [[0, 0], [44, 17]]", ""), "[geometry]", "@@[geometry]"),
               "missing key 'box'");
}

TEST(MissingKey, SeveralOfOneTableAreOneSentence) {
  // The keys are in the order of the manual. A key that is missing elsewhere has a sentence of its own.
  std::string text = change(change(slope, "cohesion = 2\n", ""), "friction_angle = \"30 deg\"\n", "");
  text = change(text, "duration = \"3 s\"", "");
  auto faults = find_faults(text);
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].line, 18) << "at the table";
  EXPECT_EQ(faults[0].sentence,
            "missing keys 'cohesion' and 'friction_angle' in [materials.sand], for example cohesion = 10 and "
            "friction_angle = 20; model = \"mohr_coulomb\" needs them");
  EXPECT_NE(faults[1].sentence.find("missing key 'duration' in [[stage]]"), std::string::npos) << faults[1].sentence;

  text = change(change(slope, "cohesion = 2\n", ""), "grain_density = 2500\n", "");
  text = change(text, "porosity = 0.2\n", "");
  faults = find_faults(text);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].sentence,
            "missing keys 'grain_density', 'porosity' and 'cohesion' in [materials.sand], for example grain_density = "
            "2500, porosity = 0.2 and cohesion = 10; model = \"mohr_coulomb\" needs 'cohesion'; or give 'unit_weight' "
            "instead of 'grain_density' or 'void_ratio' instead of 'porosity'");
}

TEST(MissingKey, OfAMissingTableIsReportedAtTheTopOfTheFile) {
  expect_fault("@@" + change(slope, "[mesh]\nsize = 0.75", ""), "missing key 'size' in [mesh]");
}

TEST(KeyOfAnotherChoice, IsRefused) {
  expect_fault("fix = \"full\"", "fix = \"full\"\nfriction = @@0.3", "has a meaning only with fix = \"friction\"");
  expect_fault("dimension = 2", "dimension = 2\nthickness = @@5", "has a meaning only with dimension = 3");
  expect_fault("[geometry]\ndimension = 2", "@@[geometry]\ndimension = 3",
               "missing key 'thickness' in [geometry], for example thickness = 5; dimension = 3 needs it");
  expect_fault(change(change(slope, "on = \"bottom\"\nfix = \"full\"", "on = \"bottom\"\nfix = \"plane\""),
                      "[[boundary]]\non = \"bottom\"", "@@[[boundary]]\non = \"bottom\""),
               "missing key 'normal' in [[boundary]]");
  expect_fault(slope + "[initial]\nk0 = @@0.5\n", "has a meaning only with stress = \"k0\"");
}

TEST(KeyOfAnotherChoice, IsNotReportedWhereTheChoiceItselfIsWrong) {
  expect_fault("model = \"mohr_coulomb\"", "model = @@\"mohr_columb\"", "no choice for 'model'");
}

TEST(Block, OfTheWrongKindIsOneFault) {
  expect_fault(slope + "@@[output.monitor]\nname = \"a\"\nat = [0, 0]\n",
               "write [[output.monitor]] instead of [output.monitor]");
  expect_fault(slope + "@@[[gravity]]\nacceleration = 9.81\n", "write [gravity] instead of [[gravity]]");
  expect_fault("title = \"Dry homogeneous slope\"", "title = \"x\"\nrest = @@3", "'rest' must be a table");
  expect_fault("title = \"Dry homogeneous slope\"", "title = \"x\"\ntraction = [@@3]",
               "'traction' is a list of tables");
}

TEST(File, ThatIsNotTomlIsOneFaultWithItsPlace) {
  const auto faults = find_faults(change(slope, "size = 0.75", "size = = 2"));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].line, 16);
  EXPECT_NE(faults[0].sentence.find("not TOML"), std::string::npos);
  EXPECT_EQ(find_faults(slope + "[mesh]\nsize = 3\n").size(), 1u) << "a table that is written twice";
}

TEST(File, ThatCannotBeOpenedIsOneSentence) {
  try {
    read_case("no/such/case.toml");
    FAIL() << "a missing file was read";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "no/such/case.toml: error: the case file cannot be opened: No such file or directory");
    EXPECT_EQ(error.code(), ExitCode::wrong_input);
  }
  EXPECT_THROW(read_case(support::make_scratch("folder").string()), InputError);
}

TEST(File, ThatIsEmptyLacksEverything) {
  std::string all;
  for (const Diagnostic& fault : find_faults("")) {
    EXPECT_FALSE(fault.sentence.empty());
    all += fault.sentence + "\n";
  }
  for (const char* part : {"'box'", "'size'", "no soil", "no material", "no stage"})
    EXPECT_NE(all.find(part), std::string::npos) << part << " is not in\n" << all;
}

TEST(Faults, OfAFileComeTogetherInItsOrder) {
  std::string text = change(slope, "size = 0.75", "size = -1");
  text = change(text, "porosity = 0.2", "porosity = 2");
  text = change(text, "on = \"left\"", "on = \"lft\"");
  text = change(text, "title =", "titel =");
  text = change(text, "damping = 0.7", "damping = \"much\"");
  const auto faults = find_faults(text);
  ASSERT_EQ(faults.size(), 5u) << InputError(faults).what();
  for (std::size_t i = 1; i < faults.size(); ++i) EXPECT_LT(faults[i - 1].line, faults[i].line);
  EXPECT_EQ(to_string(faults[1]).rfind("slope.toml:16:8: error: 'size' is -1 m", 0), 0u) << to_string(faults[1]);
}

TEST(Format, OfALaterProgramIsTheOnlyFault) {
  const auto faults = find_faults("format = 2\nkey_of_the_future = 1\n" + slope);
  ASSERT_EQ(faults.size(), 1u) << InputError(faults).what();
  EXPECT_EQ(faults[0].line, 1);
  EXPECT_NE(faults[0].sentence.find("has format 2"), std::string::npos) << faults[0].sentence;
}

TEST(Format, OfThisProgramMayBeGiven) {
  EXPECT_TRUE(find_faults("format = 1\n" + slope).empty());
  const auto faults = find_faults("format = 0\n" + slope);
  ASSERT_EQ(faults.size(), 1u) << InputError(faults).what();
  EXPECT_EQ(faults[0].line, 1);
}

TEST(Faults, OfUnknownKeysReportThem) {
  const auto faults = find_faults("titel = \"a\"\n" + slope);
  ASSERT_EQ(faults.size(), 1u) << InputError(faults).what();
  EXPECT_TRUE(faults[0].is_unknown_key);
}

/// The one sentence of a text that cannot be read.
std::string read_fault(const std::string& text) {
  const auto faults = find_faults(text);
  EXPECT_EQ(faults.size(), 1u) << text;
  return faults.empty() ? "" : faults[0].sentence;
}

TEST(File, WithoutQuotationMarksReportsWhereTheyBelong) {
  for (const auto& [from, to, message] : std::vector<std::array<std::string, 3>>{
           {"cohesion = 2", "cohesion = 10 kPa", "put the value with its unit in quotation marks: \"10 kPa\""},
           {"\"30 deg\"", "25°", "put the value with its unit in quotation marks: \"25°\""},
           {"\"30 deg\"", "-1.5e1deg # slope", "quotation marks: \"-1.5e1deg\""},
           {"\"mohr_coulomb\"", "mohr_coulomb", "put the text in quotation marks: \"mohr_coulomb\""},
           {"[44, 5]", "[44 m, 5]", "quotation marks: \"44 m\""},
           {"porosity = 0.2", "porosity = True", "'True' is written in small letters: true"}})
    EXPECT_NE(read_fault(change(slope, from, to)).find(message), std::string::npos)
        << read_fault(change(slope, from, to));
  EXPECT_DOUBLE_EQ(read_case_text(change(slope, "\"30 deg\"", "\"30°\""), "").data.materials.at("sand").friction_angle,
                   read_case_text(slope, "").data.materials.at("sand").friction_angle);
}

TEST(File, InAnotherEncodingIsToBeSavedAsUtf8) {
  std::string latin = change(slope, "Dry homogeneous slope", "B\xF6schung");
  const auto faults = find_faults(latin);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].line, 1);
  EXPECT_EQ(faults[0].column, 11);
  EXPECT_NE(faults[0].sentence.find("save it as UTF-8"), std::string::npos) << faults[0].sentence;
  for (const bool has_mark : {true, false})
    for (const bool is_big : {true, false}) {
      std::string wide = !has_mark ? "" : is_big ? "\xFE\xFF" : "\xFF\xFE";
      for (const char c : slope) wide += is_big ? std::string{'\0', c} : std::string{c, '\0'};
      EXPECT_EQ(read_fault(wide), "the file is in UTF-16; save it as UTF-8");
    }
  EXPECT_TRUE(find_faults("\xEF\xBB\xBF" + change(slope, "Dry homogeneous", "Böschung")).empty()) << "a mark of UTF-8";
}

TEST(UnknownKey, OfAnotherBlockReportsWhereItBelongs) {
  expect_fault(slope + "[analysis]\nmethods = [@@\"bishop\"]\n",
               "'bishop' is no choice for 'methods'; it belongs to 'methods' in [lem]; choose one of lem, fem");
  expect_fault(slope + "[analysis]\n@@noncircular = false\n",
               "unknown key 'noncircular' in [analysis]; it is a key of [lem]");
  expect_fault(slope + "[analysis.@@tension_crack]\ndepth = 2\n", "write [lem.tension_crack]");
}

/// Sizes at which checks that compare all with all would not end.
TEST(File, OfMoreThanAnySectionHasIsRefusedWithWhatWouldDo) {
  std::string corners = "[[0, 0], [44, 0]";
  for (int i = 0; i < 100000; ++i) corners += fmt::format(", [{:.6f}, {}]", 44 - 44e-5 * i, 5 + i % 2);
  expect_fault("points = [[0, 0], [44, 0], [44, 5], [32, 5], [12, 15], [0, 15]]", "points = @@" + corners + "]",
               "'points' has 100002 entries, and at most 10000 are read");
  std::string line = "[[0, 15]";
  for (int i = 1; i <= 9999; ++i) line += fmt::format(", [{:.6f}, 15]", 12e-4 * i);
  EXPECT_NE(find_faults(change(slope, "points = [[0, 15], [12, 15]]", "points = " + line + "]"))[0].sentence.find(
                "have 10006 corners, and a section has at most 5000"),
            std::string::npos);
  std::string materials;
  for (int i = 0; i < 10000; ++i) materials += fmt::format("[materials.m{}]\n", i);
  EXPECT_EQ(find_faults(slope + materials).front().sentence,
            "there are 10001 of [materials], and a case has at most 1000");
  std::string monitors;
  for (int i = 0; i < 2000; ++i) monitors += "[[output.monitor]]\n";
  EXPECT_EQ(find_faults(slope + monitors).front().sentence,
            "there are 2000 of [output.monitor], and a case has at most 1000");
  const auto faults = find_faults("title = \"" + std::string(1100000, ',') + "\"\n" + slope);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults[0].sentence.find("and a case has at most 1000000"), std::string::npos);
  std::string values = "[[study.vary]]\nkey = \"materials.sand.cohesion\"\nvalues = [1";
  for (int i = 0; i < 999; ++i) values += fmt::format(", {}", i + 2);
  EXPECT_NE(
      find_faults(change(slope, "Dry homogeneous slope", std::string(100000, '-')) + values + "]\n")[0].sentence.find(
          "the case is read anew"),
      std::string::npos);
}

TEST(File, NamesAreOneLine) {
  expect_fault(slope + "[[output.monitor]]\nname = @@\"a\\nb\"\nat = [5, 5]\n", "'name' must be one line");
  EXPECT_NE(
      find_faults(change(slope, "[materials.sand]", "[materials.\"a\\nb\"]"))[0].sentence.find("must be one line"),
      std::string::npos);
}

}  // namespace
}  // namespace talus::input
