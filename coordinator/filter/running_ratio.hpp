#pragma once

namespace evbal {

/// How many of what is counted there are for one of what they are counted against, by those so far, the latest most: a
/// share that rises in the evening, or a rate that is another today than usual.
class RunningRatio {
 public:
  /// Adds the counts between two plans; those before are worth `kept` of themselves.
  void add(double against, double counted, double kept) {
    against_ = kept * against_ + against;
    counted_ = kept * counted_ + counted;
  }

  /// The ratio, if the `usual` one was found with so many of what is counted against, and that is counted as well.
  double ratio(double usual, double weight) const { return (counted_ + usual * weight) / (against_ + weight); }

 private:
  double against_ = 0.0;
  double counted_ = 0.0;
};

}  // namespace evbal
