#include "tools/evbal/study_command.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/interrupt.hpp"
#include "common/plain_text.hpp"
#include "tools/evbal/console_table.hpp"
#include "tools/evbal/examine.hpp"
#include "tools/evbal/part_bounds.hpp"

#include <CLI/CLI.hpp>
#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>
#include <random>
#include <sstream>

namespace evbal {
namespace {

namespace fs = std::filesystem;

struct StudyArguments {
  fs::path benchmark;
  std::string controller;
  std::string coordinator;  ///< words with blanks between them
  fs::path entry;           ///< file of its settings
  fs::path out;
  PlayingOptions options;
};

struct VerifyArguments {
  fs::path file;
  std::optional<std::uint64_t> seed;
  std::string coordinator;
  PlayingOptions options;
};

Command split_words(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

/// Of this process and of its children that have ended.
double processor_seconds() {
  double seconds = 0.0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    seconds += static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
               1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  }
  return seconds;
}

/// Per cent, nothing if it is infinite: of one day there is no interval.
std::string per_cent_if_known(double share) {
  return std::isfinite(share) ? fixed(100.0 * share, 1, true) : "";
}

std::string results_table(const std::vector<StudyResult>& results) {
  std::vector<std::vector<std::string>> table = {
      {"part", "faults", "days", "lost, %", "from", "to", "verdict", "of the way, %"}};
  for (const StudyResult& result : results) {
    table.push_back({result.part, result.faults, std::to_string(result.days),
                     result.days > 0 ? per_cent_if_known(result.difference) : "", per_cent_if_known(result.low),
                     per_cent_if_known(result.high), result.verdict, result.way ? fixed(100.0 * *result.way, 0) : ""});
  }
  return aligned(table, 2);
}

void study(const StudyArguments& arguments) {
  if (arguments.benchmark.empty() || arguments.controller.empty()) {
    throw bad_input("study: a BENCHMARK and --controller are expected; see `evbal study --help`");
  }
  Entry entry{.controller = arguments.controller, .coordinator = split_words(arguments.coordinator), .settings = {}};
  const Benchmark benchmark = read_benchmark(find_benchmark(arguments.benchmark));
  if (!arguments.entry.empty()) {
    entry.settings = read_entry_settings(YamlValue::load(arguments.entry));
  } else if (const auto known = benchmark.entries.find(entry.controller); known != benchmark.entries.end()) {
    entry.settings = known->second;
  }
  const fs::path out =
      arguments.out.empty() ? fs::path("runs") / (benchmark.name + "-" + entry.controller) : arguments.out;
  const Examined examined = examine(arguments.benchmark, entry, out, arguments.options);
  write_file(out / "line.json", line_text(examined.line, examined.results, processor_seconds()));
  std::printf("%s\nLost passengers of %s against the reference at equal idle km, 95 %% by t. Verdict: %s.\n%s\n",
              results_table(examined.results).c_str(), entry.controller.c_str(), verdict_of(examined.results).c_str(),
              (out / "line.json").c_str());
}

void verify_lines(const VerifyArguments& arguments) {
  catch_interrupts();
  const Verifying verifying{.seed = arguments.seed ? *arguments.seed : std::random_device{}(),
                            .coordinator = split_words(arguments.coordinator),
                            .options = arguments.options};
  if (!fs::is_regular_file(arguments.file)) {
    throw bad_input(arguments.file.string(), 0, "is not there; give a file with lines of `evbal study`");
  }
  const std::vector<std::string> lines = lines_of(text_of_file(arguments.file));
  int number = 0;
  for (const std::string& line : lines) {
    ++number;
    if (!line.empty()) {
      std::printf("%s\n", verify_line(line, arguments.file.string() + ":" + std::to_string(number), verifying).c_str());
    }
  }
  if (number == 0) {
    throw bad_input(arguments.file.string(), 0, "is empty; a line of `evbal study` is expected");
  }
}

void add_verify(CLI::App& study) {
  const auto arguments = std::make_shared<VerifyArguments>();
  CLI::App* command = study.add_subcommand("verify", "Play a random tenth of the days of such lines again");
  command->add_option("FILE", arguments->file, "File with lines that `evbal study` wrote")->required();
  command->add_option("--seed", arguments->seed, "Choice of the days; otherwise drawn, and told");
  command->add_option("--coordinator", arguments->coordinator, "Program of the entry, if it lies elsewhere here")
      ->type_name("COMMAND");
  add_playing_options(*command, arguments->options);
  command->callback([arguments] { verify_lines(*arguments); });
}

}  // namespace

void add_study_command(CLI::App& app) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = app.add_subcommand("study", "Examine a controller on a frozen benchmark");
  command->add_option("BENCHMARK", arguments->benchmark, "Benchmark file (YAML), or the name of a shipped one");
  command->add_option("--controller", arguments->controller, "Who is examined");
  command->add_option("--coordinator", arguments->coordinator, "Program of a controller of your own, with its words")
      ->type_name("COMMAND");
  command->add_option("--entry", arguments->entry,
                      "YAML of its settings, search and factors, in place of the benchmark's");
  command->add_option("--out", arguments->out, "Directory, new or of this study; otherwise one under runs/");
  add_playing_options(*command, arguments->options);
  command->require_subcommand(0, 1);
  add_verify(*command);
  command->callback([command, arguments] {
    if (command->get_subcommands().empty()) {
      study(*arguments);
    }
  });
}

}  // namespace evbal
