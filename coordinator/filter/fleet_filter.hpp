#pragma once

#include "agents/protocol/measured.hpp"
#include "agents/protocol/messages.hpp"
#include "common/eigen.hpp"
#include "coordinator/filter/balance.hpp"
#include "coordinator/filter/lie.hpp"
#include "coordinator/filter/moves_made.hpp"
#include "coordinator/filter/running_ratio.hpp"

#include <array>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace evbal {

/// What the filter knows of the city.
struct FilterModel {
  int vehicles = 0;         ///< of the fleet
  Eigen::VectorXi points;   ///< installed, N
  double patience = 0.0;    ///< minutes that a passenger waits at least
  Eigen::MatrixXd minutes;  ///< that a car on its way takes, N x N, whole; until the next tick at least
  /// Probability that a charging session which has lasted so many minutes ends within the next so many.
  std::function<double(double so_far, double minutes)> share_that_ends;
};

/// Trips that are over before the plan after the one that they begin after.
struct ShortTrips {
  int from = 0;        ///< region
  int to = 0;          ///< region
  double share = 0.0;  ///< of the trips that begin in `from` between two plans
};

/// What was to be expected of the time between two plans.
struct WindowOutlook {
  std::span<const ShortTrips> short_trips;  ///< any order
  Eigen::VectorXd demand;                   ///< N, passengers
  double demand_dispersion = 1.0;           ///< variance of `demand` over its mean
};

/// The fleet as the coordinator believes it to be, and which sensors lie.
///
/// Cars are conserved: those of a region change by what arrives, which is announced, by what plans send off, by
/// sessions that begin and end, which are listed, and by passengers picked up, who are those who waited and who
/// appeared less those who wait now. What a report says too much is therefore a count with a known small mean:
/// drop-offs of trips too short to be announced, and passengers who gave up. Reports that are too surprising together
/// say that one of the four numbers lies: low_battery or vacant if the city came to have as many cars too many; else
/// demand or waiting, which leave the number of cars right. Where others lie too, the forecast of demand decides. So
/// many passengers alone surprise nobody: a spike is followed by as many pick-ups.
///
/// A number that lies is not believed until it has agreed with its estimate three times in a row, or until the fleet or
/// the forecast shows that it was wrongly accused. Estimates are those of a StockFilter for cars, of the balance for
/// passengers, and for points what was announced.
class FleetFilter {
 public:
  /// Knows of no vehicle yet.
  explicit FleetFilter(FilterModel model);

  /// What the reports of a tick come to.
  struct Result {
    std::vector<Report> reports;                ///< of all regions, with estimates for what is not believed
    std::vector<SensorFlag> flags;              ///< by (region, field)
    std::vector<FieldInnovations> innovations;  ///< of vacant, low_battery and plugged
  };

  /// Goes on to `minute`, at which `tick` begins. `reports` are those that came and whose lists can be true; `moves`
  /// are those of the last plan, and `outlook` is of the time since.
  Result observe(const Tick& tick, int minute, const std::vector<std::optional<Report>>& reports,
                 const std::vector<Move>& moves, const WindowOutlook& outlook);

  /// Variance of the number of vacant vehicles in each region: 0 where a report of them is believed.
  Eigen::VectorXd variance() const;

 private:
  using Fields = std::array<double, measured.size()>;  ///< a number for each field, by `measured`

  /// That a region's number of cars is why the city has more cars than the fleet, or fewer.
  struct Suspicion {
    double of_vacant = 0.0;  ///< ln of how much likelier the reports are if vacant cars lie
    double of_low = 0.0;     ///< likewise low-battery ones
    double cars = 0.0;       ///< that the city came to have too many of
  };

  /// How numbers of cars or passengers that are not believed have changed.
  struct Doubt {
    int steady = 0;           ///< reports in a row by which cars changed as they should
    bool jumped = false;      ///< whether they once certainly did not
    double passengers = 0.0;  ///< ln of how much likelier it is that passengers are wrong than cars
    double cars = 0.0;        ///< that are too many if it is cars
  };

  struct Region {
    RegionCounts counts;                                   ///< as they are believed to be
    std::optional<StockFilter> stock;                      ///< if not all of its cars are reported and believed
    Evidence evidence;                                     ///< of a lie that is not found yet
    Suspicion suspicion;                                   ///< likewise
    Doubt doubt;                                           ///< while not all of it is believed
    std::optional<RegionCounts> heard;                     ///< its cars as the last report said, true or not
    std::array<std::optional<Lie>, measured.size()> lies;  ///< by `measured`
    std::deque<Fields> past;                               ///< estimates at the last reports
    RunningRatio low_share;                                ///< that comes out low of the cars that come free here
    Report last;                                           ///< as given out
    int broken = 0;                                        ///< vehicles, as far as it is said
  };

