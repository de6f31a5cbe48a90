#include "tools/evbal/metric_meanings.hpp"

namespace evbal {

const std::vector<MetricMeaning>& metric_meanings() {
  static const std::vector<MetricMeaning> all = {
      {"idle_km", "km", "driven empty because a plan said so: rebalance_km + beta charge_km"},
      {"unfairness_demand", "", "distance of the regions' demand-supply ratios from the city's"},
      {"unfairness_charging", "", "the same for charged cars over cars that need a charger"},
      {"unfairness_demand_shares", "", "unfairness_demand as difference of shares"},
      {"unfairness_charging_shares", "", "unfairness_charging as difference of shares"},
      {"unfairness_demand_drop_offs", "", "unfairness_demand with drop-offs counted as supply"},
      {"demand", "passengers", "who appeared"},
      {"served", "passengers", "who were picked up"},
      {"lost", "passengers", "who gave up waiting"},
      {"wait_minutes", "min", "waiting of the passengers who were served"},
      {"completions", "sessions", "charging sessions that ended charged"},
      {"queue_minutes", "min", "low-battery cars' waiting at stations, summed over cars"},
      {"stranded", "cars", "arrived with an empty battery"},
      {"refused", "cars", "asked for by plans and not there, or without the charge to get there"},
      {"rebalance_moves", "cars", "vacant cars that plans sent to another region"},
      {"charge_moves", "cars", "low-battery cars that plans sent to another region"},
      {"top_ups", "cars", "vacant cars that plans had charge where they stood"},
      {"rebalance_km", "km", "driven by vacant cars that plans sent"},
      {"charge_km", "km", "driven by low-battery cars that plans sent"},
      {"passenger_km", "km", "driven with a passenger"},
      {"charged_kwh", "kWh", "energy charged"},
      {"unserved_ratio", "share", "lost / (served + lost)"},
      {"p90_regional_loss", "share", "90th percentile of the same over regions with passengers"},
      {"passenger_wait_min", "min", "mean wait of the passengers who were served"},
      {"charger_wait_min", "min", "low-battery cars' waiting where there is a station, summed over cars"},
      {"charger_wait_min_per_session", "min", "the same over completed sessions"},
      {"idle_km_per_served", "km", "idle_km / served"},
      {"sensor_lies", "", "fields that sensor faults falsified, region by region"},
      {"lies_seen_60", "", "of them, those whose region was flagged within 60 min"},
      {"lies_found_30", "", "those whose field was flagged within 30 min"},
      {"lies_found_60", "", "those whose field was flagged within 60 min"},
      {"lies_found", "", "those whose field was flagged before they ended"},
      {"lies_found_minutes", "min", "that passed until lies were found, in all"},
      {"large_lies", "", "lies that came to be wrong by five or more within 60 min"},
      {"large_lies_found_60", "", "of these, those whose field was flagged within 60 min"},
      {"false_alarms", "", "fields flagged in a region where no sensor lies, or did in the last hour"},
  };
  return all;
}

}  // namespace evbal
