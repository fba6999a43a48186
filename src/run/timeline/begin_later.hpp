// SPDX-License-Identifier: MIT
#pragma once
// A case that begins at a later time.

#include <memory>

#include "input/case/case.hpp"

namespace talus::run {

/// The case without its timeline, whose time 0 is just before `time` [s]: it begins with `water` (none: as [initial]
/// says), and its series of [[hydraulic]] and of transpiration go on from there. A series that jumps at `time` jumps
/// after the beginning.
input::Case begin_later(input::Case data, double time, std::shared_ptr<const input::KnownWater> water);

}  // namespace talus::run
