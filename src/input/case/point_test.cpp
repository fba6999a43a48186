#include "input/case/point_test.hpp"

namespace talus::input {

bool PointTest::is_triaxial() const {
  return kind == PointTestKind::drained_triaxial || kind == PointTestKind::undrained_triaxial;
}

bool PointTest::has_cell() const {
  return is_triaxial() || kind == PointTestKind::isotropic_compression || kind == PointTestKind::wetting;
}

const std::vector<double>& PointTest::goals() const {
  if (kind == PointTestKind::wetting) return suction;
  const bool shears = kind == PointTestKind::simple_shear;
  if (control == PointControl::strain) return shears ? shear_strain : axial_strain;
  return shears ? shear_stress : axial_stress;
}

const std::vector<PointQuantity>& list_point_quantities() {
  static const std::vector<PointQuantity> list{
      {"time", "running parameter", "", "-"},
      {"axial_strain", "axial strain", "εₐ", "-"},
      {"radial_strain", "radial strain", "εᵣ", "-"},
      {"shear_strain", "shear strain", "γ", "-"},
      {"volumetric_strain", "volumetric strain", "εᵥ", "-"},
      {"deviatoric_strain", "deviatoric strain", "", "-"},
      {"axial_stress", "axial effective stress", "σ′ₐ", "Pa"},
      {"radial_stress", "radial effective stress", "σ′ᵣ", "Pa"},
      {"shear_stress", "shear stress", "τ", "Pa"},
      {"p", "mean effective stress", "p′", "Pa"},
      {"q", "deviatoric stress", "q", "Pa"},
      {"pore_pressure", "excess pore pressure", "Δu", "Pa"},
      {"suction", "suction", "s", "Pa"},
      {"saturation", "degree of saturation", "S", "-"},
      {"void_ratio", "void ratio", "e", "-"},
      {"preconsolidation", "preconsolidation pressure", "p′c", "Pa"},
  };
  return list;
}

}  // namespace talus::input