  /// What is new of a region.
  struct News {
    const Report* report = nullptr;  ///< null if there is none
    bool present = true;             ///< whether its agent is
    std::vector<int> plugged_since;  ///< of its sessions
    double may_end = 0.0;            ///< sessions that were to be expected to end
    double may_end_variance = 0.0;   ///< of their number
    std::vector<UnderWay> bound;     ///< cars under way to it
    int points = 0;                  ///< that work, as far as it is said
    int broken = 0;                  ///< vehicles, likewise
    RegionWindow window;             ///< since the last plan
    double usual_drop_offs = 0.0;    ///< of short trips in it, by the model
    std::optional<Excess> excess;    ///< if all that it takes is believed
    bool weighed = false;            ///< whether there is evidence of it: its cars and who waits are believed

    /// Cars that its report, which there is, says to be there, plugged ones by their sessions.
    double cars() const { return report->vacant + report->low_battery + static_cast<double>(plugged_since.size()); }
  };

  /// A field that lies, and if it is a number of cars, by how many.
  struct Accusation {
    int region = 0;
    ReportField field = ReportField::none;
    double cars = 0.0;
    double variance = 0.0;    ///< of `cars`
    double passengers = 0.0;  ///< ln of how much likelier it was that passengers are wrong
  };

  /// A region of whose cars there is evidence that they are wrong, if passengers are not.
  struct Candidate {
    int region = 0;
    bool low = false;     ///< whether it is low-battery cars, not vacant ones
    bool enough = false;  ///< evidence, by itself
    double cars = 0.0;    ///< too many
  };

  /// An estimate and the standard deviation of its error.
  struct Estimate {
    double value = 0.0;
    double deviation = 0.0;
  };

  std::vector<News> news_of(const Tick& tick, int minute, const std::vector<std::optional<Report>>& reports,
                            const std::vector<Move>& moves, const WindowOutlook& outlook);
  void count_sessions(int minute, int region, News& news) const;
  void add_road_traffic(const std::vector<Move>& moves, int minute, std::vector<News>& news);
  void add_short_trips(const WindowOutlook& outlook, std::vector<News>& news) const;

  std::optional<double> believed(int region, const News& news, ReportField field) const;
  bool believes_cars(int region, const News& news) const;
  PickUps picked_up(int region, const News& news, const WindowOutlook& outlook) const;

  void notice_impossible(int region, const News& news);
  void follow(int region, News& news, const WindowOutlook& outlook);
  void weigh(int region, News& news, const WindowOutlook& outlook);
  StockChange change_of(int region, const News& news, const WindowOutlook& outlook);
  void learn(const std::vector<News>& news);
  void find_lies(const std::vector<News>& news);
  double city_gained(const std::vector<News>& news);
  bool acquit(const std::vector<News>& news, double gained);
  std::vector<int> acquitted(const std::vector<News>& news) const;
  bool retry(int region, const News& news);
  std::optional<Accusation> suspected(const std::vector<News>& news, double gained);
  std::vector<Candidate> candidates(const std::vector<News>& news) const;
  std::vector<Accusation> accused(const std::vector<News>& news);
  bool may_be_passengers(int region, const News& news) const;
  ReportField passengers_field(int region, const News& news) const;
  void disbelieve(const Accusation& of, const News& news);
  Estimate surplus(const std::vector<News>& news) const;
  void balance_fleet(const std::vector<News>& news);
  Estimate estimate(int region, const News& news, const WindowOutlook& outlook, ReportField field) const;
  Estimate passengers(int region, const News& news, const WindowOutlook& outlook, ReportField field) const;
  void settle(int tick, int region, const News& news, const WindowOutlook& outlook);
  Result result(const std::vector<News>& news) const;

  FilterModel model_;
  std::vector<Region> regions_;
  PlanMade last_;
  RunningRatio low_share_;      ///< that comes out low of the cars that come free
  RunningRatio trip_rate_;      ///< of short trips that end, to those that are usual
  std::vector<int> unplanned_;  ///< regions that did not hear of it
  double unexplained_ = 0.0;    ///< cars that the city had too many after the last reports
  bool begun_ = false;
};

}  // namespace evbal
