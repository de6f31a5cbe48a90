#include "tools/evbal/compare_command.hpp"

#include "common/error.hpp"
#include "experiments/study/statistics/comparison.hpp"
#include "experiments/study/statistics/comparison_table.hpp"
#include "experiments/study/statistics/primaries.hpp"
#include "experiments/study/store/sweep_file.hpp"
#include "experiments/study/store/sweep_folder.hpp"
#include "experiments/study/store/sweep_origin.hpp"
#include "tools/evbal/bounded_days.hpp"
#include "tools/evbal/compared_csv.hpp"
#include "tools/evbal/console_table.hpp"
#include "tools/evbal/filter_options.hpp"
#include "tools/evbal/json_output.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <utility>

namespace evbal {
namespace {

std::string table_of(const std::vector<Compared>& rows, const Question& question) {
  std::vector<Words> table = {{"scenario", "faults", "variant", "settings"}};
  const Words head = comparison_head(question, question.metric, question.reference);
  table.front().insert(table.front().end(), head.begin(), head.end());
  for (const auto& row : rows) {
    table.push_back({row.scenario, row.faults, row.variant, row.settings.empty() ? "whole front" : row.settings});
    const Words cells = comparison_cells(row, question);
    table.back().insert(table.back().end(), cells.begin(), cells.end());
  }
  return aligned(table, 4);
}

/// What is to be said of p: of rows that the sweep's page names as primary endpoints, nothing of others.
std::string primaries_text(const std::vector<Compared>& rows, const Question& question,
                           const std::vector<PrimaryAnswer>& primaries) {
  std::string text;
  for (const auto& primary : primaries) {
    const bool shown =
        std::any_of(rows.begin(), rows.end(), [&](const Compared& row) { return primary.is(question, row); });
    if (shown && primary.row.days > 0) {
      text += "Primary endpoint, " + primary.section + ": " + primary.row.variant + ", " + primary.row.scenario + " " +
              primary.row.faults + ": p " + p_text(primary.row.p) + ", after Holm for the page's " +
              std::to_string(primaries.size()) + " primary endpoints " + p_text(primary.p_holm) + "\n";
    }
  }
  return text;
}

/// The days of a sweep, and if the question is of them their bounds.
std::vector<FinishedDay> with_bounds(std::vector<FinishedDay> days, const Question& question,
                                     const std::filesystem::path& sweep_file) {
  if (!question.bound) {
    return days;
  }
  if (question.metric != "lost" || question.at != "idle_km") {
    throw bad_input(std::string(question.reference == question.bound ? "--against bound" : "--room") +
                    ": the bound is a front of lost passengers against idle km; compare `--metric lost --at idle_km`");
  }
  const std::vector<FinishedDay> bounded = bounded_days(sweep_file, days);
  days.insert(days.end(), bounded.begin(), bounded.end());
  return days;
}

struct CompareArguments {
  std::filesystem::path folder;
  std::vector<std::string> against;
  Question question;
  bool fronts = false;
  bool room = false;
  bool json = false;
  bool csv = false;
  DayFilter filter;

  Question against_one(const std::string& reference) const {
    Question asked = question;
    asked.reference = reference;
    if (room || reference == bound_variant) {
      asked.bound = bound_variant;
    }
    if (fronts && !asked.at) {
      asked.at = "idle_km";
    }
    return asked;
  }

  /// What is asked for of these days; the variants that others are held against are always there.
  std::vector<FinishedDay> chosen(const std::vector<FinishedDay>& days, const Question& asked) const {
    DayFilter with_references = filter;
    if (!filter.variants.empty()) {
      with_references.variants.push_back(asked.reference);
    }
    if (!filter.variants.empty() && asked.bound) {
      with_references.variants.push_back(*asked.bound);
    }
    return filtered(with_references, days);
  }
};

/// What is played of a sweep; says on stderr if that is not all.
PlayedDays played_days(const std::filesystem::path& sweep_file) {
  PlayedDays played = read_played(sweep_file);
  if (played.days.empty()) {
    throw bad_input(sweep_file.string() + ": none of its days is played yet");
  }
  if (!played.missing.empty()) {
    const std::size_t failed = failures_in(sweep_file).size();
    std::fprintf(stderr, "evbal: %zu of %zu days are played%s; the others are left out\n", played.days.size(),
                 played.days.size() + played.missing.size(),
                 failed > 0 ? (", " + std::to_string(failed) + " failed").c_str() : "");
  }
  return played;
}

std::string answer_to(const CompareArguments& arguments) {
  const std::filesystem::path file = arguments.folder / sweep_file_name;
  const PlayedDays played = played_days(file);
  std::vector<AnsweredQuestion> answers;
  for (const auto& reference : arguments.against) {
    const Question question = arguments.against_one(reference);
    answers.push_back(
        {question, compare(arguments.chosen(with_bounds(played.days, question, file), question), question)});
    if (arguments.fronts) {
      std::erase_if(answers.back().rows, [](const Compared& row) { return !row.whole; });
    }
  }
  std::vector<FinishedDay> asked_for = played.days;
  asked_for.insert(asked_for.end(), played.missing.begin(), played.missing.end());
  const Page page = page_of(read_origin(file).text, asked_for);
  // On some of the days only, a row is another one than the primary endpoint.
  const auto primaries = arguments.filter.days.empty() ? primary_answers(page, with_objective(page, played.days))
                                                       : std::vector<PrimaryAnswer>{};
  if (arguments.json || arguments.csv) {
    return arguments.json ? compared_json(answers, primaries) : compared_csv(answers, primaries);
  }
  std::string text;
  for (const auto& [question, rows] : answers) {
    text += (text.empty() ? "" : "\n") + table_of(rows, question) + primaries_text(rows, question, primaries);
  }
  return text;
}

}  // namespace

void add_compare_command(CLI::App& app) {
  const auto arguments = std::make_shared<CompareArguments>();
  Question& question = arguments->question;
  CLI::App* command = app.add_subcommand("compare", "Compare the variants of a sweep, day by day");
  command->add_option("DIR", arguments->folder, "Directory that `evbal sweep` wrote")->required();
  command
      ->add_option("--against", arguments->against,
                   "Variants to compare the others with; `bound`: that of `evbal bound`, with `--at idle_km`")
      ->required();
  command->add_option("--metric", question.metric, "What is compared; `lost` unless given");
  command->add_option("--at", question.at, "At equal `idle_km` or `lost`, along the fronts; also `_after_7`");
  command->add_flag("--fronts", arguments->fronts,
                    "Whole fronts only, over the idle km (or `--at`) that both variants cover");
  command->add_flag("--room", arguments->room,
                    "Also the share of the way from --against to the bound of `evbal bound`");
  add_filter_options(*command, arguments->filter);
  CLI::Option* json = command->add_flag("--json", arguments->json, "Print the rows as JSON");
  command->add_flag("--csv", arguments->csv, "Print the rows as CSV")->excludes(json);
  command->callback([arguments] { std::fputs(answer_to(*arguments).c_str(), stdout); });
}

}  // namespace evbal
