#pragma once

#include "experiments/study/design/page.hpp"
#include "experiments/study/statistics/front.hpp"
#include "experiments/study/statistics/page_days.hpp"
#include "experiments/study/statistics/primaries.hpp"

#include <optional>
#include <string>
#include <vector>

/// What the figures of a page show, worked out from its days. They are drawn by tools/report/page/.
namespace evbal {

/// A variant among the fronts: the means over days of its settings, a day and seed.
struct FrontLine {
  std::string name;                  ///< in words
  std::vector<FrontPoint> points{};  ///< lost passengers by idle km, by rising idle km
  std::vector<FrontPoint> hull{};    ///< their lower convex hull
  std::optional<Interval> km{};      ///< of a variant with a single setting: its idle km, over days
  std::optional<Interval> lost{};    ///< likewise
};

/// The fronts of one scenario.
struct FrontPanel {
  std::string title;               ///< the scenario, in words
  std::vector<FrontLine> lines{};  ///< in the order of the figure; those without days are left out
  std::vector<FrontPoint>
      bound{};         ///< the least that is possible, lost passengers by idle km; empty if it is not known
  std::string note{};  ///< on which days the bound is known
};

/// A difference with its interval.
struct FigureRow {
  std::string name;                      ///< in words
  std::optional<Interval> difference{};  ///< a share; none if nothing could be compared
  int days = 0;                          ///< that could be compared
  std::optional<double> p_holm{};        ///< of a primary endpoint
  std::optional<double> paper{};         ///< what the paper reports: the row is its own, and no day of it was played
};

/// Rows under a heading; of a map the cells of a row.
struct FigureGroup {
  std::string title;              ///< in words
  std::vector<FigureRow> rows{};  ///< at least one
};

/// The days of one scenario, from one variant to another.
struct SlopePanel {
  std::string title;                ///< the scenario, in words
  std::vector<ComparedDay> days{};  ///< lost passengers of both at equal idle km, a seed
};

/// What a metric of a variant came to.
struct Bar {
  std::string name;  ///< in words
  Interval value;    ///< mean over days, or the share of all days together, whose interval is not known
};

/// The bars of one scenario and schedule of faults.
struct BarGroup {
  std::string title;        ///< in words
  std::vector<Bar> bars{};  ///< of variants and metrics, in the order of the figure; those without days are left out
};

/// A figure, and what it shows.
struct StudyFigure {
  FigureKind kind = FigureKind::fronts;  ///< how it is drawn
  std::string name;                      ///< of its file, without a suffix: "1-fronts"
  std::string title;                     ///< above it
  std::string caption;                   ///< from the sweep's file, Markdown
  std::string from{};                    ///< of slopes: the reference, in words
  std::string to{};                      ///< of slopes: the variant, in words
  std::vector<FrontPanel> fronts{};      ///< of fronts
  std::vector<FigureGroup> groups{};     ///< of claims, forest, ablation and map
  std::vector<SlopePanel> slopes{};      ///< of slopes
  std::vector<BarGroup> bars{};          ///< of bars
  bool shares = false;                   ///< of bars: whether they are shares, not counts
};

/// What a kind of figure is called.
std::string kind_name(FigureKind kind);

/// The page's figures in their order. `answers` are its primary endpoints.
std::vector<StudyFigure> study_figures(const Page& page, const PageDays& days,
                                       const std::vector<PrimaryAnswer>& answers);

/// The bars of a figure.
std::vector<BarGroup> bar_groups(const Page& page, const PageFigure& figure, const PageDays& days);

/// The fronts of a figure in one scenario.
FrontPanel front_panel(const Page& page, const PageFigure& figure, const std::string& scenario, const PageDays& days);

}  // namespace evbal
