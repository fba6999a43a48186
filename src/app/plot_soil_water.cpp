// SPDX-License-Identifier: MIT
#include "app/plot_soil_water.hpp"

#include <fmt/format.h>

#include "base/atomic_file.hpp"
#include "base/encoding.hpp"
#include "base/error.hpp"
#include "input/read.hpp"
#include "output/plots/water_plot.hpp"

namespace talus::app {

void plot_soil_water(const CaseOptions& input, const std::filesystem::path& picture, const std::string& format) {
  const input::LoadedCase loaded = input::read_case(input.file, input.parse_overrides());
  const output::WaterPlot plot{loaded.data.title, output::sample_water_curves(loaded.data)};
  if (plot.soils.empty())
    throw Error(ExitCode::wrong_input,
                fmt::format("there is nothing to draw in '{}': no material of it has pore water, a table "
                            "[materials.NAME.water]; for the results of a run give their folder",
                            input.file));
  const std::string name = std::filesystem::path(input.file).stem().string() + "_soil_water";
  const std::filesystem::path drawn =
      picture.empty() ? std::filesystem::path(name + "." + (format.empty() ? "svg" : format)) : picture;
  const std::filesystem::path table = std::filesystem::path(drawn).replace_extension(".csv");
  output::draw(plot, drawn);
  write_atomically(table, output::make_water_table(plot.soils));
  print(stdout, fmt::format("{}\n{}\n", drawn.string(), table.string()));
}

}  // namespace talus::app
