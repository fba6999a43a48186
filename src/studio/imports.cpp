// SPDX-License-Identifier: MIT
#include "studio/imports.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "base/atomic_file.hpp"
#include "base/hash.hpp"
#include "base/text.hpp"
#include "base/user_file.hpp"
#include "studio/process.hpp"

namespace talus::studio {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::size_t most_files = 24, largest_import = 40 * largest_file::megabyte;
constexpr double longest_import = 90;  ///< [s]

/// A folder below the state folder that is removed with all its files at the end.
class ScratchFolder {
 public:
  explicit ScratchFolder(const fs::path& parent) {
    make_own_folder(parent);
    std::string name = (parent / "import-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw_cannot_write(parent, errno);
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Parses JSON that is not nested deeply; a discarded value for any other text.
json read_json(const std::string& text) {
  constexpr int deepest = 32;
  return json::parse(
      text,
      [](int depth, json::parse_event_t, json&) {
        if (depth > deepest) throw Refusal(400, "the JSON of the request is nested too deep");
        return true;
      },
      false);
}

void check_name(const std::string& name) {
  static const std::set<std::string> endings{".dxf", ".gpkg", ".geojson", ".json", ".gsz", ".csv",
                                             ".txt", ".tsv",  ".dat",     ".xyz",  ".ags"};
  const auto refuse = [&](const std::string& why) {
    throw Refusal(400, fmt::format("'{}' cannot be imported: {}", make_printable(name), why));
  };
  if (const std::string fault = find_name_fault(name); !fault.empty()) refuse(fault);
  if (find_wrong_utf8(name)) refuse("its name is not UTF-8");
  if (name.starts_with('.')) refuse("its name starts with a dot");
  if (!endings.contains(to_lower(fs::path(name).extension().string())))
    refuse(
        "its name must end in .dxf, .gpkg, .geojson or .json (drawings), .gsz (GeoStudio), or .csv, .txt, .tsv, .dat, "
        ".xyz or .ags (tables)");
}

/// Writes the files of a request into a folder. Returns their paths in the order of the request.
std::vector<fs::path> store_files(const json& files, const fs::path& folder) {
  if (!files.is_array() || files.empty() || files.size() > most_files)
    throw Refusal(400, fmt::format("an import takes 1 to {} files", most_files));
  std::vector<fs::path> paths;
  std::size_t total = 0;
  for (const json& file : files) {
    if (!file.is_object() || !file.value("name", json()).is_string() || !file.value("data", json()).is_string())
      throw Refusal(400, "each file of an import needs 'name' and 'data' as texts");
    const std::string name = file["name"].get<std::string>();
    check_name(name);
    const std::string bytes = decode_base64(file["data"].get_ref<const std::string&>());
    total += bytes.size();
    if (total > largest_import)
      throw Refusal(413, fmt::format("the files have more than {} MB in all; use talus import on the command line",
                                     largest_import / largest_file::megabyte));
    const fs::path path = folder / name;
    if (fs::exists(path)) throw Refusal(400, fmt::format("there are two files '{}'", make_printable(name)));
    write_atomically(path, bytes);
    paths.push_back(path);
  }
  return paths;
}

/// Options of the command line for those of a request.
std::vector<std::string> list_options(const json& options) {
  constexpr std::array single{"units", "lines", "as", "snap", "base", "analysis"};
  constexpr std::array repeated{"layers", "boreholes"};
  constexpr std::size_t most_values = 200, longest_value = 300;
  std::vector<std::string> arguments;
  if (options.is_null()) return arguments;
  if (!options.is_object()) throw Refusal(400, "the options of an import must be a JSON object");
  for (const auto& [key, value] : options.items()) {
    const auto is_among = [&key = key](const auto& names) {
      return std::any_of(names.begin(), names.end(), [&](const char* name) { return key == name; });
    };
    const auto add = [&, &key = key](const json& text) {
      if (!text.is_string()) throw Refusal(400, fmt::format("the option '{}' must be a text", make_printable(key)));
      const std::string& read = text.get_ref<const std::string&>();
      if (read.size() > longest_value || read.find('\0') != std::string::npos)
        throw Refusal(400, fmt::format("the option '{}' is too long", make_printable(key)));
      if (!read.empty()) arguments.push_back(fmt::format("--{}={}", key, read));
    };
    if (is_among(single))
      add(value);
    else if (is_among(repeated) && value.is_array() && value.size() <= most_values)
      std::for_each(value.begin(), value.end(), add);
    else
      throw Refusal(400, fmt::format("there is no option '{}' of an import", make_printable(key)));
  }
  return arguments;
}

std::string read_output(const fs::path& file) {
  std::string text;
  if (try_user_file(file, largest_file::megabyte, text)) return "";
  return text;
}

/// The sentence of a message of the program, without the folder in which the files were.
std::string clean_message(std::string text, const fs::path& folder) {
  const std::string place = folder.string() + "/";
  for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place)) text.erase(at, place.size());
  for (const char* prefix : {"talus: ", "error: "})
    if (text.starts_with(prefix)) text.erase(0, std::strlen(prefix));
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

}  // namespace

std::string decode_base64(const std::string& text) {
  static const std::array<int, 256> values = [] {
    std::array<int, 256> made{};
    made.fill(-1);
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < letters.size(); ++i) made[static_cast<unsigned char>(letters[i])] = static_cast<int>(i);
    return made;
  }();
  const auto refuse = [] { throw Refusal(400, "the content of a file must be base64"); };
  if (text.size() % 4 != 0) refuse();
  std::size_t padding = 0;
  while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=') ++padding;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  unsigned group = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_padding = i + padding >= text.size();
    const int value = is_padding ? 0 : values[static_cast<unsigned char>(text[i])];
    if (value < 0) refuse();
    group = group << 6 | static_cast<unsigned>(value);
    if (i % 4 != 3) continue;
    for (const int shift : {16, 8, 0}) bytes.push_back(static_cast<char>(group >> shift & 0xff));
    group = 0;
  }
  bytes.resize(bytes.size() - padding);
  return bytes;
}

