#include "coordinator/convex/tangents.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace evbal {

Tangents::Tangents(ConvexFunctionPtr function, double lower, double upper)
    : function_(std::move(function)), lower_(lower), upper_(upper) {
  constexpr int first_tangents = 18;  // the last one touches about a thousand vehicles above `lower`
  double offset = 0.0;
  for (int i = 0; i < first_tangents; ++i) {
    add(std::min(lower + offset, upper));
    offset = 1.5 * offset + 0.5;
  }
}

void Tangents::add(double at) {
  constexpr double same = 1e-9;
  EVBAL_EXPECT(at >= lower_ && at <= upper_, "a point between the ends");
  const auto next = std::ranges::lower_bound(tangents_, at, {}, &Tangent::at);
  if ((next != tangents_.end() && next->at - at < same) || (next != tangents_.begin() && at - (next - 1)->at < same)) {
    return;
  }
  const auto expansion = function_->around(at);
  tangents_.insert(next, {at, expansion.value, expansion.slope});
}

void Tangents::add_around(double slope) {
  constexpr int parts = 8;  // of each gap
  if (slope == -std::numeric_limits<double>::infinity()) {
    return;
  }
  const auto gaps = std::ssize(tangents_) - 1;
  const auto enclosing = std::ranges::lower_bound(tangents_, slope, {}, &Tangent::slope) - tangents_.begin() - 1;
  std::vector<double> points;
  for (auto gap = std::max<std::ptrdiff_t>(0, enclosing - 1); gap < std::min(gaps, enclosing + 2); ++gap) {
    const double start = tangents_[static_cast<std::size_t>(gap)].at;
    const double end = tangents_[static_cast<std::size_t>(gap) + 1].at;
    for (int part = 1; part < parts; ++part) {
      points.push_back(start + (end - start) * part / parts);
    }
  }
  for (const double at : points) {
    add(at);
  }
}

double Tangents::value_at_lower() const {
  const auto& first = tangents_.front();
  return first.value - first.slope * (first.at - lower_);
}

// Two tangents meet where  value_1 + slope_1 (x - at_1) = value_2 + slope_2 (x - at_2).
std::vector<Tangents::Piece> Tangents::pieces() const {
  std::vector<Piece> pieces;
  double start = lower_;
  for (std::size_t m = 0; m + 1 < tangents_.size(); ++m) {
    const auto& here = tangents_[m];
    const auto& next = tangents_[m + 1];
    double end = next.at;  // of tangents that are one line
    if (here.slope < next.slope) {
      const double gap = next.at - here.at;
      const double rise = next.value - here.value - here.slope * gap;
      end = next.at - std::clamp(rise / (next.slope - here.slope), 0.0, gap);
    }
    pieces.push_back({here.at, here.slope, end - start});
    start = end;
  }
  pieces.push_back({tangents_.back().at, tangents_.back().slope, std::numeric_limits<double>::infinity()});
  return pieces;
}

}  // namespace evbal
