// SPDX-License-Identifier: MIT
#pragma once
// Arrays of a report as text: quantised, compressed, in base64 (`PackedArray` in web/src/contract/).

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.hpp"

namespace talus::report {

/// Standard base64 (RFC 4648) with padding.
std::string encode_base64(std::span<const std::uint8_t> bytes);

/// Numbers 0 … 65534 of `values` between the smallest and the largest finite one; 65535 for what is not finite.
struct Quantised {
  std::vector<std::uint16_t> codes;
  double min = 0, max = 0;  ///< both 0 when no value is finite
};
Quantised quantise(std::span<const double> values);

/// An array inside the page.
struct PackedText {
  std::string id;
  std::string base64;
};

/// Collects the arrays of a report. add_* return what the document says about the array and are cheap; the work is done
/// by compress(), array by array. Both call throw_if_interrupted().
class Packer {
 public:
  /// u16 with range. With `delta` every row along the first axis is stored as its difference to the row before it:
  /// shorter where a row resembles the one before it.
  nlohmann::json add_values(const std::string& id, std::span<const double> values,
                            const std::vector<std::size_t>& shape, bool delta);
  /// Coordinates as u16: each component, which the last axis counts, has a range of its own. An elevation so keeps its
  /// digits beside an easting of a map.
  nlohmann::json add_quantised_places(const std::string& id, std::span<const double> values,
                                      const std::vector<std::size_t>& shape, bool delta);
  nlohmann::json add_bytes(const std::string& id, std::span<const std::uint8_t> values,
                           const std::vector<std::size_t>& shape);
  nlohmann::json add_numbers(const std::string& id, std::span<const std::uint32_t> values,
                             const std::vector<std::size_t>& shape, bool delta);
  /// Coordinates as f32: each component, which the last axis counts, from the middle of its range.
  nlohmann::json add_places(const std::string& id, std::span<const double> values,
                            const std::vector<std::size_t>& shape);
  /// f32.
  nlohmann::json add_reals(const std::string& id, std::span<const double> values,
                           const std::vector<std::size_t>& shape);

  std::vector<PackedText> compress(int threads) const;

  /// Throws Error (interrupted) when a signal has arrived since the packer was made.
  void throw_if_interrupted() const;

 private:
  struct Array {
    std::string id;
    std::vector<std::uint8_t> bytes;  ///< in planes
  };
  nlohmann::json keep(const std::string& id, const char* type, const std::vector<std::size_t>& shape, bool delta,
                      std::vector<std::uint8_t> bytes);
  const bool was_interrupted_ = is_interrupted();
  std::vector<Array> arrays_;
};

// The page that a report is filled into; it stands inside the program (cmake/TalusReportPage.cmake).

/// The empty page as it was built.
std::string_view get_page();

/// `page` with the document and its arrays in place of the placeholder <!--TALUS_DATA-->, and `title` as the name
/// of its window. Throws Error (internal_error) when the page has no such placeholder.
std::string fill_page(std::string_view page, const std::string& title, const nlohmann::json& document,
                      const std::vector<PackedText>& arrays);

}  // namespace talus::report
