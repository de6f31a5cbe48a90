#pragma once

#include <optional>

namespace evbal {

/// Cars that a region has too many of by its report, as a count of the cars and passengers between two reports tells:
/// what arrived, was sent off and was picked up (docs/model.md). Both are whole numbers if no sensor lies.
struct Excess {
  int cars = 0;                ///< vacant and low-battery ones
  int low = 0;                 ///< low-battery ones
  double expected = 0.0;       ///< of `cars`: those who came with passengers picked up since the last report, and
                               ///< passengers who gave up
  double expected_low = 0.0;   ///< of `low`: those who came out low
  double variance = 0.0;       ///< of `cars`
  double variance_low = 0.0;   ///< of `low`
  bool contradiction = false;  ///< whether passengers are said to wait beside vacant cars
  double passengers = 0.0;     ///< ln of how much likelier it is that passengers are wrong than cars, by the forecast
  int slack = 0;               ///< how many more of `cars` nobody could foresee: those who waited may have given up
};

/// A cumulative sum of how surprising the reports of a region are (CUSUM). What has come together since it was last
/// zero says by how much the report is off. Low-battery cars have a sum of their own beside: no passenger is in it.
class Evidence {
 public:
  /// Adds a report.
  void add(const Excess& excess);

  /// Adds cars that the city came to have too many of meanwhile.
  void add_city(double cars) { city_ += sum_ > 0.0 || low_sum_ > 0.0 ? cars : 0.0; }

  /// Whether it is enough: on training days without faults this happens less than once in ten days of a city.
  bool enough() const { return sum_ >= threshold; }

  /// Whether it is enough to accuse demand, or passengers who wait. Cars too many may also have come from trips that
  /// are more than they usually are; nothing explains cars too few.
  bool enough_against_passengers() const { return sum_ >= (cars_ > 0.0 ? threshold_of_trips : threshold); }

  /// Whether it is enough to accuse low-battery cars, whatever else lies.
  bool enough_against_low() const { return low_sum_ >= threshold; }

  /// Whether it is enough where cars that the city has too many, or too few, show that some number lies.
  bool enough_to_explain() const { return sum_ >= threshold_to_explain; }

  /// Starts from zero.
  void clear() { *this = {}; }

  /// Cars too many since the sum was last zero, less those expected.
  double cars() const { return cars_; }
  /// Likewise of low-battery ones.
  double low() const { return low_; }
  /// Likewise since the sum of low-battery ones was last zero.
  double low_alone() const { return low_alone_; }
  /// Cars that the city came to have too many of since both sums were last zero.
  double city() const { return city_; }
  /// How much likelier it is that passengers are wrong than cars, by the forecast, as a logarithm.
  double passengers() const { return passengers_; }
  /// Variance of cars().
  double variance() const { return variance_; }

 private:
  static constexpr double threshold = 13.0;
  static constexpr double of_a_contradiction = 4.0;  ///< only a car that cannot reach where they want to go explains it
  static constexpr double threshold_of_trips = 24.0;
  static constexpr double threshold_to_explain = 3.5;
  static constexpr double usual =
      2.0;  ///< surprise of a report that is not counted; that of a true one is 1 on average

  double sum_ = 0.0;
  double cars_ = 0.0;
  double low_ = 0.0;
  double variance_ = 0.0;
  double passengers_ = 0.0;
  double low_sum_ = 0.0;
  double low_alone_ = 0.0;
  double city_ = 0.0;
};

}  // namespace evbal
