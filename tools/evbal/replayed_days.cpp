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

bool is_of(const FinishedDay& stored, const SweptDay& day) {
  return stored.scenario == day.scenario && stored.variant == day.variant && stored.faults == day.faults &&
         stored.day == day.day && stored.seed == day.seed &&
         std::all_of(day.settings.begin(), day.settings.end(), [&](const auto& setting) {
           const auto at = stored.settings.find(setting.first);
           return at != stored.settings.end() && at->second == setting.second;
         });
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
  if (!std::equal(stored.begin(), stored.end(), sweep.days.begin(), sweep.days.end(), is_of)) {
    throw bad_input(file.string() + ": holds other days than the sweep has now; play it to its end first");
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
      others += "\n  " + label_of(again.days[i]) + ": digest " + played[i].digest + ", not " + before.digest;
    }
  }
  if (!others.empty()) {
    throw Error(ExitStatus::expectation_failed, file.string() + ": days that came out otherwise:" + others);
  }
  return file.string() + ": played again " + std::to_string(chosen.size()) + " of " + std::to_string(stored.size()) +
         " days, chosen by seed " + std::to_string(seed) + ": the same digests";
}

}  // namespace evbal
