// SPDX-License-Identifier: MIT
#include "output/plots/case_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/numbers.hpp"
#include "output/plots/case_symbols.hpp"
#include "output/plots/field_plot.hpp"
#include "output/plots/gnuplot.hpp"

namespace talus::output {
namespace {

using Point = results::Point;

constexpr double page_width = 1000, frame_left = 72, frame_right = 24, heading = 44;  ///< [px]
constexpr double pad_side = 60, pad_top = 46, pad_bottom = 40;  ///< between frame and section [px]
constexpr double most_height = 560, least_height = 150;         ///< of the section [px]
constexpr double row = 20;                                      ///< of legend and notes [px]
constexpr std::size_t most_messages = 300, most_names = 120;

/// Colours of the soils in the report (web/src/viewer/colours.ts).
constexpr const char* soil_colours[] = {"#e69f00", "#999999", "#009e73", "#d55e00",
                                        "#f0e442", "#cc79a7", "#7a4a24", "#6b4c9a"};

/// A name with the places on the page where it may stand, the best one first.
struct Label {
  std::string text;
  TextStyle style;
  std::vector<Pixel> places;
  bool is_needed = true;  ///< false: it is left out where no place is free
};

class Drawing {
 public:
  explicit Drawing(const CasePicture& picture) : picture_(picture), places_(fit()) {}

  std::string write();

 private:
  Rectangle fit();
  void draw_section();
  void draw_soils();
  void draw_mesh();
  void draw_water();
  void draw_loads();
  void draw_bars();
  void draw_search();
  void draw_zones();
  void mark_messages();
  void name_soils();
  void add_label(const Label& label);
  void avoid(const std::vector<Point>& line);
  void name_line(const std::string& text, const std::vector<Pixel>& line, const char* ink, bool is_needed = true);
  std::string draw_legend(double& top) const;
  std::string list_notes(double& top) const;
  std::string list_messages(double& top) const;
  const char* find_soil_colour(const std::string& material) const;
  std::string write_number(std::size_t number, const Pixel& at) const;
  bool has_section() const { return view_.scale > 0; }

  struct Entry {
    std::string sample, text;  ///< `sample`: elements around (0, 0), 28 px wide
  };

