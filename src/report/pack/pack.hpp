// SPDX-License-Identifier: MIT
#pragma once
// Arrays of a report as text: quantised, compressed and base64-encoded (`PackedArray` in web/src/contract/); and the
// page that embeds them, which is part of the program (cmake/TalusReportPage.cmake).

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.hpp"

namespace talus::report {

/// Encodes bytes as standard base64 (RFC 4648) with padding.
std::string encode_base64(std::span<const std::uint8_t> bytes);

/// Codes 0 … 65534 between the smallest and the largest finite value; 65535 for non-finite values.
struct Quantised {
  std::vector<std::uint16_t> codes;
  double min = 0, max = 0;  ///< both 0 if no value is finite
};
Quantised quantise(std::span<const double> values);

/// A packed array as text, with its id in the page.
struct PackedText {
  std::string id;
  std::string base64;
};

/// Collects the arrays of a report. The add_ functions are cheap and return the description of the array in the
/// document; compress() processes the arrays one by one. All call throw_if_interrupted().
class Packer {
 public:
  /// Adds numbers as u16 with their range. With `delta`, each row along the first axis is stored as its difference from
  /// the previous row, which is smaller for similar rows.
  nlohmann::json add_values(const std::string& id, std::span<const double> values,
                            const std::vector<std::size_t>& shape, bool delta);
  /// Adds coordinates as u16. Each component along the last axis has its own range, so that elevations keep their
  /// precision beside large map coordinates.
  nlohmann::json add_quantised_places(const std::string& id, std::span<const double> values,
                                      const std::vector<std::size_t>& shape, bool delta);
  nlohmann::json add_bytes(const std::string& id, std::span<const std::uint8_t> values,
                           const std::vector<std::size_t>& shape);
  nlohmann::json add_numbers(const std::string& id, std::span<const std::uint32_t> values,
                             const std::vector<std::size_t>& shape, bool delta);
  /// Adds coordinates as f32. Each component along the last axis is relative to the middle of its range.
  nlohmann::json add_places(const std::string& id, std::span<const double> values,
                            const std::vector<std::size_t>& shape);
  /// Adds numbers as f32.
  nlohmann::json add_reals(const std::string& id, std::span<const double> values,
                           const std::vector<std::size_t>& shape);

  std::vector<PackedText> compress(int threads) const;

  /// Throws Error (interrupted) if a signal arrived after the construction of the packer.
  void throw_if_interrupted() const;

 private:
  struct Array {
    std::string id;
    std::vector<std::uint8_t> bytes;  ///< in byte planes
  };
  nlohmann::json keep(const std::string& id, const char* type, const std::vector<std::size_t>& shape, bool delta,
                      std::vector<std::uint8_t> bytes);
  const bool was_interrupted_ = is_interrupted();
  std::vector<Array> arrays_;
};

/// Returns the page as it was built, without data.
std::string_view get_page();

/// Returns `page` with the results, the document and its arrays in place of the placeholder <!--TALUS_DATA-->, and with
/// `title` as the title of its window. Throws Error (internal_error) if the page has no placeholder.
std::string fill_page(std::string_view page, const std::string& title, const nlohmann::json& results,
                      const nlohmann::json& document, const std::vector<PackedText>& arrays);

}  // namespace talus::report
