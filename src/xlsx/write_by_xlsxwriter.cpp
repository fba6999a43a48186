// SPDX-License-Identifier: MIT
// The only file with libxlsxwriter: a workbook as an .xlsx file.

#include <xlsxwriter.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>

#include "export/workbook.hpp"

namespace talus::exports {
namespace {

using results::Cell;
using results::Column;
using results::Table;

/// Number of characters, to which the widths of columns refer.
std::size_t count_letters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string write_head(const Column& column) {
  return column.unit.empty() ? column.title : column.title + " [" + column.unit + "]";
}

constexpr const char* general = "General";

/// Returns the number format of a column: decimals where its numbers are of similar size.
const char* choose_number_format(const Column& column) {
  if (column.counts) return "0";
  double least = std::numeric_limits<double>::infinity(), largest = 0;
  bool is_whole = true;
  for (const Cell& cell : column.cells)
    if (const double* number = std::get_if<double>(&cell); number != nullptr && *number != 0) {
      least = std::min(least, std::abs(*number));
      largest = std::max(largest, std::abs(*number));
      is_whole = is_whole && *number == std::round(*number);
    }
  if (is_whole) return general;
  if (least >= 1e-2 && largest < 1e9) return "0.000";
  return largest < 1e-2 || least >= 1e9 ? "0.000E+00" : general;
}

class Writer {
 public:
  Writer(const Workbook& workbook, lxw_workbook* file) : workbook_(workbook), file_(file) {
    title_ = add_format();
    format_set_bold(title_);
    format_set_font_size(title_, 13);
    head_ = add_format();
    format_set_bold(head_);
    format_set_text_wrap(head_);
    format_set_bottom(head_, LXW_BORDER_THIN);
    format_set_bg_color(head_, 0xE8EEF4);
    text_ = add_format();
    format_set_text_wrap(text_);
    link_ = workbook_get_default_url_format(file_);
  }

  lxw_error write() {
    for (const Sheet& sheet : workbook_.sheets) {
      lxw_worksheet* page = workbook_add_worksheet(file_, sheet.name.c_str());
      if (page == nullptr) return LXW_ERROR_PARAMETER_VALIDATION;
      write_sheet(sheet, page);
    }
    return error_;
  }

 private:
  lxw_format* add_format() {
    lxw_format* format = workbook_add_format(file_);
    format_set_align(format, LXW_ALIGN_VERTICAL_TOP);
    return format;
  }

  lxw_format* find_number_format(const std::string& name) {
    const auto [at, is_new] = numbers_.try_emplace(name, nullptr);
    if (is_new) {
      at->second = add_format();
      if (name != general) format_set_num_format(at->second, name.c_str());
    }
    return at->second;
  }

  void keep(lxw_error error) {
    if (error_ == LXW_NO_ERROR) error_ = error;
  }

  /// A sheet of one table has its frozen header in the first row; several tables have titles.
  void write_sheet(const Sheet& sheet, lxw_worksheet* page) {
    std::vector<std::size_t> widths;
    for (const Table& table : sheet.tables) {
      widths.resize(std::max(widths.size(), table.columns.size()), narrowest);
      for (std::size_t c = 0; c < table.columns.size(); ++c)
        widths[c] = std::max(widths[c], choose_width(table.columns[c]));
    }
    for (std::size_t c = 0; c < widths.size(); ++c) {
      const auto column = static_cast<lxw_col_t>(c);
      keep(worksheet_set_column(page, column, column, static_cast<double>(widths[c]), nullptr));
    }
    lxw_row_t row = 0;
    const bool is_single = sheet.tables.size() == 1;
    for (std::size_t i = 0; i < sheet.tables.size(); ++i) {
      const Table& table = sheet.tables[i];
      if (!is_single) {
        const std::string& title = table.title.empty() ? workbook_.title : table.title;
        keep(worksheet_write_string(page, row++, 0, title.c_str(), title_));
      }
      std::vector<std::size_t> lines(table.rows + 1, 1);
      for (std::size_t c = 0; c < table.columns.size(); ++c)
        write_column(page, row, c, table.columns[c], widths[c],
                     sheet.ends_with_links && i + 1 == sheet.tables.size() && c == 0, lines);
      // Not every program fits the heights of rows to wrapped text by itself.
      for (std::size_t r = 0; r < lines.size(); ++r)
        if (lines[r] > 1)
          keep(worksheet_set_row(page, row + static_cast<lxw_row_t>(r),
                                 LXW_DEF_ROW_HEIGHT * static_cast<double>(std::min(lines[r], most_lines)), nullptr));
      row += static_cast<lxw_row_t>(table.rows) + 2;
    }
    if (is_single) {
      worksheet_freeze_panes(page, 1, 0);
      keep(worksheet_repeat_rows(page, 0, 0));
    }
    constexpr std::uint8_t a4 = 9;
    worksheet_set_landscape(page);
    worksheet_set_paper(page, a4);
    worksheet_fit_to_pages(page, 1, 0);
  }

