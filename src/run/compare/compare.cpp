#include "run/compare/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "input/case/method_names.hpp"
#include "run/compare/look_up.hpp"
#include "run/compare/reading.hpp"
#include "run/compare/slip_line.hpp"
#include "run/lem/run_lem.hpp"

namespace talus::run {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The methods that a surface of another method is given to: Spencer and Morgenstern–Price, which satisfy all
/// equilibrium, and those of the case that suit polylines.
std::vector<lem::Method> list_takers(const input::LimitEquilibrium& settings) {
  std::vector<lem::Method> takers{lem::Method::spencer, lem::Method::morgenstern_price};
  for (const input::SliceMethod m : settings.methods) {
    const lem::Method method = to_lem(m);
    if (input::suits_polylines(m) && std::find(takers.begin(), takers.end(), method) == takers.end())
      takers.push_back(method);
  }
  return takers;
}

json make_row(const char* method, const std::string& name, const std::string& title, const std::string& criterion,
              const std::string& surface, const json& factor) {
  return {{"method", method}, {"name", name},     {"title", title},   {"criterion", criterion}, {"surface", surface},
          {"factor", factor}, {"lower", nullptr}, {"upper", nullptr}, {"seconds", nullptr},     {"note", ""}};
}

json make_surface_entry(const std::string& name, const std::string& title, const char* method, const json& factor,
                        const json& points) {
  return {{"name", name}, {"title", title}, {"method", method}, {"factor", factor}, {"points", points}};
}

ground::Polyline to_line(const json& points) {
  ground::Polyline line;
  for (const json& x : points) line.push_back({x.at(0).get<double>(), x.at(1).get<double>()});
  return line;
}

json to_points(const ground::Polyline& line) {
  json points = json::array();
  for (const ground::Point& x : line) points.push_back({x[0], x[1]});
  return points;
}

class Comparison {
 public:
  Comparison(const input::Case& data, const lem::Slope* slope, const json& summary, const fs::path& folder, int threads)
      : data_(data), slope_(slope), summary_(summary), folder_(folder), threads_(threads) {}

  json make() {
    add_slices();
    add_elements();
    add_points();
    if (slope_ != nullptr) hand_over();
    json asked = json::array();
    for (const input::Method m : data_.methods)
      asked.push_back(m == input::Method::lem ? "lem" : (m == input::Method::fem ? "fem" : "mpm"));
    json block{{"asked", asked}, {"table", table_}, {"surfaces", surfaces_}, {"handed", handed_}};
    block["reading"] = read_differences(data_, summary_, block);
    block["partial_factors"] = nullptr;
    return block;
  }

 private:
  void add_critical(const json& c, const std::string& name, const std::string& criterion) {
    const std::string method = c.at("method"), title = c.at("title");
    json row = make_row("lem", method, title, criterion, name, c.at("factor"));
    if (const auto lambda = get_number(c, "lambda")) row["note"] = fmt::format("λ = {:.3g}", *lambda);
    if (const double f = c.at("correction"); f != 1) row["note"] = fmt::format("f₀ = {:.3f}", f);
    if (const std::string why = c.at("checks").at("refusal"); !why.empty()) row["note"] = why;
    table_.push_back(std::move(row));
    surfaces_.push_back(
        make_surface_entry(name, fmt::format("{}, {}", title, criterion), "lem", c.at("factor"), c.at("points")));
  }

  void add_slices() {
    const json& lem = get(summary_, "lem");
    if (!lem.is_object()) return;
    const std::size_t first = table_.size();
    for (const json& c : list(lem, "critical"))
      add_critical(c, "lem." + c.at("method").get<std::string>(), "critical circle");
    for (const json& c : list(lem, "noncircular"))
      add_critical(c, "lem.noncircular." + c.at("method").get<std::string>(), "critical polyline");
    for (const json& c : list(lem, "given"))
      add_critical(
          c, fmt::format("lem.surface[{}].{}", c.at("name").get<std::string>(), c.at("method").get<std::string>()),
          fmt::format("given surface '{}'", c.at("name").get<std::string>()));
    if (table_.size() > first) table_[first]["seconds"] = lem.value("seconds", 0.0);  // of all of them together
  }

