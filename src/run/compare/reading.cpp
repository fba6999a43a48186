#include "run/compare/reading.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "run/compare/look_up.hpp"
#include "run/compare/slip_line.hpp"

namespace talus::run {
namespace {

using nlohmann::json;

/// Factors that differ by less are the same [-].
constexpr double same = 0.01;
/// Differences that slices, which vary little among themselves, deserve a sentence for [-].
constexpr double noticeable = 0.02;
/// Mean distance of two surfaces over the height of the slope that still is one mechanism, where it is more than the
/// size of the elements [-].
constexpr double same_surface = 0.06;
/// Share of suction in the resistance that is worth saying [-].
constexpr double noticeable_suction = 0.01;

std::string format_share(double part) {
  return std::abs(part) < 5e-4 ? "0.1 %" : fmt::format("{:.1f} %", 100 * std::abs(part));
}

/// "1.2 % above", "3.7 % below".
std::string compare(double factor, double other) {
  if (std::abs(factor / other - 1) < 5e-4) return "the same as";
  return fmt::format("{} {}", format_share(factor / other - 1), factor >= other ? "above" : "below");
}

class Reading {
 public:
  Reading(const input::Case& data, const json& summary, const json& methods)
      : data_(data), summary_(summary), methods_(methods), height_(summary.value("slope_height", 0.0)) {
    for (const char* name : {"spencer", "morgenstern_price", "morgenstern_price_constant", "bishop", "janbu_corrected",
                             "janbu", "fellenius"}) {
      circle_ = find_slices(summary, "critical", name);
      if (!circle_) continue;
      circle_name_ = find_critical(summary, "critical", name).at("title").get<std::string>();
      circle_key_ = name;
      break;
    }
    for (const json& run : list(get(summary, "fem"), "runs"))
      (run.at("flow") == "associated" ? associated_ : given_) = &run;
    frozen_ = get_number(get(get(summary, "factor_of_safety"), "frozen"), "factor");
  }

  json read() {
    read_range();
    read_search();
    read_slices();
    read_suction();
    read_flow();
    read_element_criterion();
    read_elements();
    read_points_mesh();
    read_points_criterion();
    read_points();
    read_surfaces();
    read_seconds();
    return sentences_;
  }

 private:
  template <class... Arguments>
  void say(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
    sentences_.push_back(fmt::format(text, std::forward<Arguments>(arguments)...));
  }

  /// One factor of each kind of method: Spencer's circle, finite elements, material points.
  void read_range() {
    std::vector<std::pair<std::string, double>> parts;
    if (circle_) parts.emplace_back(fmt::format("slices ({}) {:.3f}", circle_name_, *circle_), *circle_);
    if (const json* run = given_ ? given_ : associated_) {
      const double f = run->at("factor");
      parts.emplace_back(fmt::format("finite elements ({}) {:.3f}", describe_flow(*run), f), f);
    }
    if (frozen_) parts.emplace_back(fmt::format("material points (frozen geometry) {:.3f}", *frozen_), *frozen_);
    if (parts.size() < 2) return;
    std::vector<std::string> words;
    double low = parts.front().second, high = low;
    for (const auto& [text, f] : parts) {
      words.push_back(text);
      low = std::min(low, f);
      high = std::max(high, f);
    }
    say("Factors of safety: {}; they lie within {} of each other.", fmt::join(words, ", "),
        format_share(high / low - 1));
  }

  void read_search() {
    const json& hits = list(get(get(summary_, "lem"), "search"), "limit_hits");
    // "Spencer: the critical circle …": one sentence for all methods that ended at the same limit.
    std::vector<std::pair<std::string, std::vector<std::string>>> limits;
    for (const json& hit : hits) {
      const std::string text = hit.get<std::string>();
      const std::size_t colon = std::min(text.find(": "), text.size());
      const std::string method = text.substr(0, colon), what = colon < text.size() ? text.substr(colon + 2) : "";
      auto known = std::find_if(limits.begin(), limits.end(), [&](const auto& l) { return l.first == what; });
      if (known == limits.end()) known = limits.insert(limits.end(), {what, {}});
      if (std::find(known->second.begin(), known->second.end(), method) == known->second.end())
        known->second.push_back(method);
    }
    for (const auto& [what, methods] : limits)
      say("The search of the slices ended at a limit ({}): {}.", fmt::join(methods, ", "), what);
  }

