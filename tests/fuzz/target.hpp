// SPDX-License-Identifier: MIT
#pragma once
// Common parts of the fuzz targets. A target processes bytes and may reject them with an Error; everything else ends
// the process.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

namespace talus::fuzz {

/// Runs `work`. Ends the process with its bytes in a file where `work` throws what the program would call a defect of
/// its own.
void try_to(const std::function<void()>& work);

/// The bytes as a file of this name, in a folder of this process in memory where there is one; always the same path.
const std::filesystem::path& as_file(std::span<const std::uint8_t> bytes, const char* name);

}  // namespace talus::fuzz

/// The name that libFuzzer calls; each target has one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
