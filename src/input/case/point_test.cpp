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
      {"axial_strain", "axial strain", "εₐ", "-", PointQuantityKind::strain},
      {"radial_strain", "radial strain", "εᵣ", "-", PointQuantityKind::strain},
      {"shear_strain", "shear strain", "γ", "-", PointQuantityKind::strain},
      {"volumetric_strain", "volumetric strain", "εᵥ", "-", PointQuantityKind::strain},
      {"deviatoric_strain", "deviatoric strain", "", "-", PointQuantityKind::strain},
      {"axial_stress", "axial effective stress", "σ′ₐ", "Pa", PointQuantityKind::stress},
      {"radial_stress", "radial effective stress", "σ′ᵣ", "Pa", PointQuantityKind::stress},
      {"shear_stress", "shear stress", "τ", "Pa", PointQuantityKind::stress},
      {"p", "mean effective stress", "p′", "Pa", PointQuantityKind::stress},
      {"q", "deviatoric stress", "q", "Pa", PointQuantityKind::stress},
      {"pore_pressure", "excess pore pressure", "Δu", "Pa", PointQuantityKind::stress},
      {"suction", "suction", "s", "Pa", PointQuantityKind::stress},
      {"saturation", "degree of saturation", "S", "-"},
      {"void_ratio", "void ratio", "e", "-"},
      {"preconsolidation", "preconsolidation pressure", "p′c", "Pa", PointQuantityKind::stress},
  };
  return list;
}

PointQuantityKind find_point_quantity_kind(const std::string& name) {
  for (const PointQuantity& quantity : list_point_quantities())
    if (name == quantity.name) return quantity.kind;
  return PointQuantityKind::other;
}

}  // namespace talus::input
