// SPDX-License-Identifier: MIT
#include "output/plots/case_symbols.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/plots/gnuplot.hpp"

namespace talus::output {
namespace {

std::string stroke(const char* colour, double width, const char* more = "") {
  return fmt::format("stroke=\"{}\" stroke-width=\"{:g}\" {}", colour, width, more);
}

Pixel move(const Pixel& p, const Pixel& direction, double by) {
  return {p.x + by * direction.x, p.y + by * direction.y};
}

std::string group(const char* name, const std::string& elements) {
  return fmt::format("<g class=\"{}\">\n{}</g>\n", name, elements);
}

/// Returns the normal on the side of `outward`, a direction of the section.
Pixel turn_outward(const Pixel& normal, const std::array<double, 2>& outward) {
  const bool same = normal.x * outward[0] - normal.y * outward[1] >= 0;
  return same ? normal : Pixel{-normal.x, -normal.y};
}

/// Short oblique strokes outside a line: soil or rock that does not move.
std::string hatch(const std::vector<Pixel>& line, const std::array<double, 2>& outward) {
  std::string text = write_line(line, stroke(colour::ink, 1.6));
  for (const AlongLine& p : divide_line(line, 9, 3)) {
    const Pixel out = turn_outward(p.normal, outward);
    const Pixel along{-out.y, out.x};
    text += write_line({p.at, move(move(p.at, out, 8), along, 6)}, stroke(colour::ink, 0.9));
  }
  return text;
}

std::string draw_rollers(const std::vector<Pixel>& line, const std::array<double, 2>& outward) {
  constexpr double radius = 3.2;
  std::string text;
  std::vector<Pixel> outer;
  for (const AlongLine& p : divide_line(line, 15, 3)) {
    const Pixel out = turn_outward(p.normal, outward);
    text += write_circle(move(p.at, out, radius + 0.8), radius, "fill=\"#ffffff\" " + stroke(colour::ink, 1));
    outer.push_back(move(p.at, out, 2 * radius + 1.6));
  }
  return write_line(line, stroke(colour::ink, 1.2)) + text + write_line(outer, stroke(colour::ink, 1));
}

}  // namespace

std::vector<Pixel> View::operator()(const std::vector<results::Point>& line) const {
  std::vector<Pixel> pixels;
  pixels.reserve(line.size());
  for (const results::Point& p : line) pixels.push_back((*this)(p));
  return pixels;
}

std::vector<AlongLine> divide_line(const std::vector<Pixel>& line, double spacing, std::size_t least) {
  constexpr std::size_t most = 200;
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
  if (!(length > 0) || !std::isfinite(length)) return {};
  const double wanted = std::min(length / spacing + 1, static_cast<double>(most));
  const std::size_t count = std::max(least, static_cast<std::size_t>(wanted));
  std::vector<AlongLine> points;
  double before = 0;
  std::size_t k = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Pixel &a = line[i - 1], &b = line[i];
    const double part = std::hypot(b.x - a.x, b.y - a.y);
    if (!(part > 0)) continue;
    const auto at = [&](std::size_t n) {
      return count == 1 ? length / 2 : length * static_cast<double>(n) / static_cast<double>(count - 1);
    };
    for (; k < count && at(k) <= (before + part) * (1 + 1e-12); ++k) {
      const double t = std::clamp((at(k) - before) / part, 0.0, 1.0);
      points.push_back({{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)},
                        {(b.y - a.y) / part, -(b.x - a.x) / part},
                        at(k) / length,
                        i - 1,
                        t});
    }
    before += part;
  }
  return points;
}

const char* get_colour(WaterSideKind kind) {
  switch (kind) {
    case WaterSideKind::head:
      return "#0d47a1";
    case WaterSideKind::pressure:
      return "#5e35b1";
    case WaterSideKind::seepage_face:
      return "#00897b";
    case WaterSideKind::rain:
      return "#0288d1";
    case WaterSideKind::flux:
      return "#ad1457";
    case WaterSideKind::no_flow:
      return "#616161";
  }
  return colour::water;
}

const char* get_title(WaterSideKind kind) {
  switch (kind) {
    case WaterSideKind::head:
      return "total head";
    case WaterSideKind::pressure:
      return "pore pressure";
    case WaterSideKind::seepage_face:
      return "seepage face";
    case WaterSideKind::rain:
      return "rain or evaporation";
    case WaterSideKind::flux:
      return "flux";
    case WaterSideKind::no_flow:
      return "no flow";
  }
  return "";
}