  const CasePicture& picture_;
  View view_{.scale = 0};
  Rectangle frame_;
  LabelPlaces places_;
  std::map<std::string, std::size_t> material_index_;
  std::string drawn_, labels_, marks_;
  std::size_t names_ = 0;  ///< of lines
  std::vector<Entry> legend_;
};

/// Sets view and frame, so that everything that belongs to the section is visible.
Rectangle Drawing::fit() {
  const Box box = find_extent(picture_);
  const double width = box.x1 - box.x0, height = box.y1 - box.y0, frame_width = page_width - frame_left - frame_right;
  frame_ = {frame_left, heading, page_width - frame_right, heading + 60};
  if (!(width >= 0) || !(height >= 0) || !(std::max(width, height) > 0) || !std::isfinite(width + height))
    return frame_;
  view_.scale = std::min((frame_width - 2 * pad_side) / width, most_height / height);
  const double drawn = std::max(least_height, height * view_.scale);
  // Loads stand above the ground, with their names.
  const double top =
      pad_top + (picture_.loads.empty() ? 0 : load_arrow) + 20 * static_cast<double>(picture_.shaking.size());
  frame_.bottom = frame_.top + top + drawn + pad_bottom;
  view_.x0 = (frame_.left + frame_.right) / 2 - view_.scale * (box.x0 + box.x1) / 2;
  view_.y0 = frame_.top + top + drawn / 2 + view_.scale * (box.y0 + box.y1) / 2;
  return frame_;
}

const char* Drawing::find_soil_colour(const std::string& material) const {
  const auto found = material_index_.find(material);
  return found == material_index_.end() ? "#ffffff" : soil_colours[found->second % std::size(soil_colours)];
}

void Drawing::add_label(const Label& label) {
  const double width = estimate_text_width(label.text, label.style.size), half = 0.62 * label.style.size;
  std::vector<Rectangle> rectangles;
  for (const Pixel& p : label.places) {
    const double left = label.style.anchor == Anchor::start    ? p.x
                        : label.style.anchor == Anchor::middle ? p.x - width / 2
                                                               : p.x - width;
    rectangles.push_back({left - 2, p.y - half, left + width + 2, p.y + half});
  }
  const std::size_t at = places_.choose(rectangles, !label.is_needed);
  if (at < label.places.size()) labels_ += write_text(label.places[at], label.text, label.style);
}

/// Keeps labels off a line.
void Drawing::avoid(const std::vector<Point>& line) {
  constexpr double half = 2;
  for (const AlongLine& p : divide_line(view_(line), 10, 2))
    places_.occupy({p.at.x - half, p.at.y - half, p.at.x + half, p.at.y + half});
}

/// Names a line beside its middle, or elsewhere along it.
void Drawing::name_line(const std::string& text, const std::vector<Pixel>& line, const char* ink, bool is_needed) {
  if (++names_ > most_names) return;
  std::vector<AlongLine> along = divide_line(line, 1e9, 9);
  std::ranges::stable_sort(along, {}, [](const AlongLine& p) { return std::abs(p.fraction - 0.5); });
  Label label{shorten(text, 60), {.size = 11, .anchor = Anchor::middle, .colour = ink}, {}, is_needed};
  const double half_width = estimate_text_width(label.text, 11) / 2;
  for (const double off : {13.0, 26.0, 40.0})
    for (const AlongLine& p : along)
      for (const double side : {1.0, -1.0}) {
        const Pixel normal{side * p.normal.x, side * p.normal.y};
        // Beside a steep line the text stands at its side.
        const double shift = std::abs(normal.x) > 0.5 ? std::copysign(half_width, normal.x) : 0;
        label.places.push_back({p.at.x + off * normal.x + shift, p.at.y + off * normal.y});
      }
  add_label(label);
}

void Drawing::draw_soils() {
  for (const auto& soil : picture_.soils) {
    const std::vector<Pixel> corners = view_(soil.outline);
    drawn_ += write_polygon(corners, "fill=\"#ffffff\"");
    drawn_ += write_polygon(
        corners, fmt::format("class=\"soil\" data-region=\"{}\" data-material=\"{}\" fill=\"{}\" "
                             "fill-opacity=\"0.4\" stroke=\"{}\" stroke-width=\"1\" "
                             "stroke-linejoin=\"round\"{}",
                             escape_xml(soil.region), escape_xml(soil.material), find_soil_colour(soil.material),
                             colour::ink, soil.material.empty() ? " stroke-dasharray=\"5 3\"" : ""));
  }
  if (picture_.box.size() > 2)
    drawn_ += write_polygon(view_(picture_.box), fmt::format("class=\"box\" fill=\"none\" stroke=\"{}\" "
                                                             "stroke-width=\"1\" stroke-dasharray=\"6 4\"",
                                                             colour::muted));
}

void Drawing::draw_mesh() {
  const auto draw = [&](const std::vector<CasePicture::Side>& sides, const char* ink) {
    if (sides.empty()) return;
    std::string path;
    for (const CasePicture::Side& side : sides) {
      const Pixel a = view_(side[0]), b = view_(side[1]);
      path += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", a.x, a.y, b.x, b.y);
    }
    drawn_ +=
        fmt::format("<path class=\"mesh\" d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"0.4\"/>\n", path, ink);
  };
  draw(picture_.empty_sides, "#c3cad3");
  draw(picture_.soil_sides, "#5b6675");
  if (!picture_.soil_sides.empty())
    legend_.push_back(
        {write_polygon({{2, 7}, {14, -7}, {26, 7}}, "fill=\"none\" stroke=\"#5b6675\" stroke-width=\"0.6\""), "mesh"});
}

void Drawing::draw_water() {
  const std::string surface = fmt::format("stroke=\"{}\" stroke-width=\"1.3\"", colour::water);
  for (const auto& pond : picture_.ponds)
    drawn_ +=
        write_polygon(view_(pond), fmt::format("class=\"pond\" fill=\"{}\" fill-opacity=\"0.22\"", colour::water));
  for (const Point& level : picture_.pond_levels) {
    const Pixel at = view_(level);
    drawn_ += write_level_symbol(at, colour::water);
    places_.occupy({at.x - 8, at.y - 12, at.x + 8, at.y + 8});
  }
  if (!picture_.ponds.empty())
    legend_.push_back({write_polygon({{0, -6}, {28, -6}, {28, 6}, {0, 6}},
                                     fmt::format("fill=\"{}\" fill-opacity=\"0.22\"", colour::water)),
                       "free water"});
  for (const auto& table : picture_.water_tables) {
    const char* ink = table.is_later ? colour::later_water : colour::water;
    const std::vector<Pixel> line = view_(table.points);
    const std::string style = fmt::format("stroke=\"{}\" stroke-width=\"1.8\" stroke-dasharray=\"9 3 2 3\"", ink);
    drawn_ += write_line(line, "class=\"water-table\" " + style);
    if (const auto along = divide_line(line, 1e9, 9); along.size() > 2) {
      const Pixel at = along[table.is_later ? along.size() - 3 : 2].at;
      drawn_ += write_level_symbol(at, ink);
      places_.occupy({at.x - 8, at.y - 12, at.x + 8, at.y + 8});
    }
    name_line(table.name, line, ink, false);
    legend_.push_back({write_line({{0, 0}, {28, 0}}, style), table.name});
  }
  std::set<WaterSideKind> kinds;
  for (const auto& side : picture_.water_sides) {
    drawn_ += draw_water_side(side, view_);
    name_line(side.text, view_(side.line), get_colour(side.kind));
    if (kinds.insert(side.kind).second)
      legend_.push_back(
          {write_line({{0, 0}, {28, 0}}, fmt::format("stroke=\"{}\" stroke-width=\"4\"", get_colour(side.kind))),
           get_title(side.kind)});
  }
}

void Drawing::draw_loads() {
  double y = frame_.top + 16;
  for (const auto& shaking : picture_.shaking) {
    const double length = 34, x = frame_.left + 60;
    const std::array<double, 2>& d = shaking.direction;
    drawn_ += "<g class=\"earthquake\">\n" +
              write_arrow({x - length / 2 * d[0], y + length / 2 * d[1]},
                          {x + length / 2 * d[0], y - length / 2 * d[1]}, colour::load) +
              "</g>\n";
    const double width = estimate_text_width(shaking.text, 11);
    labels_ += write_text({x + length / 2 + 8, y}, shaking.text, {.size = 11, .colour = colour::load});
    places_.occupy({x - length, y - 9, x + length / 2 + 8 + width, y + 9});
    y += d[1] != 0 ? 44 : 20;
  }
  const double most = find_largest_load(picture_.loads);
  for (const auto& load : picture_.loads) {
    if (load.line.size() < 2) continue;
    drawn_ += draw_load(load, most, view_);
    Box box;
    for (const Pixel& p : view_(load.line)) box.include(p.x, p.y);
    places_.occupy({box.x0, box.y0 - load_arrow, box.x1, box.y0});
    const double x = (box.x0 + box.x1) / 2, top = box.y0 - load_arrow - 10;
    add_label({shorten(load.text, 60),
               {.size = 11, .anchor = Anchor::middle, .colour = colour::load},
               {{x, top}, {x, top - 14}, {x - 60, top}, {x + 60, top}, {x, top - 28}, {x, box.y1 + 14}}});
  }
  if (!picture_.loads.empty()) legend_.push_back({write_arrow({14, -9}, {14, 9}, colour::load), "load"});
  std::set<SupportKind> kinds;
  for (const auto& support : picture_.supports) {
    drawn_ += draw_support(support, view_);
    if (kinds.insert(support.kind).second)
      legend_.push_back(
          {draw_support({support.kind, {{0, 0}, {28, 0}}, "", {0, -1}}, View{1, 0, -3}), get_title(support.kind)});
  }
  for (const auto& support : picture_.supports)
    if (!support.text.empty()) name_line(support.text, view_(support.line), colour::ink, false);
}

/// Draws the windows, areas and tangents that restrict slip surfaces.
void Drawing::draw_zones() {
  std::set<SearchZoneKind> kinds;
  for (const auto& zone : picture_.zones) {
    if (zone.points.empty()) continue;
    drawn_ += draw_zone(zone, view_);
    name_line(zone.text, place_name(zone, view_), get_colour(zone.kind));
    if (kinds.insert(zone.kind).second) legend_.push_back({draw_sample(zone), get_title(zone.kind)});
  }
}

void Drawing::draw_bars() {
  for (const auto& bar : picture_.bars) {
    drawn_ += draw_bar(bar, view_);
    if (!bar.text.empty()) name_line(bar.text, {view_(bar.head), view_(bar.end)}, colour::bar);
  }
  if (!picture_.bars.empty())
    legend_.push_back({draw_bar({"", {0, 0}, {28, 0}, 0.4}, View{1, 0, 0}), "bar with its bonded part"});
}

void Drawing::draw_search() {
  for (const auto& zone : picture_.roots) {
    drawn_ += draw_roots(zone, view_);
    name_line(zone.text, view_(zone.ground), colour::roots);
  }
  if (!picture_.roots.empty())
    legend_.push_back({write_polygon({{0, -6}, {28, -6}, {28, 6}, {0, 6}},
                                     fmt::format("fill=\"{}\" fill-opacity=\"0.18\"", colour::roots)),
                       "roots"});
  for (const auto& range : picture_.ranges) {
    if (range.ground.size() < 2) continue;
    drawn_ += draw_range(range, view_);
    std::vector<Pixel> line = view_(range.ground);
    for (Pixel& p : line) p.y -= 7;
    name_line(range.text, line, range.is_entry ? colour::entry : colour::exit);
  }
  if (picture_.centres) {
    const CasePicture::CentreGrid& grid = *picture_.centres;
    drawn_ += draw_centres(grid, view_);
    const Pixel a = view_(grid.from), b = view_(grid.to);
    for (const double level : grid.levels) {
      const double y = view_({0, level}).y;
      drawn_ +=
          write_line({{frame_.left, y}, {frame_.right, y}},
                     fmt::format("class=\"level-line\" stroke=\"{}\" stroke-width=\"0.8\" stroke-dasharray=\"2 4\"",
                                 colour::exit));
    }
    const double x = (a.x + b.x) / 2;
    add_label({shorten(grid.text, 80),
               {.size = 11, .anchor = Anchor::middle, .colour = colour::exit},
               {{x, std::min(a.y, b.y) - 9}, {x, std::max(a.y, b.y) + 9}}});
  }
  const std::string style = fmt::format("stroke=\"{}\" stroke-width=\"1.6\" stroke-dasharray=\"7 3\"", colour::surface);
  for (const auto& surface : picture_.surfaces) {
    drawn_ += write_line(view_(surface.points), "class=\"surface\" " + style);
    name_line(surface.name, view_(surface.points), colour::surface);
  }
  if (!picture_.surfaces.empty()) legend_.push_back({write_line({{0, 0}, {28, 0}}, style), "given slip surface"});
  for (const auto& line : picture_.lines) {
    drawn_ +=
        write_line(view_(line.points), fmt::format("class=\"line\" stroke=\"{}\" stroke-width=\"1.2\"", colour::ink));
    if (!line.name.empty()) name_line(line.name, view_(line.points), colour::ink, false);
  }
}

/// Names the regions where there is room, with their materials where those have other names.
void Drawing::name_soils() {
  std::size_t named = 0;
  for (const auto& soil : picture_.soils) {
    if (++named > most_names || soil.outline.size() < 3) continue;
    const std::vector<Pixel> corners = view_(soil.outline);
    Box box;
    for (const Pixel& p : corners) box.include(p.x, p.y);
    const std::string material = soil.material.empty() ? "no material" : soil.material;
    const std::string whole = soil.region == soil.material ? soil.region : soil.region + ": " + material;
    const double size = box.y1 - box.y0 < 14 ? 10 : 12;
    std::string text = shorten(whole, 50);
    if (estimate_text_width(text, size) > box.x1 - box.x0) text = shorten(soil.region, 30);
    const std::vector<Pixel> rooms = list_rooms(corners, estimate_text_width(text, size));
    add_label({text, {.size = size, .anchor = Anchor::middle}, rooms, false});
  }
}

std::string Drawing::write_number(std::size_t number, const Pixel& at) const {
  const bool is_error = picture_.messages[number - 1].is_error;
  return write_circle(at, 9,
                      fmt::format("fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"1.2\"",
                                  is_error ? colour::error : colour::warning)) +
         write_text(at, std::to_string(number),
                    {.size = number > 99 ? 8.0 : 11.0,
                     .anchor = Anchor::middle,
                     .colour = "#ffffff",
                     .halo = false,
                     .bold = true});
}

/// Marks the places of messages. A number stands beside its place, since the place itself is what the reader looks for.
void Drawing::mark_messages() {
  if (!has_section()) return;
  constexpr double radius = 10;
  for (std::size_t i = 0; i < std::min(picture_.messages.size(), most_messages); ++i) {
    const CasePicture::Message& message = picture_.messages[i];
    if (!message.place || !std::isfinite((*message.place)[0]) || !std::isfinite((*message.place)[1])) continue;
    const Pixel at = view_(*message.place);
    const Pixel dot{std::clamp(at.x, frame_.left, frame_.right), std::clamp(at.y, frame_.top, frame_.bottom)};
    std::vector<Pixel> around;
    std::vector<Rectangle> rectangles;
    for (const double distance : {20.0, 32.0, 46.0, 62.0, 80.0})
      for (int k = 0; k < 12; ++k) {
        const double angle = 3.14159265358979 * (0.25 + k / 6.0);
        const Pixel centre{dot.x + distance * std::cos(angle), dot.y - distance * std::sin(angle)};
        around.push_back(centre);
        rectangles.push_back({centre.x - radius, centre.y - radius, centre.x + radius, centre.y + radius});
      }
    const Pixel number = around[places_.choose(rectangles, false)];
    const char* ink = message.is_error ? colour::error : colour::warning;
    const bool is_visible = dot.x == at.x && dot.y == at.y;
    marks_ += fmt::format("<g class=\"mark {}\" data-number=\"{}\" data-x=\"{}\" data-y=\"{}\">\n",
                          message.is_error ? "error" : "warning", i + 1,
                          write_shortest(round_to_digits((*message.place)[0] / picture_.length.si, 9)),
                          write_shortest(round_to_digits((*message.place)[1] / picture_.length.si, 9)));
    marks_ += write_line({dot, number}, fmt::format("stroke=\"{}\" stroke-width=\"1.3\"", ink)) +
              write_circle(dot, 3.2,
                           is_visible ? fmt::format("fill=\"{}\" stroke=\"#ffffff\"", ink)
                                      : fmt::format("fill=\"#ffffff\" stroke=\"{}\"", ink)) +
              write_number(i + 1, number) + "</g>\n";
  }
}

void Drawing::draw_section() {
  std::vector<std::string> regions_of;
  for (const auto& soil : picture_.soils) {
    if (soil.material.empty()) continue;
    const auto [entry, is_new] = material_index_.try_emplace(soil.material, material_index_.size());
    if (is_new) regions_of.emplace_back();
    std::string& regions = regions_of[entry->second];
    if (soil.region != soil.material) regions += (regions.empty() ? "" : ", ") + soil.region;
  }
  for (std::size_t i = 0; i < regions_of.size(); ++i)
    for (const auto& [material, index] : material_index_)
      if (index == i)
        legend_.push_back(
            {write_polygon({{0, -7}, {28, -7}, {28, 7}, {0, 7}},
                           fmt::format("fill=\"{}\" fill-opacity=\"0.4\" stroke=\"{}\" stroke-width=\"0.8\"",
                                       find_soil_colour(material), colour::ink)),
             shorten(regions_of[i].empty() ? material : material + ": " + regions_of[i], 70)});
  if (!has_section()) return;
  draw_soils();
  draw_mesh();
  // Very many lines would take long.
  if (picture_.water_sides.size() + picture_.surfaces.size() < most_names / 2) {
    for (const auto& side : picture_.water_sides) avoid(side.line);
    for (const auto& range : picture_.ranges) avoid(range.ground);
    for (const auto& surface : picture_.surfaces) avoid(surface.points);
  }
  // Numbers of messages take their places first, and names of soils, which the legend repeats, take theirs last.
  mark_messages();
  draw_loads();
  draw_bars();
  draw_water();
  draw_search();
  draw_zones();
  name_soils();
}

std::string Drawing::draw_legend(double& top) const {
  constexpr double sample = 36, gap = 26, size = 12;
  double column = 0;
  for (const Entry& entry : legend_) column = std::max(column, sample + estimate_text_width(entry.text, size) + gap);
  const double width = frame_.right - frame_.left;
  const auto columns = static_cast<std::size_t>(std::max(1.0, std::floor(width / std::max(column, 1.0))));
  const std::size_t rows = (legend_.size() + columns - 1) / columns;
  std::string text;
  for (std::size_t i = 0; i < legend_.size(); ++i) {
    const std::size_t in_row = i / rows;
    const double x = frame_.left + column * static_cast<double>(in_row),
                 y = top + row * (static_cast<double>(i % rows) + 0.5);
    text += fmt::format("<g transform=\"translate({:.2f} {:.2f})\">\n{}{}</g>\n", x, y, legend_[i].sample,
                        write_text({sample, 0}, legend_[i].text, {.size = size, .halo = false}));
  }
  top += row * static_cast<double>(rows) + (legend_.empty() ? 0 : 8);
  return "<g class=\"legend\">\n" + text + "</g>\n";
}

std::string Drawing::list_notes(double& top) const {
  std::string text;
  for (const std::string& note : picture_.notes)
    for (const std::string& line : wrap_text(note, 125)) {
      text += write_text({frame_.left, top + row / 2}, line, {.size = 12, .colour = colour::muted, .halo = false});
      top += 17;
    }
  top += picture_.notes.empty() ? 0 : 10;
  return "<g class=\"notes\">\n" + text + "</g>\n";
}

std::string Drawing::list_messages(double& top) const {
  std::string text;
  const std::size_t listed = std::min(picture_.messages.size(), most_messages);
  for (std::size_t i = 0; i < listed; ++i) {
    const CasePicture::Message& message = picture_.messages[i];
    text +=
        fmt::format("<g class=\"message {}\" data-number=\"{}\">\n", message.is_error ? "error" : "warning", i + 1) +
        write_number(i + 1, {frame_.left + 9, top + row / 2});
    for (const std::string& line : wrap_text(message.text, 118)) {
      text += write_text({frame_.left + 26, top + row / 2}, line, {.size = 12, .halo = false});
      top += 17;
    }
    text += "</g>\n";
    top += 7;
  }
  if (listed < picture_.messages.size()) {
    text += write_text({frame_.left, top + row / 2},
                       fmt::format("and {} further messages", picture_.messages.size() - listed),
                       {.size = 12, .halo = false});
    top += row;
  }
  return "<g class=\"messages\">\n" + text + "</g>\n";
}

std::string Drawing::write() {
  draw_section();
  std::string text =
      write_text({frame_.left, 22}, shorten(picture_.title, 90), {.size = 16, .halo = false, .bold = true});
  if (has_section())
    text += fmt::format(
        "<clipPath id=\"frame\"><rect x=\"{0:.2f}\" y=\"{1:.2f}\" width=\"{2:.2f}\" height=\"{3:.2f}\"/>"
        "</clipPath>\n<g clip-path=\"url(#frame)\">\n{4}</g>\n<g class=\"labels\">\n{5}</g>\n{6}{7}",
        frame_.left, frame_.top, frame_.right - frame_.left, frame_.bottom - frame_.top, drawn_, labels_,
        draw_axes(view_, frame_, picture_.length), marks_);
  else
    text += write_text({frame_.left, frame_.top + 24}, "No section could be read from this case.", {.halo = false});
  double top = frame_.bottom + (has_section() ? 48 : 0);
  text += list_messages(top);
  text += draw_legend(top);
  text += list_notes(top);
  return write_svg(page_width, top + 16, picture_.title, text);
}

}  // namespace

std::string write_case_picture(const CasePicture& picture) {
  return Drawing(picture).write();
}

}  // namespace talus::output
