#include "tools/evbal/report_command.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "tools/evbal/filter_options.hpp"
#include "tools/evbal/report_content.hpp"
#include "tools/evbal/study_page.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

namespace evbal {
namespace {

namespace fs = std::filesystem;

struct ReportArguments {
  std::vector<std::string> folders;
  std::vector<std::string> against;
  DayFilter filter;
  std::string out;
  bool figures = false;
};

/// A run directory itself, or those in a directory of several.
std::vector<fs::path> runs_in(const fs::path& folder) {
  std::vector<fs::path> found;
  if (fs::is_directory(folder) && !fs::exists(folder / "run.sqlite")) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      // The link `latest` leads to a run that is here anyway.
      if (!entry.is_symlink() && fs::exists(entry.path() / "summary.json")) {
        found.push_back(entry.path());
      }
    }
    std::sort(found.begin(), found.end());
  }
  return found.empty() ? std::vector<fs::path>{folder} : found;
}

PageContent content_of(const ReportArguments& arguments) {
  std::optional<fs::path> sweep;
  std::vector<RecordedRun> runs;
  std::string draws;
  for (const fs::path given : arguments.folders) {
    if (fs::exists(given / "sweep.sqlite")) {
      if (sweep) {
        throw bad_input(given.string() + ": a page is on one sweep, and that is " + sweep->string());
      }
      sweep = given;
      continue;
    }
    draws += fs::exists(given / "draws.md") ? text_of_file(given / "draws.md") : "";
    for (const auto& folder : runs_in(given)) {
      runs.push_back(read_run(folder));
    }
  }
  if (!sweep && !arguments.against.empty()) {
    throw bad_input("--against: there is no sweep among the directories, whose variants could be compared");
  }
  if (!sweep && !is_empty(arguments.filter)) {
    throw bad_input(
        "--scenario, --faults, --variant and --days choose among the days of a sweep: there is none among "
        "the directories");
  }
  PageContent content = sweep ? content_on(*sweep, arguments.against, arguments.filter, runs) : content_on(runs);
  content.draws = draws;
  return content;
}

/// Draws the figures of a sweep's page alone.
fs::path figures(const ReportArguments& arguments) {
  if (arguments.folders.size() > 1 || !arguments.out.empty() || !arguments.against.empty() ||
      !is_empty(arguments.filter)) {
    throw bad_input("--figures: give the directory of one sweep, into which its figures are drawn, and nothing else");
  }
  const fs::path folder = arguments.folders.front();
  return write_study_figures(folder, read_study_page(folder));
}

void report(const ReportArguments& arguments) {
  if (arguments.figures) {
    std::printf("%s\n", figures(arguments).c_str());
    return;
  }
  const fs::path folder = arguments.folders.size() == 1 ? arguments.folders.front() : ".";
  const fs::path page = arguments.out.empty() ? folder / "report.html" : fs::path(arguments.out);
  write_file(page, report_page(content_of(arguments)));
  std::printf("%s\n", page.c_str());
}

}  // namespace

void write_report(const fs::path& page, const std::vector<RecordedRun>& runs) {
  write_file(page, report_page(content_on(runs)));
}

void add_report_command(CLI::App& app) {
  const auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = app.add_subcommand("report", "Write one HTML page on finished runs, or on a sweep");
  command->add_option("DIR", arguments->folders, "Run directories, directories of them, or a sweep's")->required();
  command->add_option("--against", arguments->against, "Variants of the sweep to compare the others with");
  add_filter_options(*command, arguments->filter);
  command->add_option("--out", arguments->out, "The page; otherwise report.html in DIR, or here if there are several");
  command->add_flag("--figures", arguments->figures,
                    "Only draw the figures of the sweep's page.md anew, as SVG files in DIR/figures");
  command->callback([arguments] { report(*arguments); });
}

}  // namespace evbal
