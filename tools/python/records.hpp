#pragma once

#include "common/eigen.hpp"

#include <pybind11/numpy.h>

#include <string>

namespace evbal {

/// A table of N x M numbers as an array of the same shape.
pybind11::array_t<double> table_of(const Eigen::MatrixXd& table);

/// A finished run, as read_run() of Python gives it: its numbers by name, `steps` as arrays, `regions` as arrays of
/// steps x regions. Throws Error{bad_input} as read_run.
pybind11::dict run_of(const std::string& folder);

/// The days of a finished sweep as columns by name, in the order of the sweep. Throws Error{bad_input} as
/// read_finished.
pybind11::dict sweep_of(const std::string& folder);

}  // namespace evbal