const char* get_title(SupportKind kind) {
  switch (kind) {
    case SupportKind::fixed:
      return "fixed: no motion";
    case SupportKind::rollers:
      return "rollers: no motion across";
    case SupportKind::plane:
      return "no motion along a normal";
    case SupportKind::wall:
      return "rough wall";
    case SupportKind::moving:
      return "prescribed velocity";
  }
  return "";
}

std::string draw_support(const CasePicture::Support& support, const View& view) {
  const std::vector<Pixel> line = view(support.line);
  std::string text;
  switch (support.kind) {
    case SupportKind::fixed:
    case SupportKind::wall:
      text = hatch(line, support.outward);
      break;
    case SupportKind::rollers:
    case SupportKind::plane:
      text = draw_rollers(line, support.outward);
      break;
    case SupportKind::moving:
      for (const AlongLine& p : divide_line(line, 40, 3))
        text += write_arrow(move(p.at, {support.outward[0], -support.outward[1]}, -18), p.at, colour::ink);
      text += write_line(line, stroke(colour::ink, 1.6));
  }
  return group("support", text);
}

std::string draw_water_side(const CasePicture::WaterSide& side, const View& view) {
  const std::vector<Pixel> line = view(side.line);
  const char* ink = get_colour(side.kind);
  const char* dashes = side.kind == WaterSideKind::seepage_face ? "stroke-dasharray=\"10 4\""
                       : side.kind == WaterSideKind::no_flow    ? "stroke-dasharray=\"3 3\""
                                                                : "";
  std::string text = write_line(line, stroke(ink, 4, "stroke-opacity=\"0.8\" ") + dashes);
  if (side.kind == WaterSideKind::rain)
    for (const AlongLine& p : divide_line(line, 34, 2))
      text += write_arrow({p.at.x, p.at.y - 17}, {p.at.x, p.at.y - 4}, ink);
  return group("hydraulic", text);
}

double find_largest_load(const std::vector<CasePicture::Load>& loads) {
  double most = 0;
  for (const CasePicture::Load& load : loads)
    for (const auto& q : load.load) most = std::max(most, std::hypot(q[0], q[1]));
  return most;
}

std::string draw_load(const CasePicture::Load& load, double most, const View& view) {
  constexpr double shortest = 12;
  const std::vector<Pixel> line = view(load.line);
  std::string text;
  std::vector<Pixel> tails;
  for (const AlongLine& p : divide_line(line, 22, 2)) {
    if (p.segment + 1 >= load.load.size()) break;
    const auto &a = load.load[p.segment], &b = load.load[p.segment + 1];
    const std::array q{a[0] + p.within_segment * (b[0] - a[0]), a[1] + p.within_segment * (b[1] - a[1])};
    const double size = std::hypot(q[0], q[1]);
    if (!(size > 0) || !(most > 0)) {
      tails.push_back(p.at);
      continue;
    }
    const double length = shortest + (load_arrow - shortest) * size / most;
    const Pixel to{q[0] / size, -q[1] / size};
    // Arrows along the line would hide one another and the line: they are short and stand above it.
    const double across = std::abs(to.x * p.normal.x + to.y * p.normal.y);
    const bool is_along = across < 0.2;
    const Pixel up = p.normal.y < 0 ? p.normal : Pixel{-p.normal.x, -p.normal.y};
    const Pixel tip = is_along ? move(p.at, up, 6) : p.at;
    const Pixel tail = move(tip, to, is_along ? -std::min(length, 16.0) : -length);
    text += write_arrow(tail, tip, colour::load);
    tails.push_back(tail);
  }
  return group("load", write_line(tails, stroke(colour::load, 1.4)) + text);
}

Box find_extent(const CasePicture& picture) {
  Box box;
  const auto include = [&](const std::vector<results::Point>& line) {
    for (const results::Point& p : line)
      if (std::isfinite(p[0]) && std::isfinite(p[1])) box.include(p[0], p[1]);
  };
  for (const auto& soil : picture.soils) include(soil.outline);
  for (const auto& line : picture.lines) include(line.points);
  include(picture.box);
  for (const auto& side : picture.soil_sides) include({side[0], side[1]});
  for (const auto& pond : picture.ponds) include(pond);
  for (const auto& load : picture.loads) include(load.line);
  for (const auto& surface : picture.surfaces) include(surface.points);
  for (const auto& bar : picture.bars) include({bar.head, bar.end});
  if (picture.centres) include({picture.centres->from, picture.centres->to});
  for (const auto& zone : picture.zones) include(zone.points);
  return box;
}

