// SPDX-License-Identifier: MIT
// Reference: UDUNITS-2, for every unit of its database and for compound units of case files.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "base/unit_definition.hpp"
#include "base/unit_table_data.hpp"

namespace talus::units {

std::optional<UnitDefinition> define_unit_by_table(const std::string& text);

namespace {

void expect_same(const std::string& text) {
  const auto expected = define_unit(text), found = define_unit_by_table(text);
  ASSERT_EQ(found.has_value(), expected.has_value()) << text;
  if (!expected) return;
  EXPECT_DOUBLE_EQ(found->factor, expected->factor) << text;
  EXPECT_DOUBLE_EQ(found->offset, expected->offset) << text;
  EXPECT_EQ(found->powers, expected->powers) << text;
}

TEST(UnitTable, has_every_unit_of_the_database) {
  ASSERT_GT(table_units.size(), 500U);
  for (const TableUnit& unit : table_units) expect_same(std::string(unit.id));
}

TEST(UnitTable, knows_prefixes) {
  for (const TablePrefix& prefix : table_prefixes)
    for (const char* unit : {"m", "Pa", "N", "pascal", "newton", "g", "s"}) {
      const std::string text = std::string(prefix.id) + unit;
      expect_same(text);
    }
}

TEST(UnitTable, reads_compound_units) {
  for (const char* text : {"",
                           "1",
                           "kN/m3",
                           "kN m-3",
                           "kN.m-3",
                           "kN*m^-3",
                           "kN/m^3",
                           "kN/m**3",
                           "kg m-1 s-2",
                           "kN/m2/m",
                           "kN/(m2 m)",
                           "kN/(m.m)",
                           "m s-1",
                           "m2/day",
                           "mm/h",
                           "mm per h",
                           "psf",
                           "kcf",
                           "PSF",
                           "pcf/ft",
                           "ksf.ft",
                           "lb/ft3",
                           "lbf/ft2",
                           "psi",
                           "Pa s",
                           "Pa.s",
                           "kPa/m",
                           "g/cm3",
                           "kN·m",
                           "kN/m²",
                           "m³/s",
                           "m³·s⁻¹",
                           "rad",
                           "rad/s",
                           "deg/m",
                           "%",
                           "°",
                           "µm",
                           "m-2",
                           "W/m2",
                           "kN-m",
                           "pound_force/foot2",
                           "1000 pound_force/foot2",
                           "(kN)",
                           "kN / m3",
                           "Hz",
                           "s-1",
                           "tonne/m3",
                           "inches",
                           "feet",
                           "years",
                           "days",
                           "KILOpascal"})
    expect_same(text);
}

TEST(UnitTable, refuses_what_is_no_unit) {
  for (const char* text :
       {"kpaa", "kN/", "/m", "(m", "m)", "kN//m", "m^", "^2", "m^x", "xyz", "k", "*", "kN m3x3 3", "m;", "()"})
    EXPECT_FALSE(define_unit_by_table(text)) << text;
  EXPECT_FALSE(define_unit_by_table(std::string(100'000, '(')));
}

}  // namespace
}  // namespace talus::units
