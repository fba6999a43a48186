#include "material/law.hpp"

namespace talus::material {

double constrained_modulus(const Law& law, const double* sigma, const double* state) {
  return std::visit(
      [&]<class L>(const L& l) {
        if constexpr (is_cam_clay<L>)
          return l.constrained_modulus(sigma, state);
        else
          return l.constrained_modulus();
      },
      law);
}

bool has_changing_stiffness(const Law& law) {
  return std::visit([]<class L>(const L&) { return is_cam_clay<L>; }, law);
}

template <int NS>
double elastic_energy(const Law& law, const double* sigma, const double* state) {
  return std::visit(
      [&]<class L>(const L& l) {
        if constexpr (is_cam_clay<L>)
          return l.template elastic_energy<NS>(sigma, state);
        else
          return l.template elastic_energy<NS>(sigma);
      },
      law);
}
template double elastic_energy<4>(const Law&, const double*, const double*);
template double elastic_energy<6>(const Law&, const double*, const double*);

std::vector<StateField> list_state_fields(const Law& law) {
  return std::visit(
      []<class L>([[maybe_unused]] const L& l) {
        std::vector<StateField> list;
        if constexpr (is_cam_clay<L> || std::is_same_v<L, RootedMohrCoulomb>) {
          for (const StateField& field : L::fields()) list.push_back(field);
        }
        if constexpr (std::is_same_v<L, External>) list = l.fields();
        return list;
      },
      law);
}

void show_state(const Law& law, const double* state, double saturation, double* values) {
  if (const auto* soil = std::get_if<ModifiedCamClay>(&law)) soil->show(state, saturation, values);
  if (const auto* soil = std::get_if<RootedCamClay>(&law)) soil->show(state, saturation, values);
  if (std::holds_alternative<RootedMohrCoulomb>(law)) values[0] = state[1];
  if (const auto* model = std::get_if<External>(&law)) std::copy_n(state + 1, model->parameters().states, values);
}

}  // namespace talus::material
