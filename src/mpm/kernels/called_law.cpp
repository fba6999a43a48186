// SPDX-License-Identifier: MIT
#include "mpm/kernels/called_law.hpp"

#include <variant>

namespace talus::mpm {

template <int NS>
material::Response<Pack> update_called(const material::Law& law, Pack* sigma, const Pack* d_epsilon, Pack* state,
                                       MaskOf<Pack> active, const material::Surroundings<Pack>& around) {
  return std::visit(
      [&](const auto& given) -> material::Response<Pack> {
        const auto& kernel = material::get_kernel(given);
        if constexpr (is_called<std::decay_t<decltype(kernel)>>)
          return kernel.template update<NS>(sigma, d_epsilon, state, active, around);
        else
          return {false, Pack(0.0), Pack(0.0)};  // not called
      },
      law);
}
template material::Response<Pack> update_called<4>(const material::Law&, Pack*, const Pack*, Pack*, MaskOf<Pack>,
                                                   const material::Surroundings<Pack>&);
template material::Response<Pack> update_called<6>(const material::Law&, Pack*, const Pack*, Pack*, MaskOf<Pack>,
                                                   const material::Surroundings<Pack>&);

}  // namespace talus::mpm
