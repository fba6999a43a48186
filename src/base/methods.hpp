#pragma once
// What answers: the three methods, and the methods of slices. One word for each, from the case to the page.

namespace talus {

/// Slices, finite elements, material points.
enum class Method { lem, fem, mpm };

enum class SliceMethod {
  fellenius,                  ///< ordinary method; with water N' = W cosα - u l (the classical form)
  bishop,                     ///< simplified; polylines: moments about the centre of the fitted circle, says so
  janbu,                      ///< simplified, f_0 = 1
  janbu_corrected,            ///< simplified times f_0
  spencer,                    ///< parallel interslice forces
  morgenstern_price,          ///< half-sine interslice function
  morgenstern_price_constant  ///< constant interslice function: Spencer's forces by the other formulation
};

}  // namespace talus
