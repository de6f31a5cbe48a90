#include "coordinator/filter/count_law.hpp"
#include "coordinator/filter/fleet_filter.hpp"
#include "coordinator/filter/innocents.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

// Who lies.

namespace evbal {
namespace {

constexpr double suspicion_enough = 3.0;    ///< of one region before all others: 20 to 1
constexpr double most_suspicion = 6.0;      ///< by one report
constexpr double certain_deviations = 2.0;  ///< of the fleet's balance, beyond which it says that somebody lies
constexpr double least_of_city = 0.7;       ///< of that balance
constexpr double most_by_city = 6.0;        ///< that it says of who is wrong
// ln of how much likelier it is that an accusation was of the wrong kind, for it to be turned, and at most at first.
constexpr double certain_of_passengers = 4.0;
constexpr double most_doubt = 3.0;
constexpr double first_doubt = 0.3;  ///< variance of a count that was just found to be wrong, beside the evidence's
// -ln of the odds that a suspect tells the truth: of one whose cars have just changed as they should, and of others.
constexpr double price_of_steady = -1.0;
constexpr double price_of_others = 2.0;

/// By how much likelier a count becomes, as a logarithm, if `gained` of it are a lie.
double likelier(int count, int gained, double expected, int slack) {
  return log_probability(count - gained, expected, slack) - log_probability(count, expected, slack);
}

/// One report convinces nobody alone.
double limited(double suspicion) {
  return std::clamp(suspicion, -most_suspicion, most_suspicion);
}

}  // namespace

void FleetFilter::find_lies(const std::vector<News>& news) {
  double gained = city_gained(news);
  if (acquit(news, gained)) {
    gained += city_gained(news);
  }
  for (const Accusation& accusation : accused(news)) {
    disbelieve(accusation, news[static_cast<std::size_t>(accusation.region)]);
    gained = 0.0;
  }
  if (const auto culprit = suspected(news, gained)) {
    disbelieve(*culprit, news[static_cast<std::size_t>(culprit->region)]);
  }
}

/// Believes cars again where that was wrong not to, unless somebody else has just gained as many as would tell so.
bool FleetFilter::acquit(const std::vector<News>& news, double gained) {
  for (std::size_t i = 0; i < news.size(); ++i) {
    const Evidence& evidence = regions_[i].evidence;
    if (news[i].weighed && evidence.enough_to_explain() && std::abs(evidence.cars() - gained) < 1.0) {
      return false;
    }
  }
  const std::vector<int> innocent = acquitted(news);
  for (const int region : innocent) {
    Region& known = regions_[static_cast<std::size_t>(region)];
    known.lies.at(index_of(ReportField::vacant)).reset();
    known.lies.at(index_of(ReportField::low_battery)).reset();
    known.stock.reset();
  }
  return !innocent.empty();
}

/// Those who tell the truth, as is likeliest of all suspects together: an accusation that was wrong, or is no longer
/// true, leaves the city with cars too many or too few.
std::vector<int> FleetFilter::acquitted(const std::vector<News>& news) const {
  std::vector<Suspect> suspects;
  for (std::size_t i = 0; i < news.size(); ++i) {
    const Region& known = regions_[i];
    const Report* said = news[i].report;
    if (!known.stock || said == nullptr || said->vacant < 0 || said->low_battery < 0 ||
        std::max(said->vacant, said->low_battery) > model_.vehicles) {
      continue;
    }
    suspects.push_back({static_cast<int>(i), news[i].cars() - total(known.stock->counts()),
                        total_variance(known.stock->covariance()),
                        known.doubt.steady > 0 ? price_of_steady : price_of_others});
  }
  const Estimate now = surplus(news);
  return likeliest_innocents(now.value, now.deviation * now.deviation, suspects);
}

/// Turns an accusation of passengers into one of cars, or the reverse, if what came since says so.
bool FleetFilter::retry(int region, const News& news) {
  Region& known = regions_[static_cast<std::size_t>(region)];
  auto& vacant = known.lies.at(index_of(ReportField::vacant));
  auto& demand = known.lies.at(index_of(ReportField::demand));
  const bool low = known.lies.at(index_of(ReportField::low_battery)).has_value();
  if (demand && !vacant && news.weighed && known.doubt.passengers < -certain_of_passengers) {
    demand.reset();
    disbelieve({region, ReportField::vacant, known.doubt.cars, std::abs(known.doubt.cars), 0.0}, news);
    return true;
  }
  if (vacant && !demand && !low && known.stock && news.report != nullptr &&
      known.doubt.passengers > certain_of_passengers) {
    vacant.reset();
    known.stock.reset();
    disbelieve({region, ReportField::demand, 0.0, 0.0, 0.0}, news);
    return true;
  }
  return false;
}

/// Whose evidence is to be looked at, the largest number of cars first.
std::vector<FleetFilter::Candidate> FleetFilter::candidates(const std::vector<News>& news) const {
  std::vector<Candidate> open;
  for (int i = 0; i < static_cast<int>(news.size()); ++i) {
    const Evidence& evidence = regions_[static_cast<std::size_t>(i)].evidence;
    if (!news[static_cast<std::size_t>(i)].weighed) {
      continue;
    }
    if (evidence.enough_against_low()) {
      open.push_back({i, true, true, evidence.low_alone()});
    } else if (evidence.enough_to_explain()) {
      const double cars = evidence.cars();
      open.push_back({i, evidence.low() * cars > cars * cars / 2.0, evidence.enough(), cars});
    }
  }
  std::ranges::stable_sort(open, std::ranges::greater{}, [](const Candidate& is) { return std::abs(is.cars); });
  return open;
}

/// Whom the evidence accuses. Where there is enough by itself it is a number of cars or of passengers: of cars the city
/// came to have as many too many, and of passengers the forecast knows how many are usual. Where there is less, it is a
/// number of cars that explains what the city has gained or lost. If the city is the fleet with the report and not
/// without, a lie has come to its end.
std::vector<FleetFilter::Accusation> FleetFilter::accused(const std::vector<News>& news) {
  const std::vector<Candidate> open = candidates(news);
  double explained = 0.0;  // of what the city has gained, by those who are taken to lie about cars
  for (const Candidate& is : open) {
    explained += is.enough ? is.cars : 0.0;
  }
  const Estimate now = surplus(news);
  const double deviation = std::max(least_of_city, now.deviation);
  std::vector<Accusation> found;
  for (const Candidate& is : open) {
    Evidence& evidence = regions_[static_cast<std::size_t>(is.region)].evidence;
    const News& here = news[static_cast<std::size_t>(is.region)];
    const double others = explained - (is.enough ? is.cars : 0.0);
    const auto for_cars = [&](double left) { return (std::abs(left) - std::abs(left - is.cars)) / deviation; };
    const double for_passengers =
        evidence.passengers() - std::clamp(for_cars(evidence.city() - others), -most_by_city, most_by_city);
    const bool passengers = is.enough && for_passengers > 0.0 && (is.low || may_be_passengers(is.region, here));
    const bool ended = for_cars(now.value - others) < -certain_deviations;
    const bool counted = is.enough ? !passengers
                                   : std::abs(is.cars) > certain_deviations * now.deviation &&
                                         for_cars(evidence.city() - others) > certain_deviations;
    if (is.enough && (passengers || ended)) {
      explained -= is.cars;
    }
    if (counted && ended) {
      evidence.clear();
    } else if (counted) {
      explained += is.enough ? 0.0 : is.cars;
      found.push_back({is.region, is.low ? ReportField::low_battery : ReportField::vacant, is.cars,
                       is.low ? 0.0 : evidence.variance(), for_passengers});
    } else if (passengers && !is.low && evidence.enough_against_passengers()) {
      found.push_back({is.region, passengers_field(is.region, here), is.cars, 0.0, for_passengers});
    }
  }
  return found;
}

/// Whether so many passengers can be wrong: no more can be too many than are said to have been.
bool FleetFilter::may_be_passengers(int region, const News& news) const {
  return news.excess &&
         (news.report->vacant == 0 ||
          news.excess->cars <= news.report->demand + regions_[static_cast<std::size_t>(region)].counts.waiting);
}

/// Too few cars are too many passengers who wait if somebody waits beside a vacant car; too many are too few of them if
/// nobody waits where there is none; else demand is wrong.
ReportField FleetFilter::passengers_field(int region, const News& news) const {
  const bool waits = news.report->waiting > 0;
  const bool vacant = news.report->vacant > 0;
  const bool too_few = regions_[static_cast<std::size_t>(region)].evidence.cars() < 0.0;
  return waits == vacant && waits == too_few ? ReportField::waiting : ReportField::demand;
}

/// If the city has gained or lost cars, a number of cars lies somewhere, be it by little: that of the region where so
/// many too many are likely, and likelier than anywhere else.
std::optional<FleetFilter::Accusation> FleetFilter::suspected(const std::vector<News>& news, double gained) {
  const Estimate now = surplus(news);
  const int cars = static_cast<int>(std::lround(gained));
  const bool told = cars != 0 && std::abs(cars) > certain_deviations * now.deviation;
  const auto most = [](const Suspicion& is) { return std::max(is.of_vacant, is.of_low); };
  double second = -std::numeric_limits<double>::infinity();
  Region* culprit = nullptr;
  for (std::size_t i = 0; i < news.size(); ++i) {
    Region& known = regions_[i];
    if (!news[i].excess || std::abs(now.value) < 0.5) {
      known.suspicion = {};
    } else if (told) {
      const Excess& excess = *news[i].excess;
      const double of_cars = likelier(excess.cars, cars, excess.expected, excess.slack);
      known.suspicion.of_vacant += limited(of_cars);
      known.suspicion.of_low += limited(of_cars + likelier(excess.low, cars, excess.expected_low, 0));
      known.suspicion.cars += gained;
    }
    if (culprit == nullptr || most(known.suspicion) > most(culprit->suspicion)) {
      second = culprit == nullptr ? second : most(culprit->suspicion);
      culprit = &known;
    } else {
      second = std::max(second, most(known.suspicion));
    }
  }
  if (!told || most(culprit->suspicion) < suspicion_enough || most(culprit->suspicion) - second < suspicion_enough) {
    return std::nullopt;
  }
  const Suspicion is = culprit->suspicion;
  culprit->suspicion = {};
  return Accusation{static_cast<int>(culprit - regions_.data()),
                    is.of_low > is.of_vacant ? ReportField::low_battery : ReportField::vacant, is.cars,
                    is.cars * is.cars / 4.0, 0.0};
}

void FleetFilter::disbelieve(const Accusation& of, const News& news) {
  Region& known = regions_[static_cast<std::size_t>(of.region)];
  std::deque<double> before;
  for (const Fields& past : known.past) {
    before.push_back(past.at(index_of(of.field)));
  }
  known.lies.at(index_of(of.field)).emplace(std::move(before));
  if (news.weighed && (of.field == ReportField::vacant || of.field == ReportField::low_battery)) {
    RegionCounts counts{static_cast<double>(news.report->vacant), static_cast<double>(news.report->low_battery),
                        static_cast<double>(news.plugged_since.size()), 0.0};
    (of.field == ReportField::vacant ? counts.vacant : counts.low_battery) -= of.cars;
    StockVector variances = StockVector::Zero();
    variances(static_cast<int>(of.field == ReportField::vacant ? CarKind::vacant : CarKind::low_battery)) =
        of.variance + first_doubt;
    known.stock.emplace(stock_of(counts, count_of(news.bound, Errand::passenger)), variances);
    known.doubt = {};
  }
  known.doubt.passengers = std::clamp(of.passengers, -most_doubt, most_doubt);
  known.doubt.cars = of.cars;
  known.evidence.clear();
}

}  // namespace evbal
