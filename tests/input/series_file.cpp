// SPDX-License-Identifier: MIT
// Time series in files.

#include <unistd.h>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "base/units.hpp"
#include "support/scratch.hpp"
#include "wet_slope.hpp"

namespace talus::input {
namespace {

constexpr double day = 86400, mm = 1e-3;

/// A case beside a table, in a folder of its own.
class SeriesFromFile : public ::testing::Test {
 protected:
  /// The wet slope with rain from the columns of `table`.
  Case read(const std::string& table, const std::string& keys, const std::string& initial = "date = 2023-03-01") {
    std::ofstream(folder_ / "station.csv") << table;
    std::string text = change(wet_slope, "on = \"crest\"\ncondition = \"seepage_face\"",
                              "on = \"crest\"\ncondition = \"rain\"\nrate = { file = \"station.csv\", " + keys + " }");
    text = change(text, "pore_pressure = \"seepage\"", initial + "\npore_pressure = \"seepage\"");
    return read_case_text(text, (folder_ / "slope.toml").string()).data;
  }
  std::string fault(const std::string& table, const std::string& keys,
                    const std::string& initial = "date = 2023-03-01") {
    try {
      read(table, keys, initial);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  const std::filesystem::path folder_ = support::make_scratch("table");
};

TEST_F(SeriesFromFile, DailyRainIsARateForADay) {
  const Case data = read("date,rain [mm]\n2023-02-28,2\n2023-03-01,24\n2023-03-02,0\n", "column = \"rain\"");
  const TimeTable rain = data.hydraulics.at(1).values();
  EXPECT_NEAR(rain.at(-0.5 * day), 2 * mm / day, 1e-15);
  EXPECT_NEAR(rain.at(0.5 * day), 24 * mm / day, 1e-15);
  EXPECT_EQ(rain.at(1.5 * day), 0);
  EXPECT_EQ(rain.at(9 * day), 0);  // the last row lasts as long as the one before, and then nothing is known to fall
  EXPECT_EQ(data.hydraulics.at(1).series, SeriesShape::steps);
}

TEST_F(SeriesFromFile, EvaporationIsTakenOff) {
  const Case data = read("# a station\ntime [day];rain [mm];et [mm]\n0;5,5;1\n2;0;3\n4;1;1\n",
                         "column = \"rain\", minus = \"et\"", "season = 0");
  const TimeTable rain = data.hydraulics.at(1).values();
  EXPECT_NEAR(rain.at(day), 4.5 * mm / (2 * day), 1e-15);
  EXPECT_NEAR(rain.at(3 * day), -3 * mm / (2 * day), 1e-15);
}

TEST_F(SeriesFromFile, RatesKeepTheirShape) {
  const Case data = read("time [h],rain [mm/h]\n0,0\n10,6\n", "column = \"rain\"");
  EXPECT_NEAR(data.hydraulics.at(1).values().at(5 * 3600.0), 3 * mm / 3600, 1e-15);
  EXPECT_EQ(data.hydraulics.at(1).series, SeriesShape::linear);
}

TEST_F(SeriesFromFile, TheEchoHasTheRows) {
  const Case data = read("date,rain [mm]\n2023-03-01,24\n2023-03-02,0\n", "column = \"rain\"");
  EXPECT_FALSE(data.hydraulics.at(1).rate.source);
  EXPECT_EQ(data.hydraulics.at(1).rate.time.size(), 3u);
  EXPECT_EQ(format_date(data.initial.date->seconds), "2023-03-01");
}

TEST_F(SeriesFromFile, FaultsNameFileAndLine) {
  const std::string rain = "column = \"rain\"";
  EXPECT_NE(fault("date,rain [mm]\n2023-03-01,1\n2023-03-01,2\n", rain).find("station.csv:3: its date is not after"),
            std::string::npos);
  EXPECT_NE(fault("date,rain [mm]\n2023-03-01,1\n2023-03-02,\n", rain).find("station.csv:3: no value of 'rain'"),
            std::string::npos);
  EXPECT_NE(fault(std::string("d\0a\0t\0e\0,\0", 10), rain).find("is in UTF-16; save it as UTF-8"), std::string::npos);
  EXPECT_NE(fault("date,rain [mm]\n01/03/2023,1\n", rain).find("'01/03/2023' is no date"), std::string::npos);
  EXPECT_NE(fault("date,rain [mm]\n2023-02-30,1\n", rain).find("'2023-02-30' is no date"), std::string::npos);
  EXPECT_NE(fault("date,rain\n2023-03-01,1\n", rain).find("has no unit; head it 'rain [mm]'"), std::string::npos);
  EXPECT_NE(fault("date,rainfall [mm]\n2023-03-01,1\n", rain).find("no column 'rain'"), std::string::npos);
  EXPECT_NE(fault("date,rain [kPa]\n2023-03-01,1\n2023-03-02,1\n", rain).find("is a stress"), std::string::npos);
  EXPECT_NE(fault("date,rain [mm]\n2023-03-01,1\n", rain).find("a single row"), std::string::npos);
  EXPECT_NE(fault("day,rain [mm]\n1,1\n", rain).find("no column 'date' and no column 'time'"), std::string::npos);
  EXPECT_NE(fault("date,rain [mm]\n2023-03-01,1\n2023-03-02,1\n", rain, "season = 0").find("[initial] date must say"),
            std::string::npos);
  EXPECT_NE(fault("date,rain [mm]\n2023-03-05,1\n2023-03-06,1\n", rain).find("begins at 2023-03-05, after 2023-03-01"),
            std::string::npos);
  EXPECT_NE(fault("", "colum = \"rain\"").find("no 'colum'"), std::string::npos);
  EXPECT_NE(fault("", "minus = \"rain\"").find("needs 'file' and 'column'"), std::string::npos);
}

TEST(Dates, AreReadAndWritten) {
  EXPECT_EQ(parse_date("1970-01-02"), day);
  EXPECT_EQ(parse_date("1970-01-01T06:30"), 6.5 * 3600);
  EXPECT_EQ(format_date(*parse_date("2024-02-29 23:59")), "2024-02-29 23:59");
  EXPECT_EQ(format_date(-60), "1969-12-31 23:59");
  EXPECT_FALSE(parse_date("2023-13-01"));
  EXPECT_FALSE(parse_date("2023-3-1"));
}

TEST_F(SeriesFromFile, MissingValuesAreRefused) {
  const std::string rain = "column = \"rain\"";
  for (const char* cell : {"-999", "-9999", "-99.9", "-999.0", "-999,00", "NaN", "nan", "NA", "N/A", "null", "", "-"}) {
    const std::string message =
        fault(fmt::format("date;rain [mm]\n2023-03-01;1\n2023-03-02;{}\n2023-03-03;1\n", cell), rain);
    EXPECT_NE(message.find("station.csv:3: no value of 'rain'; 1 of 3 values are missing"), std::string::npos)
        << cell << message;
    EXPECT_NE(message.find("fill = \"zero\""), std::string::npos) << message;
  }
  for (const char* cell : {"-9", "-9.9", "-98.9", "99.9", "-0.999"})
    EXPECT_EQ(fault(fmt::format("date;rain [mm]\n2023-03-01;1\n2023-03-02;{}\n", cell), rain), "") << cell;
  EXPECT_NE(fault("date,rain [mm]\n2023-03-01,1\n2023-03-02,wet\n", rain).find("'wet' is not a number"),
            std::string::npos);
}

TEST_F(SeriesFromFile, AMissingDayIsAGapWhereAllOthersAreThere) {
  std::string daily = "date,rain [mm]\n", events = daily;
  for (const int d : {1, 2, 3, 4, 5, 6, 9, 10, 11, 12}) daily += fmt::format("2023-03-{:02},{}\n", d, d);
  for (const int d : {1, 4, 5, 9, 17, 18, 30}) events += fmt::format("2023-03-{:02},{}\n", d, d);
  const std::string message = fault(daily, "column = \"rain\"");
  EXPECT_NE(message.find("station.csv:7: the rows after it are missing; 2 of 12 values"), std::string::npos) << message;
  EXPECT_EQ(fault(events, "column = \"rain\""), "") << "rows as they come";
}

/// Amounts in mm: the rain of the days around the gap is not spread over it.
TEST_F(SeriesFromFile, GapsAreFilledOnRequest) {
  const std::string table =
      "date,rain [mm]\n2023-03-01,2\n2023-03-02,4\n2023-03-03,-999\n2023-03-04,8\n2023-03-05,1\n"
      "2023-03-06,1\n2023-03-07,1\n2023-03-10,4\n2023-03-11,1\n2023-03-12,1\n2023-03-13,1\n";
  for (const auto& [fill, missing, gap] :
       std::vector<std::tuple<std::string, double, double>>{{"zero", 0, 0}, {"previous", 4, 1}, {"linear", 6, 2}}) {
    const TimeTable rain = read(table, "column = \"rain\", fill = \"" + fill + "\"").hydraulics.at(1).values();
    EXPECT_NEAR(rain.at(1.5 * day), 4 * mm / day, 1e-15) << fill;
    EXPECT_NEAR(rain.at(2.5 * day), missing * mm / day, 1e-15) << fill;
    EXPECT_NEAR(rain.at(6.5 * day), 1 * mm / day, 1e-15) << fill;
    EXPECT_NEAR(rain.at(7.5 * day), gap * mm / day, 1e-15) << fill;
  }
  EXPECT_NE(fault("date,rain [mm]\n2023-03-01,NA\n2023-03-02,1\n", "column = \"rain\", fill = \"previous\"")
                .find("station.csv:2: fill = \"previous\" has no value before it"),
            std::string::npos);
  EXPECT_NE(fault(table, "column = \"rain\", fill = \"none\"").find("choose one of zero, previous, linear"),
            std::string::npos);
}

}  // namespace
}  // namespace talus::input
