#pragma once

#include "common/eigen.hpp"
#include "common/error.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace evbal {

/// Parses a JSON file; repeated keys are refused. Throws Error{bad_input}.
nlohmann::json parse_json(const std::filesystem::path& file);

/// The same of a text; `name` stands for the file in messages.
nlohmann::json parse_json(const std::string& text, const std::string& name);

/// Strict view of a JSON object: what is asked for must be there and fit, and finish() refuses what nobody asked for.
/// Everything that does not fit throws Error{bad_input} as "file: key: what would be right".
class JsonObject {
 public:
  /// `place` says where in the file it stands, for messages.
  JsonObject(const nlohmann::json& value, std::string file, std::string place);

  /// Whether the key is there.
  bool has(const std::string& key) const;
  /// An object.
  JsonObject object(const std::string& key);
  /// A list of objects.
  std::vector<JsonObject> objects(const std::string& key);
  /// A text.
  std::string text(const std::string& key);
  /// A list of texts.
  std::vector<std::string> texts(const std::string& key);
  /// True or false.
  bool boolean(const std::string& key);
  /// A whole number in [low, high].
  int integer(const std::string& key, int low, int high);
  /// A number in [low, high].
  double number(const std::string& key, double low, double high);
  /// A list of numbers in [low, high].
  std::vector<double> numbers(const std::string& key, double low, double high);

  /// A list of `rows` lists of `columns` numbers. In place of a list may stand {"columns": [...], "values": [...]}, the
  /// numbers that are not 0, by ascending column.
  Eigen::MatrixXd matrix(const std::string& key, Eigen::Index rows, Eigen::Index columns, double low, double high);

  /// The same where only the number of rows is known.
  Eigen::MatrixXd matrix(const std::string& key, Eigen::Index rows, double low, double high);

  /// Throws Error{bad_input} if there are keys that nobody asked for.
  void finish() const;
  /// An Error{bad_input} at a key.
  Error error(const std::string& key, const std::string& message) const;

 private:
  const nlohmann::json& require(const std::string& key);
  Eigen::RowVectorXd sparse(Eigen::Index size, double low, double high);
  double number_in(const nlohmann::json& value, const std::string& key, double low, double high) const;

  const nlohmann::json* value_;
  std::string file_;
  std::string place_;
  std::set<std::string> known_;
};

}  // namespace evbal
