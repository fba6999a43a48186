#include "run/summary.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <map>

#include "base/atomic_file.hpp"
#include "base/version.hpp"
#include "mpm/body/observe.hpp"
#include "output/files/history.hpp"

namespace talus::run {

using nlohmann::json;

namespace {

const char* to_word(StageEnd end) {
  return end == StageEnd::rest ? "rest" : (end == StageEnd::failed ? "failed" : "time");
}

std::string now_as_text() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  return fmt::format("{:04d}-{:02d}-{:02d}T{:02d}:{:02d}:{:02d}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday,
                     utc.tm_hour, utc.tm_min, utc.tm_sec);
}

std::string find_machine() {
  char name[256] = {};
  gethostname(name, sizeof name - 1);
  return name;
}

}  // namespace

json to_json(const StageReport& s) {
  return {{"name", s.name},
          {"end", to_word(s.end)},
          {"start", s.start},
          {"time", s.time},
          {"steps", s.steps},
          {"time_step", s.time_step},
          {"displacement", s.displacement},
          {"force_ratio", s.force_ratio},
          {"nodal_speed", s.speed},
          {"wall", s.wall}};
}

json to_json(const Criterion& c) {
  json j{{"name", c.name}, {"factor", nullptr}, {"lower", nullptr}, {"upper", nullptr}, {"note", c.note}};
  if (!c.factor) return j;
  j["factor"] = *c.factor;
  j["lower"] = c.lower;
  j["upper"] = c.upper;
  return j;
}

json to_json(const FrozenResult& f, double dilatancy_min, double dilatancy_max) {
  json meshes = json::array();
  for (const MeshFactor& m : f.meshes) {
    json trials = json::array();
    for (const TrialResult& t : m.trials) trials.push_back(to_json(t));
    meshes.push_back({{"size", m.size},
                      {"points", m.points},
                      {"factor", m.factor()},
                      {"lower", m.lower},
                      {"upper", m.upper},
                      {"undecided", m.undecided},
                      {"trials", trials}});
  }
  json j{{"factor", f.factor()}, {"uncertainty", f.uncertainty()},       {"extrapolated", nullptr},
         {"meshes", meshes},     {"dilatancy_angle_min", dilatancy_min}, {"dilatancy_angle_max", dilatancy_max}};
  if (f.extrapolated) j["extrapolated"] = *f.extrapolated;
  return j;
}

json to_json(const Runout& r) {
  return {{"largest_displacement", r.largest_displacement},
          {"moved_volume", r.moved_volume},
          {"moved_threshold", r.threshold},
          {"direction", r.direction},
          {"front_advance", r.front_advance},
          {"farthest_advance", r.farthest_advance},
          {"toe", r.toe},
          {"initial_toe", r.initial_toe},
          {"toe_distance", r.toe_distance},
          {"crest", r.crest},
          {"crest_retreat", r.crest_retreat},
          {"centre_advance", r.centre_advance},
          {"centre_drop", r.centre_drop}};
}

json to_json(const Profile& p) {
  return {{"bin", p.bin}, {"x", p.x}, {"height", p.height}};
}

json describe_provenance(const input::LoadedCase& loaded, const std::string& input_hash, int threads) {
  return {{"program", "talus"},       {"version", version},        {"commit", commit},
          {"compiler", compiler},     {"build_type", build_type},  {"architecture", architecture},
          {"lane_width", lane_width}, {"machine", find_machine()}, {"threads", threads},
          {"started", now_as_text()}, {"case_file", loaded.file},  {"input_hash", input_hash}};
}

json describe_case(const input::LoadedCase& loaded, const std::string& input_hash, int threads) {
  const input::Case& data = loaded.data;
  json outlines = json::array();
  for (const mesh::Polygon& p : data.mesh.polygons) {
    json outline = json::array();
    for (const auto& x : p.points) outline.push_back({x[0], x[1]});
    outlines.push_back(std::move(outline));
  }
  return {{"title", data.title},
          {"project", describe_project(data)},
          {"provenance", describe_provenance(loaded, input_hash, threads)},
          {"units",
           {{"length", data.output.length_unit},
            {"displacement", data.output.displacement_unit},
            {"stress", data.output.stress_unit}}},
          {"outlines", std::move(outlines)},
          {"input", loaded.echo.get()}};
}

json describe_project(const input::Case& data) {
  const input::Project& p = data.project;
  return {{"title", data.title},        {"project", p.name},      {"client", p.client}, {"author", p.author},
          {"checked_by", p.checked_by}, {"revision", p.revision}, {"notes", p.notes}};
}

