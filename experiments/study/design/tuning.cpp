#include "experiments/study/design/tuning.hpp"

#include "common/contract.hpp"
#include "common/decimal.hpp"
#include "common/table_text.hpp"
#include "experiments/study/design/study_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace evbal {
namespace {

constexpr std::array primes = {2, 3, 5, 7, 11, 13};
constexpr int quick_candidates = 4;

/// The index's digits in a base, mirrored at the point: a coordinate of Halton's sequence, within (0, 1).
double radical_inverse(int index, int base) {
  double value = 0.0;
  for (double unit = 1.0 / base; index > 0; index /= base, unit /= base) {
    value += index % base * unit;
  }
  return value;
}

YamlValue at(const SearchAxis& axis, double share, const std::string& file) {
  if (!axis.choices.empty()) {
    return axis.choices[static_cast<std::size_t>(share * static_cast<double>(axis.choices.size()))];
  }
  return rounded_setting(axis.from * std::pow(axis.to / axis.from, share), file);
}

SearchAxis read_axis(const std::string& path, const YamlValue& value) {
  refuse_path(value, path);
  if (value.is_list()) {
    return {.path = path, .choices = distinct_items(value)};
  }
  YamlMap range(value);
  SearchAxis axis{.path = path, .from = range.require("from").number(), .to = range.require("to").number()};
  range.finish();
  if (axis.from <= 0.0 || axis.to <= axis.from) {
    throw value.error("is no range; give `{from: 1, to: 100}`, both above 0, or a list of values");
  }
  return axis;
}

Tunable read_tunable(const YamlValue& value) {
  YamlMap map(value);
  Tunable variant;
  variant.controller = read_chosen(map);
  const auto name = map.find("name");
  variant.name = name ? plain_name(*name) : variant.controller.name;
  if (const auto given = map.find("settings")) {
    YamlMap settings(*given);
    for (const auto& path : settings.keys()) {
      variant.settings.push_back({path, settings.require(path)});
      refuse_path(variant.settings.back().value, path);
    }
  }
  YamlMap search(map.require("search"));
  map.finish();
  for (const auto& path : search.keys()) {
    variant.search.push_back(read_axis(path, search.require(path)));
  }
  if (variant.search.empty() || variant.search.size() > primes.size()) {
    throw search.value().error("give 1 to " + std::to_string(primes.size()) + " settings to search");
  }
  return variant;
}

/// What is tuned on test days would be told what it is examined on; what was tuned elsewhere is not tuned here.
void refuse_what_is_not_tuned_on(const Replications& replications) {
  for (const auto& name : replications.scenarios()) {
    if (const auto& other = replications.tuned_as(name)) {
      throw other->error("a scenario that takes what was tuned for another one is not tuned itself; leave it out here");
    }
    const City city = read_scenario(replications.of(name).front().yaml).world.city;
    for (const auto& day : replications.days_of(name)) {
      if (std::find(city.train_days.begin(), city.train_days.end(), day.text()) == city.train_days.end()) {
        throw day.error("`" + day.text() + "` is no training day of " + city.name +
                        did_you_mean(day.text(), city.train_days) + "; tune on its training days only, from " +
                        city.train_days.front() + " to " + city.train_days.back());
      }
    }
  }
}

/// So many of the replications, spread evenly.
std::vector<Replication> spread(const std::vector<Replication>& all, std::size_t count) {
  std::vector<Replication> some;
  for (std::size_t i = 0; i < count; ++i) {
    some.push_back(all[i * all.size() / count]);
  }
  return some;
}

/// How many of `all` replications the candidates that are left play.
std::size_t replications_for(std::size_t left, std::size_t all) {
  return std::clamp<std::size_t>(2 * all / left, 1, all);
}

}  // namespace