std::string import_dropped(const Workspace& workspace, const fs::path& program, const std::string& body) {
  const json asked = read_json(body);
  if (!asked.is_object()) throw Refusal(400, "the body of an import must be a JSON object");
  const std::vector<std::string> options = list_options(asked.value("options", json()));
  const ScratchFolder scratch(workspace.state() / "imports");
  const fs::path inputs = scratch.path() / "files", output = scratch.path() / "case.toml";
  make_folder(inputs);
  std::vector<std::string> arguments{"talus", "import"};
  for (const fs::path& path : store_files(asked.value("files", json()), inputs)) arguments.push_back(path.string());
  arguments.insert(arguments.end(), {"-o", output.string()});
  arguments.insert(arguments.end(), options.begin(), options.end());
  std::string why;
  const int process = start_process(program, arguments, {scratch.path() / "out", scratch.path() / "err"}, why);
  if (process == 0) throw Refusal(500, why);
  const int status = wait_for_process(process, longest_import).value_or(-1);
  const std::string said = clean_message(read_output(scratch.path() / "err"), inputs);
  if (status < 0) throw Refusal(400, "the files were not read within 90 s, or the program crashed on them");
  if (status != 0) throw Refusal(400, said.empty() ? "the files cannot be imported" : said);
  std::string text;
  if (try_user_file(output, largest_file::case_file, text))
    throw Refusal(413, "the case of these files is larger than a case file may be");
  // Remarks are the indented lines of the output.
  json remarks = json::array();
  const std::string printed = clean_message(read_output(scratch.path() / "out"), inputs);
  for (std::size_t from = 0; from < printed.size();) {
    const std::size_t end = std::min(printed.find('\n', from), printed.size());
    if (printed.compare(from, 2, "  ") == 0) remarks.push_back(printed.substr(from + 2, end - from - 2));
    from = end + 1;
  }
  return json{{"text", text}, {"remarks", remarks}}.dump(-1, ' ', false, json::error_handler_t::replace);
}

Asides::Asides(const Workspace& workspace) : folder_(workspace.state() / "aside") {
  make_own_folder(folder_);
}

fs::path Asides::find(const std::string& name) const {
  constexpr std::size_t longest = 1200;
  if (name.empty() || name.size() > longest) throw Refusal(404, "there is no such note");
  return folder_ / (hash_text(name) + ".json");
}

std::string Asides::read(const std::string& name) const {
  std::string text;
  if (try_user_file(find(name), largest_import, text) || json::parse(text, nullptr, false).is_discarded())
    return "null";
  return text;
}

void Asides::write(const std::string& name, const std::string& text) const {
  constexpr std::size_t most_notes = 500;
  const fs::path file = find(name);
  if (text.size() > largest_import)
    throw Refusal(413, fmt::format("a note has at most {} MB", largest_import / largest_file::megabyte));
  const json read = read_json(text);
  if (read.is_discarded()) throw Refusal(400, "a note must be JSON");
  const FileLock lock(folder_ / "notes.lock");
  if (read.is_null()) return remove_file(file);
  std::error_code failure;
  const auto count = std::distance(fs::directory_iterator(folder_, failure), fs::directory_iterator());
  if (!fs::exists(file) && count > static_cast<std::ptrdiff_t>(most_notes))
    throw Refusal(507, "too many notes are stored for this folder");
  write_atomically(file, text);
}

}  // namespace talus::studio
