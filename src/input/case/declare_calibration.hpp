#pragma once
// [calibration]: parameters and measured curves of `talus calibrate`.

#include "input/case/case.hpp"
#include "input/language/codec.hpp"

namespace talus::input {

template <>
inline constexpr auto choices<CalibrationScale> = std::array{
    Choice{CalibrationScale::linear, "linear", "equal steps of the number itself"},
    Choice{CalibrationScale::log, "log", "equal steps of its logarithm, for a number whose order is unknown"},
};

template <class Visitor>
void describe(Visitor& v, CalibrationParameter& p) {
  v.key("key", p.key, plain().required().example(R"("materials.sand.young_modulus")"),
        "The number of a material that is fitted, written as for --set. A test that sets it keeps its own value.");
  v.key("min", p.min, plain().required().example("5000"),
        "Its smallest value: a number in the unit of the key, or a text with a unit.");
  v.key("max", p.max, plain().required().example(R"("80 MPa")"), "Its largest value.");
  v.key("start", p.start, plain().example("20000"),
        "Where the search begins; if not given, at the value that the material has.");
  v.key("scale", p.scale, plain(), "How the search moves between the smallest and the largest value.");
}

template <class Visitor>
void describe(Visitor& v, MeasuredCurve& c) {
  v.key("test", c.test, plain().required().example(R"("cell 100 kPa")"), "Name of the [[test]] that was measured.");
  v.key("x", c.x, plain().required().example(R"("axial_strain")"),
        "Abscissa, a column of the tables of `talus point`: axial_strain, axial_stress, p, suction …");
  v.key("y", c.y, plain().required().example(R"("q")"),
        "Ordinate, whose differences are made small: q, volumetric_strain, void_ratio …");
  v.key("file", c.file, plain().example(R"("measured/cell_100.csv")"),
        "Table with a column for x and one for y, headed with their names and units, such as `axial_strain [%],q "
        "[kPa]`; relative to the case file. Rows are in the order of the measurement.");
  v.key("data", c.data, plain().needed_without("file", !c.file.empty()).example("[[0.05, 165.1], [0.1, 226.2]]"),
        "The rows themselves, [[x, y], ...].");
  v.key("x_unit", c.x_unit, plain().allowed_without("file", !c.file.empty()).example(R"("%")"),
        "Unit of x in `data`; if not given, kPa for stresses and none for the rest.");
  v.key("y_unit", c.y_unit, plain().allowed_without("file", !c.file.empty()).example(R"("MPa")"),
        "Unit of y in `data`, in the same way.");
  v.key("error", c.error, plain().above(0).example(R"("3 kPa")"),
        "Standard error of the measured y: in per cent of the largest measured value, or an amount. If not given, 1 %. "
        "Differences count in parts of it.");
  v.key("weight", c.weight, plain().at_least(0),
        "Factor of the differences of this curve; 0: the curve is shown and not fitted.");
}

template <class Visitor>
void describe(Visitor& v, Calibration& c) {
  v.key(
      "starts", c.starts, plain().at_least(1).at_most(1000),
      "Number of searches: one from `start`, the others from random values between `min` and `max`. The best counts.");
  v.key("seed", c.seed, plain().at_least(0), "Seed of the random values; equal seeds give equal results.");
  v.key("iterations", c.iterations, plain().at_least(1), "Largest number of iterations of each search.");
  v.tables("parameter", c.parameters, 0, "A number that is fitted.");
  v.tables("curve", c.curves, 0, "A measured curve.");
}

}  // namespace talus::input
