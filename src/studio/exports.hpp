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

/// Returns a text that changes with any file of a folder of results, by their names, sizes and times.
std::string stamp_results(const std::filesystem::path& results);

/// Returns the data of the report of a run, which may be in progress, as `talus report RESULTS --data FILE` writes
/// them. Throws Refusal if there are no results yet.
std::string read_report_data(const Workspace& workspace, const std::filesystem::path& program,
                             const std::filesystem::path& results);

}  // namespace talus::studio
