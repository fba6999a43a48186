#pragma once
// What answers: the three methods, and the methods of slices. One word for each, from the case to the page.

namespace talus {

/// Slices, finite elements, material points.
enum class Method { lem, fem, mpm };

enum class SliceMethod {
  fellenius,
  bishop,
  janbu,
  janbu_corrected,
  spencer,
  morgenstern_price,
  morgenstern_price_constant
};

}  // namespace talus
