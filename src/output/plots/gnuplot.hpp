// SPDX-License-Identifier: MIT
#pragma once
// Pictures through gnuplot: the program writes a script with its data inside, gnuplot draws it, and the script stays
// beside the picture so that it can be restyled by hand (`gnuplot curve.gp`).

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace talus::output {

/// Colours that people with any colour vision tell apart (Okabe and Ito 2008, https://jfly.uni-koeln.de/color).
inline constexpr const char* line_colours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                               "#56B4E9", "#E69F00", "#000000"};
inline constexpr const char* text_colour = "#333333";
inline constexpr const char* grid_colour = "#DDDDDD";

/// Width [px] that a text of the pictures' font takes at most; gnuplot itself cannot tell a script.
double estimate_width(const std::string& text);

/// Draws `body`, a gnuplot script without terminal and output (it may use the variable title_font), as a picture of
/// `width` × `height` [px at 96 dpi]. The extension of `picture` decides: .svg, or .png with twice the pixels. The
/// script is kept as the same name with .gp. Throws Error (wrong_input) for another extension, Error (cannot_write)
/// with one sentence when gnuplot is not installed or fails, or a file cannot be written; a picture is whole or absent.
void run_gnuplot(const std::filesystem::path& picture, const std::string& body, int width, int height);

/// `text` as a gnuplot string in which every character stands for itself.
std::string quote(const std::string& text);
/// A stored name for people: `deviatoric_strain` → `deviatoric strain`.
std::string to_words(const std::string& name);
/// A label: `deviatoric strain`, `stress [kPa]`, `area [m²]`; no bracket for "-" and "".
std::string make_label(const std::string& words, const std::string& unit);

/// A data block `$name` with one row per item, all columns of one length.
std::string make_data(const std::string& name, const std::vector<std::span<const double>>& columns);

/// A step of 1, 2 or 5 times a power of ten that cuts `length` into at most `most` pieces.
double find_tic_step(double length, double most);
/// The script's lines for the tics of `axis` ("x", "y", "cb"): that step, and as many decimals as it needs.
std::string make_tics(const char* axis, double length, double most);

}  // namespace talus::output
