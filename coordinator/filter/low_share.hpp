#pragma once

namespace evbal {

/// Of the cars that come free, the share that comes out low, by those counted so far, the latest most: it rises in the
/// evening, when batteries are empty.
class LowShare {
 public:
  /// Adds the cars that came free between two plans, `low` of which came out low; those before are worth `kept` of
  /// themselves.
  void add(double free, double low, double kept) {
    free_ = kept * free_ + free;
    low_ = kept * low_ + low;
  }

  /// The share, if so many cars of which the share is `usual` are counted as well.
  double share(double usual, double cars) const { return (low_ + usual * cars) / (free_ + cars); }

 private:
  double free_ = 0.0;
  double low_ = 0.0;
};

}  // namespace evbal
