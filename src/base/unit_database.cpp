// SPDX-License-Identifier: MIT
// Units by UDUNITS-2, which is not thread-safe: units.cpp serialises the calls.
#include <udunits2.h>

#include <cerrno>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/unit_definition.hpp"
#include "base/user_file.hpp"

namespace talus::units {

namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

/// Reads the database once.
ut_system* get_system() {
  static ut_system* const system = [] {
    ut_set_error_message_handler(ut_ignore);
    errno = 0;
    ut_system* made = ut_read_xml(nullptr);
    if (made == nullptr) refuse_full_file_table(errno);
    if (made == nullptr)
      throw Error(ExitCode::internal_error,
                  "the unit database of UDUNITS-2 cannot be read; install it (Debian: libudunits2-data) or name its "
                  "file in the environment variable UDUNITS2_XML_PATH");
    for (const auto& [name, definition] : practice_units) {
      const Unit unit(ut_parse(made, definition, UT_ASCII));
      ut_map_name_to_unit(name, UT_ASCII, unit.get());
    }
    return made;
  }();
  return system;
}

/// Removes the factor from a definition such as "1000 m-1.kg.s-2" and the offset from "K @ 273.15".
std::string strip_scale(std::string text) {
  text = text.substr(0, text.find(" @"));
  const auto blank = text.find(' ');
  return blank == std::string::npos ? text : text.substr(blank + 1);
}

/// Reads "m-1.kg.s-2"; a plain number has no powers.
std::array<int, UnitDefinition::base.size()> read_powers(std::string_view text) {
  std::array<int, UnitDefinition::base.size()> powers{};
  while (!text.empty()) {
    const std::string_view part = text.substr(0, text.find('.'));
    const std::size_t digits = part.find_first_of("-0123456789");
    for (std::size_t i = 0; i < powers.size(); ++i)
      if (part.substr(0, digits) == UnitDefinition::base[i])
        powers[i] += digits == std::string_view::npos ? 1 : std::atoi(std::string(part.substr(digits)).c_str());
    text.remove_prefix(std::min(part.size() + 1, text.size()));
  }
  return powers;
}

}  // namespace

std::optional<UnitDefinition> define_unit(const std::string& text) {
  const PlainNumbers plain;
  ut_system* const system = get_system();
  const Unit unit(ut_parse(system, text.c_str(), UT_UTF8));
  if (unit == nullptr) return std::nullopt;
  std::array<char, 256> definition{};
  ut_format(unit.get(), definition.data(), definition.size(), UT_ASCII | UT_DEFINITION);
  const std::string si = strip_scale(definition.data());
  const Unit base(ut_parse(system, si.c_str(), UT_ASCII));
  if (ut_are_convertible(unit.get(), base.get()) == 0) return std::nullopt;  // a date, "s since 2000-01-01"
  const std::unique_ptr<cv_converter, void (*)(cv_converter*)> converter(ut_get_converter(unit.get(), base.get()),
                                                                         cv_free);
  if (converter == nullptr) fail_input("'{}' cannot be converted to SI units", text);
  UnitDefinition out;
  out.offset = cv_convert_double(converter.get(), 0);
  out.factor = cv_convert_double(converter.get(), 1) - out.offset;
  out.powers = read_powers(si);
  return out;
}

}  // namespace talus::units
