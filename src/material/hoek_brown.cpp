// SPDX-License-Identifier: MIT
#include "material/hoek_brown.hpp"

#include <cmath>

namespace talus::material {

HoekBrownMass make_rock_mass(const HoekBrownInput& in) {
  return {in.intact_strength, in.intact_constant * std::exp((in.gsi - 100) / (28 - 14 * in.disturbance)),
          std::exp((in.gsi - 100) / (9 - 3 * in.disturbance)),
          0.5 + (std::exp(-in.gsi / 15) - std::exp(-20.0 / 3)) / 6};
}

Properties HoekBrown::list_properties(const Input& in) {
  const HoekBrownInput& rock = in.get<HoekBrownInput>();
  const HoekBrownMass mass = make_rock_mass(rock);
  return {
      {"intact_strength", "uniaxial strength of the intact rock", "σ_ci", ShownAs::stress, rock.intact_strength, {}},
      {"gsi", "Geological Strength Index", "GSI", ShownAs::number, rock.gsi, {}},
      {"intact_constant", "constant of the intact rock", "m_i", ShownAs::number, rock.intact_constant, {}},
      {"disturbance", "disturbance", "D", ShownAs::number, rock.disturbance, {}},
      {"rock_mass_constant", "constant of the rock mass", "m_b", ShownAs::number, mass.m, {}},
      {"rock_mass_s", "constant of the rock mass", "s", ShownAs::number, mass.s, {}},
      {"rock_mass_exponent", "exponent of the rock mass", "a", ShownAs::number, mass.a, {}}};
}

}  // namespace talus::material
