#include "tools/evbal/compare_command.hpp"

#include "common/decimal.hpp"
#include "common/error.hpp"
#include "experiments/study/statistics/comparison.hpp"
#include "experiments/study/statistics/front_comparison.hpp"
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
#include <utility>

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

std::string per_cent(double share) {
  return fixed(100.0 * share, 1, true) + " %";
}

std::string fronts_table(const std::vector<ComparedFronts>& rows, const FrontQuestion& question) {
  std::vector<std::vector<std::string>> table = {{"scenario", "faults", "variant", question.metric, question.reference,
                                                  "of totals", "difference", "95 % by t", "p", "days", "apart",
                                                  "covered"}};
  if (question.bound) {
    table.front().push_back("of the way");
  }
  for (const auto& row : rows) {
    table.push_back({row.scenario, row.faults, row.variant});
    if (row.days == 0) {
      table.back().insert(table.back().end(), {"", "", "", "", "", "", "0", std::to_string(row.apart)});
      continue;
    }
    table.back().insert(table.back().end(),
                        {fixed(row.value, 0), fixed(row.reference, 0),
                         row.reference > 0.0 ? per_cent(row.value / row.reference - 1.0) : "", per_cent(row.ratio.mean),
                         Shown{100.0, ""}.range(row.ratio), fixed(row.p, 4), std::to_string(row.days),
                         std::to_string(row.apart), fixed(100.0 * row.covered, 0) + " %"});
    if (row.way) {
      table.back().push_back(fixed(100.0 * *row.way, 0) + " %");
    }
  }
  return aligned(table, 3);
}

/// The days of a sweep with what is known of their bounds.
std::vector<FinishedDay> with_bounds(std::vector<FinishedDay> days, const std::filesystem::path& folder) {
  const std::vector<FinishedDay> bounded = bounded_days(folder / sweep_file_name, days);
  days.insert(days.end(), bounded.begin(), bounded.end());
  return days;
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
    return with_bounds(std::move(days), folder);
  }
  return days;
}

/// The answer to what is asked of whole fronts.
std::string fronts_answer(const Question& question, bool with_bound, const std::filesystem::path& folder, bool json) {
  const FrontQuestion asked{.metric = question.metric,
                            .reference = question.reference,
                            .at = question.at.value_or("idle_km"),
                            .bound = with_bound ? std::optional<std::string>(bound_variant) : std::nullopt};
  if (with_bound && (asked.metric != "lost" || asked.at != "idle_km")) {
    throw bad_input("--room: the bound is a front of lost passengers against idle km");
  }
  std::vector<FinishedDay> days = read_finished(folder / sweep_file_name);
  const auto rows = compare_fronts(with_bound ? with_bounds(std::move(days), folder) : days, asked);
  return json ? compared_fronts_json(rows) : fronts_table(rows, asked);
}

}  // namespace

void add_compare_command(CLI::App& app) {
  struct Arguments {
    std::filesystem::path folder;
    Question question;
    bool fronts = false;
    bool room = false;
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
  CLI::Option* fronts = command->add_flag(
      "--fronts", arguments->fronts, "Whole fronts, day by day, over the idle km (or `--at`) that both variants cover");
  command->add_flag("--room", arguments->room, "Also the share of the way from --against to the bound of `evbal bound`")
      ->needs(fronts);
  command->add_flag("--json", arguments->json, "Print the rows as JSON");
  command->callback([arguments] {
    if (arguments->fronts) {
      std::fputs(fronts_answer(arguments->question, arguments->room, arguments->folder, arguments->json).c_str(),
                 stdout);
      return;
    }
    const auto rows = compare(days_for(arguments->question, arguments->folder), arguments->question);
    std::fputs((arguments->json ? compared_json(rows) : table_of(rows, arguments->question)).c_str(), stdout);
  });
}

}  // namespace evbal
