// SPDX-License-Identifier: MIT
// Checks of a mesh file that Gmsh does not make: the format and, in a text file, that all nodes of elements exist.
// Format: https://gmsh.info/doc/texinfo/gmsh.html#MSH-file-format, versions 4.0 and 4.1.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string_view>
#include <unordered_set>

#include "base/error.hpp"
#include "base/user_file.hpp"
#include "mesh/gmsh_mesh.hpp"

namespace talus::mesh {

namespace {

/// Returns the number of nodes of Gmsh's linear element types; 0 for other types, which are rejected later by name.
int count_nodes(long type) {
  constexpr std::array<int, 16> nodes{0, 2, 3, 4, 4, 8, 6, 5, 0, 0, 0, 0, 0, 0, 0, 1};
  return type > 0 && type < static_cast<long>(nodes.size()) ? nodes[static_cast<std::size_t>(type)] : 0;
}

/// Parser of a text file by words.
class MeshText {
 public:
  explicit MeshText(const std::string& path) : path_(path), file_(path, std::ios::binary), buffer_(longest_line, '\0') {
    file_.seekg(0, std::ios::end);
    size_ = static_cast<long>(file_.tellg());
    file_.seekg(0);
  }

  [[noreturn]] void fail(const std::string& what) const {
    fail_input("mesh file '{}', line {}: {}", path_, line_, what);
  }

  /// Reads the next line without trailing blanks; returns false at the end of the file.
  bool next_line() {
    file_.getline(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    ++line_;
    const auto size = static_cast<std::size_t>(file_.gcount());
    if (file_.fail() && size > 0) fail(fmt::format("it has more than {} characters", longest_line));
    if (file_.fail()) return false;
    text_.assign(buffer_.data(), file_.eof() ? size : size - 1);
    while (!text_.empty() && (text_.back() == '\r' || text_.back() == ' ')) text_.pop_back();
    at_ = 0;
    return true;
  }
  const std::string& line() const { return text_; }

  /// Reads the next integer on this or a later line.
  long take_number(const char* what) {
    const std::string_view word = take_word(what);
    long value = 0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc() || end != word.data() + word.size())
      fail(fmt::format("'{}' is not {}, a whole number", word.substr(0, longest_shown), what));
    return value;
  }
  /// Reads a number of entries, which is limited by the file size: each entry has at least two bytes.
  long take_count(const char* what) {
    const long count = take_number(what);
    if (count < 0 || count > size_ / 2) fail(fmt::format("{} cannot be {}", what, count));
    return count;
  }
  void skip_words(int count) {
    for (int i = 0; i < count; ++i) take_word("a coordinate");
  }
  void skip_line() { at_ = text_.size(); }

 private:
  std::string_view take_word(const char* what) {
    for (;;) {
      at_ = text_.find_first_not_of(" \t", at_);
      if (at_ != std::string::npos) break;
      if (!next_line()) fail(fmt::format("the file ends where {} should stand", what));
    }
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(" \t", begin), text_.size());
    return std::string_view(text_).substr(begin, at_ - begin);
  }

  /// Limits on the characters of a line, and of a word in a message.
  static constexpr std::size_t longest_line = 1 << 16, longest_shown = 40;

  std::string path_;
  std::ifstream file_;
  std::string buffer_;
  long size_ = 0;
  std::string text_;
  std::size_t at_ = 0;
  int line_ = 0;
};

struct Header {
  double version = 0;
  bool is_binary = false;
};

Header read_header(const std::string& path) {
  if (const auto fault = find_file_fault(path, largest_file::mesh))
    fail_input("mesh file '{}' cannot be opened: {}", path, fault->why);
  std::array<char, 256> begin{};  // the beginning of a file, which may have no line breaks
  std::ifstream whole(path, std::ios::binary);
  whole.read(begin.data(), begin.size());
  std::istringstream file(std::string(begin.data(), static_cast<std::size_t>(whole.gcount())));
  std::string first;
  Header header;
  int kind = 0;
  file >> first;
  if (first != "$MeshFormat" || !(file >> header.version))
    fail_input("'{}' is not a Gmsh mesh: it does not begin with $MeshFormat", path);
  if (header.version < 4 || header.version >= 5)
    fail_input("mesh file '{}' has format version {}: version 4 is needed (gmsh -save -format msh4 writes it)", path,
               header.version);
  header.is_binary = (file >> kind) && kind != 0;
  return header;
}

/// Header of a block of nodes or elements: flag of parametric coordinates or element type, and number of entries.
struct Block {
  long holds = 0, count = 0;
};

Block take_block(MeshText& file, const char* holds) {
  file.take_number("the dimension of a block");
  file.take_number("the number of a block");
  const long first = file.take_number(holds);
  return {first, file.take_count("the size of a block")};
}

/// Reads the number of blocks and of all entries; from version 4.1 also the smallest and largest tag.
long take_section(MeshText& file, bool has_range) {
  const long blocks = file.take_count("the number of blocks");
  file.take_count("the number of entries");
  if (has_range) file.take_number("the smallest number"), file.take_number("the largest number");
  return blocks;
}

std::unordered_set<long> read_nodes(MeshText& file, bool is_4_1) {
  std::unordered_set<long> nodes;
  const auto take_node = [&] {
    const long number = file.take_number("the number of a node");
    if (number <= 0) file.fail(fmt::format("a node has the number {}; they count from 1", number));
    nodes.insert(number);
  };
  for (long left = take_section(file, is_4_1); left > 0; --left) {
    const Block block = take_block(file, "whether a block has parameters");
    for (long i = 0; i < block.count && is_4_1; ++i) take_node();
    for (long i = 0; i < block.count; ++i) {
      if (!is_4_1) take_node();
      file.skip_words(3);
      if (block.holds != 0) file.skip_line();  // parametric coordinates, as many as the dimension of the entity
    }
  }
  return nodes;
}

void check_elements(MeshText& file, bool is_4_1, const std::unordered_set<long>& nodes) {
  for (long left = take_section(file, is_4_1); left > 0; --left) {
    const Block block = take_block(file, "the type of a block's elements");
    const int per_element = count_nodes(block.holds);
    if (per_element == 0) return;
    for (long i = 0; i < block.count; ++i) {
      const long number = file.take_number("the number of an element");
      for (int k = 0; k < per_element; ++k) {
        const long node = file.take_number("a node of an element");
        if (!nodes.contains(node)) file.fail(fmt::format("element {} has node {}, which does not exist", number, node));
      }
    }
  }
}

}  // namespace

void check_mesh_file(const std::string& path) {
  const Header header = read_header(path);
  if (header.is_binary) return;
  constexpr double with_ranges = 4.05;  // between versions 4.0 and 4.1
  const bool is_4_1 = header.version > with_ranges;
  MeshText file(path);
  std::unordered_set<long> nodes;
  bool has_nodes = false;
  while (file.next_line()) {
    if (file.line() == "$Nodes") {
      file.skip_line();
      nodes = read_nodes(file, is_4_1);
      has_nodes = true;
    } else if (file.line() == "$Elements") {
      if (!has_nodes) file.fail("elements stand before the nodes");
      file.skip_line();
      check_elements(file, is_4_1, nodes);
    }
  }
}

}  // namespace talus::mesh
