#include "experiments/study/design/study_file.hpp"
#include "experiments/study/design/tuning.hpp"
#include "tests/folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>

namespace evbal {
namespace {

const std::vector<std::string> axes = {"balancing.p_shortage", "balancing.omega", "balancing.theta_0",
                                       "balancing.p_surplus"};

/// Places of a candidate on `axes`: 0 at 1, 1 at 100, by the logarithm.
std::vector<double> places_of(const std::map<std::string, std::string>& settings) {
  std::vector<double> places;
  for (const auto& axis : axes) {
    const auto value = settings.find(axis);
    places.push_back(value == settings.end() ? 0.5 : std::log10(std::stod(value->second)) / 2.0);
  }
  return places;
}

/// Passengers lost with settings at these places, on the replication of this number.
using LostAt = std::function<double(const std::vector<double>&, std::size_t)>;

/// A tuning that was played to its end.
struct SearchPlayed {
  std::map<std::string, std::string> settings{};  ///< that won
  std::size_t days = 0;                           ///< that were played
  std::vector<std::string> edges{};               ///< of these settings
};

class TuningSearch : public ::testing::Test {
 protected:
  TuningSearch() { folder_.write("base.yaml", "schema: 1\ncity: toy-5\nday: 2024-01-01\nseed: 1\n"); }

  /// Four days, with and without faults, so eight replications; `search` of the variant.
  Tuning read(const std::string& search) const {
    return read_tuning(
        folder_.write("tuning.yaml",
                      "schema: 1\nscenario: base.yaml\ndays: [2024-01-01, 2024-01-02, 2024-01-03, 2024-01-04]\n"
                      "seeds: [7]\nfaults: {calm: none, again: none}\nobjective: {lost: 1}\ncandidates: 16\n"
                      "variants: [{controller: nominal, search: {" +
                          search + "}}]\n"),
        false);
  }

  /// A tuning over this range of each axis.
  Tuning over_all_axes(const std::string& range = "{from: 1, to: 100}") const {
    std::string search;
    for (const auto& axis : axes) {
      search += (search.empty() ? "" : ", ") + axis + ": " + range;
    }
    return read(search);
  }

  static SearchPlayed play(const Tuning& tuning, const LostAt& lost) {
    auto contests = contests_of(tuning);
    std::set<std::string> played;
    while (undecided(contests)) {
      const Sweep round = round_of(tuning, contests);
      std::vector<FinishedDay> days;
      for (const auto& day : round.days) {
        const auto number = static_cast<std::size_t>(std::stoi(day.day.substr(8)) - 1 + (day.faults == "calm" ? 0 : 4));
        const std::vector<double> places = places_of(day.settings);
        std::string key = std::to_string(number);
        for (const double place : places) {
          key += " " + std::to_string(place);
        }
        played.insert(key);
        days.push_back({.variant = day.variant, .faults = day.faults, .day = day.day, .seed = day.seed});
        days.back().totals = {{"lost", lost(places, number)}};
      }
      judge_round(tuning, days, contests);
    }
    SearchPlayed result{.days = played.size(), .edges = edges_of(tuning, contests.front())};
    const Tuned tuned = winners(tuning, contests);
    for (const auto& [path, value] : tuned.begin()->second.settings) {
      result.settings[path] = shown(value);
    }
    return result;
  }

 private:
  Folder folder_;
};

/// A bowl around a best point, which lies elsewhere on each replication; `mean` is that of all of them.
struct Bowl {
  std::vector<double> best;
  std::vector<double> steepness;
  std::vector<std::vector<double>> shifts;  ///< of the best, by replication; their mean is 0

  double at(const std::vector<double>& places, const std::vector<double>& shift) const {
    double lost = 100.0;
    for (std::size_t i = 0; i < best.size(); ++i) {
      lost += steepness[i] * std::pow(places[i] - best[i] - shift[i], 2);
    }
    return lost;
  }
  double excess(const std::vector<double>& places) const { return at(places, std::vector<double>(4)) - 100.0; }
};

Bowl random_bowl(std::mt19937_64& random, double beyond) {
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11U) * 0x1p-53;
  };
  Bowl bowl{.best = {}, .steepness = {}, .shifts = std::vector<std::vector<double>>(8)};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    bowl.best.push_back(uniform(-beyond, 1.0 + beyond));
    bowl.steepness.push_back(1000.0 * std::pow(10.0, uniform(-1.0, 1.0)));
    for (std::size_t day = 0; day < 4; ++day) {
      bowl.shifts[day].push_back(uniform(-0.15, 0.15));
      bowl.shifts[day + 4].push_back(-bowl.shifts[day].back());
    }
  }
  return bowl;
}

/// What the winners lose more than the best, in the mean of 60 bowls.
double mean_excess(const std::function<SearchPlayed(const LostAt&)>& play, double beyond) {
  std::mt19937_64 random(20241128);
  double sum = 0.0;
  for (int i = 0; i < 60; ++i) {
    const Bowl bowl = random_bowl(random, beyond);
    const SearchPlayed played = play([&](const std::vector<double>& places, std::size_t replication) {
      return bowl.at(places, bowl.shifts[replication]);
    });
    EXPECT_LE(played.days, 40U);
    sum += bowl.excess(places_of(played.settings));
  }
  return sum / 60.0;
}

