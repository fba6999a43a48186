// SPDX-License-Identifier: MIT
// Units by a table, for WebAssembly, where UDUNITS-2 is missing. tools/wasm/make_unit_table.py generates the table from
// the installed UDUNITS-2; the grammar is that of UDUNITS-2 without offsets, logarithms and times.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/unit_definition.hpp"
#include "base/unit_table_data.hpp"

namespace talus::units {

namespace {

using Known = std::optional<UnitDefinition>;

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}
bool are_alike(std::string_view a, std::string_view b) {
  return a.size() == b.size() && to_lower(a) == to_lower(b);
}

/// Returns the entry of this name, ignoring its case, or else of this symbol.
Known find_entry(std::string_view id) {
  for (const TableUnit& unit : table_units)
    if (!unit.is_symbol && are_alike(id, unit.id)) return UnitDefinition{unit.factor, unit.offset, unit.powers};
  for (const auto& [name, definition] : practice_units)
    if (are_alike(id, name)) return define_unit(definition);
  for (const TableUnit& unit : table_units)
    if (unit.is_symbol && id == unit.id) return UnitDefinition{unit.factor, unit.offset, unit.powers};
  return std::nullopt;
}

/// Returns the longest prefix with which `id` begins; null if there is none.
const TablePrefix* find_prefix(std::string_view id, bool is_symbol) {
  const TablePrefix* longest = nullptr;
  for (const TablePrefix& p : table_prefixes) {
    const std::string_view start = id.substr(0, p.id.size());
    if (p.is_symbol != is_symbol || !(is_symbol ? start == p.id : are_alike(start, p.id))) continue;
    if (longest == nullptr || p.id.size() > longest->id.size()) longest = &p;
  }
  return longest;
}

/// Returns the unit of an identifier with any prefixes by name and one by symbol.
Known find_unit(std::string_view id) {
  double scale = 1;
  bool has_symbol = false;
  while (!id.empty()) {
    if (Known unit = find_entry(id)) {
      unit->factor *= scale;
      return unit;
    }
    const TablePrefix* prefix = find_prefix(id, false);
    if (prefix == nullptr && !has_symbol) {
      prefix = find_prefix(id, true);
      has_symbol = true;
    }
    if (prefix == nullptr) return std::nullopt;
    scale *= prefix->factor;
    id.remove_prefix(prefix->id.size());
  }
  return std::nullopt;
}

UnitDefinition raise(const UnitDefinition& unit, int power) {
  UnitDefinition out;
  for (int i = 0; i < std::abs(power); ++i) out.factor *= unit.factor;
  if (power < 0) out.factor = 1 / out.factor;
  for (std::size_t i = 0; i < out.powers.size(); ++i) out.powers[i] = power * unit.powers[i];
  if (power == 1) out.offset = unit.offset;
  return out;
}

UnitDefinition multiply(const UnitDefinition& a, const UnitDefinition& b, int sign) {
  UnitDefinition out;
  out.factor = sign > 0 ? a.factor * b.factor : a.factor / b.factor;
  for (std::size_t i = 0; i < out.powers.size(); ++i) out.powers[i] = a.powers[i] + sign * b.powers[i];
  return out;
}

/// Recursive descent: product = power { [·|/] power }, power = basic [integer], basic = id | number | "(" product ")".
class Parser {
 public:
  explicit Parser(std::string_view text) : rest_(text) {}

  Known read_all() {
    const Known unit = read_product();
    skip_blanks();
    return rest_.empty() ? unit : std::nullopt;
  }

 private:
  Known read_product() {
    Known product = read_power();
    while (product) {
      skip_blanks();
      if (rest_.empty() || rest_[0] == ')') break;
      const int sign = read_operator();
      const Known next = read_power();
      if (!next) return std::nullopt;
      product = multiply(*product, *next, sign);
    }
    return product;
  }

  Known read_power() {
    const Known basic = read_basic();
    if (!basic) return std::nullopt;
    const std::optional<int> power = read_exponent();
    return power ? raise(*basic, *power) : basic;
  }

