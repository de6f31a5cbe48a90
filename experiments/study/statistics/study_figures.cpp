#include "experiments/study/statistics/study_figures.hpp"

#include <algorithm>
#include <array>

namespace evbal {
namespace {

/// One of the paper's claims, of its robust method against the one without robustness.
struct Claim {
  const char* metric;
  const char* title;
  double paper;  ///< share by which it fell
  const char* at;
  const char* equal;  ///< at what, in words
};

constexpr std::array claims = {
    Claim{"idle_km", "Total cost, km driven empty", -0.1449, "lost", "at equally many lost passengers"},
    Claim{"unfairness_demand", "Unfairness of supply to demand", -0.1578, "idle_km", "at equal km driven empty"},
    Claim{"unfairness_charging", "Unfairness of the chargers' use", -0.3451, "idle_km", "at equal km driven empty"}};

FigureRow row_of(std::string name, const Compared& row) {
  return {.name = std::move(name),
          .difference = row.days > 0 ? std::optional(row.difference) : std::nullopt,
          .days = row.days};
}

/// The variants of a figure against one reference: rows in the order of the figure's scenarios and variants; of those
/// that were not played a row without days.
class Rows {
 public:
  Rows(const PageFigure& figure, const PageDays& days, const Question& question)
      : rows_(whole_rows(days, figure.variants, question, figure.scenarios, figure.faults)) {}

  Compared of(const std::string& scenario, const std::string& faults, const std::string& variant) const {
    const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Compared& row) {
      return row.scenario == scenario && row.faults == faults && row.variant == variant;
    });
    return found == rows_.end() ? Compared{.scenario = scenario, .faults = faults, .variant = variant} : *found;
  }

 private:
  std::vector<Compared> rows_;
};

