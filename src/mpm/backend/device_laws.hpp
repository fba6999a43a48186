// SPDX-License-Identifier: MIT
#pragma once
// Constitutive laws on a GPU: stored as bytes with the index of their kind, because std::visit does not work there.

#include <cstring>
#include <type_traits>
#include <utility>

#include "mpm/kernels/laws.hpp"

namespace talus::mpm {

/// Laws that call a user's library or iterate run on the CPU only; others are stored as the class whose update a step
/// calls.
template <class L>
inline constexpr bool runs_on_device =
    !L::traits.is_opaque && std::is_same_v<L, std::decay_t<decltype(material::get_kernel(std::declval<const L&>()))>>;

/// Limit of the bit sets of materials in laws.hpp.
inline constexpr int most_laws = 32;

/// A law stored as bytes.
struct StoredLaw {
  static constexpr std::size_t room = sizeof(material::Law);
  alignas(material::Law) unsigned char bytes[room];
  int kind;  ///< index in material::Law
  int states;
  bool softens;

  template <class L>
  TALUS_PORTABLE const L& get() const {
    return *reinterpret_cast<const L*>(bytes);
  }
  /// Calls work(law) with the stored law.
  TALUS_PORTABLE void visit(auto&& work) const {
    visit_kinds(work, std::make_index_sequence<std::variant_size_v<material::Law>>());
  }

 private:
  template <class Work, std::size_t... Kind>
  TALUS_PORTABLE void visit_kinds(Work& work, std::index_sequence<Kind...>) const {
    static_cast<void>(((kind == static_cast<int>(Kind) ? (visit_kind<Kind>(work), true) : false) || ...));
  }
  template <std::size_t Kind, class Work>
  TALUS_PORTABLE void visit_kind(Work& work) const {
    using L = std::variant_alternative_t<Kind, material::Law>;
    if constexpr (runs_on_device<L>) work(get<L>());
  }
};

/// Index of `L` in material::Law.
template <class L, std::size_t Kind = 0>
constexpr int find_kind() {
  if constexpr (std::is_same_v<L, std::variant_alternative_t<Kind, material::Law>>)
    return static_cast<int>(Kind);
  else
    return find_kind<L, Kind + 1>();
}

struct DeviceLaws {
  const StoredLaw* laws = nullptr;
  std::uint32_t count = 0;
  int states = 0;  ///< largest number of state variables of a law

  TALUS_PORTABLE std::uint32_t size() const { return count; }
  TALUS_PORTABLE const StoredLaw& operator[](int m) const { return laws[m]; }
};

/// Stores a law, which must run on a device.
inline StoredLaw store_law(const material::Law& law) {
  StoredLaw stored{};
  stored.states = material::state_size(law);
  stored.softens = material::traits_of(law).softens;
  std::visit(
      [&](const auto& given) {
        const auto& kernel = material::get_kernel(given);
        using L = std::decay_t<decltype(kernel)>;
        if constexpr (runs_on_device<L>) {
          stored.kind = find_kind<L>();
          static_assert(std::is_trivially_copyable_v<L>);
          std::memcpy(stored.bytes, &kernel, sizeof kernel);
        }
      },
      law);
  return stored;
}

// Functions of a law in a list (see laws.hpp).

TALUS_PORTABLE void visit_law(const DeviceLaws& laws, std::uint32_t m, auto&& work) {
  laws[static_cast<int>(m)].visit(work);
}
TALUS_PORTABLE inline bool law_softens(const DeviceLaws& laws, std::uint32_t m) {
  return laws[static_cast<int>(m)].softens;
}
TALUS_PORTABLE inline int count_states(const DeviceLaws& laws, int m) {
  return laws[m].states;
}
TALUS_PORTABLE inline double find_modulus(const DeviceLaws& laws, int m, const double* sigma, const double* state) {
  double modulus = 0;
  laws[m].visit([&](const auto& law) { modulus = law.constrained_modulus(sigma, state); });
  return modulus;
}
template <int NS>
TALUS_PORTABLE double find_energy(const DeviceLaws& laws, int m, const double* sigma, const double* state) {
  double energy = 0;
  laws[m].visit([&](const auto& law) { energy = law.template elastic_energy<NS>(sigma, state); });
  return energy;
}
TALUS_PORTABLE inline double find_gap(const DeviceLaws& laws, int m, const double* state) {
  double gap = 0;
  laws[m].visit([&](const auto& law) {
    if constexpr (requires { law.find_gap(state); }) gap = law.find_gap(state);
  });
  return gap;
}

}  // namespace talus::mpm
