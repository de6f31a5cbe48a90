#include "experiments/study/statistics/page_markdown.hpp"

#include "common/decimal.hpp"
#include "common/table_text.hpp"
#include "experiments/study/statistics/intervals.hpp"
#include "experiments/study/statistics/markdown.hpp"
#include "experiments/study/statistics/page_comparison.hpp"
#include "experiments/study/statistics/primaries.hpp"
#include "experiments/study/statistics/ranks.hpp"
#include "experiments/study/statistics/replication.hpp"
#include "experiments/study/statistics/study_figures.hpp"
#include "experiments/study/statistics/verdict.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <tuple>
#include <utility>

namespace evbal {
namespace {

/// Scenario, faults and variant of a row, in the order of the sweep, with its days.
using Group = std::tuple<std::string, std::string, std::string>;
std::vector<std::pair<Group, std::vector<const FinishedDay*>>> grouped(const std::vector<FinishedDay>& days,
                                                                       const Words& variants) {
  std::vector<std::pair<Group, std::vector<const FinishedDay*>>> groups;
  for (const auto& day : days) {
    if (!contains(variants, day.variant)) {
      continue;
    }
    const Group group{day.scenario, day.faults, day.variant};
    const auto known = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == group; });
    (known == groups.end() ? groups.emplace_back(group, std::vector<const FinishedDay*>{}) : *known)
        .second.push_back(&day);
  }
  return groups;
}

std::string means(const MeansSection& section, const std::vector<FinishedDay>& days) {
  Words names = {"scenario", "faults", "variant"};
  names.insert(names.end(), section.metrics.begin(), section.metrics.end());
  std::string text = header(names, 3);
  for (const auto& [group, of_group] : grouped(days, section.variants)) {
    Words cells = {markdown_cell(std::get<0>(group)), markdown_cell(std::get<1>(group)), std::get<2>(group)};
    for (const auto& metric : section.metrics) {
      const Interval mean = mean_over_days(of_group, metric);
      cells.push_back(rounded(mean.mean) + (is_known(mean) ? " ± " + rounded(mean.high - mean.mean) : ""));
    }
    text += table_row(cells);
  }
  return text;
}

std::string correlated(const CorrelateSection& section, const std::vector<FinishedDay>& days) {
  std::map<Replication, std::vector<const FinishedDay*>> replications;
  std::vector<std::pair<std::string, std::string>> rows;
  for (const auto& day : days) {
    if (contains(section.variants, day.variant)) {
      replications[replication_of(day)].push_back(&day);
      if (const std::pair row(day.scenario, day.faults); std::find(rows.begin(), rows.end(), row) == rows.end()) {
        rows.push_back(row);
      }
    }
  }
  Words names = {"scenario", "faults"};
  names.insert(names.end(), section.metrics.begin(), section.metrics.end());
  std::string text = header(names, 2);
  for (const auto& [scenario, faults] : rows) {
    Words cells = {markdown_cell(scenario), markdown_cell(faults)};
    for (const auto& metric : section.metrics) {
      std::vector<DayValue> values;
      for (const auto& [replication, points] : replications) {
        if (std::get<0>(replication) == scenario && std::get<1>(replication) == faults) {
          std::vector<double> x;
          std::vector<double> y;
          for (const auto* point : points) {
            x.push_back(point->totals.at(metric));
            y.push_back(point->totals.at(section.with));
          }
          values.push_back({std::get<2>(replication), rank_correlation(x, y)});
        }
      }
      const Interval mean = t_interval(values);
      cells.push_back(fixed(mean.mean, 2, true) + " (" + range(mean, 1.0, 2, true) + ")");
    }
    text += table_row(cells);
  }
  return text;
}

std::string settings(const SettingsSection& section, const std::vector<FinishedDay>& days) {
  std::string text = header({"scenario", "variant", "controller", "settings"}, 4);
  std::set<std::string> seen;
  for (const auto& day : days) {
    if (!contains(section.variants, day.variant) || !seen.insert(day.scenario + " " + day.variant).second) {
      continue;
    }
    std::string list;
    for (const auto& [path, value] : day.settings) {
      if (!value.empty()) {
        list.append(list.empty() ? "`" : ", `").append(path).append("` ").append(markdown_cell(value));
      }
    }
    text += table_row({markdown_cell(day.scenario), day.variant, day.controller, list});
  }
  return text;
}

