// SPDX-License-Identifier: MIT
#include "input/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <variant>

#include "base/user_file.hpp"
#include "base/version.hpp"
#include "input/case/case.hpp"
#include "input/case/checks.hpp"
#include "input/case/pressure_table.hpp"
#include "input/case/series_file.hpp"
#include "input/case/support.hpp"
#include "input/case/uncertain_number.hpp"
#include "input/catalogue.hpp"
#include "input/echo.hpp"
#include "input/language/codec_types.hpp"
#include "input/language/parse.hpp"
#include "input/language/reader.hpp"
#include "input/sketch.hpp"

namespace talus::input {

namespace {

std::string read_text(const std::string& path) {
  std::string text;
  if (const auto fault = try_user_file(path, largest_file::case_file, text))
    throw InputError({{path, 0, 0, fmt::format("the case file cannot be opened: {}", fault->why)}});
  return text;
}

void normalise(std::array<double, 3>& v) {
  const double length = std::hypot(v[0], v[1], v[2]);
  if (length > 0)
    for (double& component : v) component /= length;
}

/// Returns the methods of [analysis], on which the requirements of the other blocks depend.
std::set<std::string> find_methods(const toml::table& root) {
  std::set<std::string> asked;
  const toml::array* list = root["analysis"]["methods"].as_array();
  if (list == nullptr) return {"mpm"};
  for (const toml::node& word : *list) asked.insert(word.value_or(std::string()));
  return asked;
}

/// Blocks that are required for a slope and absent from a file of element tests alone.
const std::set<std::string> slope_blocks{"geometry", "mesh", "regions", "stage"};

bool has_tests_alone(const toml::table& root) {
  return root.contains("test") && std::none_of(slope_blocks.begin(), slope_blocks.end(),
                                               [&](const std::string& name) { return root.contains(name); });
}

/// Rejects a case of a later format with this fault alone, since unknown keys would follow from it.
void check_format(const toml::table& root, const Places& places) {
  const std::int64_t format = root["format"].value_or<std::int64_t>(1);
  if (format <= newest_format) return;
  const toml::source_position at = root.get("format")->source().begin;
  const Place place = places.locate("format", static_cast<int>(at.line), static_cast<int>(at.column));
  throw InputError(
      {{place.file, place.line, place.column,
        fmt::format(
            "this case has format {}; Talus {} reads cases up to format {}. Use the version that it was written for",
            format, version, newest_format)}});
}

/// Removes blocks that were not given from the echo: a file of element tests alone has no defaults of a slope.
void drop_absent_blocks(nlohmann::json& echo, const Places& places) {
  for (auto block = echo.begin(); block != echo.end();)
    block = places.is_given(block.key()) ? std::next(block) : echo.erase(block);
}

/// The boundary lines of a section before its polygons are built from them.
struct CaseReading : LoadedCase {
  Layering layering;
};

/// Reads and checks the case without what needs repeated readings (values of a study, soils of element tests). `root`
/// is the table of the file. Returns false if there are faults; `loaded` then has what could be read.
bool read_once(toml::table root, const std::string& name, const std::vector<Override>& overrides, CaseScope scope,
               Findings& findings, CaseReading& loaded) {
  findings.describe_owners = describe_owners;
  apply_overrides(root, overrides, findings);
  check_format(root, findings.places);
  loaded.is_whole = scope == CaseScope::whole || !has_tests_alone(root);
  // [geometry] comes first in the file, but its checks depend on whether [mesh] has an external mesh.
  loaded.data.mesh.file = root["mesh"]["file"].value_or(std::string());
  Reader reader(root, findings);
  if (!loaded.is_whole) reader.leave_out(slope_blocks);
  std::set<std::string> asked = find_methods(root);
  // An element test requires all parameters of the law, as the FEM does.
  if (root.contains("test")) asked.insert("fem");
  reader.ask_methods(asked);
  describe(reader, loaded.data);
  reader.finish();
  if (!check_extent(loaded.data, findings)) return false;
  complete_units(loaded.data);
  loaded.layering = loaded.data.layering;
  build_layers(loaded.data, name, findings);
  load_series(loaded.data, name, findings);
  load_pressure_table(loaded.data, name, findings);
  complete(loaded.data, name, findings.places);
  if (loaded.is_whole) {
    join_polygons(loaded.data, findings);
    check_geometry(loaded.data, findings);
    check_cover(loaded.data, findings);
  }
  check_unusual(loaded.data, findings);
  check_materials(loaded.data, findings);
  check_roots(loaded.data, findings);
  check_conditions(loaded.data, findings);
  check_water(loaded.data, findings);
  check_hydraulics(loaded.data, findings);
  check_given_pressures(loaded.data, findings);
  check_result(loaded.data, findings);
  check_start_stress(loaded.data, findings);
  if (loaded.is_whole) check_analysis(loaded.data, findings);
  if (loaded.is_whole) check_methods(loaded.data, findings);
  if (loaded.is_whole) check_slices(loaded.data, findings);
  if (loaded.is_whole) check_timeline(loaded.data, findings);
  if (loaded.is_whole) check_construction(loaded.data, findings);
  if (loaded.is_whole) check_seepage(loaded.data, findings);
  if (loaded.is_whole) check_drawdown(loaded.data, findings);
  if (loaded.is_whole) check_supports(loaded.data, findings);
  check_sampling(loaded.data, findings);
  check_output(loaded.data, findings);
  check_point_tests(loaded.data, findings);
  complete_calibration(loaded.data, name, findings);
  check_compare(loaded.data, findings);
  if (!findings.empty()) return false;
  std::vector<std::string> replaced;
  if (loaded.is_whole) replaced = replace_harmful(loaded.data);
  // LEM has no mechanism that bends a wall, and limit analysis no force across a pile.
  if (find_axial_obstacle(loaded.data)) loaded.data.lem.referee = false;
  nlohmann::json result = echo(loaded.data, findings.places);
  if (!loaded.is_whole) drop_absent_blocks(result, findings.places);
  loaded.echo = JsonTree(std::move(result));
  normalise_directions(loaded.data);
  loaded.warnings = findings.sort_warnings(loaded.data.unusual);
  for (std::string& sentence : replaced) loaded.warnings.push_back({name, 0, 0, std::move(sentence)});
  loaded.file = name;
  return true;
}

/// Repeated readings of the case with changed values. The study itself is left out, because it may have thousands of
/// values.
class Trials {
 public:
  Trials(const std::string& text, const std::string& name, const std::vector<Override>& overrides)
      : text_(text), name_(name), overrides_(overrides) {
    // The text is written again without the study, unless a value changes in writing. Tables are not copied, because
    // copies lose the positions of the keys in the file.
    toml::table root = parse_toml(text, name);
    if (root.erase("study") > 0) {
      std::ostringstream shorter;
      shorter << root;
      if (parse_quietly(shorter.str()) == root) text_ = shorter.str();
    }
    std::erase_if(overrides_, [](const Override& o) { return o.key == "study" || o.key.rfind("study.", 0) == 0; });
  }

