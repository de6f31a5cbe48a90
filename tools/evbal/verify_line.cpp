#include "common/error.hpp"
#include "common/files.hpp"
#include "common/random.hpp"
#include "common/scratch_folder.hpp"
#include "common/version.hpp"
#include "experiments/scenario/input_digests.hpp"
#include "experiments/study/executors/day_keys.hpp"
#include "experiments/study/store/sweep_file.hpp"
#include "tools/evbal/examine.hpp"
#include "tools/evbal/part_bounds.hpp"
#include "tools/evbal/replayed_days.hpp"

#include <algorithm>
#include <cmath>

namespace evbal {
namespace {

namespace fs = std::filesystem;

/// One in so many days is played again.
constexpr std::size_t kOneIn = 10;

Error does_not_hold(const std::string& place, const std::string& what) {
  return Error(ExitStatus::expectation_failed, place + ": " + what);
}

Benchmark benchmark_of(const StudyLine& line, const std::string& place) {
  if (line.version != version()) {
    throw bad_input(place + ": was made by evbal " + line.version + ", this is " + version() +
                    "; days repeat under the same version only");
  }
  Benchmark benchmark = read_benchmark(find_benchmark(fs::path(line.file).filename()));
  if (benchmark.name != line.benchmark || benchmark.digest != line.benchmark_digest) {
    throw bad_input(place + ": is of benchmark " + line.benchmark + ", of which " + line.file +
                    " here differs; take the file and the scenarios that it was made with");
  }
  const auto same_name = [](const StudiedPart& part, const BenchmarkPart& own) { return part.name == own.name; };
  if (!std::equal(line.parts.begin(), line.parts.end(), benchmark.parts.begin(), benchmark.parts.end(), same_name)) {
    throw does_not_hold(place, "has other parts than its benchmark");
  }
  return benchmark;
}

/// The sweeps of a line's parts.
std::vector<Sweep> sweeps_of(const StudyLine& line, const Benchmark& benchmark, const Entry& entry,
                             const fs::path& folder) {
  std::vector<Sweep> sweeps;
  for (std::size_t i = 0; i < benchmark.parts.size(); ++i) {
    const fs::path file = folder / (benchmark.parts[i].name + ".sweep.yaml");
    write_file(file, sweep_yaml(benchmark.parts[i], entry, line.parts[i].settings));
    sweeps.push_back(read_sweep(file));
  }
  return sweeps;
}

std::string name_of(const StudiedPart& part, const SweptDay& day) {
  return part.name + ", " + day.variant + (day.faults.empty() ? "" : ", " + day.faults) + ", " + day.day + ", seed " +
         std::to_string(day.seed);
}

/// Plays some days of a part again.
void check_days(const StudiedPart& part, const Sweep& sweep, const std::vector<std::size_t>& chosen,
                const fs::path& folder, const std::string& place, const PlayingOptions& options) {
  Sweep again{.settings = sweep.settings, .days = {}};
  for (const std::size_t i : chosen) {
    again.days.push_back(sweep.days[i]);
  }
  if (again.days.empty()) {
    return;
  }
  const SweepFolder played(folder, sweep_file_name);
  refuse_failed(play_shown(again, keys_of(again), played, options), again);
  const std::vector<FinishedDay> days = read_finished(played.file());
  for (std::size_t i = 0; i < days.size(); ++i) {
    const StudiedDay& claimed = part.days[chosen[i]];
    const double km = days[i].totals.at("idle_km");
    const double lost = days[i].totals.at("lost");
    if (claimed.digest != days[i].digest || claimed.lost != lost || claimed.idle_km != km) {
      throw does_not_hold(place, name_of(part, again.days[i]) + ": played again it loses " + std::to_string(lost) +
                                     " passengers at " + std::to_string(km) + " idle km with digest " + days[i].digest +
                                     ", not " + std::to_string(claimed.lost) + " at " +
                                     std::to_string(claimed.idle_km) + " with " + claimed.digest);
    }
  }
}

/// Computes a bound of a part again.
void check_bound(const BenchmarkPart& own, const StudiedPart& part, const Sweep& sweep, RandomStream& random,
                 const std::string& place) {
  std::vector<StudiedBound> wanted;
  if (part.bounds.empty()) {
    return;
  }
  const StudiedBound& claimed = part.bounds[random.below(part.bounds.size())];
  const auto day = std::find_if(sweep.days.begin(), sweep.days.end(), [&](const SweptDay& one) {
    return one.day == claimed.day && one.seed == claimed.seed && scenario_of(one).schedule.faults.empty();
  });
  const std::string name = part.name + ", bound of " + claimed.day + ", seed " + std::to_string(claimed.seed);
  if (day == sweep.days.end()) {
    throw does_not_hold(place, name + ": the benchmark has no such day");
  }
  const std::vector<Driving> corners = bound_of(own, *day).corners;
  const auto near = [](const Driving& a, const Driving& b) {
    return std::abs(a.km - b.km) <= 1e-3 + 1e-6 * b.km && std::abs(a.lost - b.lost) <= 1e-3 + 1e-6 * b.lost;
  };
  if (!std::equal(corners.begin(), corners.end(), claimed.corners.begin(), claimed.corners.end(), near)) {
    throw does_not_hold(place, name + ": computed again it is another");
  }
}

}  // namespace

std::string verify_line(const std::string& text, const std::string& place, const Verifying& verifying) {
  const ClaimedLine claimed = read_line(text, place);
  const StudyLine& line = claimed.line;
  const Benchmark benchmark = benchmark_of(line, place);
  const ScratchFolder folder;
  const Entry entry{
      line.controller,
      command_from(fs::current_path(), verifying.coordinator.empty() ? line.coordinator : verifying.coordinator),
      {}};
  if (command_digest(entry.coordinator) != line.coordinator_digest) {
    throw bad_input(place + ": `" + shown(entry.coordinator) +
                    "` is not the coordinator that it was made with; give that one by --coordinator");
  }
  const std::vector<Sweep> sweeps = sweeps_of(line, benchmark, entry, folder.path());
  const std::string results = results_text(results_of(line, sweeps));
  if (results != claimed.results) {
    throw does_not_hold(place, "its days come to other results: " + results);
  }
  RandomStream random(verifying.seed, Purpose::verified_day, {});
  std::size_t all = 0;
  for (const Sweep& sweep : sweeps) {
    all += sweep.days.size();
  }
  const std::vector<std::size_t> chosen = random_choice((all + kOneIn - 1) / kOneIn, all, random);
  std::size_t before = 0;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    std::vector<std::size_t> here;
    for (const std::size_t day : chosen) {
      if (day >= before && day < before + sweeps[i].days.size()) {
        here.push_back(day - before);
      }
    }
    before += sweeps[i].days.size();
    check_days(line.parts[i], sweeps[i], here, folder.path() / benchmark.parts[i].name, place, verifying.options);
    check_bound(benchmark.parts[i], line.parts[i], sweeps[i], random, place);
  }
  return place + ": " + line.benchmark + ", " + line.controller + ": holds; played again " +
         std::to_string(chosen.size()) + " of " + std::to_string(all) + " days, chosen by --seed " +
         std::to_string(verifying.seed);
}

}  // namespace evbal
