// SPDX-License-Identifier: MIT
// Folders for the files of tests. Each process has one of its own, so that test runs at the same time do not collide.
#pragma once

#include <filesystem>
#include <string>

namespace talus::support {

/// The path `name` in the folder of this process, which is removed when the process exits. Nothing is made at the path.
std::filesystem::path name_scratch(const std::string& name);

/// An empty folder `name` in the folder of this process.
std::filesystem::path make_scratch(const std::string& name);

}  // namespace talus::support