  /// Throws InputError if that many readings, for values of a study or for tests, would take too long.
  void require(std::size_t readings) const {
    constexpr std::size_t most_bytes = 60'000'000,
                          least = 10'000;  // a short case takes as long as one of `least` bytes
    const std::size_t size = std::max(text_.size(), least);
    if (readings > most_bytes / size)
      throw InputError({{name_, 0, 0,
                         fmt::format("the case is read anew for each value of [study] and each [[test]] with 'set': "
                                     "with its {} bytes, at most {} of them can be checked",
                                     text_.size(), most_bytes / size)}});
  }

  /// Returns the case with `changes`, or its first fault.
  std::variant<LoadedCase, Diagnostic> read(const std::vector<Override>& changes) const {
    std::vector<Override> all = overrides_;
    all.insert(all.end(), changes.begin(), changes.end());
    Places places(name_);
    Findings findings(places);
    toml::table root = parse_toml(text_, name_);
    root.erase("study");
    CaseReading loaded;
    if (read_once(std::move(root), name_, all, CaseScope::whole_or_tests, findings, loaded)) return loaded;
    return findings.sort().front();
  }
  /// Returns the first fault of the case with one change; std::nullopt if there is none.
  std::optional<Diagnostic> find_fault(const Override& change) const {
    const auto outcome = read({change});
    const Diagnostic* fault = std::get_if<Diagnostic>(&outcome);
    return fault == nullptr ? std::nullopt : std::optional(*fault);
  }

