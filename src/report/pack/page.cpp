// SPDX-License-Identifier: MIT
#include "report/pack/page.hpp"

#include <nlohmann/json.hpp>

#include "base/encoding.hpp"
#include "base/error.hpp"

// From page_data.S, which the build makes.
extern "C" {
extern const char talus_report_page[];
extern const char talus_report_page_end[];
}

namespace talus::report {
namespace {

constexpr std::string_view mark = "<!--TALUS_DATA-->";

std::string escape_html(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '&')
      safe += "&amp;";
    else
      safe += c;
  }
  return safe;
}

/// A script ends at "</script" whatever its type, and "<!--" changes how its rest is read. In JSON a '<' stands inside
/// strings only, where it may be written by its number.
std::string escape_script(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

}  // namespace

std::string_view get_page() {
  return {talus_report_page, static_cast<std::size_t>(talus_report_page_end - talus_report_page)};
}

std::string fill_page(std::string_view page, const std::string& title, const nlohmann::json& document,
                      const std::vector<PackedText>& arrays) {
  // The last one: the page's own script stands before it and might name it.
  const std::size_t at = page.rfind(mark);
  if (at == std::string_view::npos) {
    throw Error(
        ExitCode::internal_error,
        "the page for reports inside this program has no place for data; build it again (docs/manual/report.md)");
  }
  std::string data = "<script type=\"application/json\" id=\"talus-report\">";
  // Text that is no UTF-8, in a title for example, must not prevent the report.
  data += escape_script(document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  data += "</script>\n";
  for (const PackedText& array : arrays)
    data += "<script type=\"text/plain\" id=\"" + array.id + "\">" + array.base64 + "</script>\n";

  std::string head(page.substr(0, at));
  const std::size_t name = head.find("<title>"), name_end = head.find("</title>");
  if (!title.empty() && name != std::string::npos && name_end != std::string::npos && name < name_end)
    head.replace(name + 7, name_end - name - 7, escape_html(make_printable(title)));
  return head + data + std::string(page.substr(at + mark.size()));
}

}  // namespace talus::report
