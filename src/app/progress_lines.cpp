// SPDX-License-Identifier: MIT
#include "app/progress_lines.hpp"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/text.hpp"

namespace talus::app {
namespace {

using nlohmann::ordered_json;

ordered_json to_json(const ProgressValues& values) {
  ordered_json out{{"method", values.method}};
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value && std::isfinite(*value)) out[key] = *value;
  };
  if (!values.series.empty()) out["series"] = values.series;
  add("lower", values.lower);
  add("upper", values.upper);
  add("factor", values.factor);
  if (values.holds) out["holds"] = *values.holds;
  add("displacement", values.displacement);
  add("time", values.time);
  if (values.total > 0) {
    out["done"] = values.done;
    out["total"] = values.total;
  }
  if (!values.surface.empty()) out["surface"] = values.surface;
  return out;
}

}  // namespace

void write_progress_line(const ProgressReport& report) {
  ordered_json line{{"line", report.line}};
  if (!report.label.empty()) line["label"] = report.label;
  if (!report.stage.empty()) {
    line["stage"] = report.stage;
    line["time"] = report.time;
    line["duration"] = report.duration;
  }
  if (!report.values.method.empty()) line["values"] = to_json(report.values);
  print(stderr, line.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n");
  std::fflush(stderr);
}

}  // namespace talus::app
