// SPDX-License-Identifier: MIT
#pragma once
// Files that the page offers for download: the section as DXF, the tables of results as XLSX. `talus export` writes
// them in a child process, because GDAL and libxlsxwriter are modules with many dependencies.

#include <filesystem>
#include <string>

#include "studio/workspace.hpp"

namespace talus::studio {

/// Returns the bytes of an export of a folder of results; `format`: "dxf" or "xlsx". Throws Refusal.
std::string export_results(const Workspace& workspace, const std::filesystem::path& program,
                           const std::filesystem::path& results, const std::string& format);

/// Returns the section of the text of a case as DXF. `path`: its file, beside which its tables are; may be empty.
/// Throws Refusal.
std::string export_case(const Workspace& workspace, const std::filesystem::path& program, const std::string& text,
                        const std::string& path);

}  // namespace talus::studio
