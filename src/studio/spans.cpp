// SPDX-License-Identifier: MIT
#include "studio/spans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/error.hpp"
#include "input/language/parse.hpp"

namespace talus::studio {

LineTable::LineTable(const std::string& text) : text_(text) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  starts_.push_back(text.starts_with(mark) ? mark.size() : 0);
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') starts_.push_back(i + 1);
}

std::size_t LineTable::find_byte(std::size_t line, std::size_t column) const {
  if (line < 1 || column < 1) return 0;
  const std::size_t index = std::min(line, starts_.size()) - 1;
  const std::size_t end = index + 1 < starts_.size() ? starts_[index + 1] : text_.size();
  std::size_t byte = starts_[index];
  for (std::size_t i = 1; i < column && byte < end; ++i) {
    ++byte;
    while (byte < end && (static_cast<unsigned char>(text_[byte]) & 0xC0U) == 0x80) ++byte;
  }
  return byte;
}

namespace {

/// Returns true for a list of tables with a header each.
bool has_headers(const toml::array& list) {
  return !list.empty() && list.is_array_of_tables() && !list.front().as_table()->is_inline();
}

class SpanSearch {
 public:
  explicit SpanSearch(const std::string& text) : text_(text), lines_(text) {}

  TextSpans find(const toml::table& root) {
    add_table(root, "");
    return std::move(spans_);
  }

 private:
  Span find(const toml::source_region& region) const {
    const std::size_t begin = lines_.find_byte(region.begin.line, region.begin.column);
    return {begin, std::max(begin, lines_.find_byte(region.end.line, region.end.column))};
  }

  void add(const toml::node& node, const std::string& path) {
    Span span = find(node.source());
    // The parser's region of a number ends at the next character that it reads.
    while (span[1] > span[0] && std::string_view(" \t\r\n").find(text_[span[1] - 1]) != std::string_view::npos)
      --span[1];
    if (const toml::table* table = node.as_table()) {
      const std::size_t last = add_table(*table, path);
      if (!table->is_inline()) span[1] = std::max(span[1], last);
    } else if (const toml::array* list = node.as_array()) {
      for (std::size_t i = 0; i < list->size(); ++i) add(*list->get(i), path + "." + std::to_string(i));
      if (has_headers(*list))
        span[1] = std::max(span[1], spans_.values[path + "." + std::to_string(list->size() - 1)][1]);
    }
    spans_.values[path] = span;
  }

  /// Returns the end of the last value of the table that is not in a table with a header of its own.
  std::size_t add_table(const toml::table& table, const std::string& path) {
    std::size_t last = 0;
    for (const auto& [key, node] : table) {
      const std::string name(key.str());
      const std::string inner = path.empty() ? name : fmt::format("{}.{}", path, name);
      add(node, inner);
      spans_.keys[inner] = find(key.source());
      const toml::table* block = node.as_table();
      const bool has_header =
          (block != nullptr && !block->is_inline()) || (node.is_array() && has_headers(*node.as_array()));
      if (!has_header) last = std::max(last, spans_.values[inner][1]);
    }
    return last;
  }

  const std::string& text_;
  LineTable lines_;
  TextSpans spans_;
};

}  // namespace

TextSpans find_spans(const std::string& text) {
  try {
    return SpanSearch(text).find(input::parse_toml(text, ""));
  } catch (const Error&) {
    return {};
  }
}

}  // namespace talus::studio
