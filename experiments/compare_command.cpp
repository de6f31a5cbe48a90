#include "experiments/compare_command.hpp"

#include "experiments/sweep/comparison.hpp"
#include "experiments/sweep/sweep_file.hpp"
#include "experiments/table.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace evbal {
namespace {

std::string number(double value, int digits, bool sign) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), sign ? "%+.*f" : "%.*f", digits, value);
  return text.data();
}

std::string percent(const Interval& interval) {
  return number(100.0 * interval.low, 1, true) + " .. " + number(100.0 * interval.high, 1, true);
}

std::string table_of(const std::vector<Compared>& rows, const Question& question) {
  std::vector<std::vector<std::string>> cells = {{"faults", "variant", "settings", question.at.value_or(""),
                                                  question.metric, question.reference, "difference, %", "95 % by t",
                                                  "95 % by bootstrap", "pairs", "outside"}};
  for (const auto& row : rows) {
    cells.push_back({row.faults, row.variant, row.settings.empty() ? "all together" : row.settings});
    const bool any = row.pairs > 0;
    for (const auto& cell :
         {any && question.at ? number(row.at, 0, false) : "", any ? number(row.value, 1, false) : "",
          any ? number(row.reference, 1, false) : "", any ? number(100.0 * row.by_t.mean, 1, true) : "",
          any ? percent(row.by_t) : "", any ? percent(row.by_bootstrap) : "", std::to_string(row.pairs),
          std::to_string(row.outside)}) {
      cells.back().push_back(cell);
    }
  }
  return aligned(cells, 3);
}

}  // namespace

void add_compare_command(CLI::App& app) {
  struct Arguments {
    std::filesystem::path folder;
    Question question;
  };
  const auto arguments = std::make_shared<Arguments>();
  Question& question = arguments->question;
  question.metric = "lost";
  CLI::App* command = app.add_subcommand("compare", "Compare the variants of a finished sweep, paired by day and seed");
  command->add_option("DIR", arguments->folder, "Directory that `evbal sweep` wrote")->required();
  command->add_option("--against", question.reference, "Variant to compare the others with")->required();
  command->add_option("--metric", question.metric, "What is compared; `lost` unless given");
  command->add_option("--at", question.at, "Metric at whose equal values, along the reference's front: `idle_km`");
  command->callback([arguments] {
    const auto days = read_finished(arguments->folder / "sweep.sqlite");
    std::printf("%s", table_of(compare(days, arguments->question), arguments->question).c_str());
  });
}

}  // namespace evbal