std::string draw_bar(const CasePicture::Bar& bar, const View& view) {
  const Pixel head = view(bar.head), end = view(bar.end);
  const Pixel from{head.x + bar.free_share * (end.x - head.x), head.y + bar.free_share * (end.y - head.y)};
  std::string text =
      write_line({head, end}, stroke(colour::bar, 1.4)) + write_line({from, end}, stroke(colour::bar, 3));
  const double length = std::hypot(end.x - head.x, end.y - head.y), plate = 5;
  if (length > 0) {
    const Pixel across{-(end.y - head.y) / length, (end.x - head.x) / length};
    text += write_line({move(head, across, plate), move(head, across, -plate)}, stroke(colour::bar, 2));
  }
  return group("bar", text);
}

std::string draw_roots(const CasePicture::RootZone& roots, const View& view) {
  const std::vector<Pixel> line = view(roots.ground);
  const double depth = roots.depth * view.scale;
  std::vector<Pixel> zone = line;
  std::string text;
  const std::vector<AlongLine> points = divide_line(line, 14, 2);
  for (const AlongLine& p : points) {
    const Pixel down = p.normal.y > 0 ? p.normal : Pixel{-p.normal.x, -p.normal.y};
    const Pixel side{-down.y, down.x};
    for (const double spread : {-3.0, 0.0, 3.0})
      text += write_line({p.at, move(move(p.at, down, spread == 0 ? depth : 0.7 * depth), side, spread)},
                         stroke(colour::roots, 0.9));
  }
  for (auto p = points.rbegin(); p != points.rend(); ++p)
    zone.push_back(move(p->at, p->normal.y > 0 ? p->normal : Pixel{-p->normal.x, -p->normal.y}, depth));
  return group("roots", write_polygon(zone, fmt::format("fill=\"{}\" fill-opacity=\"0.18\"", colour::roots)) + text);
}

std::string draw_range(const CasePicture::GroundRange& range, const View& view) {
  constexpr double above = 7;
  std::vector<Pixel> line = view(range.ground);
  for (Pixel& p : line) p.y -= above;
  const char* ink = range.is_entry ? colour::entry : colour::exit;
  std::string text = write_line(line, stroke(ink, 2, "stroke-opacity=\"0.8\""));
  for (const Pixel& end : {line.front(), line.back()})
    text += write_line({{end.x, end.y - 5}, {end.x, end.y + above}}, stroke(ink, 2));
  return group("range", text);
}

const char* get_colour(SearchZoneKind kind) {
  return kind == SearchZoneKind::excluded  ? colour::load
         : kind == SearchZoneKind::tangent ? colour::exit
                                           : colour::entry;
}

const char* get_title(SearchZoneKind kind) {
  switch (kind) {
    case SearchZoneKind::window:
      return "window with a vertex of each slip surface";
    case SearchZoneKind::passage:
      return "window that each slip surface passes";
    case SearchZoneKind::excluded:
      return "area without slip surfaces";
    default:
      return "tangent of each slip circle";
  }
}

std::string draw_zone(const CasePicture::SearchZone& zone, const View& view) {
  const std::string ink = stroke(get_colour(zone.kind), 1.4,
                                 zone.kind == SearchZoneKind::window     ? ""
                                 : zone.kind == SearchZoneKind::excluded ? "stroke-dasharray=\"2 2\""
                                                                         : "stroke-dasharray=\"8 3\"");
  const std::vector<Pixel> points = view(zone.points);
  std::string text;
  if (points.size() == 1)
    text = write_circle(points.front(), 4, "fill=\"none\" " + ink);
  else if (zone.is_closed)
    text = write_polygon(points, fmt::format("fill=\"{}\" fill-opacity=\"{}\" ", get_colour(zone.kind),
                                             zone.kind == SearchZoneKind::excluded ? 0.25 : 0.1) +
                                     ink);
  else
    text = write_line(points, ink);
  return group("search-zone", text);
}

