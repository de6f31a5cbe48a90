#include "experiments/study/statistics/study_figures.hpp"

#include <limits>
#include <utility>

namespace evbal {
namespace {

/// A metric over days: its mean a day, or its share of what another comes to.
class Total {
 public:
  Total(const std::string& metric, const std::optional<std::string>& of) : metric_(metric), of_(of) {}

  void add(const FinishedDay& day) {
    values_.push_back({day.day, day.totals.at(metric_)});
    sum_ += values_.back().value;
    whole_ += of_ ? day.totals.at(*of_) : 0.0;
  }

  /// None without days, or if the whole is nothing.
  std::optional<Interval> value() const {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    if (values_.empty() || (of_ && whole_ == 0.0)) {
      return std::nullopt;
    }
    return of_ ? Interval{sum_ / whole_, -unknown, unknown} : t_interval(values_);
  }

 private:
  const std::string& metric_;
  const std::optional<std::string>& of_;
  std::vector<DayValue> values_;
  double sum_ = 0.0;
  double whole_ = 0.0;
};

std::string bar_words(const Page& page, const PageFigure& figure, const std::string& variant,
                      const std::string& metric) {
  const std::string words = words_for(page, variant);
  return figure.metrics.size() == 1 ? words : figure.variants.size() == 1 ? metric : words + ", " + metric;
}

BarGroup bar_group(const Page& page, const PageFigure& figure, const PageDays& days, const std::string& scenario,
                   const std::string& faults) {
  BarGroup group{.title =
                     (figure.scenarios.size() > 1 ? words_for(page, scenario) + ", " : "") + words_for(page, faults)};
  for (const std::string& variant : figure.variants) {
    for (const std::string& metric : figure.metrics) {
      Total total(metric, figure.of);
      for (const FinishedDay& day : days.days) {
        if (day.variant == variant && day.scenario == scenario && day.faults == faults) {
          total.add(day);
        }
      }
      if (const auto value = total.value()) {
        group.bars.push_back({bar_words(page, figure, variant, metric), *value});
      }
    }
  }
  return group;
}

}  // namespace

std::vector<BarGroup> bar_groups(const Page& page, const PageFigure& figure, const PageDays& days) {
  std::vector<BarGroup> groups;
  for (const std::string& scenario : figure.scenarios) {
    for (const std::string& faults : figure.faults) {
      BarGroup group = bar_group(page, figure, days, scenario, faults);
      if (!group.bars.empty()) {
        groups.push_back(std::move(group));
      }
    }
  }
  return groups;
}

}  // namespace evbal
