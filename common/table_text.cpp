#include "common/table_text.hpp"

#include <algorithm>

namespace evbal {

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    return std::string(text);
  }
  std::string cell = "\"";
  for (const char c : text) {
    cell += c == '"' ? "\"\"" : std::string(1, c);
  }
  return cell + "\"";
}

std::string csv_row(const std::vector<std::string>& cells) {
  std::string row;
  for (const auto& cell : cells) {
    row += (&cell == &cells.front() ? "" : ",") + csv_cell(cell);
  }
  return row + "\n";
}

std::vector<std::string> split_csv(std::string_view row, char separator) {
  std::vector<std::string> cells;
  split_csv(row, separator, cells);
  return cells;
}

void split_csv(std::string_view row, char separator, std::vector<std::string>& cells) {
  std::size_t count = 0;
  const auto begin_cell = [&] {
    if (cells.size() == count) {
      cells.emplace_back();
    }
    cells[count].clear();
    ++count;
  };
  begin_cell();
  bool in_quotes = false;
  while (!row.empty()) {
    const std::size_t plain = in_quotes ? row.find('"') : std::min(row.find('"'), row.find(separator));
    cells[count - 1].append(row.substr(0, plain));
    if (plain == std::string_view::npos) {
      break;
    }
    const bool quote = row[plain] == '"';
    row.remove_prefix(plain + 1);
    if (!quote) {
      begin_cell();
    } else if (in_quotes && row.starts_with('"')) {
      cells[count - 1] += '"';
      row.remove_prefix(1);
    } else {
      in_quotes = !in_quotes;
    }
  }
  cells.resize(count);
}

std::string markdown_cell(std::string_view text) {
  std::string cell;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>|#").find(c) != std::string_view::npos) {
      cell += '\\';
    }
    cell += c == '\n' || c == '\r' ? ' ' : c;
  }
  return cell;
}

}  // namespace evbal