template <class Value>
std::string listed(const std::vector<FinishedDay>& days, const Value& value) {
  Words names;
  for (const auto& day : days) {
    if (const std::string name = value(day); !contains(names, name)) {
      names.push_back(name);
    }
  }
  std::string text;
  for (const auto& name : names) {
    text += (text.empty() ? "" : ", ") + markdown_cell(name);
  }
  return text;
}

/// The box of what was decided after some of the results were known.
std::string box(const std::string& text) {
  std::string quoted = "**Decided after results were seen.** " + text;
  for (std::size_t at = quoted.find('\n'); at != std::string::npos; at = quoted.find('\n', at + 3)) {
    quoted.replace(at, 1, "\n> ");
  }
  return text.empty() ? "" : "> " + quoted + "\n";
}

std::string made_from(const std::vector<FinishedDay>& days, const std::string& command) {
  return "Made by\n\n    " + command + "\n\nfrom " + std::to_string(days.size()) +
         " simulated days. Scenarios: " + listed(days, [](const FinishedDay& day) { return day.scenario; }) +
         ". Days: " + listed(days, [](const FinishedDay& day) { return day.day; }) +
         ". Seeds: " + listed(days, [](const FinishedDay& day) { return std::to_string(day.seed); }) +
         ". Faults: " + listed(days, [](const FinishedDay& day) { return day.faults.empty() ? "own" : day.faults; }) +
         ".\n";
}

std::string table_of(const PageSection& section, const std::vector<FinishedDay>& days) {
  return (section.compare ? compared(*section.compare, days) : "") +
         (section.fronts ? compared(*section.fronts, days) : "") + (section.means ? means(*section.means, days) : "") +
         (section.correlate ? correlated(*section.correlate, days) : "") +
         (section.settings ? settings(*section.settings, days) : "");
}

/// Whether the page begins with answers, so that its tables are an appendix.
bool has_answers(const Page& page) {
  return !page.verdict.empty() || !page.figures.empty();
}

std::string tables(const Page& page, const std::vector<FinishedDay>& days, const std::vector<PrimaryAnswer>& answers) {
  const std::string heading = has_answers(page) ? "\n### " : "\n## ";
  std::string text = has_answers(page) ? "\n## Appendix: tables\n" : "";
  if (!page.verdict.empty() || std::any_of(page.sections.begin(), page.sections.end(), [](const PageSection& section) {
        return section.compare || section.fronts;
      })) {
    text += heading + "Primary endpoints\n\n" + primaries(answers);
  }
  for (const auto& section : page.sections) {
    text += heading + section.title + "\n\n" + section.text + (section.text.empty() ? "" : "\n\n") +
            table_of(section, days);
  }
  return text;
}

std::string figure_links(const std::vector<StudyFigure>& figures) {
  std::string text;
  int number = 0;
  for (const StudyFigure& figure : figures) {
    text += "\n![" + markdown_cell(figure.title) + "](figures/" + figure.name + ".svg)\n\n**Figure " +
            std::to_string(++number) + ".** " + figure.caption + "\n";
  }
  return text;
}

}  // namespace

PageText page_text(const Page& page, const PageDays& days, const std::vector<PrimaryAnswer>& answers,
                   const std::string& command) {
  return {.verdict = verdict_text(page, days, answers),
          .decided_after = box(page.decided_after),
          .reading = (has_answers(page) ? "\n## How to read it\n\n" : "\n") + page.text +
                     (page.text.empty() ? "" : "\n\n") + made_from(days.days, command),
          .tables = tables(page, days.days, answers)};
}

std::string page_markdown(const std::string& title, const PageText& text, const std::vector<StudyFigure>& figures) {
  const auto apart = [](const std::string& part) { return part.empty() ? "" : "\n" + part; };
  return "# " + title + "\n" + apart(text.verdict) + figure_links(figures) + apart(text.decided_after) + text.reading +
         text.tables;
}

}  // namespace evbal
