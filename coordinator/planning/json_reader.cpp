#include "coordinator/planning/json_reader.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

namespace evbal {
namespace {

using nlohmann::json;

std::string shown(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::string range(double low, double high) {
  return "[" + shown(low) + ", " + shown(high) + "]";
}

/// `in`: a stream or a text.
template <class In>
json parse(In&& in, const std::string& name) {
  std::vector<std::set<std::string>> open_objects;
  const auto refuse_repeats = [&](int, json::parse_event_t event, json& parsed) {
    if (event == json::parse_event_t::object_start) {
      open_objects.emplace_back();
    } else if (event == json::parse_event_t::object_end) {
      open_objects.pop_back();
    } else if (event == json::parse_event_t::key && !open_objects.back().insert(parsed.get<std::string>()).second) {
      throw bad_input(name, 0, "key `" + parsed.get<std::string>() + "` is given twice");
    }
    return true;
  };
  try {
    return json::parse(std::forward<In>(in), refuse_repeats);
  } catch (const json::exception& e) {
    throw bad_input(name, 0, std::string("not valid JSON: ") + e.what());
  }
}

}  // namespace

json parse_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) {
    throw bad_input(file.string(), 0, "cannot be read; give an existing JSON file");
  }
  return parse(in, file.string());
}

json parse_json(const std::string& text, const std::string& name) {
  return parse(text, name);
}

JsonObject::JsonObject(const json& value, std::string file, std::string place)
    : value_(&value), file_(std::move(file)), place_(std::move(place)) {
  if (!value.is_object()) {
    throw bad_input(file_, 0, (place_.empty() ? "" : place_ + ": ") + "an object is expected");
  }
}

Error JsonObject::error(const std::string& key, const std::string& message) const {
  return bad_input(file_, 0, (place_.empty() ? "" : place_ + ".") + key + ": " + message);
}

const json& JsonObject::require(const std::string& key) {
  known_.insert(key);
  const auto found = value_->find(key);
  if (found == value_->end()) {
    throw error(key, "is missing");
  }
  return *found;
}

double JsonObject::number_in(const json& value, const std::string& key, double low, double high) const {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(number >= low && number <= high)) {
    throw error(key, "a number in " + range(low, high) + " is expected, not " + value.dump().substr(0, 40));
  }
  return number;
}

bool JsonObject::has(const std::string& key) const {
  return value_->contains(key);
}

JsonObject JsonObject::object(const std::string& key) {
  return {require(key), file_, (place_.empty() ? "" : place_ + ".") + key};
}

std::vector<JsonObject> JsonObject::objects(const std::string& key) {
  const json& list = require(key);
  if (!list.is_array()) {
    throw error(key, "a list is expected");
  }
  std::vector<JsonObject> out;
  for (const json& item : list) {
    out.emplace_back(item, file_, (place_.empty() ? "" : place_ + ".") + key + "[" + std::to_string(out.size()) + "]");
  }
  return out;
}

std::string JsonObject::text(const std::string& key) {
  const json& value = require(key);
  if (!value.is_string()) {
    throw error(key, "a text is expected");
  }
  return value.get<std::string>();
}

std::vector<std::string> JsonObject::texts(const std::string& key) {
  const json& list = require(key);
  std::vector<std::string> out;
  for (const json& item : list.is_array() ? list : json::array({nullptr})) {
    if (!item.is_string()) {
      throw error(key, "a list of texts is expected");
    }
    out.push_back(item.get<std::string>());
  }
  return out;
}

bool JsonObject::boolean(const std::string& key) {
  const json& value = require(key);
  if (!value.is_boolean()) {
    throw error(key, "true or false is expected");
  }
  return value.get<bool>();
}

int JsonObject::integer(const std::string& key, int low, int high) {
  const double value = number(key, low, high);
  if (value != std::floor(value)) {
    throw error(key, "a whole number is expected");
  }
  return static_cast<int>(value);
}

double JsonObject::number(const std::string& key, double low, double high) {
  return number_in(require(key), key, low, high);
}

std::vector<double> JsonObject::numbers(const std::string& key, double low, double high) {
  const json& list = require(key);
  if (!list.is_array()) {
    throw error(key, "a list of numbers is expected");
  }
  std::vector<double> out;
  for (const json& item : list) {
    out.push_back(number_in(item, key, low, high));
  }
  return out;
}

Eigen::RowVectorXd JsonObject::sparse(Eigen::Index size, double low, double high) {
  const std::vector<double> columns = numbers("columns", 0.0, static_cast<double>(size) - 1.0);
  const std::vector<double> values = numbers("values", low, high);
  finish();
  if (columns.size() != values.size()) {
    throw error("columns", "as many numbers are expected as of `values`");
  }
  Eigen::RowVectorXd out = Eigen::RowVectorXd::Zero(size);
  double last = -1.0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] != std::floor(columns[i]) || columns[i] <= last) {
      throw error("columns", "whole numbers are expected, ascending");
    }
    last = columns[i];
    out(static_cast<Eigen::Index>(last)) = values[i];
  }
  return out;
}

Eigen::MatrixXd JsonObject::matrix(const std::string& key, Eigen::Index rows, Eigen::Index columns, double low,
                                   double high) {
  const json& list = require(key);
  const std::string shape = std::to_string(rows) + " lists of " + std::to_string(columns) + " numbers are expected";
  if (!list.is_array() || list.size() != static_cast<std::size_t>(rows)) {
    throw error(key, shape);
  }
  Eigen::MatrixXd out(rows, columns);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const json& line = list[static_cast<std::size_t>(row)];
    const std::string line_key = key + "[" + std::to_string(row) + "]";
    if (line.is_object()) {
      out.row(row) =
          JsonObject(line, file_, (place_.empty() ? "" : place_ + ".") + line_key).sparse(columns, low, high);
      continue;
    }
    if (!line.is_array() || line.size() != static_cast<std::size_t>(columns)) {
      throw error(line_key, shape);
    }
    for (Eigen::Index column = 0; column < columns; ++column) {
      out(row, column) = number_in(line[static_cast<std::size_t>(column)], key, low, high);
    }
  }
  return out;
}

Eigen::MatrixXd JsonObject::matrix(const std::string& key, Eigen::Index rows, double low, double high) {
  const json& list = require(key);
  const bool has_rows = list.is_array() && !list.empty() && list.front().is_array();
  return matrix(key, rows, has_rows ? static_cast<Eigen::Index>(list.front().size()) : 0, low, high);
}

void JsonObject::finish() const {
  for (const auto& [key, value] : value_->items()) {
    if (!known_.contains(key)) {
      throw error(key, "is no key here");
    }
  }
}

}  // namespace evbal
