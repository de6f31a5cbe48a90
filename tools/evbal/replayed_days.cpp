#include "tools/evbal/replayed_days.hpp"

#include "common/contract.hpp"
#include "common/error.hpp"
#include "common/scratch_folder.hpp"
#include "experiments/study/executors/day_keys.hpp"
#include "experiments/study/store/sweep_file.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace evbal {
namespace {

std::string name_of(const SweptDay& day) {
  std::string name = day.scenario + " " + day.variant;
  for (const auto& [path, value] : day.settings) {
    name.append(" ").append(path).append("=").append(value);
  }
  return name + (day.faults.empty() ? "" : " " + day.faults) + " " + day.day + " seed " + std::to_string(day.seed);
}

}  // namespace

std::vector<std::size_t> random_choice(std::size_t count, std::size_t all, RandomStream& random) {
  EVBAL_EXPECT(count <= all, "no more than there are");
  std::vector<std::size_t> left(all);
  std::iota(left.begin(), left.end(), std::size_t{0});
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(left[i], left[i + random.below(all - i)]);
  }
  left.resize(count);
  std::sort(left.begin(), left.end());
  return left;
}

std::string replay_days(const Sweep& sweep, const std::filesystem::path& file, std::size_t count, std::uint64_t seed,
                        const PlayingOptions& options) {
  const std::vector<FinishedDay> stored = read_finished(file);
  if (stored.size() != sweep.days.size()) {
    throw bad_input(file.string() + ": holds " + std::to_string(stored.size()) + " days, of which the sweep has " +
                    std::to_string(sweep.days.size()) + " now; play it to its end first");
  }
  RandomStream random(seed, Purpose::verified_day, {});
  const auto chosen = random_choice(std::min(count, stored.size()), stored.size(), random);
  Sweep again{.settings = sweep.settings, .days = {}};
  for (const std::size_t i : chosen) {
    again.days.push_back(sweep.days[i]);
  }
  const ScratchFolder scratch;
  const SweepFolder folder(scratch.path() / "again", sweep_file_name);
  refuse_failed(play_shown(again, keys_of(again), folder, options), again);
  const std::vector<FinishedDay> played = read_finished(folder.file());
  std::string others;
  for (std::size_t i = 0; i < played.size(); ++i) {
    const FinishedDay& before = stored[chosen[i]];
    if (played[i].digest != before.digest) {
      others += "\n  " + name_of(again.days[i]) + ": digest " + played[i].digest + ", not " + before.digest;
    }
  }
  if (!others.empty()) {
    throw Error(ExitStatus::expectation_failed, file.string() + ": days that came out otherwise:" + others);
  }
  return file.string() + ": played again " + std::to_string(chosen.size()) + " of " + std::to_string(stored.size()) +
         " days, chosen by seed " + std::to_string(seed) + ": the same digests";
}

}  // namespace evbal
