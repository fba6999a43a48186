// SPDX-License-Identifier: MIT
#include "report/content/slices.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/file_name.hpp"
#include "report/words/numbers.hpp"
#include "results/governing.hpp"
#include "results/json.hpp"

namespace talus::report {

using nlohmann::json;

namespace {

/// null for 0, which stands for a surface that was refused.
json write_factor(const std::optional<double>& factor) {
  return factor.value_or(0) > 0 ? json(*factor) : json();
}

json take_number(const std::optional<double>& number) {
  return number ? json(*number) : json();
}

json list_numbers(const std::vector<std::optional<double>>& numbers) {
  json list = json::array();
  for (const std::optional<double>& number : numbers) list.push_back(take_number(number));
  return list;
}

/// The columns of the slice table; older folders know fewer.
json take_columns(const results::SliceTable& slices) {
  json columns = results::to_json(slices);
  for (json& column : columns)
    if (column.size() != slices.size()) column = std::vector<double>(slices.size());
  return columns;
}

json take_surface(const results::CriticalSurface& found, const char* kind, bool governs) {
  const results::SlipSurface& surface = found.surface;
  const results::SurfaceChecks& checks = found.checks;
  json taken{{"kind", kind},
             {"name", surface.name.value_or("")},
             {"method", results::to_word(surface.method)},
             {"title", surface.title},
             {"factor", write_factor(surface.factor)},
             {"lambda", is_rigorous(surface.method) ? take_number(found.lambda) : json()},
             {"correction", found.correction},
             {"points", surface.points},
             {"area", found.area},
             {"depth", found.depth},
             {"yield_acceleration", take_number(found.yield_acceleration)},
             {"checks",
              {{"smallest_m_alpha", checks.smallest_m_alpha},
               {"tensile_share", keep_finite(checks.tensile_share)},
               {"thrust_outside", keep_finite(checks.thrust_outside)},
               {"refusal", checks.refusal}}},
             {"warnings", found.warnings},
             {"governs", governs}};
  if (const auto& drawn = found.drawdown)
    taken["drawdown"] = {{"factor_before", write_factor(drawn->factor_before)},
                         {"undrained_factor", write_factor(drawn->undrained_factor)},
                         {"normal", drawn->normal},
                         {"shear", drawn->shear},
                         {"strength", list_numbers(drawn->strength)}};
  if (surface.circle) taken["circle"] = results::to_json(*surface.circle);
  if (found.slices.size() > 0) taken["slices"] = take_columns(found.slices);
  return taken;
}

json list_minima(const results::SliceResult& lem) {
  json list = json::array();
  for (const auto& [method, surfaces] : lem.minima)
    for (const results::SlipSurface& m : surfaces) {
      json taken{{"method", method}, {"factor", m.factor.value_or(0)}, {"points", m.points}};
      if (m.circle) taken["circle"] = results::to_json(*m.circle);
      list.push_back(std::move(taken));
    }
  return list;
}

json take_search(const results::SliceSearch& search) {
  json refused = json::array(), limit_hits = json::array();
  for (const auto& [method, reasons] : search.refused) {
    json list = json::array();
    for (const auto& [reason, count] : reasons) list.push_back({{"reason", reason}, {"count", count}});
    refused.push_back({{"method", method}, {"reasons", list}});
  }
  for (const results::LimitHit& hit : search.limit_hits)
    limit_hits.push_back(fmt::format("{}: {}", hit.method, hit.limit));
  json taken{{"kind", results::to_word(search.kind)},
             {"tried", search.tried},
             {"refused", refused},
             {"limit_hits", limit_hits},
             {"circles_per_second", search.circles_per_second}};
  const results::SearchRanges& ranges = search.ranges;
  if (ranges.exit) taken["exit"] = *ranges.exit;
  if (ranges.entry) taken["entry"] = *ranges.entry;
  if (ranges.grid) taken["grid"] = {ranges.grid->from, ranges.grid->to};
  return taken;
}

json pack_trials(const results::SliceTrials& file, Packer& packer) {
  const std::size_t methods = file.methods.size(), count = file.trials.size();
  if (count == 0 || methods == 0) return {};
  std::vector<double> circles, factors;
  for (const std::vector<double>& trial : file.trials) {
    if (trial.size() < 5 + methods) throw Error(ExitCode::wrong_input, "a trial is shorter than the others");
    circles.insert(circles.end(), trial.begin(), trial.begin() + 5);
    for (std::size_t k = 0; k < methods; ++k) factors.push_back(keep_finite(trial[5 + k]));
  }
  return {{"count", count},
          {"methods", file.methods},
          {"circles", packer.add_places("lem.circles", circles, {count, 5})},
          {"factors", packer.add_reals("lem.factors", factors, {count, methods})}};
}

json pack_maps(const results::SliceTrials& file, Packer& packer) {
  json list = json::array();
  for (const auto& [method, map] : file.maps) {
    const auto columns = static_cast<std::size_t>(map.columns), rows = static_cast<std::size_t>(map.rows);
    if (columns * rows == 0 || map.factor.size() != columns * rows) continue;
    std::vector<double> factors;
    for (const std::optional<double>& v : map.factor) factors.push_back(v.value_or(0));
    list.push_back({{"method", method},
                    {"from", map.from},
                    {"to", map.to},
                    {"columns", columns},
                    {"rows", rows},
                    {"factor", packer.add_reals("lem.map." + method, factors, {rows, columns})}});
  }
  return list;
}

}  // namespace

json make_slices(const ResultFolder& folder, Packer& packer, json& warnings) {
  if (!folder.run.slices) return {};
  const results::SliceResult& lem = *folder.run.slices;
  json surfaces = json::array(), methods = json::array();
  std::map<SliceMethod, std::string> titles;
  const auto governing = results::find_governing_surface(folder.run);
  static const std::vector<results::CriticalSurface> none;
  for (const auto& [kind, list] :
       {std::pair{"circle", &lem.critical}, std::pair{"polyline", &lem.noncircular}, std::pair{"given", &lem.given},
        std::pair{"optimised", folder.run.methods ? &folder.run.methods->optimised : &none}})
    for (const results::CriticalSurface& found : *list) {
      surfaces.push_back(take_surface(found, kind, governing && governing->found == &found));
      titles[found.surface.method] = found.surface.title;
    }
  for (const SliceMethod method : lem.methods) {
    const std::string name = results::to_word(method);
    methods.push_back({{"name", name}, {"title", titles.contains(method) ? titles[method] : name}});
  }
  json slices{{"methods", methods},   {"slice_count", lem.slices},  {"seconds", lem.seconds},
              {"surfaces", surfaces}, {"minima", list_minima(lem)}, {"maps", json::array()}};
  if (lem.drawdown) slices["drawdown"] = get_title(*lem.drawdown);
  if (lem.error) slices["error"] = *lem.error;
  if (lem.search) slices["search"] = take_search(*lem.search);
  try {
    const auto file =
        results::read_file<results::SliceFile>(join_name(folder.path, lem.trials_file.value_or("lem.json")));
    if (!file || !file->trials) return slices;
    if (json trials = pack_trials(*file->trials, packer); !trials.is_null()) slices["trials"] = std::move(trials);
    slices["maps"] = pack_maps(*file->trials, packer);
  } catch (const Error& error) {
    warnings.push_back(fmt::format("The trial surfaces are not shown: {}", error.what()));
  }
  return slices;
}

}  // namespace talus::report