 private:
  /// Parses a text that this program wrote; returns an empty table if that fails.
  static toml::table parse_quietly(const std::string& text) {
    try {
      return toml::parse(text);
    } catch (const toml::parse_error&) {
      return {};
    }
  }

  std::string text_, name_;
  std::vector<Override> overrides_;
};

/// Checks each value of a study by reading the case with that value.
void check_study(const LoadedCase& loaded, const Trials& trials, Findings& findings) {
  const std::vector<Vary>& vary = loaded.data.study.vary;
  std::size_t values = 0;
  for (const Vary& v : vary) values += v.values.size();
  trials.require(values);
  for (std::size_t i = 0; i < vary.size(); ++i) {
    for (std::size_t j = 0; j < vary[i].values.size(); ++j) {
      const auto fault = trials.find_fault({vary[i].key, vary[i].values[j]});
      if (!fault) continue;
      findings.add(fmt::format("study.vary.{}.values.{}", i, j), "the study cannot set {} = {}: {}", vary[i].key,
                   vary[i].values[j], fault->sentence);
      // An unknown key is reported once, not for each of its values.
      if (fault->is_unknown_key) break;
    }
  }
}

/// Checks an uncertain number by reading the case with its mean and with its limits.
void check_uncertain_numbers(const LoadedCase& loaded, const Trials& trials, Findings& findings) {
  const std::vector<RandomNumber>& numbers = loaded.data.study.sampling.numbers;
  trials.require(4 * numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const RandomNumber& number = numbers[i];
    const std::string path = fmt::format("study.random.{}", i);
    bool is_good = true;
    for (const auto& [key, value] : {std::pair{"mean", &number.mean},
                                     {"lowest", &number.lowest},
                                     {"mode", &number.mode},
                                     {"highest", &number.highest}}) {
      if (value->empty() || !is_good) continue;
      const auto fault = trials.find_fault({number.key, *value});
      if (!fault) continue;
      findings.add(path + "." + key, "the study cannot set {} = {}: {}", number.key, *value, fault->sentence);
      is_good = false;
    }
    if (!is_good) continue;
    try {
      resolve(number, loaded.data, loaded.echo.get());
    } catch (const Error& error) {
      findings.add(path, error.what());
    }
  }
}

/// Reads the soil of each test; the settings of a test are checked by reading the case with them.
void read_test_soils(LoadedCase& loaded, const Trials& trials, Findings& findings) {
  trials.require(loaded.data.tests.size());
  for (std::size_t i = 0; i < loaded.data.tests.size(); ++i) {
    const PointTest& test = loaded.data.tests[i];
    if (test.set.empty()) {
      loaded.data.test_soils.push_back(loaded.data.materials.at(test.material));
      continue;
    }
    std::vector<Override> changes;
    for (const PointSetting& s : test.set)
      changes.push_back({fmt::format("materials.{}.{}", test.material, s.key), s.value});
    const auto changed = trials.read(changes);
    if (const LoadedCase* it = std::get_if<LoadedCase>(&changed))
      loaded.data.test_soils.push_back(it->data.materials.at(test.material));
    else
      findings.add(fmt::format("test.{}.set", i), "the test '{}' cannot change material '{}' so: {}", test.name,
                   test.material, std::get<Diagnostic>(changed).sentence);
  }
}

/// Checks what needs repeated readings of the case.
void read_again(const std::string& text, const std::string& name, const std::vector<Override>& overrides,
                Findings& findings, LoadedCase& loaded) {
  loaded.text = text;
  const Trials trials(text, name, overrides);
  check_study(loaded, trials, findings);
  check_uncertain_numbers(loaded, trials, findings);
  read_test_soils(loaded, trials, findings);
}

}  // namespace

void normalise_directions(Case& data) {
  normalise(data.gravity.direction);
  for (Boundary& boundary : data.boundaries)
    if (boundary.fix == Fix::plane) normalise(boundary.normal);
}

LoadedCase read_case_text(const std::string& text, const std::string& name, const std::vector<Override>& overrides,
                          CaseScope scope) {
  Places places(name);
  Findings findings(places);
  CaseReading loaded;
  if (read_once(parse_toml(text, name), name, overrides, scope, findings, loaded))
    read_again(text, name, overrides, findings, loaded);
  if (!findings.empty()) throw InputError(findings.sort());
  loaded.places = std::move(places);
  return static_cast<LoadedCase&&>(loaded);
}

LoadedCase read_case(const std::string& path, const std::vector<Override>& overrides, CaseScope scope) {
  return read_case_text(read_text(path), path, overrides, scope);
}

namespace {

/// The reading of a sketch, which its functions share.
struct SketchReading {
  Places places;
  Findings findings;
  std::vector<std::pair<std::string, Place>> given;

