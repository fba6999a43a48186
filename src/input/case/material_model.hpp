#pragma once
// How stress follows strain: the laws of [materials.NAME].

#include <array>

#include "input/language/spec.hpp"

namespace talus::input {

enum class MaterialModel {
  linear_elastic,
  mohr_coulomb,
  rooted_mohr_coulomb,
  modified_cam_clay,
  rooted_cam_clay,
  external
};

template <>
inline constexpr auto choices<MaterialModel> = std::array{
    Choice{MaterialModel::mohr_coulomb, "mohr_coulomb",
           "linear elastic, perfectly plastic with Mohr–Coulomb's strength"},
    Choice{MaterialModel::rooted_mohr_coulomb, "rooted_mohr_coulomb", "the same with the cohesion of roots added"},
    Choice{MaterialModel::modified_cam_clay, "modified_cam_clay",
           "modified Cam-clay, hardening with plastic volume and with suction (Tamagnini)"},
    Choice{MaterialModel::rooted_cam_clay, "rooted_cam_clay",
           "the same with roots that harden and strengthen the soil (Świtała et al.)"},
    Choice{MaterialModel::linear_elastic, "linear_elastic", "linear elastic, without any strength limit"},
    Choice{MaterialModel::external, "external", "a compiled UMAT of Abaqus"},
};

}  // namespace talus::input
