// SPDX-License-Identifier: MIT
#pragma once
// Files of others that are dropped on the page: `talus import` makes a case of them. Names and bytes come from a page
// and are hostile until they are checked here.

#include <filesystem>
#include <string>

#include "studio/workspace.hpp"

namespace talus::studio {

/// Decodes standard base64 (RFC 4648) with padding. Throws Refusal (400) for any other text.
std::string decode_base64(const std::string& text);

/// Imports files. `body` is JSON: {files: [{name, data: base64}], options: {units, lines, as, snap, base, analysis:
/// texts; layers, boreholes: lists of texts}}, with the meaning of the options of `talus import`. The files are stored
/// in a folder of their own below the state folder of `workspace`, `program` reads them as a child process of limited
/// time, and the folder is removed. Returns JSON {text: the case, remarks: [sentence]}. Throws Refusal with the
/// sentence of the program where it refuses the files, and for names, sizes and options that are not accepted.
std::string import_dropped(const Workspace& workspace, const std::filesystem::path& program, const std::string& body);

/// Notes of the page that belong to no case file, such as the material library and the place of a background picture:
/// a JSON text under a name.
class Asides {
 public:
  /// Makes the folder below the state folder of `workspace`.
  explicit Asides(const Workspace& workspace);
  /// Returns the text that was stored under `name`; "null" if there is none.
  std::string read(const std::string& name) const;
  /// Stores a JSON text, or removes it if it is "null". Throws Refusal for what is no JSON, too large, or one of too
  /// many.
  void write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path find(const std::string& name) const;
  std::filesystem::path folder_;
};

}  // namespace talus::studio
