// SPDX-License-Identifier: MIT
#include "output/plots/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/text.hpp"

namespace talus::output {
namespace {

bool continues_character(char c) {
  return (c & 0xC0) == 0x80;  // UTF-8
}

std::size_t count_characters(const std::string& text) {
  return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, continues_character));
}

/// Returns the number of bytes of the first `characters` characters.
std::size_t find_end(const std::string& text, std::size_t characters) {
  std::size_t end = 0;
  while (end < text.size() && characters > 0) {
    ++end;
    while (end < text.size() && continues_character(text[end])) ++end;
    --characters;
  }
  return end;
}

/// Coordinates far outside the page are moved to where every viewer can compute with them.
double limit(double pixel) {
  constexpr double far = 1e5;
  return std::isfinite(pixel) ? std::clamp(pixel, -far, far) : far;
}

std::string write_points(const std::vector<Pixel>& points) {
  std::string text;
  for (const Pixel& p : points) text += fmt::format("{}{:.2f},{:.2f}", text.empty() ? "" : " ", limit(p.x), limit(p.y));
  return text;
}

bool is_inside(const Pixel& x, const std::vector<Pixel>& corners) {
  bool inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Pixel &a = corners[i], &b = corners[j];
    if ((a.y > x.y) != (b.y > x.y) && x.x < a.x + (b.x - a.x) * (x.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

double measure_distance(const Pixel& x, const Pixel& a, const Pixel& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((x.x - a.x) * dx + (x.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(x.x - a.x - t * dx, x.y - a.y - t * dy);
}

}  // namespace

std::string escape_xml(const std::string& text) {
  std::string result;
  for (const char c : make_printable(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string shorten(const std::string& text, std::size_t most) {
  if (count_characters(text) <= most) return text;
  return text.substr(0, find_end(text, most - 1)) + "…";
}

double estimate_text_width(const std::string& text, double size) {
  constexpr double mean_width = 0.6;  // of a character, over the font size
  return mean_width * size * static_cast<double>(count_characters(text));
}

std::vector<std::string> wrap_text(const std::string& text, std::size_t most) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    std::string line = text.substr(begin, 4 * most);  // characters have at most four bytes
    std::size_t end = find_end(line, most);
    if (begin + end < text.size()) {
      const std::size_t blank = line.rfind(' ', end);
      if (blank != std::string::npos && blank > 0) end = blank;
    }
    lines.push_back(line.substr(0, end));
    begin += end;
    while (begin < text.size() && text[begin] == ' ') ++begin;
  }
  return lines;
}

std::string write_line(const std::vector<Pixel>& points, const std::string& attributes) {
  return fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", write_points(points), attributes);
}

std::string write_polygon(const std::vector<Pixel>& points, const std::string& attributes) {
  return fmt::format("<polygon points=\"{}\" {}/>\n", write_points(points), attributes);
}

std::string write_circle(const Pixel& centre, double radius, const std::string& attributes) {
  return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>\n", limit(centre.x), limit(centre.y),
                     radius, attributes);
}

std::string write_text(const Pixel& at, const std::string& text, const TextStyle& style) {
  constexpr double half_height = 0.36;  // of capitals, over the font size
  const char* anchor = style.anchor == Anchor::start ? "start" : style.anchor == Anchor::middle ? "middle" : "end";
  return fmt::format(
      "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:g}\" text-anchor=\"{}\" fill=\"{}\"{}{}>{}</text>\n", limit(at.x),
      limit(at.y + half_height * style.size), style.size, anchor, style.colour,
      style.bold ? " font-weight=\"bold\"" : "",
      style.halo ? " stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\" "
                   "stroke-opacity=\"0.85\" paint-order=\"stroke\""
                 : "",
      escape_xml(text));
}

std::string write_arrow(const Pixel& from, const Pixel& to, const std::string& colour) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (!(length > 0)) return "";
  const double head = std::min(7.0, 0.6 * length), ux = (to.x - from.x) / length, uy = (to.y - from.y) / length;
  const Pixel back{to.x - head * ux, to.y - head * uy};
  return write_line({from, back}, fmt::format("stroke=\"{}\" stroke-width=\"1.4\"", colour)) +
         write_polygon({to,
                        {back.x - 0.45 * head * uy, back.y + 0.45 * head * ux},
                        {back.x + 0.45 * head * uy, back.y - 0.45 * head * ux}},
                       fmt::format("fill=\"{}\"", colour));
}

std::string write_level_symbol(const Pixel& level, const std::string& colour) {
  const std::string line = fmt::format("stroke=\"{}\" stroke-width=\"1.2\"", colour);
  return write_polygon({level, {level.x - 6, level.y - 10}, {level.x + 6, level.y - 10}},
                       "fill=\"#ffffff\" class=\"level\" " + line) +
         write_line({{level.x - 6, level.y + 3}, {level.x + 6, level.y + 3}}, line) +
         write_line({{level.x - 3, level.y + 6}, {level.x + 3, level.y + 6}}, line);
}

std::string write_svg(double width, double height, const std::string& title, const std::string& elements) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"DejaVu Sans, Arial, Helvetica, sans-serif\">\n<title>{2}</title>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{3}</svg>\n",
      width, height, escape_xml(title), elements);
}

double LabelPlaces::measure_overlap(const Rectangle& label) const {
  const auto measure = [&](const Rectangle& other) {
    const double w = std::min(label.right, other.right) - std::max(label.left, other.left),
                 h = std::min(label.bottom, other.bottom) - std::max(label.top, other.top);
    return w > 0 && h > 0 ? w * h : 0;
  };
  constexpr double outside = 3;  // a clipped label is worse than one on another
  const double area = (label.right - label.left) * (label.bottom - label.top);
  double sum = outside * std::max(0.0, area - measure(frame_));
  if (sum < 1e-6 * area) sum = 0;
  for (const Rectangle& other : occupied_) sum += measure(other);
  return sum;
}

std::size_t LabelPlaces::choose(const std::vector<Rectangle>& places, bool only_free) {
  std::size_t best = places.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size() && least > 0; ++i)
    if (const double overlap = measure_overlap(places[i]); overlap < least) best = i, least = overlap;
  if (best == places.size() || (only_free && least > 0)) return places.size();
  occupy(places[best]);
  return best;
}

std::vector<Pixel> list_rooms(const std::vector<Pixel>& corners, double text_width) {
  constexpr int columns = 25, rows = 13;
  if (corners.empty()) return {};
  const auto [left, right] = std::ranges::minmax(corners, {}, &Pixel::x);
  const auto [top, bottom] = std::ranges::minmax(corners, {}, &Pixel::y);
  std::vector<std::pair<double, Pixel>> rooms;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const Pixel x{left.x + (i + 0.5) / columns * (right.x - left.x), top.y + (j + 0.5) / rows * (bottom.y - top.y)};
      if (!is_inside(x, corners)) continue;
      double room = 1e9;
      for (std::size_t k = 0; k < corners.size(); ++k)
        room = std::min(room, measure_distance(x, corners[k], corners[(k + 1) % corners.size()]));
      // Both ends of the text inside the polygon count as much as room above and below it.
      const double half = text_width / 2;
      for (const double side : {-half, half})
        if (!is_inside({x.x + side, x.y}, corners)) room *= 0.5;
      rooms.emplace_back(-room, x);
    }
  std::ranges::stable_sort(rooms, {}, [](const auto& entry) { return entry.first; });
  std::vector<Pixel> places;
  for (std::size_t i = 0; i < std::min<std::size_t>(rooms.size(), 60); ++i) places.push_back(rooms[i].second);
  return places;
}

}  // namespace talus::output
