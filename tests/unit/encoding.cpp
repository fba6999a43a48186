// SPDX-License-Identifier: MIT
// Sanitising of text for a terminal, a picture or a table.
#include "base/text.hpp"

#include <gtest/gtest.h>

#include <string>

#include "output/files/history.hpp"
#include "output/plots/gnuplot.hpp"

namespace talus {
namespace {

using namespace std::string_literals;

TEST(Printable, ShowsControlsByTheirNumber) {
  EXPECT_EQ(make_printable("\x1b]0;owned\a"), "\\x1b]0;owned\\x07");
  EXPECT_EQ(make_printable("a\0b\x7f"s), "a\\x00b\\x7f");
  EXPECT_EQ(make_printable("a\nb\tc\r"), "a\\x0ab\\x09c\\x0d");
  EXPECT_EQ(make_printable("a\nb\tc\r", true), "a\nb\\x09c\\x0d");
  EXPECT_EQ(make_printable("\u009b31m \u202ertl\u2066 \u2028 \uffff"), "\\u009b31m \\u202ertl\\u2066 \\u2028 \\uffff");
}

TEST(Printable, LeavesTextsOfPeopleAlone) {
  for (const char* text : {"", "Böschung 1", "γ_sat = 20 kN/m³", "斜面", "🏔 ψ < φ"})
    EXPECT_EQ(make_printable(text), text);
}

TEST(Printable, ShowsBytesThatAreNoUtf8) {
  EXPECT_EQ(make_printable("B\xf6schung"), "B\\xf6schung");
  EXPECT_EQ(make_printable("\xed\xa0\x80\xc0\xaf\xe2\x82"), "\\xed\\xa0\\x80\\xc0\\xaf\\xe2\\x82");
  EXPECT_EQ(find_wrong_utf8("ab\xf6"), 2u);
  EXPECT_EQ(find_wrong_utf8("γ\u202e\n"), std::nullopt);
}

TEST(Cell, IsNoFormula) {
  for (const char* text : {"=1+2", "+cmd|' /C calc'!A0", "-1+2", "@SUM(A1)"})
    EXPECT_EQ(output::make_cell(text), "'" + std::string(text));
  for (const char* text : {"-5", "+3.5", "-1e-5", "5 kPa", "a=b", ""}) EXPECT_EQ(output::make_cell(text), text);
  EXPECT_EQ(output::quote_field("=A1,\"x\""), "\"'=A1,\"\"x\"\"\"");
  EXPECT_EQ(output::quote_field("a\nb"), "a\\x0ab");
}

TEST(Gnuplot, GetsNoControlCharacters) {
  EXPECT_EQ(output::quote("]]>"), "']] >'");
  EXPECT_EQ(output::quote("a\n`rm`\x1b'"), "'a\\\\x0a`rm`\\\\x1b'''");
}

}  // namespace
}  // namespace talus