  explicit SketchReading(const std::string& file) : places(file), findings(places) {}

  /// Returns the path of the last key that begins at or before a place of the file; with --set, the path that it sets.
  std::string find_path(const Diagnostic& message) const {
    std::string found;
    std::pair<int, int> nearest{0, 0};
    for (const auto& [path, place] : given) {
      if (place.file != message.file) continue;
      const std::pair at{place.line, place.column};
      if (message.line == 0) {
        if (place.line != 0) continue;  // not of --set
        if (found.empty() || path.size() < found.size()) found = path;
      } else if (at <= std::pair{message.line, message.column} && at >= nearest) {
        // A list of tables begins where its first table does; the longer path is that of the table.
        if (at > nearest || path.size() > found.size()) found = path;
        nearest = at;
      }
    }
    // An item that could not be read is not recorded: the message then belongs to its list, not to the item before.
    const bool is_before = message.line > 0 && nearest != std::pair{message.line, message.column};
    while (is_before && is_item(found)) found.resize(found.rfind('.'));
    return found;
  }

 private:
  /// Returns true for an item of a list of values, "points.0"; false for a table of a list, which has keys.
  bool is_item(const std::string& path) const {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string::npos || path.find_first_not_of("0123456789", dot + 1) != std::string::npos) return false;
    const auto below = std::upper_bound(given.begin(), given.end(), path + ".",
                                        [](const std::string& key, const auto& entry) { return key < entry.first; });
    const bool has_part = below != given.end() && below->first.starts_with(path + ".");
    return !has_part || std::isdigit(static_cast<unsigned char>(below->first[path.size() + 1])) != 0;
  }
};

}  // namespace

namespace {

/// Returns the sketch of what read_once() has read.
Sketch make_sketch(CaseReading&& read, bool is_good, const std::string& name) {
  Sketch sketch;
  sketch.file = name;
  sketch.data = std::move(read.data);
  sketch.layering = std::move(read.layering);
  sketch.is_whole = read.is_whole;
  if (!is_good) normalise_directions(sketch.data);
  Places places(name);
  Findings ignored(places);
  sketch.is_small = check_extent(sketch.data, ignored);
  return sketch;
}

/// Connects the functions of a sketch with its reading.
void share_reading(const std::shared_ptr<SketchReading>& reading, Sketch& sketch) {
  for (const std::string& key : reading->places.list_given())
    reading->given.emplace_back(key, reading->places.find(key));
  sketch.is_sound = [reading](const std::string& key) { return reading->findings.is_sound(key); };
  sketch.is_given = [reading](const std::string& key) { return reading->places.is_given(key); };
  sketch.find_path = [reading](const Diagnostic& message) { return reading->find_path(message); };
}

}  // namespace