  void read_slices() {
    const auto bishop = find_slices(summary_, "critical", "bishop"),
               spencer = find_slices(summary_, "critical", "spencer"),
               janbu = find_slices(summary_, "critical", "janbu");
    if (bishop && spencer) {
      if (std::abs(*bishop / *spencer - 1) < same)
        say("Bishop ({:.3f}) and Spencer ({:.3f}) agree within {}: on circles the interslice forces matter little "
            "here.",
            *bishop, *spencer, format_share(*bishop / *spencer - 1));
      else
        say("Bishop ({:.3f}) lies {} Spencer ({:.3f}): it satisfies no horizontal equilibrium of the slices, which "
            "matters in this slope.",
            *bishop, compare(*bishop, *spencer), *spencer);
    }
    if (janbu && spencer && *janbu / *spencer < 1 - noticeable) {
      const double f0 = find_critical(summary_, "critical", "janbu").at("correction");
      const auto corrected = find_slices(summary_, "critical", "janbu_corrected");
      say("Simplified Janbu ({:.3f}) lies {} Spencer, as it leaves the shear between slices out{}.", *janbu,
          compare(*janbu, *spencer),
          corrected ? fmt::format("; with its correction it is {:.3f}", *corrected)
                    : (f0 != 1 ? fmt::format("; its correction would be {:.3f}", f0) : ""));
    }
    const auto polyline = find_slices(summary_, "noncircular", circle_key_);
    if (!circle_ || !polyline) return;
    if (*polyline / *circle_ < 1 - same)
      say("The best polyline ({}, {:.3f}) lies {} the best circle ({:.3f}): the weakest surface is no circle.",
          circle_name_, *polyline, compare(*polyline, *circle_), *circle_);
    else
      say("The best polyline ({}, {:.3f}) is no more than {} from the best circle: a circle is a fair shape of the "
          "mechanism here.",
          circle_name_, *polyline, format_share(*polyline / *circle_ - 1));
  }

  /// How much of the resistance on the critical circle is suction's.
  void read_suction() {
    const json& slices = get(find_critical(summary_, "critical", circle_key_), "slices");
    if (!slices.is_object()) return;
    double suction = 0, all = 0;
    for (std::size_t i = 0; i < slices.at("length").size(); ++i) {
      const double length = slices.at("length")[i], u = slices.at("pore_pressure")[i];
      const double friction = slices.at("tan_friction")[i], normal = slices.at("normal")[i];
      suction += slices.at("suction_strength")[i].get<double>() * length;
      all += slices.at("cohesion")[i].get<double>() * length +
             std::max(0.0, normal - std::max(0.0, u) * length) * friction;
    }
    if (!(all > 0) || suction < noticeable_suction * all) return;
    bool by_angle = false, by_saturation = false;
    for (const auto& [region, name] : data_.regions) {
      const input::SuctionStrength how = data_.materials.at(name).slices.suction_strength;
      by_angle = by_angle || how == input::SuctionStrength::phi_b;
      by_saturation =
          by_saturation || how == input::SuctionStrength::from_water || how == input::SuctionStrength::saturation;
    }
    say("Suction gives {} of the resistance on the critical circle of {}{}.", format_share(suction / all), circle_name_,
        by_angle && given_ ? "; the finite elements cannot take φ_b and leave it out"
        : by_saturation && (given_ != nullptr || associated_ != nullptr || frozen_)
            ? "; every method takes it as χ s with the same χ"
            : "");
  }

  void read_flow() {
    if (given_ && associated_) {
      const double a = given_->at("factor"), b = associated_->at("factor");
      if (std::abs(a / b - 1) < same / 2)
        say("The flow rule hardly matters: finite elements give {:.3f} with {} and {:.3f} with ψ = φ.", a,
            describe_flow(*given_), b);
      else
        say("The flow rule matters: finite elements give {:.3f} with ψ = φ and {:.3f}, {} it, with {}. Slices know no "
            "flow rule; their answer belongs to ψ = φ.",
            b, a, compare(a, b), describe_flow(*given_));
    } else if (given_ && circle_ && is_nonassociated()) {
      const double f = given_->at("factor");
      if (f / *circle_ < 1 - same)
        say("The finite elements flow with {} < φ, slices know no flow rule: [fem] flow = \"both\" shows how much of "
            "the "
            "difference ({} {}) that is.",
            describe_flow(*given_), compare(f, *circle_), circle_name_);
    }
  }