std::string draw_sample(const CasePicture::SearchZone& zone) {
  CasePicture::SearchZone sample{zone.kind, "", {{0, 0}, {28, 0}}, zone.is_closed};
  if (zone.points.size() == 1) sample.points = {{14, 0}};
  if (zone.is_closed) sample.points = {{2, -5}, {26, -5}, {26, 5}, {2, 5}};
  return draw_zone(sample, View{1, 0, 0});
}

std::vector<Pixel> place_name(const CasePicture::SearchZone& zone, const View& view) {
  std::vector<Pixel> line = view(zone.points);
  if (line.size() > 1) return line;
  return {{line[0].x - 5, line[0].y}, {line[0].x + 5, line[0].y}};
}

std::string draw_centres(const CasePicture::CentreGrid& grid, const View& view) {
  constexpr int most = 30;  // centres that are drawn along a side
  const Pixel a = view(grid.from), b = view(grid.to);
  std::string text = write_polygon({a, {b.x, a.y}, b, {a.x, b.y}},
                                   "fill=\"none\" " + stroke(colour::exit, 0.8, "stroke-dasharray=\"4 3\""));
  const int columns = std::min(grid.columns, most), rows = std::min(grid.rows, most);
  const auto share = [](int i, int n) { return n > 1 ? static_cast<double>(i) / (n - 1) : 0.5; };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j)
      text += write_circle({a.x + share(i, columns) * (b.x - a.x), a.y + share(j, rows) * (b.y - a.y)}, 1.2,
                           fmt::format("fill=\"{}\"", colour::exit));
  return group("centres", text);
}

std::string draw_axes(const View& view, const Rectangle& frame, const ShownUnit& length) {
  const double unit = length.si;
  std::string text = write_polygon(
      {{frame.left, frame.top}, {frame.right, frame.top}, {frame.right, frame.bottom}, {frame.left, frame.bottom}},
      fmt::format("class=\"frame\" fill=\"none\" stroke=\"{}\" stroke-width=\"0.8\"", "#d5dae1"));
  double widest = 0;  // widest number at the y axis [px]
  const auto write_axis = [&](bool is_x) {
    const double from = (is_x ? (frame.left - view.x0) : (view.y0 - frame.bottom)) / view.scale / unit,
                 to = (is_x ? (frame.right - view.x0) : (view.y0 - frame.top)) / view.scale / unit;
    const double step = find_tic_step(to - from, is_x ? 12 : std::max(3.0, (frame.bottom - frame.top) / 45));
    const int decimals = std::clamp(-static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 6);
    const TextStyle style{
        .size = 11, .anchor = is_x ? Anchor::middle : Anchor::end, .colour = colour::muted, .halo = false};
    for (double n = std::ceil(from / step - 1e-9); n * step <= to * (1 + 1e-12) + 1e-9 * step; ++n) {
      const double value = n * step;
      std::string label = std::abs(step) < 1e6 && std::abs(value) < 1e9 ? fmt::format("{:.{}f}", value, decimals)
                                                                        : fmt::format("{:.4g}", value);
      if (n == 0) label = "0";
      if (!is_x) widest = std::max(widest, estimate_text_width(label, style.size));
      const Pixel at = is_x ? Pixel{view.x0 + view.scale * value * unit, frame.bottom}
                            : Pixel{frame.left, view.y0 - view.scale * value * unit};
      text += write_line({at, is_x ? Pixel{at.x, at.y + 5} : Pixel{at.x - 5, at.y}}, "stroke=\"#5b6675\"");
      text += write_text(is_x ? Pixel{at.x, at.y + 14} : Pixel{at.x - 8, at.y}, label, style);
    }
  };
  write_axis(true);
  write_axis(false);
  const TextStyle name{.size = 12, .anchor = Anchor::middle, .colour = colour::muted, .halo = false};
  return text + write_text({(frame.left + frame.right) / 2, frame.bottom + 31}, make_label("x", length.name), name) +
         fmt::format("<g transform=\"translate({:.2f} {:.2f}) rotate(-90)\">{}</g>\n",
                     std::clamp(frame.left - widest - 17, 7.0, 16.0), (frame.top + frame.bottom) / 2,
                     write_text({0, 0}, make_label("y", length.name), name));
}

}  // namespace talus::output
