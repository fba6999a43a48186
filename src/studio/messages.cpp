// SPDX-License-Identifier: MIT
#include "studio/messages.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "run/case_picture.hpp"

namespace talus::studio {

using nlohmann::json;

MessageWriter::MessageWriter(const std::string& text, const input::Sketch& sketch)
    : lines_(text),
      sketch_(sketch),
      ground_(run::find_sketched_ground(sketch)),
      spans_(find_spans(text)),
      size_(text.size()) {
  for (const auto& [path, span] : spans_.keys) names_.emplace(span[0], path);
  // A list of tables begins where its first table does; the longer path is that of the table.
  for (const auto& [path, span] : spans_.values)
    if (std::string& known = starts_[span[0]]; path.size() > known.size()) known = path;
}

void MessageWriter::add(const char* severity, const Diagnostic& message, json& list) const {
  constexpr std::size_t most_places = 300;  // of a hostile text with very many faults
  json& out = list.emplace_back();
  out["severity"] = severity;
  out["text"] = message.sentence;
  out["line"] = message.line;
  out["column"] = message.column;
  out["key"] = "";
  out["span"] = out["place"] = nullptr;
  if (message.line > 0) add_place(message, out);
  if (list.size() > most_places) return;
  if (const auto place = run::find_message_place(sketch_, ground_, message)) out["place"] = *place;
}

void MessageWriter::add_place(const Diagnostic& message, json& out) const {
  const std::size_t at =
      lines_.find_byte(static_cast<std::size_t>(message.line), static_cast<std::size_t>(message.column));
  const auto name = names_.find(at);
  const auto start = starts_.find(at);
  const std::string path = name != names_.end()     ? name->second
                           : start != starts_.end() ? start->second
                                                    : sketch_.find_path(message);
  out["key"] = path;
  if (message.is_unknown_key && name != names_.end()) {
    out["span"] = spans_.keys.at(path);
    return;
  }
  const auto value = spans_.values.find(path);
  // The text is not TOML, or the message concerns the whole of it.
  if (value == spans_.values.end())
    out["span"] = Span{std::min(at, size_), std::min(at + 1, size_)};
  else
    out["span"] = value->second;
}

}  // namespace talus::studio
