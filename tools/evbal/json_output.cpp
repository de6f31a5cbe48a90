#include "tools/evbal/json_output.hpp"

#include "common/files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>

namespace evbal {
namespace {

using Json = nlohmann::ordered_json;

std::string document(const Json& json) {
  return json.dump(2) + "\n";
}

Json interval_json(const Interval& interval) {
  return {{"mean", interval.mean}, {"low", interval.low}, {"high", interval.high}};
}

/// A word of YAML as what it is: a number, true or false, else a text.
Json scalar_json(const std::string& text) {
  if (text == "true" || text == "false") {
    return text == "true";
  }
  const char* end = text.data() + text.size();
  std::uint64_t whole = 0;  // seeds do not fit into a double
  if (const auto read = std::from_chars(text.data(), end, whole); read.ec == std::errc{} && read.ptr == end) {
    return whole;
  }
  double number = 0.0;
  const auto read = std::from_chars(text.data(), end, number);
  return read.ec == std::errc{} && read.ptr == end ? Json(number) : Json(text);
}

Json yaml_json(const YamlValue& value) {
  if (value.is_scalar()) {
    return scalar_json(value.text());
  }
  if (value.is_list()) {
    Json list = Json::array();
    for (const auto& item : value.items()) {
      list.push_back(yaml_json(item));
    }
    return list;
  }
  YamlMap map(value);
  Json json = Json::object();
  for (const auto& key : map.keys()) {
    json[key] = yaml_json(map.require(key));
  }
  return json;
}

Json or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json compared_row_json(const Compared& row, const Question& question, const std::vector<PrimaryAnswer>& primaries) {
  Json json = {{"scenario", row.scenario},
               {"faults", row.faults},
               {"variant", row.variant},
               {"settings", row.settings},
               {"metric", question.metric},
               {"reference_variant", question.reference},
               {"at", question.at ? Json(*question.at) : Json()},
               {"whole", row.whole},
               {"days", row.days},
               {"apart", row.apart},
               {"points", row.points},
               {"inside", row.inside}};
  if (row.days > 0) {
    const auto primary = std::find_if(primaries.begin(), primaries.end(),
                                      [&](const PrimaryAnswer& answer) { return answer.is(question, row); });
    json.update({{"from", row.from},
                 {"to", row.to},
                 {"covered", row.covered},
                 {"value", row.value},
                 {"reference", row.reference},
                 {"of_totals", or_null(of_totals(row))},
                 {"relative", row.relative},
                 {"difference", interval_json(row.difference)},
                 {"p", row.p},
                 {"p_holm", primary == primaries.end() ? Json() : Json(primary->p_holm)},
                 {"way", or_null(row.way)}});
  }
  return json;
}

}  // namespace

std::string runs_json(const std::vector<RunResult>& runs, const std::filesystem::path& report) {
  Json json = {{"report", report.string()}, {"runs", Json::array()}};
  for (const auto& run : runs) {
    Json summary = {{"folder", run.folder.string()}};
    summary.update(Json::parse(text_of_file(run.folder / "summary.json")));
    json["runs"].push_back(std::move(summary));
  }
  return document(json);
}

std::string draws_json(const DrawsResult& draws, const std::filesystem::path& folder) {
  Json json = {{"folder", folder.string()}, {"controllers", Json::array()}};
  for (const auto& drawn : draws.controllers) {
    Json metrics;
    for (const auto& metric : drawn.metrics) {
      for (const auto& [name, value] : named(metric.distribution)) {
        metrics[metric.name][name] = value;
      }
      metrics[metric.name]["without"] = metric.without;
    }
    json["controllers"].push_back({{"controller", drawn.controller},
                                   {"draws", drawn.draws},
                                   {"metrics", std::move(metrics)},
                                   {"worst",
                                    {{"draw", drawn.worst},
                                     {"metric", drawn.worst_metric},
                                     {"value", drawn.worst_value},
                                     {"scenario", drawn.worst_file.string()}}}});
  }
  return document(json);
}

std::string compared_json(const std::vector<AnsweredQuestion>& answers, const std::vector<PrimaryAnswer>& primaries) {
  Json json = Json::array();
  for (const auto& [question, rows] : answers) {
    for (const Compared& row : rows) {
      json.push_back(compared_row_json(row, question, primaries));
    }
  }
  return document(json);
}

std::string comparisons_json(const std::vector<Comparison>& comparisons) {
  Json json = Json::array();
  for (const auto& comparison : comparisons) {
    json.push_back({{"what", comparison.what},
                    {"cases", comparison.cases},
                    {"largest", comparison.largest},
                    {"allowed", comparison.allowed},
                    {"holds", comparison.holds()},
                    {"where", comparison.where}});
  }
  return document(json);
}

std::string listing_json(const Listing& listing) {
  Json json = Json::array();
  for (const auto& row : listing.rows) {
    Json one;
    for (std::size_t column = 0; column < row.size(); ++column) {
      std::visit([&](const auto& cell) { one[listing.columns[column]] = cell; }, row[column]);
    }
    json.push_back(std::move(one));
  }
  return document(json);
}

std::string sourced_json(const SourcedScenario& scenario) {
  Json sources;
  for (const auto& [path, source] : scenario.sources) {
    sources[path] = source;
  }
  return document({{"scenario", yaml_json(scenario.resolved)}, {"sources", std::move(sources)}});
}

std::string findings_json(const std::vector<Finding>& findings) {
  Json json = Json::array();
  for (const auto& finding : findings) {
    json.push_back({{"what", finding.what},
                    {"well", finding.well ? Json(*finding.well) : Json()},
                    {"cure", finding.well.value_or(true) ? Json() : Json(finding.cure)}});
  }
  return document(json);
}

}  // namespace evbal
