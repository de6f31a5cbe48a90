#include "tools/ingest/sessions.hpp"

#include "common/contract.hpp"
#include "common/decimal.hpp"
#include "tools/ingest/time_pattern.hpp"
#include "tools/records/row_tally.hpp"
#include "tools/records/text_lines.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace evbal {
namespace {

/// Whether the first row of a table names all columns of the format.
bool has_columns(const std::filesystem::path& file, const TableFormat& format) {
  CsvRows rows(file, format.separator);
  for (int line = 0; line < format.skip_rows; ++line) {
    rows.skip_line();
  }
  return !format.header ||
         (rows.next() && std::all_of(format.columns.begin(), format.columns.end(), [&](const auto& column) {
            return std::find(rows.fields().begin(), rows.fields().end(), column) != rows.fields().end();
          }));
}

/// Reads the rows of tables of sessions.
class SessionReader {
 public:
  SessionReader(const SessionFormat& format, const SessionChoice& choice)
      : format_(format),
        choice_(choice),
        no_time_("no time like " + time_example(format.time)),
        other_length_("not from " + decimal(choice.shortest) + " to " + decimal(choice.longest) + " min long") {}

  /// Puts the length of a row's session into `minutes`, or says why it cannot.
  RowFault read(const RawTable& row, double& minutes) {
    if (!row.whole()) {
      return row.fault();
    }
    if (format_.charger && row.text(*format_.charger).find(choice_.model) == std::string_view::npos) {
      return {"another model of charger", row.text(*format_.charger), false};
    }
    const auto start = time_in(row, format_.start, format_.time, text_);
    const auto end = start ? time_in(row, format_.end, format_.time, text_) : std::nullopt;
    if (!end) {
      const bool told = text_.find_first_not_of(' ') != std::string::npos;
      return {told ? std::string_view(no_time_) : "no start or no end", text_, told};
    }
    minutes = static_cast<double>(*end - *start) / 60.0;
    if (minutes < choice_.shortest || minutes > choice_.longest) {
      text_ = decimal(minutes) + " min";
      return {other_length_, text_, false};
    }
    return {};
  }

 private:
  const SessionFormat& format_;
  const SessionChoice& choice_;
  std::string no_time_;
  std::string other_length_;
  std::string text_;
};

void read_table(const std::filesystem::path& file, const SessionFormat& format, SessionReader& reader, Dropped& dropped,
                std::vector<double>& minutes, long long& read) {
  RawTable table(file, format.table);
  RowTally tally(table, dropped);
  for (; table.next(); ++read) {
    double length = 0.0;
    if (tally.keeps(reader.read(table, length))) {
      minutes.push_back(length);
    }
  }
  tally.finish();
}

}  // namespace

SessionSample read_sessions(const std::filesystem::path& folder, const SessionFormat& format,
                            const SessionChoice& choice) {
  SessionReader reader(format, choice);
  SessionSample sample;
  Dropped dropped;
  long long read = 0;
  std::vector<std::filesystem::path> others;
  try {
    const auto files = csv_files(folder);
    for (const auto& file : files) {
      if (has_columns(file, format.table) || (file == files.back() && others.size() + 1 == files.size())) {
        read_table(file, format, reader, dropped, sample.minutes, read);
      } else {
        others.push_back(file);
      }
    }
    if (sample.minutes.empty()) {
      throw bad_input(folder.string(), 0,
                      "has no session of a charger of model `" + choice.model + "` and of allowed length");
    }
  } catch (const Error& error) {
    throw with_report(error, dropped.report());
  }
  std::sort(sample.minutes.begin(), sample.minutes.end());
  std::ostringstream out;
  out << "session rows read: " << read << "\n" << dropped.report();
  if (!others.empty()) {
    out << "  tables without these columns, not read: " << others.size() << " (first: " << others.front().string()
        << ")\n";
  }
  out << "sessions used: " << sample.minutes.size() << ", median " << decimal(quantiles(sample.minutes, 3)[1])
      << " min\n";
  sample.report = out.str();
  return sample;
}

std::vector<double> quantiles(const std::vector<double>& ascending, int n) {
  EVBAL_EXPECT(!ascending.empty() && n >= 2, "at least one value and two quantiles");
  std::vector<double> values;
  for (int q = 0; q < n; ++q) {
    const double at = static_cast<double>(ascending.size() - 1) * q / (n - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, ascending.size() - 1);
    const double share = at - static_cast<double>(below);
    values.push_back((1.0 - share) * ascending[below] + share * ascending[above]);
  }
  return values;
}

}  // namespace evbal