  void add_elements() {
    const json& fem = get(summary_, "fem");
    for (const json& run : list(fem, "runs")) {
      const bool associated = run.at("flow") == "associated";
      const std::string words = describe_flow(run), stem = associated ? "fem.associated" : "fem";
      json row = make_row("fem", associated ? "associated" : "as_given", fmt::format("Finite elements, {}", words),
                          "no equilibrium", stem + ".band", run.at("factor"));
      row["lower"] = run.at("stable");
      row["upper"] = run.at("failed");
      row["seconds"] = run.at("seconds");
      row["note"] = fmt::format("{}, {} elements of {:.3g} m", fem.at("element").get<std::string>(),
                                fem.at("elements").get<int>(), fem.at("size").get<double>());
      if (run.at("slip_line").empty()) row["surface"] = "";
      table_.push_back(row);
      if (run.at("by_displacement").is_number()) {
        json other = row;
        other["criterion"] = "displacement runs away";
        other["factor"] = run.at("by_displacement");
        other["lower"] = other["upper"] = other["seconds"] = nullptr;
        table_.push_back(std::move(other));
      }
      if (!run.at("slip_line").empty())
        surfaces_.push_back(make_surface_entry(stem + ".band", fmt::format("Band of the finite elements, {}", words),
                                               "fem", run.at("factor"), run.at("slip_line")));
    }
  }

  void add_points() {
    if (!input::uses(data_, input::Method::mpm)) return;
    const json& factors = get(summary_, "factor_of_safety");
    const PointsSlipLine line = find_line();
    const std::string surface = line.line.empty() ? "" : "mpm.slip_line";
    const std::size_t first = table_.size();
    const json& frozen = get(factors, "frozen");
    if (frozen.is_object()) {
      const double f = frozen.at("factor"), width = frozen.at("uncertainty");
      json row = make_row("mpm", "frozen", "Material points", "rest or run-away at frozen geometry", surface, f);
      row["lower"] = f - width;
      row["upper"] = f + width;
      std::string note;
      for (const json& m : frozen.at("meshes"))
        note += fmt::format("{}{:.3f} at h = {:g} m", note.empty() ? "" : ", ", m.at("factor").get<double>(),
                            m.at("size").get<double>());
      if (!frozen.at("extrapolated").is_null()) note += ", extrapolated to h = 0";
      row["note"] = note;
      table_.push_back(std::move(row));
    }
    for (const json& c : list(factors, "criteria")) {
      json row = make_row("mpm", c.at("name"), "Material points",
                          fmt::format("{} criterion on the displacement curve", c.at("name").get<std::string>()),
                          surface, c.at("factor"));
      for (const char* key : {"lower", "upper"}) row[key] = c.at(key);
      row["note"] = c.at("note");
      table_.push_back(std::move(row));
    }
    if (table_.size() > first) {
      const double wall = get(summary_, "timing").value("wall", 0.0);
      table_[first]["seconds"] = std::max(0.0, wall - find_seconds(summary_, "lem") - find_seconds(summary_, "fem"));
    }
    if (line.line.empty()) return;
    surfaces_.push_back(
        make_surface_entry("mpm.slip_line",
                           line.factor > 1 ? fmt::format("Slip line of the material points at SRF {:.4g}", line.factor)
                                           : std::string("Slip line of the material points"),
                           "mpm", line.factor, to_points(line.line)));
    surfaces_.back()["source"] = line.source;
  }

  PointsSlipLine find_line() const {
    try {
      return find_points_slip_line(data_, summary_, folder_);
    } catch (const Error&) {  // frames of a run that was stopped may be damaged
      return {};
    }
  }

