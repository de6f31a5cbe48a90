#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace evbal {

/// A cell of CSV (RFC 4180): in double quotes if it holds a comma, a quote or a line break.
std::string csv_cell(std::string_view text);

/// A row of CSV with its line break.
std::string csv_row(const std::vector<std::string>& cells);

/// The cells of a row of CSV, without their quotes. Cells that hold a line break are not known.
std::vector<std::string> split_csv(std::string_view row, char separator = ',');

/// The same into `cells`, whose memory is used again.
void split_csv(std::string_view row, char separator, std::vector<std::string>& cells);

/// A cell of a Markdown table: no character of it ends the cell, begins a heading or sets type.
std::string markdown_cell(std::string_view text);

}  // namespace evbal