std::vector<FigureGroup> claim_groups(const Page& page, const PageFigure& figure, const PageDays& days) {
  const std::string& reference = figure.against.front();
  const bool fronts = has_front(days.days, reference);
  std::vector<FigureGroup> groups;
  for (const Claim& claim : claims) {
    const Rows rows(figure, days,
                    {.metric = claim.metric,
                     .reference = reference,
                     .at = fronts ? std::optional<std::string>(claim.at) : std::nullopt});
    FigureGroup group{.title = claim.title + std::string(fronts ? std::string(", ") + claim.equal : "")};
    group.rows.push_back({.name = "The paper, Shenzhen, data not public", .paper = claim.paper});
    for (const std::string& scenario : figure.scenarios) {
      const Compared row = rows.of(scenario, figure.faults.front(), figure.variants.front());
      group.rows.push_back(row_of("Here, " + words_for(page, scenario), row));
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

std::string pair_words(const Page& page, const PrimaryAnswer& answer) {
  return words_for(page, answer.row.variant) + " against " + words_for(page, answer.question.reference);
}

/// The answers to one question, or of one section.
FigureGroup primary_group(const Page& page, const std::vector<const PrimaryAnswer*>& answers) {
  const std::string pair = pair_words(page, *answers.front());
  const bool one_pair = std::all_of(answers.begin(), answers.end(),
                                    [&](const auto* answer) { return pair_words(page, *answer) == pair; });
  FigureGroup group{.title = answers.front()->section + (one_pair ? " " + pair : "")};
  for (const PrimaryAnswer* answer : answers) {
    const auto& [scenario, faults, variant, against, metric] = answer->endpoint();
    group.rows.push_back(row_of(words_for(page, scenario) + (faults.empty() ? "" : ", " + words_for(page, faults)) +
                                    (one_pair ? "" : ": " + pair_words(page, *answer)) +
                                    (metric == "lost" ? "" : ", " + metric),
                                answer->row));
    FigureRow& shown = group.rows.back();
    shown.p_holm = answer->p_holm;
    if (answer->row.days > 0 && !answer->row.relative) {
      shown.difference.reset();
      shown.name += " (no ratio: see the table)";
    }
  }
  return group;
}

std::vector<FigureGroup> primary_groups(const Page& page, const std::vector<PrimaryAnswer>& answers) {
  std::vector<FigureGroup> groups;
  for (std::size_t i = 0; i < answers.size();) {
    std::vector<const PrimaryAnswer*> of_one;
    for (const std::string& section = answers[i].section; i < answers.size() && answers[i].section == section; ++i) {
      of_one.push_back(&answers[i]);
    }
    groups.push_back(primary_group(page, of_one));
  }
  return groups;
}

std::vector<FigureGroup> ablation_groups(const Page& page, const PageFigure& figure, const PageDays& days) {
  std::vector<FigureGroup> groups;
  for (const std::string& reference : figure.against) {
    const Rows rows(figure, days, {.metric = "lost", .reference = reference, .at = "idle_km"});
    for (const std::string& scenario : figure.scenarios) {
      FigureGroup group{.title = words_for(page, scenario) + ", against " + words_for(page, reference)};
      for (const std::string& variant : figure.variants) {
        if (variant != reference) {
          group.rows.push_back(row_of(words_for(page, variant), rows.of(scenario, figure.faults.front(), variant)));
        }
      }
      groups.push_back(std::move(group));
    }
  }
  return groups;
}

std::vector<FigureGroup> map_groups(const Page& page, const PageFigure& figure, const PageDays& days) {
  const Rows rows(figure, days, {.metric = "lost", .reference = figure.against.front(), .at = "idle_km"});
  std::vector<FigureGroup> groups;
  for (const std::string& scenario : figure.scenarios) {
    groups.push_back({.title = words_for(page, scenario)});
    for (const std::string& faults : figure.faults) {
      groups.back().rows.push_back(row_of(words_for(page, faults), rows.of(scenario, faults, figure.variants.front())));
    }
  }
  return groups;
}

std::vector<SlopePanel> slope_panels(const Page& page, const PageFigure& figure, const PageDays& days) {
  const Rows rows(figure, days, {.metric = "lost", .reference = figure.against.front(), .at = "idle_km"});
  std::vector<SlopePanel> panels;
  for (const std::string& scenario : figure.scenarios) {
    panels.push_back(
        {words_for(page, scenario), rows.of(scenario, figure.faults.front(), figure.variants.front()).by_day});
  }
  return panels;
}

std::string metric_words(const PageFigure& figure) {
  std::string words;
  for (const std::string& metric : figure.metrics) {
    words += (words.empty() ? "" : " and ") + metric;
  }
  return words;
}

std::string title_of(const Page& page, const PageFigure& figure) {
  const auto pair = [&] {
    return words_for(page, figure.variants.front()) + " against " + words_for(page, figure.against.front());
  };
  switch (figure.kind) {
    case FigureKind::fronts:
      return "Passengers lost against kilometres driven empty, a day";
    case FigureKind::claims:
      return "The paper's three claims, and what came out here: " + pair();
    case FigureKind::forest:
      return "The questions, and what came out";
    case FigureKind::slopes:
      return "Day by day, passengers lost at equal km driven empty: " + pair();
    case FigureKind::ablation:
      return "What each change earns by itself: passengers lost at equal km driven empty";
    case FigureKind::map:
      return "Where it pays, passengers lost at equal km driven empty: " + pair();
    case FigureKind::bars:
      return metric_words(figure) + (figure.of ? ", share of " + *figure.of : ", a day");
  }
  return "";
}

}  // namespace

std::string kind_name(FigureKind kind) {
  return kind == FigureKind::fronts     ? "fronts"
         : kind == FigureKind::claims   ? "claims"
         : kind == FigureKind::forest   ? "forest"
         : kind == FigureKind::slopes   ? "slopes"
         : kind == FigureKind::ablation ? "ablation"
         : kind == FigureKind::map      ? "map"
                                        : "bars";
}

std::vector<StudyFigure> study_figures(const Page& page, const PageDays& days,
                                       const std::vector<PrimaryAnswer>& answers) {
  std::vector<StudyFigure> figures;
  for (const PageFigure& asked : page.figures) {
    StudyFigure figure{.kind = asked.kind,
                       .name = std::to_string(figures.size() + 1) + "-" + kind_name(asked.kind),
                       .title = title_of(page, asked),
                       .caption = asked.caption};
    switch (asked.kind) {
      case FigureKind::fronts:
        for (const std::string& scenario : asked.scenarios) {
          figure.fronts.push_back(front_panel(page, asked, scenario, days));
        }
        break;
      case FigureKind::claims:
        figure.groups = claim_groups(page, asked, days);
        break;
      case FigureKind::forest:
        figure.groups = primary_groups(page, answers);
        break;
      case FigureKind::slopes:
        figure.from = words_for(page, asked.against.front());
        figure.to = words_for(page, asked.variants.front());
        figure.slopes = slope_panels(page, asked, days);
        break;
      case FigureKind::ablation:
        figure.groups = ablation_groups(page, asked, days);
        break;
      case FigureKind::map:
        figure.groups = map_groups(page, asked, days);
        break;
      case FigureKind::bars:
        figure.bars = bar_groups(page, asked, days);
        figure.shares = asked.of.has_value();
        break;
    }
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace evbal