  /// Surfaces of the other methods on slices.
  void hand_over() {
    const lem::SearchOptions options = make_search_options(data_.lem, threads_);
    const json given = surfaces_;
    for (const json& s : given) {
      if (s.at("method") == "lem") continue;
      const std::string from = s.at("name"), of = s.at("title");
      const auto surface = make_surface(*slope_, to_line(s.at("points")));
      for (const lem::Method method : list_takers(data_.lem)) {
        const std::string name = lem::name_method(method);
        if (!surface) {
          add_handed(from, name, fmt::format("{} on: {}", lem::title_method(method), of), nullptr,
                     "the line does not part a mass from the ground");
          continue;
        }
        const lem::Critical found = solve_surface(*slope_, *surface, method, options);
        const bool has_factor = found.solution.factor > 0;
        const lem::Refusal why = found.cut.refusal != lem::Refusal::none ? found.cut.refusal : found.solution.refusal;
        const std::string refusal = why == lem::Refusal::none ? "" : lem::name_refusal(why);
        add_handed(from, name, fmt::format("{} on: {}", lem::title_method(method), of),
                   has_factor ? json(found.solution.factor) : json(nullptr), refusal);
        if (method != lem::Method::spencer && method != lem::Method::morgenstern_price) continue;
        table_.push_back(make_row("lem", name, lem::title_method(method), "on: " + of, from,
                                  has_factor ? json(found.solution.factor) : json(nullptr)));
        table_.back()["note"] = refusal;
      }
      if (surface) optimise(*surface, from, of, options);
    }
  }

  void optimise(const lem::Surface& surface, const std::string& from, const std::string& of,
                const lem::SearchOptions& options) {
    const lem::Critical best = lem::optimise(*slope_, surface, lem::Method::spencer, options);
    if (!(best.solution.factor > 0)) return;
    const std::string title = "Spencer, optimised from: " + of;
    add_handed(from, "spencer_optimised", title, best.solution.factor, "");
    const std::string name = fmt::format("lem.handed[{}].spencer_optimised", from);
    table_.push_back(
        make_row("lem", "spencer_optimised", "Spencer", "optimised from: " + of, name, best.solution.factor));
    json points = json::array();
    for (const lem::Point& x : best.surface.line) points.push_back({x[0], x[1]});
    surfaces_.push_back(make_surface_entry(name, title, "lem", best.solution.factor, points));
  }

  void add_handed(const std::string& from, const std::string& to, const std::string& title, const json& factor,
                  const std::string& refusal) {
    handed_.push_back({{"from", from}, {"to", to}, {"title", title}, {"factor", factor}, {"refusal", refusal}});
  }

  const input::Case& data_;
  const lem::Slope* slope_;
  const json& summary_;
  const fs::path& folder_;
  int threads_;
  json table_ = json::array(), surfaces_ = json::array(), handed_ = json::array();
};

}  // namespace

json compare_methods(const input::Case& data, const lem::Slope* slope, const json& summary, const fs::path& folder,
                     int threads) {
  return Comparison(data, slope, summary, folder, threads).make();
}

double find_main_factor(const json& summary) {
  if (const auto f = get_number(get(summary, "factor_of_safety"), "value")) return *f;
  for (const json& c : list(get(summary, "factor_of_safety"), "criteria"))
    if (const auto f = get_number(c, "factor")) return *f;
  for (const json& run : list(get(summary, "fem"), "runs"))
    if (const auto f = get_number(run, "factor")) return *f;
  double rigorous = 0, any = 0;
  const auto take = [](double f, double& least) { least = least == 0 ? f : std::min(least, f); };
  for (const char* key : {"critical", "noncircular", "given"}) {
    for (const json& c : list(get(summary, "lem"), key)) {
      const auto f = get_number(c, "factor");
      if (!f || *f <= 0) continue;
      take(*f, any);
      const std::string method = c.at("method");
      if (method == "spencer" || method.starts_with("morgenstern")) take(*f, rigorous);
    }
  }
  return rigorous > 0 ? rigorous : any;
}

}  // namespace talus::run