Tuning read_tuning(const std::filesystem::path& file, bool quick) {
  YamlMap map(YamlValue::load(file));
  map.require("schema").integer(1, 1);
  Tuning tuning{.replications = Replications(map)};
  refuse_what_is_not_tuned_on(tuning.replications);
  tuning.objective = read_prices(map.require("objective"));
  tuning.candidates = map.require("candidates").integer(2, 1024);
  tuning.variants = read_variants(map.require("variants"), read_tunable);
  map.finish();
  if (quick) {
    tuning.replications.cut(1, 1);
    tuning.candidates = std::min(tuning.candidates, quick_candidates);
  }
  return tuning;
}

std::vector<Contest> contests_of(const Tuning& tuning) {
  std::vector<Contest> contests;
  for (const auto& scenario : tuning.replications.scenarios()) {
    for (std::size_t v = 0; v < tuning.variants.size(); ++v) {
      const Tunable& variant = tuning.variants[v];
      Contest contest{.scenario = scenario, .variant = v};
      for (int number = 1; number <= tuning.candidates; ++number) {
        Candidate candidate{.number = number, .settings = variant.settings};
        for (std::size_t i = 0; i < variant.search.size(); ++i) {
          const SearchAxis& axis = variant.search[i];
          put(candidate.settings, {axis.path, at(axis, radical_inverse(number, primes.at(i)), variant.name)});
        }
        contest.candidates.push_back(std::move(candidate));
      }
      contest.left = contest.candidates.size();
      contests.push_back(std::move(contest));
    }
  }
  return contests;
}

bool undecided(const std::vector<Contest>& contests) {
  return contests.front().left > 1;
}

Sweep round_of(const Tuning& tuning, const std::vector<Contest>& contests) {
  Sweep round;
  for (const auto& contest : contests) {
    const Tunable& variant = tuning.variants[contest.variant];
    const auto all = tuning.replications.of(contest.scenario);
    const auto replications = spread(all, replications_for(contest.left, all.size()));
    for (std::size_t i = 0; i < contest.left; ++i) {
      const Candidate& candidate = contest.candidates[i];
      note_paths(candidate.settings, round.settings);
      for (const auto& replication : replications) {
        round.days.push_back(day_of(replication, variant.name, variant.controller, candidate.settings));
      }
    }
  }
  return round;
}

void judge_round(const Tuning& tuning, const std::vector<FinishedDay>& days, std::vector<Contest>& contests) {
  auto day = days.begin();
  for (auto& contest : contests) {
    const std::size_t replications = replications_for(contest.left, tuning.replications.of(contest.scenario).size());
    for (std::size_t i = 0; i < contest.left; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < replications; ++j) {
        EVBAL_EXPECT(day != days.end(), "every day of the round");
        sum += priced(tuning.objective, *day++);
      }
      contest.candidates[i].objective = sum / static_cast<double>(replications);
      contest.candidates[i].days = static_cast<int>(replications);
    }
    std::stable_sort(contest.candidates.begin(), contest.candidates.begin() + static_cast<std::ptrdiff_t>(contest.left),
                     [](const Candidate& a, const Candidate& b) { return a.objective < b.objective; });
    contest.left = (contest.left + 1) / 2;
  }
  EVBAL_EXPECT(day == days.end(), "no day but the round's");
}

Tuned winners(const Tuning& tuning, const std::vector<Contest>& contests) {
  Tuned tuned;
  for (const auto& contest : contests) {
    const Tunable& variant = tuning.variants[contest.variant];
    tuned[{contest.scenario, variant.name}] = {variant.controller, contest.candidates.front().settings};
  }
  return tuned;
}

std::string candidates_csv(const Tuning& tuning, const std::vector<Contest>& contests) {
  std::string csv = "scenario,variant,candidate,days,objective,settings\n";
  for (const auto& contest : contests) {
    for (const auto& candidate : contest.candidates) {
      std::string settings;
      for (const auto& [path, value] : candidate.settings) {
        settings += (settings.empty() ? "" : " ") + path + "=" + shown(value);
      }
      csv += csv_row({contest.scenario, tuning.variants[contest.variant].name, decimal(candidate.number),
                      decimal(candidate.days), decimal(candidate.objective), settings});
    }
  }
  return csv;
}

}  // namespace evbal