template <int D>
json describe_mesh(const mpm::Body<D>& body) {
  const mesh::Quality<D> q = mesh::measure_quality(body.mesh());
  json place = json::array();
  for (const double x : q.worst_place) place.push_back(x);
  return {{"dimension", D},
          {"nodes", body.mesh().node_count()},
          {"elements", body.mesh().element_count()},
          {"soil_elements", q.element_count},
          {"points", body.points.size()},
          {"smallest_altitude", q.min_altitude},
          {"mean_altitude", q.mean_altitude},
          {"smallest_altitude_at", place},
          {"mean_size", q.mean_size},
          {"smallest_angle", q.min_angle},
          {"critical_time_step", mpm::find_critical_step(body, mpm::StepOptions<D>{}).dt}};
}

json describe_timing(const mpm::Timing& t) {
  return {{"solve_momentum", t.solve_momentum}, {"remap_momentum", t.remap_momentum},
          {"smooth_strain", t.smooth_strain},   {"advance_points", t.advance_points},
          {"smooth_return", t.smooth_return},   {"relocate", t.relocate}};
}

template <int D>
json describe_budgets(const mpm::Body<D>& body, const Vec<D>& gravity) {
  const auto t = mpm::sum_points(body, gravity);
  json momentum = json::array(), lost_momentum = json::array(), lost_points = json::array();
  std::array<double, D> sum{};
  double lost_mass = 0;
  for (const auto& l : body.lost) {
    lost_mass += l.mass;
    json position = json::array();
    for (std::size_t d = 0; d < D; ++d) {
      sum[d] += l.momentum[d];
      position.push_back(l.position[d]);
    }
    if (lost_points.size() < 100) lost_points.push_back({{"id", l.id}, {"time", l.time}, {"position", position}});
  }
  for (std::size_t d = 0; d < D; ++d) {
    momentum.push_back(t.momentum[d]);
    lost_momentum.push_back(sum[d]);
  }
  return {{"mass", t.mass},
          {"points", t.points},
          {"kinetic_energy", t.kinetic},
          {"potential_energy", t.potential},
          {"elastic_energy", t.elastic},
          {"plastic_work", body.work.dissipated},
          {"damping_work", body.work.damped},
          {"external_work", body.work.external},
          {"momentum", momentum},
          {"lost",
           {{"points", body.lost.size()}, {"mass", lost_mass}, {"momentum", lost_momentum}, {"first", lost_points}}}};
}

json describe_curve(const CurveResult& curve, const std::optional<Bilinear>& bilinear,
                    const std::vector<Criterion>& criteria) {
  json points = json::array(), list = json::array();
  for (const TrialResult& t : curve.trials) points.push_back(to_json(t));
  for (const Criterion& c : criteria) list.push_back(to_json(c));
  json j{{"points", points}, {"criteria", list}};
  if (bilinear && bilinear->criterion.factor) {
    const auto branch = [](const Branch& b) {
      return json{{"slope", b.slope}, {"intercept", b.intercept}, {"points", b.factors}};
    };
    j["bilinear"] = {{"factor", *bilinear->criterion.factor},
                     {"first", branch(bilinear->first)},
                     {"second", branch(bilinear->last)}};
  }
  return j;
}

void write_profiles(const std::filesystem::path& path, const Profile& before, const Profile& after) {
  std::map<double, std::pair<std::string, std::string>> rows;
  for (std::size_t i = 0; i < before.x.size(); ++i) rows[before.x[i]].first = output::to_shortest(before.height[i]);
  for (std::size_t i = 0; i < after.x.size(); ++i) rows[after.x[i]].second = output::to_shortest(after.height[i]);
  std::string text = "x [m],ground before [m],ground after [m]\n";
  for (const auto& [x, heights] : rows)
    text += fmt::format("{},{},{}\n", output::to_shortest(x), heights.first, heights.second);
  write_atomically(path, text);
}

namespace {

/// As wide as `width` characters; letters outside ASCII count once.
std::string pad(const std::string& text, std::size_t width) {
  const auto length = static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
  return text + std::string(length < width ? width - length : 1, ' ');
}

/// The factors of all methods side by side, and what their differences say.
std::string write_method_table(const json& methods) {
  const json& table = methods.at("table");
  if (table.empty()) return "";
  constexpr std::size_t method_width = 30, criterion_width = 52;
  std::string text = "  " + pad("Method", method_width) + pad("Criterion", criterion_width) + "Factor   Seconds\n";
  for (const json& row : table) {
    text += "  " + pad(row.at("title").get<std::string>(), method_width) +
            pad(row.at("criterion").get<std::string>(), criterion_width) +
            (row.at("factor").is_number() ? fmt::format("{:6.3f}", row.at("factor").get<double>()) : "  none");
    if (row.at("seconds").is_number()) text += fmt::format("  {:8.3g}", row.at("seconds").get<double>());
    text += '\n';
  }
  for (const json& sentence : methods.at("reading")) text += sentence.get<std::string>() + "\n";
  const json& factors = methods.at("partial_factors");
  if (factors.is_object()) text += factors.at("text").get<std::string>() + "\n";
  return text;
}

}  // namespace

