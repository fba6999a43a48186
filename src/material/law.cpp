// SPDX-License-Identifier: MIT
#include "material/law.hpp"

#include "material/every_law.hpp"

namespace talus::material {

const Traits& get_traits(Model model) {
  return Laws::traits[static_cast<std::size_t>(model)];
}

std::string list_sliceable() {
  return list_words([](const Traits& t) { return t.serves_slices && !t.only_slices && t.strength == Strength::known; });
}

bool needs_block(Model model, int place) {
  bool answer = false;
  Laws::visit(model, [&]<class L>() {
    [&]<class... Block>(const Numbers<Block...>*) {
      const std::array needed{L::Input::template has<Block>...};
      answer = needed[static_cast<std::size_t>(place)];
    }(static_cast<const SoilNumbers*>(nullptr));
  });
  return answer;
}

std::string list_words(bool (*holds)(const Traits&), const char* last) {
  std::vector<std::string> words;
  for (const Traits& t : Laws::traits)
    if (holds(t)) words.push_back('"' + std::string(t.word) + '"');
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : i + 1 < words.size() ? ", " : last) + words[i];
  return text;
}

Law make_law(Model model, const SoilNumbers& in, const StrengthChange& change) {
  std::optional<Law> law;
  Laws::visit(model, [&]<class L>() { law.emplace(L::make(typename L::Input(in), change)); });
  return std::move(*law);
}

void check_soil(Model model, const SoilNumbers& in, const SoilFindings& findings) {
  Laws::visit(model, [&]<class L>() {
    if constexpr (requires { L::check(in, findings); }) L::check(in, findings);
  });
}

Properties list_properties(Model model, const SoilNumbers& in) {
  Properties list;
  Laws::visit(model, [&]<class L>() {
    if constexpr (requires { L::list_properties(in); }) list = L::list_properties(in);
  });
  return list;
}

Properties list_root_properties(Model model, const SoilNumbers& in, double content) {
  Properties list;
  Laws::visit(model, [&]<class L>() {
    if constexpr (requires { L::list_root_properties(in, content); }) list = L::list_root_properties(in, content);
  });
  return list;
}

std::string describe_model(Model model, const SoilNumbers& in) {
  std::string title = get_traits(model).title;
  Laws::visit(model, [&]<class L>() {
    if constexpr (requires { L::describe_model(in); }) title = L::describe_model(in);
  });
  return title;
}

std::optional<SliceStrength> find_slice_strength(Model model, const SoilNumbers& in) {
  std::optional<SliceStrength> strength;
  Laws::visit(model, [&]<class L>() {
    if constexpr (requires { L::find_slice_strength(in); }) strength = L::find_slice_strength(in);
  });
  return strength;
}

void divide_strength(Model model, SoilNumbers& in, PartialDivision& division) {
  Laws::visit(model, [&]<class L>() {
    using Changeable = typename L::Input::Changeable;
    if constexpr (requires { L::divide(Changeable(in), division); }) L::divide(Changeable(in), division);
  });
}

bool is_divisible(Model model) {
  bool answer = false;
  Laws::visit(model, [&]<class L>() {
    using Changeable = typename L::Input::Changeable;
    answer = requires(const Changeable& in, PartialDivision& division) {
      L::divide(in, division);
    };
  });
  return answer;
}

bool is_total_stress(Model model, const SoilNumbers& in) {
  bool answer = false;
  Laws::visit(model, [&]<class L>() {
    if constexpr (requires { L::is_total_stress(in); }) answer = L::is_total_stress(in);
  });
  return answer;
}

std::optional<Model> find_local_model(Model model, const SoilNumbers& in) {
  std::optional<Model> local;
  Laws::visit(model, [&]<class L>() {
    if constexpr (requires { L::varies(in); })
      if (L::varies(in)) local = model_of<typename L::Local>;
  });
  return local;
}

void stop_softening(Model& model, SoilNumbers& in) {
  Laws::visit(Model(model), [&]<class L>() {
    if constexpr (requires { typename L::Limit; }) {
      L::stop_softening(typename L::Input::Changeable(in));
      model = model_of<typename L::Limit>;
    }
  });
}

std::optional<double> find_oedometric_modulus(Model model, const SoilNumbers& in) {
  std::optional<double> modulus;
  Laws::visit(model, [&]<class L>() {
    if constexpr (requires { L::find_oedometric_modulus(in); })
      modulus = L::find_oedometric_modulus(in);
    else if constexpr (L::Input::template has<YoungInput>)
      if (in.young_modulus > 0) modulus = LinearElastic::make(in).constrained_modulus();
  });
  return modulus;
}

int state_size(const Law& law) {
  return std::visit([](const auto& l) { return l.state_size; }, law);
}

const Traits& traits_of(const Law& law) {
  return Laws::traits[law.index()];
}

void set_initial_state(const Law& law, const SoilNumbers& in, const StateStart& start, double* state) {
  std::visit(
      [&]<class L>(const L& l) {
        if constexpr (requires { l.set_initial_state(in, start, state); }) l.set_initial_state(in, start, state);
      },
      law);
}

void read_start(const Law& law, const double* state, StateStart& start) {
  std::visit(
      [&]<class L>(const L&) {
        if constexpr (requires { L::read_start(state, start); }) L::read_start(state, start);
      },
      law);
}

double constrained_modulus(const Law& law, const double* sigma, const double* state) {
  return std::visit([&](const auto& l) { return l.constrained_modulus(sigma, state); }, law);
}

std::optional<double> find_constant_modulus(const Law& law) {
  return std::visit(
      [](const auto& l) -> std::optional<double> {
        if constexpr (requires { l.constrained_modulus(); })
          return l.constrained_modulus();
        else
          return std::nullopt;
      },
      law);
}

template <int NS>
double elastic_energy(const Law& law, const double* sigma, const double* state) {
  return std::visit([&](const auto& l) { return l.template elastic_energy<NS>(sigma, state); }, law);
}
template double elastic_energy<4>(const Law&, const double*, const double*);
template double elastic_energy<6>(const Law&, const double*, const double*);

std::vector<StateField> list_state_fields(const Law& law) {
  return std::visit(
      []([[maybe_unused]] const auto& l) -> std::vector<StateField> {
        if constexpr (requires { l.fields(); })
          return l.fields();
        else
          return {};
      },
      law);
}

void show_state(const Law& law, const double* state, double saturation, double* values) {
  std::visit(
      [&]([[maybe_unused]] const auto& l) {
        if constexpr (requires { l.show(state, saturation, values); }) l.show(state, saturation, values);
      },
      law);
}

double find_gap(const Law& law, const double* state) {
  return std::visit(
      [&]([[maybe_unused]] const auto& l) {
        if constexpr (requires { l.find_gap(state); })
          return l.find_gap(state);
        else
          return 0.0;
      },
      law);
}

std::optional<LawFailure> take_failure(const Law& law) {
  return std::visit(
      []([[maybe_unused]] const auto& l) -> std::optional<LawFailure> {
        if constexpr (requires { l.take_failure(); })
          return l.take_failure();
        else
          return std::nullopt;
      },
      law);
}

}  // namespace talus::material
