#include "tools/evbal/compare_command.hpp"

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "experiments/study/statistics/comparison.hpp"
#include "experiments/study/store/sweep_file.hpp"
#include "experiments/study/store/sweep_folder.hpp"
#include "tools/evbal/bounded_days.hpp"
#include "tools/evbal/console_table.hpp"
#include "tools/evbal/json_output.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace evbal {
namespace {

/// Relative differences in per cent; where there are none, the plain ones.
struct Shown {
  double factor;
  const char* unit;

  std::string mean(const Interval& interval) const { return fixed(factor * interval.mean, 1, true) + unit; }
  std::string range(const Interval& interval) const {
    return fixed(factor * interval.low, 1, true) + " .. " + fixed(factor * interval.high, 1, true);
  }
};

std::vector<std::string> cells_of(const Compared& row, const Question& question) {
  const std::string outside = std::to_string(row.outside);
  if (row.pairs == 0) {
    return {"", "", "", "", "", "", "", "", "0", outside};
  }
  const Shown shown = row.relative ? Shown{100.0, " %"} : Shown{1.0, ""};
  const Interval& interval = row.relative ? row.by_t : row.difference;
  return {question.at ? fixed(row.at, 0) : "",
          fixed(row.value, 1),
          fixed(row.reference, 1),
          shown.mean(interval),
          shown.range(interval),
          row.relative ? shown.range(row.by_bootstrap) : "",
          fixed(row.p, 4),
          fixed(row.p_holm, 4),
          std::to_string(row.pairs),
          outside};
}

std::string table_of(const std::vector<Compared>& rows, const Question& question) {
  std::vector<std::vector<std::string>> table = {{"scenario", "faults", "variant", "settings", question.at.value_or(""),
                                                  question.metric, question.reference, "difference", "95 % by t",
                                                  "95 % by bootstrap", "p", "p, Holm", "pairs", "outside"}};
  for (const auto& row : rows) {
    table.push_back({row.scenario, row.faults, row.variant, row.settings.empty() ? "all together" : row.settings});
    const auto more = cells_of(row, question);
    table.back().insert(table.back().end(), more.begin(), more.end());
  }
  return aligned(table, 4);
}

/// The days of a sweep; with them the bounds of these, if they are asked for.
std::vector<FinishedDay> days_for(const Question& question, const std::filesystem::path& folder) {
  std::vector<FinishedDay> days = read_finished(folder / sweep_file_name);
  const auto is_reference = [&](const FinishedDay& day) { return day.variant == question.reference; };
  if (question.reference == bound_variant && std::none_of(days.begin(), days.end(), is_reference)) {
    if (question.metric != "lost" || question.at != "idle_km") {
      throw bad_input(
          "--against bound: is a front of lost passengers against idle km; compare `--metric lost --at "
          "idle_km`");
    }
    const std::vector<FinishedDay> bounded = bounded_days(folder / sweep_file_name, days);
    days.insert(days.end(), bounded.begin(), bounded.end());
  }
  return days;
}

}  // namespace

void add_compare_command(CLI::App& app) {
  struct Arguments {
    std::filesystem::path folder;
    Question question;
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  Question& question = arguments->question;
  question.metric = "lost";
  CLI::App* command = app.add_subcommand("compare", "Compare the variants of a finished sweep, paired by day and seed");
  command->add_option("DIR", arguments->folder, "Directory that `evbal sweep` wrote")->required();
  command
      ->add_option("--against", question.reference,
                   "Variant to compare the others with; `bound`: that of `evbal bound`, with `--at idle_km`")
      ->required();
  command->add_option("--metric", question.metric, "What is compared; `lost` unless given");
  command->add_option("--at", question.at, "Metric at whose equal values, along the reference's front: `idle_km`");
  command->add_flag("--json", arguments->json, "Print the rows as JSON");
  command->callback([arguments] {
    const auto rows = compare(days_for(arguments->question, arguments->folder), arguments->question);
    std::fputs((arguments->json ? compared_json(rows) : table_of(rows, arguments->question)).c_str(), stdout);
  });
}

}  // namespace evbal