/// The best of 16 points of Halton's sequence, of which ever fewer play ever more of the eight replications.
SearchPlayed halved(const LostAt& lost) {
  std::vector<std::vector<double>> points;
  for (int number = 1; number <= 16; ++number) {
    points.emplace_back();
    for (const int base : {2, 3, 5, 7}) {
      double place = 0.0;
      for (double unit = 1.0 / base, rest = number; rest >= 1.0; rest = std::floor(rest / base), unit /= base) {
        place += std::fmod(rest, base) * unit;
      }
      points.back().push_back(place);
    }
  }
  for (std::size_t replications = 1; replications <= 8; replications *= 2) {
    const auto sum = [&](const std::vector<double>& point) {
      double all = 0.0;
      for (std::size_t i = 0; i < replications; ++i) {
        all += lost(point, i * 8 / replications);
      }
      return all;
    };
    std::stable_sort(points.begin(), points.end(), [&](const auto& a, const auto& b) { return sum(a) < sum(b); });
    points.resize(points.size() / 2);
  }
  SearchPlayed result{.days = 16 + 8 + 4 * 2 + 2 * 4};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    result.settings[axes[i]] = std::to_string(std::pow(100.0, points.front()[i]));
  }
  return result;
}

TEST_F(TuningSearch, ComesNearerToTheBestThanOneSpreadOfCandidatesOnAsManyDays) {
  const Tuning tuning = over_all_axes();
  const auto searched = [&](const LostAt& lost) { return play(tuning, lost); };
  EXPECT_LT(mean_excess(searched, 0.0), 0.85 * mean_excess(halved, 0.0));
  EXPECT_LT(mean_excess(searched, 0.3), 0.65 * mean_excess(halved, 0.3));
}

TEST_F(TuningSearch, FollowsTheBestPastTheEdgeOfItsRange) {
  const Tuning tuning = over_all_axes();
  for (const double best : {1.4, -0.4}) {
    const LostAt lost = [&](const std::vector<double>& places, std::size_t) {
      return 1000.0 * std::pow(places[0] - best, 2) + 50.0 * std::pow(places[2] - 0.5, 2);
    };
    const std::vector<double> found = places_of(play(tuning, lost).settings);
    EXPECT_LT(lost(found, 0), 160.0) << "which is the least that the range has";
    EXPECT_NEAR(found[0], best, 0.35);
  }
}

TEST_F(TuningSearch, StopsWhereItMayNotGoFurtherAndSaysSo) {
  const LostAt upwards = [](const std::vector<double>& places, std::size_t) {
    return 1000.0 * std::pow(places[0] - 2.0, 2);
  };
  const SearchPlayed limited = play(read("balancing.p_shortage: {from: 1, to: 100, most: 150}"), upwards);
  EXPECT_GT(std::stod(limited.settings.at(axes[0])), 100.0);
  EXPECT_LE(std::stod(limited.settings.at(axes[0])), 150.0);
  ASSERT_EQ(limited.edges.size(), 1U);
  EXPECT_EQ(limited.edges[0], axes[0] + "=" + limited.settings.at(axes[0]) + ", upper edge");
}

TEST_F(TuningSearch, DoesNotGoWhereTheScenarioRefusesAValue) {
  const Tuning tuning = read("balancing.flow_served: {from: 0.1, to: 1}");
  auto contests = contests_of(tuning);
  while (undecided(contests)) {
    const Sweep round = round_of(tuning, contests);
    std::vector<FinishedDay> days;
    for (const auto& day : round.days) {
      const double value = std::stod(day.settings.at("balancing.flow_served"));
      EXPECT_LE(value, 1.0);
      days.push_back(
          {.variant = day.variant, .faults = day.faults, .day = day.day, .totals = {{"lost", 100.0 / value}}});
    }
    judge_round(tuning, days, contests);
  }
  EXPECT_EQ(edges_of(tuning, contests.front()).size(), 1U);
}

TEST_F(TuningSearch, IsNotDisturbedBySettingsThatDoNothing) {
  const LostAt first_only = [](const std::vector<double>& places, std::size_t) {
    return 1000.0 * std::pow(places[0] - 0.37, 2);
  };
  const auto alone = play(read("balancing.p_shortage: {from: 1, to: 100}"), first_only).settings;
  EXPECT_EQ(play(over_all_axes(), first_only).settings.at(axes[0]), alone.at(axes[0]));
  EXPECT_NEAR(places_of(alone)[0], 0.37, 0.02);
}

TEST_F(TuningSearch, ComparesCandidatesOnTheSameDaysAndFaultsInTurn) {
  const Tuning tuning = over_all_axes();
  auto contests = contests_of(tuning);
  std::vector<std::size_t> candidates;
  std::vector<std::set<std::string>> shared;
  while (undecided(contests)) {
    const Sweep round = round_of(tuning, contests);
    const std::size_t each = round.days.size() / contests.front().left;
    candidates.push_back(contests.front().left);
    shared.emplace_back();
    std::vector<FinishedDay> days;
    for (std::size_t i = 0; i < round.days.size(); ++i) {
      const SweptDay& day = round.days[i];
      EXPECT_EQ(day.day + day.faults, round.days[i % each].day + round.days[i % each].faults);
      shared.back().insert(day.faults + " " + day.day);
      days.push_back(
          {.variant = day.variant, .faults = day.faults, .day = day.day, .totals = {{"lost", static_cast<double>(i)}}});
    }
    judge_round(tuning, days, contests);
  }
  EXPECT_EQ(candidates, (std::vector<std::size_t>{12, 16, 8, 2}));
  EXPECT_EQ(shared[1], (std::set<std::string>{"calm 2024-01-01"}));
  EXPECT_EQ(shared[2], (std::set<std::string>{"calm 2024-01-01", "again 2024-01-02"}));
  EXPECT_EQ(shared[3].size(), 8U);
}

}  // namespace
}  // namespace evbal
