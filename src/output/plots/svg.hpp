// SPDX-License-Identifier: MIT
#pragma once
// Elements of SVG drawings on a page in pixels, and places for labels that do not overlap.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace talus::output {

/// A place on the page [px]; y increases downwards.
struct Pixel {
  double x = 0, y = 0;
};

/// Escapes text of a user for the content and for the attributes of XML. Control characters become visible escapes.
std::string escape_xml(const std::string& text);

/// Returns the text, with at most `most` characters: a longer one ends with "…".
std::string shorten(const std::string& text, std::size_t most);

/// Returns the width [px] of a text at a font size [px], an estimate for sans-serif fonts.
double estimate_text_width(const std::string& text, double size);

/// Divides a text at its blanks into lines of at most `most` characters; longer words are divided too.
std::vector<std::string> wrap_text(const std::string& text, std::size_t most);

enum class Anchor { start, middle, end };

struct TextStyle {
  double size = 12;  ///< [px]
  Anchor anchor = Anchor::start;
  std::string colour = "#1b2330";
  bool halo = true;  ///< a white edge, for texts on colours
  bool bold = false;
};

// The functions return elements. Attributes are written by the program: they are not escaped.

std::string write_line(const std::vector<Pixel>& points, const std::string& attributes);
std::string write_polygon(const std::vector<Pixel>& points, const std::string& attributes);
std::string write_circle(const Pixel& centre, double radius, const std::string& attributes);
/// `at`: the middle of the text in height, its start, middle or end in width.
std::string write_text(const Pixel& at, const std::string& text, const TextStyle& style);
/// An arrow with its head at `to`.
std::string write_arrow(const Pixel& from, const Pixel& to, const std::string& colour);
/// The symbol of a free water level: a triangle that stands on the level, with two short lines below it.
std::string write_level_symbol(const Pixel& level, const std::string& colour);

/// Returns a whole drawing. `title` names it for readers of the file.
std::string write_svg(double width, double height, const std::string& title, const std::string& elements);

/// Returns places within a polygon for a name, those far from its sides first.
std::vector<Pixel> list_rooms(const std::vector<Pixel>& corners, double text_width);

/// A rectangle on the page [px].
struct Rectangle {
  double left = 0, top = 0, right = 0, bottom = 0;
};

/// Rectangles of the page that labels occupy.
class LabelPlaces {
 public:
  explicit LabelPlaces(const Rectangle& frame) : frame_(frame) {}

  /// Returns the overlap with occupied rectangles, and the area outside the frame, which counts more [px²].
  double measure_overlap(const Rectangle& label) const;
  void occupy(const Rectangle& label) { occupied_.push_back(label); }
  /// Returns the index of the first of some places without overlap, or of that with the least overlap, and occupies
  /// it. With `only_free` returns the number of places, and occupies none, where no place is free.
  std::size_t choose(const std::vector<Rectangle>& places, bool only_free);

 private:
  Rectangle frame_;
  std::vector<Rectangle> occupied_;
};

}  // namespace talus::output
