// SPDX-License-Identifier: MIT
#pragma once
// Places of keys and values in the text of a case, as bytes, so that an editor changes a value and nothing else.

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace talus::studio {

/// Bytes from the first to behind the last.
using Span = std::array<std::size_t, 2>;

/// Converts lines and columns, which count characters from 1, to bytes.
class LineTable {
 public:
  explicit LineTable(const std::string& text);
  std::size_t find_byte(std::size_t line, std::size_t column) const;

 private:
  const std::string& text_;
  std::vector<std::size_t> starts_;
};

struct TextSpans {
  std::map<std::string, Span> values;  ///< by path, "geometry.polygon.0.points.2"
  std::map<std::string, Span> keys;    ///< names before "=", and tables' own names in their header
};

/// Returns the spans of all values and keys; none for a text that is not TOML. The span of a table with a header begins
/// with the header and ends behind its last own value, where a further key can be added.
TextSpans find_spans(const std::string& text);

}  // namespace talus::studio