std::string write_digest(const json& s) {
  std::string text = fmt::format("{}\n", s.at("title").get<std::string>());
  if (s.contains("methods")) text += write_method_table(s.at("methods"));
  if (s.contains("mesh")) {
    const json& mesh = s.at("mesh");
    text += fmt::format("  {} points in {} elements, critical time step {:.3g} s\n", mesh.at("points").get<int>(),
                        mesh.at("soil_elements").get<int>(), mesh.at("critical_time_step").get<double>());
  }
  for (const json& stage : s.value("stages", json::array())) {
    text += fmt::format("  stage '{}': {} steps to t = {:.4g} s, {}\n", stage.at("name").get<std::string>(),
                        stage.at("steps").get<std::int64_t>(), stage.at("time").get<double>(),
                        stage.at("end") == "rest" ? "at rest" : "time is up");
  }
  if (s.contains("factor_of_safety")) {
    const json& f = s.at("factor_of_safety");
    if (f.contains("frozen")) {
      const json& z = f.at("frozen");
      text += fmt::format("Factor of safety {:.3f}", z.at("factor").get<double>());
      if (z.at("extrapolated").is_null()) {
        text += fmt::format(" (one mesh, not extrapolated; bracket ± {:.3f})", z.at("uncertainty").get<double>());
      } else {
        text += " (";
        for (const json& m : z.at("meshes"))
          text += fmt::format("{:.3f} at h = {:g} m, ", m.at("factor").get<double>(), m.at("size").get<double>());
        text += fmt::format("extrapolated to h = 0; brackets ± {:.3f})", z.at("uncertainty").get<double>());
      }
      text += fmt::format(", dilatancy angle {:.3g}°\n", z.at("dilatancy_angle_max").get<double>());
    }
    if (f.contains("criteria")) {
      for (const json& c : f.at("criteria")) {
        if (c.at("factor").is_null())
          text += fmt::format("  by the {} criterion: none ({})\n", c.at("name").get<std::string>(),
                              c.at("note").get<std::string>());
        else
          text += fmt::format("  by the {} criterion on moving geometry: {:.3f} [{:g}, {:g}]\n",
                              c.at("name").get<std::string>(), c.at("factor").get<double>(),
                              c.at("lower").get<double>(), c.at("upper").get<double>());
      }
    }
  }
  if (s.contains("runouts")) {
    for (const json& r : s.at("runouts")) {
      const json& m = r.at("runout");
      text += fmt::format(
          "Runout at SRF {:g}: front advances {:.3g} m and passes the toe by {:.3g} m, crest retreats {:.3g} m, {:.4g} "
          "m³ move, {} after {:.3g} s\n",
          r.at("srf").get<double>(), m.at("front_advance").get<double>(), m.at("toe_distance").get<double>(),
          m.at("crest_retreat").get<double>(), m.at("moved_volume").get<double>(),
          r.at("end") == "rest" ? "at rest" : "still moving", r.at("time").get<double>());
    }
  }
  if (s.contains("runout")) {
    const json& m = s.at("runout");
    text += fmt::format("Runout: front advances {:.3g} m, largest displacement {:.3g} m, {:.4g} m³ move\n",
                        m.at("front_advance").get<double>(), m.at("largest_displacement").get<double>(),
                        m.at("moved_volume").get<double>());
  }
  if (s.contains("motion")) text += s.at("motion").at("sentence").get<std::string>() + "\n";
  if (s.contains("seepage")) {
    const json& w = s.at("seepage");
    text += fmt::format("Steady seepage: {:.3g} m³/s through, largest suction {:.3g} kPa\n",
                        w.at("inflow").get<double>(), 1e-3 * w.at("largest_suction").get<double>());
  }
  if (s.contains("season")) {
    const json& w = s.at("season");
    text += fmt::format(
        "Season of {:.4g} days: {:.3g} m³ of rain and inflow entered, {:.3g} m³ left, {:.3g} of {:.3g} m³ transpired; "
        "closes to {:.1g}\n",
        w.at("duration").get<double>() / 86400, w.at("inflow").get<double>(), w.at("outflow").get<double>(),
        w.at("transpired").get<double>(), w.at("potential").get<double>(), std::abs(w.at("error").get<double>()));
  }
  if (s.contains("water")) {
    const json& w = s.at("water");
    text += fmt::format(
        "Water: {:.5g} kg at the start, {:.3g} kg came in, {:.3g} kg left, {:.5g} kg now; closes to "
        "{:.1g}\n",
        w.at("initial").get<double>(), w.at("entered").get<double>(), w.at("left").get<double>(),
        w.at("stored").get<double>(), std::abs(w.at("error").get<double>()));
  }
  for (const json& w : s.at("warnings")) text += fmt::format("warning: {}\n", w.get<std::string>());
  return text;
}

template json describe_mesh<2>(const mpm::Body<2>&);
template json describe_mesh<3>(const mpm::Body<3>&);
template json describe_budgets<2>(const mpm::Body<2>&, const Vec<2>&);
template json describe_budgets<3>(const mpm::Body<3>&, const Vec<3>&);

}  // namespace talus::run