  /// Returns a width in characters.
  static std::size_t choose_width(const Column& column) {
    constexpr std::size_t head_width = 18, widest = 48;
    std::size_t width = std::min(count_letters(write_head(column)) + 2, head_width);
    for (const Cell& cell : column.cells)
      if (const auto* text = std::get_if<std::string>(&cell))
        width = std::max(width, std::min(count_letters(*text) + 2, widest));
    return width;
  }

  /// Returns the number of lines of a wrapped text: letters are a little narrower than the digits of the unit of width.
  static std::size_t count_lines(const std::string& text, std::size_t width) {
    return std::max<std::size_t>(1, (count_letters(text) + width - 1) / width);
  }

  /// Writes the header at `row` and the cells below it; `lines` receives the heights of their rows.
  void write_column(lxw_worksheet* page, lxw_row_t row, std::size_t number, const Column& column, std::size_t width,
                    bool has_links, std::vector<std::size_t>& lines) {
    const auto c = static_cast<lxw_col_t>(number);
    const std::string head = write_head(column);
    lines[0] = std::max(lines[0], count_lines(head, width));
    keep(worksheet_write_string(page, row, c, head.c_str(), head_));
    lxw_format* format = find_number_format(choose_number_format(column));
    for (std::size_t i = 0; i < column.cells.size(); ++i) {
      ++row;
      if (const auto* value = std::get_if<double>(&column.cells[i])) {
        if (column.is_mixed) format = find_number_format(choose_number_format({"", "", "", false, true, {*value}}));
        keep(worksheet_write_number(page, row, c, *value, format));
      } else if (const auto* truth = std::get_if<bool>(&column.cells[i])) {
        keep(worksheet_write_boolean(page, row, c, *truth ? 1 : 0, text_));
      } else if (const auto* text = std::get_if<std::string>(&column.cells[i])) {
        if (has_links) keep(worksheet_write_url(page, row, c, ("internal:'" + *text + "'!A1").c_str(), link_));
        keep(worksheet_write_string(page, row, c, text->c_str(), has_links ? link_ : text_));
        lines[i + 1] = std::max(lines[i + 1], count_lines(*text, width));
      }
    }
  }

  static constexpr std::size_t narrowest = 10;   ///< width of a column
  static constexpr std::size_t most_lines = 20;  ///< of a row: spreadsheets limit their heights
  const Workbook& workbook_;
  lxw_workbook* file_;
  lxw_format *title_ = nullptr, *head_ = nullptr, *text_ = nullptr, *link_ = nullptr;
  std::map<std::string, lxw_format*> numbers_;
  lxw_error error_ = LXW_NO_ERROR;
};

}  // namespace
}  // namespace talus::exports

extern "C" void talus_write_workbook(const talus::exports::Workbook& workbook, const char* path, std::string& error) {
  lxw_workbook* file = workbook_new(path);
  if (file == nullptr) {
    error = "there is no memory";
    return;
  }
  const auto text = [](const std::string& value) { return const_cast<char*>(value.c_str()); };
  lxw_doc_properties properties{};
  properties.title = text(workbook.title);
  properties.author = text(workbook.author);
  properties.comments = text(workbook.program);
  workbook_set_properties(file, &properties);
  const lxw_error written = talus::exports::Writer(workbook, file).write();
  const lxw_error closed = workbook_close(file);
  if (const lxw_error first = written != LXW_NO_ERROR ? written : closed; first != LXW_NO_ERROR)
    error = lxw_strerror(first);
}
