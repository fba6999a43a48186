// SPDX-License-Identifier: MIT
#pragma once
// How every type of a key is written: for visitors of the whole case.

#include "input/language/codec_list.hpp"
#include "input/language/codec_series.hpp"
#include "input/language/codec_shares.hpp"
#include "input/language/codec_turns.hpp"
