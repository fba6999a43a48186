// SPDX-License-Identifier: MIT
#pragma once
// Symbols of a section: axes, supports, hydraulic conditions, loads, roots and search ranges, as elements of SVG.

#include <string>
#include <vector>

#include "output/plots/case_picture.hpp"
#include "output/plots/field_plot.hpp"
#include "output/plots/svg.hpp"

namespace talus::output {

/// The map from the section [m] to the page [px], true to scale.
struct View {
  double scale = 1;  ///< [px/m]
  double x0 = 0;     ///< page x of x = 0 [px]
  double y0 = 0;     ///< page y of y = 0 [px]
  Pixel operator()(const results::Point& p) const { return {x0 + scale * p[0], y0 - scale * p[1]}; }
  std::vector<Pixel> operator()(const std::vector<results::Point>& line) const;
};

namespace colour {
inline constexpr const char *ink = "#1b2330", *muted = "#5b6675", *water = "#1565c0", *later_water = "#26a0da",
                            *load = "#b3261e", *roots = "#2e7d32", *bar = "#37474f", *entry = "#7b1fa2",
                            *exit = "#00796b", *surface = "#c2185b", *error = "#c62828", *warning = "#b26a00";
}  // namespace colour

/// Points at equal distances along a line, with the unit normal to the left of its direction on the page.
struct AlongLine {
  Pixel at, normal;
  double fraction = 0;        ///< of the length
  std::size_t segment = 0;    ///< index of the start of its segment
  double within_segment = 0;  ///< from 0 to 1
};
/// Returns at least `least` and at most 200 of them; none for a line without length.
std::vector<AlongLine> divide_line(const std::vector<Pixel>& line, double spacing, std::size_t least);

const char* get_colour(WaterSideKind kind);
const char* get_title(WaterSideKind kind);
const char* get_title(SupportKind kind);
const char* get_colour(SearchZoneKind kind);
const char* get_title(SearchZoneKind kind);

std::string draw_support(const CasePicture::Support& support, const View& view);
std::string draw_water_side(const CasePicture::WaterSide& side, const View& view);
/// `most`: largest load of the section [Pa], which has the longest arrows.
std::string draw_load(const CasePicture::Load& load, double most, const View& view);
/// Returns the largest size of the loads [Pa].
double find_largest_load(const std::vector<CasePicture::Load>& loads);
/// Length of the arrow of the largest load [px].
inline constexpr double load_arrow = 40;
/// Returns the box around everything that belongs to the section [m].
Box find_extent(const CasePicture& picture);
std::string draw_bar(const CasePicture::Bar& bar, const View& view);
std::string draw_roots(const CasePicture::RootZone& roots, const View& view);
std::string draw_range(const CasePicture::GroundRange& range, const View& view);
std::string draw_zone(const CasePicture::SearchZone& zone, const View& view);
/// Returns the sample of a zone in a legend, around (0, 0).
std::string draw_sample(const CasePicture::SearchZone& zone);
/// Returns the line beside which the name of a zone stands.
std::vector<Pixel> place_name(const CasePicture::SearchZone& zone, const View& view);
std::string draw_centres(const CasePicture::CentreGrid& grid, const View& view);
/// Frame, tics and names of the axes in units of length.
std::string draw_axes(const View& view, const Rectangle& frame, const ShownUnit& length);

}  // namespace talus::output
