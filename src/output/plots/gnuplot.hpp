// SPDX-License-Identifier: MIT
#pragma once
// Plots by gnuplot: the program writes a script that contains the data, and gnuplot draws it. The script is kept beside
// the picture for later changes (`gnuplot curve.gp`).

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace talus::output {

/// Colours that remain distinct under colour blindness (Okabe and Ito 2008, https://jfly.uni-koeln.de/color).
inline constexpr const char* line_colours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                               "#56B4E9", "#E69F00", "#000000"};
inline constexpr const char* text_colour = "#333333";
inline constexpr const char* grid_colour = "#DDDDDD";

/// Returns an upper estimate of the width [px] of a text in the font of the pictures; gnuplot gives a script no width.
double estimate_width(const std::string& text);

/// Draws `body`, a gnuplot script without terminal and output (it may use the variable title_font), as a picture of
/// `width` × `height` [px at 96 dpi]. The extension of `picture` is .svg, or .png with twice the pixels. The script is
/// kept under the same name with .gp. The picture is written atomically. Throws Error (wrong_input) for another
/// extension, and Error (cannot_write) if gnuplot is not installed or fails, or a file cannot be written.
void run_gnuplot(const std::filesystem::path& picture, const std::string& body, int width, int height);

/// Draws an SVG as a PNG with twice its pixels, by rsvg-convert. The picture is written atomically. Throws Error
/// (cannot_write) if rsvg-convert is not installed or fails, or the file cannot be written.
void draw_png(const std::filesystem::path& picture, const std::string& svg);

/// Returns `text` as a gnuplot string without escape sequences or markup.
std::string quote(const std::string& text);
/// Converts a stored name to words: `deviatoric_strain` → `deviatoric strain`.
std::string to_words(const std::string& name);
/// Returns a label: `deviatoric strain`, `stress [kPa]`, `area [m²]`; no brackets for "-" and "".
std::string make_label(const std::string& words, const std::string& unit);

/// Returns a data block `$name` with one row per item; all columns have the same length.
std::string make_data(const std::string& name, const std::vector<std::span<const double>>& columns);

/// Returns a step of 1, 2 or 5 times a power of ten that divides `length` into at most `most` intervals.
double find_tic_step(double length, double most);
/// Returns the script for the tics of `axis` ("x", "y", "cb"), with the step of find_tic_step() and the decimals that
/// it needs.
std::string make_tics(const char* axis, double length, double most);

}  // namespace talus::output