Sketch read_sketch(const std::string& path, const std::vector<Override>& overrides, CaseScope scope) {
  const auto reading = std::make_shared<SketchReading>(path);
  Sketch sketch;
  sketch.file = path;
  try {
    CaseReading read;
    const bool is_good = read_once(parse_toml(read_text(path), path), path, overrides, scope, reading->findings, read);
    sketch = make_sketch(std::move(read), is_good, path);
  } catch (const Error&) {  // not TOML, or of a later format: read_case() reports it
  }
  share_reading(reading, sketch);
  return sketch;
}

Examination examine_text(const std::string& text, const std::string& name, const std::vector<Override>& overrides,
                         CaseScope scope) {
  const auto reading = std::make_shared<SketchReading>(name);
  Findings& findings = reading->findings;
  Examination found;
  found.sketch.file = name;
  try {
    CaseReading read;
    const bool is_good = read_once(parse_toml(text, name), name, overrides, scope, findings, read);
    if (is_good) {
      read_again(text, name, overrides, findings, read);
      found.warnings = read.warnings;
    } else {
      found.warnings = findings.sort_warnings(read.data.unusual);
    }
    if (findings.empty()) {
      found.loaded = read;
      found.loaded->places = reading->places;
    }
    found.sketch = make_sketch(std::move(read), is_good, name);
    found.faults = findings.sort();
  } catch (const InputError& error) {  // not TOML, or of a later format
    found.faults = error.diagnostics();
  }
  share_reading(reading, found.sketch);
  return found;
}

std::vector<Diagnostic> read_warnings(const std::string& path, const std::vector<Override>& overrides,
                                      CaseScope scope) {
  Places places(path);
  Findings findings(places);
  try {
    CaseReading loaded;
    read_once(parse_toml(read_text(path), path), path, overrides, scope, findings, loaded);
    return findings.sort_warnings(loaded.data.unusual);
  } catch (const Error&) {  // not TOML, or of a later format: read_case() reports it
    return {};
  }
}

void check_against_mesh(const LoadedCase& loaded, const std::set<std::string>& sides,
                        const std::set<std::string>& regions) {
  Places places = loaded.places;
  Findings findings(places);
  check_sides(loaded.data, sides, findings);
  check_regions(loaded.data, regions, findings);
  if (!findings.empty()) throw InputError(findings.sort());
}

namespace {

/// Collects the files that keys name: `file` of a mesh, a series or a measured curve, `library` of a soil, `result` of
/// [initial].
void gather_files(const toml::node& node, std::vector<std::string>& names) {
  if (const toml::array* list = node.as_array())
    for (const toml::node& entry : *list) gather_files(entry, names);
  const toml::table* table = node.as_table();
  if (table == nullptr) return;
  for (const auto& [key, value] : *table) {
    const std::string_view name = key.str();
    if (name == "study" || name == "title") continue;
    const std::optional<std::string> text = value.value<std::string>();
    if (!text || text->empty() || (name != "file" && name != "library" && name != "result")) {
      gather_files(value, names);
      continue;
    }
    if (std::find(names.begin(), names.end(), *text) == names.end()) names.push_back(*text);
  }
}

}  // namespace

std::vector<std::string> list_files(const std::string& text, const std::vector<Override>& overrides) {
  toml::table root = toml::parse(text);
  Places places("");
  Findings findings(places);
  apply_overrides(root, overrides, findings);
  std::vector<std::string> names;
  gather_files(root, names);
  return names;
}

}  // namespace talus::input
