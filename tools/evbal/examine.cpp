#include "tools/evbal/examine.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/interrupt.hpp"
#include "common/version.hpp"
#include "experiments/scenario/input_digests.hpp"
#include "experiments/study/design/tuned.hpp"
#include "experiments/study/store/sweep_file.hpp"
#include "tools/evbal/part_bounds.hpp"
#include "tools/evbal/sweep_command.hpp"
#include "tools/evbal/tune_command.hpp"

#include <algorithm>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// What the entry's tuning found; nothing if it searches nothing.
std::vector<Setting> tuned_settings(const Benchmark& benchmark, const BenchmarkPart& part, const Entry& entry,
                                    const fs::path& out, const PlayingOptions& options) {
  if (!entry.settings.search) {
    return {};
  }
  const fs::path file = out / (part.name + ".tuning.yaml");
  write_file(file, tuning_yaml(benchmark, part, entry));
  const Tuned tuned = read_tuned(tune({file, out / part.name, false, options}));
  return tuned.begin()->second.settings;
}

StudiedPart examine_part(const Benchmark& benchmark, const BenchmarkPart& part, const Entry& entry, const fs::path& out,
                         const PlayingOptions& options, Sweep& swept) {
  StudiedPart studied{
      .name = part.name,
      .settings = examined_settings(entry.settings, tuned_settings(benchmark, part, entry, out, options)),
      .days = {},
      .bounds = {}};
  const fs::path file = out / (part.name + ".sweep.yaml");
  write_file(file, sweep_yaml(part, entry, studied.settings));
  const fs::path folder = sweep({file, (out / part.name).string(), false, options}).parent_path();
  for (const FinishedDay& day : read_finished(folder / sweep_file_name)) {
    studied.days.push_back({day.totals.at("idle_km"), day.totals.at("lost"), day.digest});
  }
  swept = read_sweep(file);
  studied.bounds = bounds_of(part, swept, options.quiet);
  return studied;
}

}  // namespace

Examined examine(const fs::path& file, const Entry& entry, const fs::path& out, const PlayingOptions& options) {
  catch_interrupts();
  const Benchmark benchmark = read_benchmark(find_benchmark(file));
  Entry absolute = entry;
  absolute.coordinator = command_from(fs::current_path(), entry.coordinator);
  Examined examined{.line = {.file = file.filename().string(),
                             .benchmark = benchmark.name,
                             .benchmark_digest = benchmark.digest,
                             .version = version(),
                             .controller = entry.controller,
                             .coordinator = entry.coordinator,
                             .coordinator_digest = command_digest(absolute.coordinator),
                             .parts = {}},
                    .results = {}};
  fs::create_directories(out);
  std::vector<Sweep> sweeps(benchmark.parts.size());
  for (std::size_t i = 0; i < benchmark.parts.size(); ++i) {
    examined.line.parts.push_back(examine_part(benchmark, benchmark.parts[i], absolute, out, options, sweeps[i]));
  }
  examined.results = results_of(examined.line, sweeps);
  return examined;
}

}  // namespace evbal