  Known read_basic() {
    skip_blanks();
    if (rest_.empty()) return std::nullopt;
    if (take("(")) {
      if (++depth_ > most_depth) return std::nullopt;
      const Known inner = read_product();
      --depth_;
      return inner && take(")") ? inner : std::nullopt;
    }
    if (is_digit(rest_[0]) || rest_[0] == '.' || rest_[0] == '-' || rest_[0] == '+') return read_factor();
    return find_unit(read_id());
  }

  Known read_factor() {
    UnitDefinition number;
    take("+");
    const char* end = parse_number(rest_.data(), rest_.data() + rest_.size(), number.factor);
    if (end == nullptr) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return number;
  }

  /// Letters and digits that begin and end with a letter, or one of three signs.
  std::string_view read_id() {
    std::size_t length = 0;
    if (rest_[0] == '%' || rest_[0] == '\'' || rest_[0] == '"') length = 1;
    if (length == 0 && is_letter(rest_[0]))
      for (std::size_t i = 0; i < rest_.size() && (is_letter(rest_[i]) || is_digit(rest_[i])); ++i) {
        if (begins_exponent(rest_.substr(i)) || rest_.substr(i).starts_with("·")) break;
        if (is_letter(rest_[i])) length = i + 1;
      }
    const std::string_view id = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return id;
  }

  int read_operator() {
    if (take("/") || take("per ") || take("PER ")) return -1;
    if (!take("**")) take("*") || take(".") || take("·") || take("-");
    return 1;
  }

  std::optional<int> read_exponent() {
    skip_blanks();
    if (std::string power = read_superscripts(); !power.empty()) return std::atoi(power.c_str());
    const bool is_raised = take("^") || take("**");
    std::size_t length = !rest_.empty() && (rest_[0] == '-' || rest_[0] == '+') ? 1 : 0;
    const std::size_t first = length;
    while (length < rest_.size() && is_digit(rest_[length]) && length < first + 2) ++length;
    const bool is_whole =
        length > first && (length == rest_.size() || (!is_digit(rest_[length]) && rest_[length] != '.'));
    if (!is_whole) {
      if (is_raised) rest_ = "^";  // no unit
      return std::nullopt;
    }
    const int power = std::atoi(std::string(rest_.substr(0, length)).c_str());
    rest_.remove_prefix(length);
    return power;
  }

  std::string read_superscripts() {
    std::string digits;
    for (bool is_more = true; is_more;) {
      is_more = false;
      for (const auto& [sign, plain] : superscripts)
        if (take(sign)) digits += plain, is_more = true;
    }
    return digits.size() < 4 ? digits : "";
  }

  static bool begins_exponent(std::string_view text) {
    return std::any_of(superscripts.begin(), superscripts.end(),
                       [&](const auto& s) { return text.starts_with(s.first); });
  }

  bool take(std::string_view word) {
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  void skip_blanks() {
    while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_[0])) != 0) rest_.remove_prefix(1);
  }

  static constexpr int most_depth = 20;
  static constexpr std::array<std::pair<std::string_view, char>, 10> superscripts{{{"⁰", '0'},
                                                                                   {"¹", '1'},
                                                                                   {"²", '2'},
                                                                                   {"³", '3'},
                                                                                   {"⁴", '4'},
                                                                                   {"⁵", '5'},
                                                                                   {"⁶", '6'},
                                                                                   {"⁷", '7'},
                                                                                   {"⁸", '8'},
                                                                                   {"⁹", '9'}}};
  std::string_view rest_;
  int depth_ = 0;
};

}  // namespace

std::optional<UnitDefinition> define_unit(const std::string& text) {
  if (text.find_first_not_of(" \t") == std::string::npos) return UnitDefinition{};
  const Known unit = Parser(text).read_all();
  return unit && std::isfinite(unit->factor) && unit->factor != 0 ? unit : std::nullopt;
}

}  // namespace talus::units