  bool is_nonassociated() const {
    return std::any_of(data_.regions.begin(), data_.regions.end(), [&](const auto& region) {
      const input::Material& m = data_.materials.at(region.second);
      return m.friction_angle > 0 && m.dilatancy_angle < m.friction_angle - 1e-9;
    });
  }

  void read_element_criterion() {
    for (const json* run : {given_, associated_}) {
      if (run == nullptr) continue;
      const auto other = get_number(*run, "by_displacement");
      const double f = run->at("factor");
      if (!other || std::abs(*other / f - 1) < same) continue;
      say("With {} the criteria of the finite elements differ: displacements run away at {:.3f}, {} the factor without "
          "equilibrium ({:.3f}).",
          describe_flow(*run), *other, compare(*other, f), f);
    }
  }

  /// Finite elements against slices.
  void read_elements() {
    const json* run = associated_ ? associated_ : given_;
    if (run == nullptr || !circle_) return;
    const double f = run->at("factor"), half = (run->at("failed").get<double>() - run->at("stable").get<double>()) / 2;
    if (std::abs(f - *circle_) <= half + same * *circle_)
      say("Finite elements ({}, {:.3f}) and {} ({:.3f}) agree within {}.", describe_flow(*run), f, circle_name_,
          *circle_, format_share(f / *circle_ - 1));
    else
      say("Finite elements ({}, {:.3f}) lie {} {} ({:.3f}){}.", describe_flow(*run), f, compare(f, *circle_),
          circle_name_, *circle_,
          f > *circle_ ? "; a finer mesh ([fem] size) shows whether the elements are too stiff" : "");
  }

  void read_points_mesh() {
    const json& frozen = get(get(summary_, "factor_of_safety"), "frozen");
    const json& meshes = list(frozen, "meshes");
    if (meshes.size() < 2) return;
    const double coarse = meshes[0].at("factor"), fine = meshes[1].at("factor"),
                 bracket = get_number(frozen, "uncertainty").value_or(0);
    if (std::abs(coarse - fine) <= bracket)
      say("Material points: halving the elements changes the factor by less than the width of the bracket ({:.3f} and "
          "{:.3f}).",
          coarse, fine);
    else
      say("Material points: {:.3f} on elements of {:g} m and {:.3f} on {:g} m, {:.3f} at size zero; {} is the share of "
          "the mesh in the factor on the coarse one.",
          coarse, meshes[0].at("size").get<double>(), fine, meshes[1].at("size").get<double>(), *frozen_,
          format_share(coarse / *frozen_ - 1));
  }

  void read_points_criterion() {
    for (const json& c : list(get(summary_, "factor_of_safety"), "criteria")) {
      const auto f = get_number(c, "factor");
      if (c.at("name") != "bilinear" || !f) continue;
      if (!frozen_) {
        if (circle_ && std::abs(*f / *circle_ - 1) > noticeable)
          say("The bilinear construction on the displacement curve of the material points gives {:.3f}, {} {}: it "
              "reads "
              "failure off the growth of displacements, not off equilibrium.",
              *f, compare(*f, *circle_), circle_name_);
        return;
      }
      if (std::abs(*f / *frozen_ - 1) > noticeable)
        say("The criterion matters: the same soil fails at {:.3f} by the bilinear construction on the displacement "
            "curve and at {:.3f} by rest or run-away; the bilinear one lies {} and reads the growth of displacements, "
            "not "
            "the loss of equilibrium.",
            *f, *frozen_, compare(*f, *frozen_));
    }
  }

  void read_points() {
    if (!frozen_) return;
    const json* run = given_ ? given_ : associated_;
    if (run == nullptr && !circle_) return;
    const double other = run ? run->at("factor").get<double>() : *circle_;
    const std::string words = run ? fmt::format("finite elements ({})", describe_flow(*run)) : circle_name_;
    if (std::abs(*frozen_ / other - 1) < noticeable)
      say("Material points at frozen geometry ({:.3f}) confirm {} ({:.3f}).", *frozen_, words, other);
    else
      say("Material points at frozen geometry ({:.3f}) lie {} {} ({:.3f}){}.", *frozen_, compare(*frozen_, other),
          words, other,
          is_extrapolated()
              ? ""
              : "; they are those of one mesh, and [strength_reduction.frozen] meshes = 2 shows its share");
  }

