#include "tools/python/records.hpp"

#include "experiments/record/recorded_run.hpp"
#include "experiments/study/design/finished_day.hpp"
#include "experiments/study/store/sweep_file.hpp"
#include "experiments/study/store/sweep_folder.hpp"

#include <pybind11/stl.h>

#include <filesystem>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace evbal {
namespace {

namespace py = pybind11;

/// An array that takes the numbers over, without a copy.
py::array_t<double> array_of(std::vector<double> numbers) {
  auto kept = std::make_unique<std::vector<double>>(std::move(numbers));
  const double* first = kept->data();
  const std::size_t size = kept->size();
  const py::capsule owner(kept.release(), [](void* held) { delete static_cast<std::vector<double>*>(held); });
  return py::array_t<double>(size, first, owner);
}

/// The columns of regions.csv lie step by step.
py::array_t<double> steps_by_regions(const Eigen::MatrixXd& regions_by_steps) {
  py::array_t<double> array({regions_by_steps.cols(), regions_by_steps.rows()});
  std::copy_n(regions_by_steps.data(), regions_by_steps.size(), array.mutable_data());
  return array;
}

/// A column of text or of whole numbers, one for each day.
template <class Value>
py::list column(const std::vector<FinishedDay>& days, Value FinishedDay::*member) {
  py::list values;
  for (const FinishedDay& day : days) {
    values.append(day.*member);
  }
  return values;
}

void add_totals(const std::vector<FinishedDay>& days, py::dict& columns) {
  for (const std::string& metric : finished_metrics()) {
    std::vector<double> values;
    values.reserve(days.size());
    for (const FinishedDay& day : days) {
      values.push_back(day.totals.at(metric));
    }
    columns[metric.c_str()] = array_of(std::move(values));
  }
}

/// A variant that does not set a key has nothing there.
void add_settings(const std::vector<FinishedDay>& days, py::dict& columns) {
  std::set<std::string> keys;
  for (const FinishedDay& day : days) {
    for (const auto& [key, value] : day.settings) {
      keys.insert(key);
    }
  }
  for (const std::string& key : keys) {
    py::list values;
    for (const FinishedDay& day : days) {
      const auto value = day.settings.find(key);
      values.append(value == day.settings.end() ? std::string() : value->second);
    }
    columns[key.c_str()] = values;
  }
}

}  // namespace

py::array_t<double> table_of(const Eigen::MatrixXd& table) {
  py::array_t<double> array({table.rows(), table.cols()});
  auto cells = array.mutable_unchecked<2>();
  for (Eigen::Index i = 0; i < table.rows(); ++i) {
    for (Eigen::Index j = 0; j < table.cols(); ++j) {
      cells(i, j) = table(i, j);
    }
  }
  return array;
}

py::dict run_of(const std::string& folder) {
  RecordedRun run = read_run(folder);
  py::dict read;
  read["scenario"] = run.scenario;
  read["day"] = run.date;
  read["seed"] = run.seed;
  read["controller"] = run.controller;
  read["digest"] = run.digest;
  read["fallbacks"] = run.fallbacks;
  read["step_minutes"] = run.step_minutes;
  read["totals"] = run.totals;
  py::dict steps;
  for (auto& [name, values] : run.steps) {
    steps[name.c_str()] = array_of(std::move(values));
  }
  read["steps"] = steps;
  py::dict regions;
  for (const auto& [name, values] : run.by_region) {
    regions[name.c_str()] = steps_by_regions(values);
  }
  read["regions"] = regions;
  return read;
}

py::dict sweep_of(const std::string& folder) {
  const std::vector<FinishedDay> days = read_finished(std::filesystem::path(folder) / sweep_file_name);
  py::dict columns;
  columns["scenario"] = column(days, &FinishedDay::scenario);
  columns["variant"] = column(days, &FinishedDay::variant);
  columns["controller"] = column(days, &FinishedDay::controller);
  columns["faults"] = column(days, &FinishedDay::faults);
  columns["day"] = column(days, &FinishedDay::day);
  columns["seed"] = column(days, &FinishedDay::seed);
  add_settings(days, columns);
  add_totals(days, columns);
  return columns;
}

}  // namespace evbal
