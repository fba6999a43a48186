// SPDX-License-Identifier: MIT
// Arrays are recovered from the page.

#include "report/pack/pack.hpp"

#include <cmath>
#include <limits>

#include "report_page.hpp"
#include "support/draw.hpp"

namespace talus::report {
namespace {

TEST(Pack, Base64IsThatOfTheStandard) {
  // The test vectors of RFC 4648.
  const auto encode = [](const std::string& text) {
    return encode_base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(encode(""), "");
  EXPECT_EQ(encode("f"), "Zg==");
  EXPECT_EQ(encode("fo"), "Zm8=");
  EXPECT_EQ(encode("foo"), "Zm9v");
  EXPECT_EQ(encode("foob"), "Zm9vYg==");
  EXPECT_EQ(encode("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encode("foobar"), "Zm9vYmFy");
}

/// Packs, compresses and reads back.
template <class Add>
std::vector<double> go_around(const Add& add) {
  Packer packer;
  const nlohmann::json array = add(packer);
  const std::vector<PackedText> texts = packer.compress(2);
  EXPECT_EQ(texts.size(), 1u);
  EXPECT_EQ(texts[0].id, array.at("id"));
  return decode(array, texts[0].base64);
}

TEST(Pack, ValuesComeBackWithinHalfAStep) {
  support::Draw draw(3);
  std::vector<double> values;
  for (int i = 0; i < 6 * 500; ++i) values.push_back(draw(-3e5, 7e4));
  values[7] = -3e5;
  values[8] = 7e4;
  for (const bool delta : {false, true}) {
    const auto back = go_around([&](Packer& p) { return p.add_values("a", values, {6, 500}, delta); });
    ASSERT_EQ(back.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(back[i], values[i], 3.7e5 / 65534 / 2 * (1 + 1e-9));
    // The ends are exact: no value of the report lies outside the results'.
    EXPECT_EQ(back[7], -3e5);
    EXPECT_EQ(back[8], 7e4);
  }
}

TEST(Pack, NaNStaysNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const std::vector<double> values{1, nan, 3, infinite, 2, -infinite};
  for (const bool delta : {false, true}) {
    const auto back = go_around([&](Packer& p) { return p.add_values("a", values, {3, 2}, delta); });
    EXPECT_EQ(back[0], 1);
    EXPECT_EQ(back[2], 3);
    EXPECT_NEAR(back[4], 2, 2 / 65534.0);
    for (const std::size_t i : {1u, 3u, 5u}) EXPECT_TRUE(std::isnan(back[i])) << i;
  }
}

TEST(Pack, AConstantAndAnEmptyFieldHaveNoRange) {
  const auto constant =
      go_around([](Packer& p) { return p.add_values("a", std::vector<double>(4, -2.5), {4}, false); });
  EXPECT_EQ(constant, std::vector<double>(4, -2.5));
  const std::vector<double> none(3, std::numeric_limits<double>::quiet_NaN());
  for (const double v : go_around([&](Packer& p) { return p.add_values("a", none, {3}, false); }))
    EXPECT_TRUE(std::isnan(v));
}

TEST(Pack, NumbersAreExact) {
  const std::vector<std::uint32_t> ids{4000000000u, 0, 17, 65536, 4294967295u, 2};
  for (const bool delta : {false, true}) {
    const auto back = go_around([&](Packer& p) { return p.add_numbers("ids", ids, {6}, delta); });
    EXPECT_EQ(back, std::vector<double>(ids.begin(), ids.end()));
  }
  const std::vector<std::uint8_t> bytes{0, 255, 31};
  EXPECT_EQ(go_around([&](Packer& p) { return p.add_bytes("m", bytes, {3}); }), (std::vector<double>{0, 255, 31}));
  const std::vector<double> reals{0.5, -1e-30, 44.25};
  const auto back = go_around([&](Packer& p) { return p.add_reals("x", reals, {3}); });
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(back[i], static_cast<double>(static_cast<float>(reals[i])));
}

/// Points of two frames over a section of 40 m by 12 m; the last one leaves the grid.
std::vector<double> draw_places(const std::vector<double>& origin) {
  support::Draw draw(11);
  std::vector<double> places;
  for (int i = 0; i < 2 * 300; ++i)
    for (const double d : {draw(0, 40), draw(0, 12)}) places.push_back(origin[places.size() % 2] + d);
  places[places.size() - 1] = places[places.size() - 2] = std::numeric_limits<double>::quiet_NaN();
  return places;
}

TEST(Pack, PlacesOfAMapKeepTheirDigits) {
  const std::vector<double> map{500000.25, 4000000.5};
  const std::vector<double> here = draw_places({0, 0}), there = draw_places(map);
  const auto go = [](const std::vector<double>& places) {
    return go_around([&](Packer& p) { return p.add_quantised_places("a", places, {2, 300, 2}, true); });
  };
  const std::vector<double> packed_here = go(here), packed_there = go(there);
  for (std::size_t i = 0; i < here.size(); ++i) {
    if (std::isnan(here[i])) {
      EXPECT_TRUE(std::isnan(packed_there[i]));
      continue;
    }
    // Half a step of the component's own range.
    EXPECT_NEAR(packed_there[i], there[i], (i % 2 == 0 ? 40 : 12) / 65534.0 / 2 * (1 + 1e-4));
    EXPECT_NEAR(packed_there[i] - map[i % 2], packed_here[i], 40 / 65534.0 * (1 + 1e-4));
  }
}

TEST(Pack, NodesOfAMapKeepTheirDigits) {
  const std::vector<double> map{500000.25, 4000000.5};
  std::vector<double> nodes = draw_places(map);
  nodes.resize(nodes.size() - 2);
  const auto back = go_around([&](Packer& p) { return p.add_places("n", nodes, {nodes.size() / 2, 2}); });
  // Half of the last bit of a float of 20 m.
  for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_NEAR(back[i], nodes[i], 20 * 6e-8);
  EXPECT_TRUE(go_around([](Packer& p) { return p.add_places("n", {}, {0, 2}); }).empty());
}

TEST(Pack, RowsThatResembleEachOtherGetShorter) {
  support::Draw draw(5);
  std::vector<double> values(20 * 2000);
  for (std::size_t i = 0; i < 2000; ++i) values[i] = draw(0, 1);
  for (std::size_t i = 2000; i < values.size(); ++i) values[i] = values[i - 2000] + 1e-5;
  const auto measure = [&](bool delta) {
    Packer packer;
    packer.add_values("a", values, {20, 2000}, delta);
    return packer.compress(1)[0].base64.size();
  };
  EXPECT_LT(3 * measure(true), measure(false));
}

}  // namespace
}  // namespace talus::report