  bool is_extrapolated() const {
    return get(get(get(summary_, "factor_of_safety"), "frozen"), "extrapolated").is_number();
  }

  /// Whether the methods see one mechanism, and what slices say on the surfaces of the others.
  void read_surfaces() {
    if (circle_key_.empty() || !(height_ > 0)) return;
    const ground::Polyline circle = find_surface("lem." + circle_key_);
    if (circle.size() < 2) return;
    for (const json& s : list(methods_, "surfaces")) {
      if (s.at("method") == "lem") continue;
      const ground::Polyline line = find_surface(s.at("name"));
      if (line.size() < 2) continue;
      const double mean = find_mean_distance(circle, line);
      const bool both = given_ && associated_;
      const std::string rule = s.at("name").get<std::string>().find("associated") != std::string::npos
                                   ? " with ψ = φ"
                                   : (given_ ? " with " + describe_flow(*given_) : "");
      const std::string of = s.at("method") == "fem" ? "band of the finite elements" + (both ? rule : "")
                                                     : "slip line of the material points";
      const std::string handed = describe_handed(s.at("name"));
      const double size = s.at("method") == "fem" ? get_number(get(summary_, "fem"), "size").value_or(0)
                                                  : get_number(get(summary_, "mesh"), "mean_size").value_or(0);
      if (mean < std::max(same_surface * height_, size))
        say("One mechanism: the {} is on average {:.2g} m ({} of the height) from the critical circle of {}{}.", of,
            mean, format_share(mean / height_), circle_name_, handed);
      else
        say("The {} is on average {:.2g} m ({} of the height) from the critical circle of {}: the mechanisms "
            "differ{}{}.",
            of, mean, format_share(mean / height_), circle_name_, handed, describe_near_minimum(line, size));
    }
  }

  /// Another local minimum of the slices that is this mechanism.
  std::string describe_near_minimum(const ground::Polyline& line, double size) const {
    double nearest = std::max(same_surface * height_, size);
    std::string words;
    for (const json& m : list(get(get(summary_, "lem"), "minima"), circle_key_.c_str())) {
      const auto f = get_number(m, "factor");
      const ground::Polyline other = to_line(m.at("points"));
      if (!f || other.size() < 2) continue;
      const double mean = find_mean_distance(other, line);
      if (mean >= nearest) continue;
      nearest = mean;
      words = fmt::format("; a local minimum of {} ({:.3f}) lies {:.2g} m from it", circle_name_, *f, mean);
    }
    return words;
  }

  static ground::Polyline to_line(const json& points) {
    ground::Polyline line;
    for (const json& x : points) line.push_back({x.at(0).get<double>(), x.at(1).get<double>()});
    return line;
  }

  ground::Polyline find_surface(const std::string& name) const {
    for (const json& s : list(methods_, "surfaces"))
      if (s.at("name") == name) return to_line(s.at("points"));
    return {};
  }

  std::string describe_handed(const std::string& from) const {
    for (const json& h : list(methods_, "handed")) {
      const auto f = get_number(h, "factor");
      if (h.at("from") != from || h.at("to") != "spencer" || !f) continue;
      const auto own = find_slices(summary_, "critical", "spencer");
      return fmt::format(", and Spencer on it gives {:.3f}{}", *f,
                         own ? ", " + compare(*f, *own) + " that of the circle" : "");
    }
    return "";
  }

  void read_seconds() {
    std::vector<std::string> parts;
    const auto add = [&](const char* words, double seconds) {
      if (seconds > 0) parts.push_back(fmt::format("{} {:.3g} s", words, seconds));
    };
    add("slices", find_seconds(summary_, "lem"));
    add("finite elements", find_seconds(summary_, "fem"));
    for (const json& row : list(methods_, "table"))
      if (row.at("method") == "mpm" && row.at("seconds").is_number()) add("material points", row.at("seconds"));
    if (parts.size() > 1) say("Computing time: {}.", fmt::join(parts, ", "));
  }

  const input::Case& data_;
  const json &summary_, &methods_;
  double height_;
  std::optional<double> circle_, frozen_;
  std::string circle_name_, circle_key_;
  const json *given_ = nullptr, *associated_ = nullptr;
  json sentences_ = json::array();
};

}  // namespace

json read_differences(const input::Case& data, const json& summary, const json& methods) {
  return Reading(data, summary, methods).read();
}

}  // namespace talus::run
