#include "experiments/study/statistics/ranks.hpp"

#include "common/contract.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace evbal {

std::vector<double> centred_ranks(const std::vector<double>& values) {
  std::vector<double> ranks;
  ranks.reserve(values.size());
  for (const double value : values) {
    const auto below = std::count_if(values.begin(), values.end(), [value](double other) { return other < value; });
    const auto above = std::count_if(values.begin(), values.end(), [value](double other) { return other > value; });
    ranks.push_back(static_cast<double>(below - above));
  }
  return ranks;
}

namespace {

double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

}  // namespace

double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
  EVBAL_EXPECT(x.size() == y.size(), "pairs");
  const std::vector<double> a = centred_ranks(x);
  const std::vector<double> b = centred_ranks(y);
  const double sizes = product(a, a) * product(b, b);
  return sizes == 0.0 ? 0.0 : product(a, b) / std::sqrt(sizes);
}

}  // namespace evbal
