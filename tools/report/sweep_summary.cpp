#include "tools/report/sweep_summary.hpp"

#include "common/error.hpp"
#include "common/suggestion.hpp"

#include <algorithm>
#include <set>

namespace evbal {
namespace {

bool same_point(const FinishedDay& a, const FinishedDay& b) {
  return a.variant == b.variant && a.scenario == b.scenario && a.faults == b.faults && a.settings == b.settings;
}

/// Values of the days of a point.
struct PointValues {
  std::map<std::string, std::vector<DayValue>> totals;
  std::map<std::string, std::map<int, std::vector<DayValue>>> hours;  ///< by column and hour

  void add(const FinishedDay& day, const FinishedSteps& steps) {
    for (const auto& [metric, value] : day.totals) {
      totals[metric].push_back({day.day, value});
    }
    for (const auto& [column, values] : steps.columns) {
      std::map<int, double> sums;
      for (std::size_t step = 0; step < values.size(); ++step) {
        sums[std::stoi(steps.starts[step])] += values[step];
      }
      for (const auto& [hour, sum] : sums) {
        hours[column][hour].push_back({day.day, sum});
      }
    }
  }
};

bool has_several_settings(const std::vector<FinishedDay>& days, const std::string& variant) {
  std::map<std::string, std::set<std::map<std::string, std::string>>> settings;  // by scenario, which may differ in it
  for (const auto& day : days) {
    if (day.variant == variant) {
      settings[day.scenario].insert(day.settings);
    }
  }
  if (settings.empty()) {
    std::set<std::string> names;
    for (const auto& day : days) {
      names.insert(day.variant);
    }
    throw bad_input("--against: no variant is called `" + variant + "`" +
                    did_you_mean(variant, {names.begin(), names.end()}));
  }
  return settings.begin()->second.size() > 1;
}

/// The questions about a reference; `suffix` stands behind every metric.
std::vector<Question> questions(const std::string& reference, bool front, const std::string& suffix) {
  const auto metric = [&suffix](const char* name) { return name + suffix; };
  const auto at = [&](const char* name) { return front ? std::optional(metric(name)) : std::nullopt; };
  std::vector<Question> all;
  for (const char* name : {"lost", "unfairness_demand", "unfairness_charging", "charger_wait_min"}) {
    all.push_back({metric(name), reference, at("idle_km")});
  }
  all.push_back({metric("idle_km"), reference, at("lost")});
  return all;
}

Answer answer(const std::vector<FinishedDay>& days, const Question& question,
              const std::vector<PrimaryAnswer>& primaries) {
  Answer answer{.question = question};
  try {
    answer.rows = compare(days, question);
  } catch (const Error& error) {
    answer.refused = error.what();
  }
  for (const Compared& row : answer.rows) {
    const auto primary =
        std::find_if(primaries.begin(), primaries.end(), [&](const auto& one) { return one.is(question, row); });
    answer.p_holm.push_back(primary == primaries.end() ? std::nullopt : std::optional(primary->p_holm));
  }
  return answer;
}

}  // namespace

std::vector<SweptPoint> swept_points(const std::vector<FinishedDay>& days, const std::vector<FinishedSteps>& steps) {
  std::vector<SweptPoint> points;
  std::vector<PointValues> values;
  for (std::size_t i = 0; i < days.size(); ++i) {
    const auto at = std::find_if(points.begin(), points.end(),
                                 [&](const SweptPoint& point) { return same_point(point.first, days[i]); });
    const auto position = static_cast<std::size_t>(at - points.begin());
    if (at == points.end()) {
      points.push_back({.first = days[i]});
      values.emplace_back();
    }
    ++points[position].pairs;
    values[position].add(days[i], steps[i]);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const auto& [metric, of_days] : values[i].totals) {
      points[i].means[metric] = t_interval(of_days).mean;
    }
    for (const auto& [column, by_hour] : values[i].hours) {
      for (const auto& [hour, of_days] : by_hour) {
        points[i].hours[column].push_back({hour, t_interval(of_days)});
      }
    }
  }
  return points;
}

std::vector<Answer> answers(const std::vector<FinishedDay>& days, const std::vector<std::string>& references,
                            const std::vector<PrimaryAnswer>& primaries) {
  std::vector<Answer> all;
  for (const auto& reference : references) {
    const bool front = has_several_settings(days, reference);
    for (const char* suffix : {"", "_after_7"}) {
      for (const auto& question : questions(reference, front, suffix)) {
        if (days.front().totals.contains(question.metric)) {
          all.push_back(answer(days, question, primaries));
        }
      }
    }
  }
  return all;
}

}  // namespace evbal
