#pragma once

#include "tools/fit/fit_city.hpp"

namespace evbal {

/// Prints how good a fit is (docs/fit.md): forecast errors against two rivals, in all and by region, with the orders
/// chosen; thresholds and their held-out coverage; the distribution of demand that `turnover` plans for.
void print_fit(const City& city, const CityFit& fit);

}  // namespace evbal
