#include "tools/evbal/study_line.hpp"

#include "common/digest.hpp"
#include "common/error.hpp"
#include "common/version.hpp"
#include "coordinator/planning/json_reader.hpp"
#include "experiments/study/design/benchmark.hpp"
#include "experiments/study/statistics/comparison.hpp"
#include "tools/evbal/bounded_days.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <set>

namespace evbal {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* study_format = "evbal-study-1";
constexpr double any_number = 1e12;

std::vector<FinishedDay> days_of(const StudiedPart& part, const Sweep& sweep) {
  if (part.days.size() != sweep.days.size()) {
    throw bad_input("part `" + part.name + "`: " + std::to_string(part.days.size()) + " days, the benchmark has " +
                    std::to_string(sweep.days.size()));
  }
  std::vector<FinishedDay> days;
  for (std::size_t i = 0; i < part.days.size(); ++i) {
    const SweptDay& day = sweep.days[i];
    days.push_back({.scenario = day.scenario,
                    .variant = day.variant,
                    .controller = day.controller,
                    .faults = day.faults,
                    .day = day.day,
                    .seed = day.seed,
                    .settings = day.settings,
                    .totals = {{"idle_km", part.days[i].idle_km}, {"lost", part.days[i].lost}}});
  }
  return days;
}

/// The bounds of days without faults, as days of the schedule that has none.
void add_bounds(const StudiedPart& part, const Sweep& sweep, std::vector<FinishedDay>& days) {
  for (const StudiedBound& bound : part.bounds) {
    for (std::size_t i = 0; i < sweep.days.size(); ++i) {
      const SweptDay& day = sweep.days[i];
      if (day.day == bound.day && day.seed == bound.seed && scenario_of(day).schedule.faults.empty()) {
        const auto points = bound_points(bound.corners, days[i]);
        days.insert(days.end(), points.begin(), points.end());
        break;
      }
    }
  }
}

StudyResult with_interval(StudyResult result, const Interval& interval) {
  result.difference = interval.mean;
  result.low = interval.low;
  result.high = interval.high;
  result.verdict = result.days == 0    ? "not comparable"
                   : result.high < 0.0 ? "fewer"
                   : result.low > 0.0  ? "more"
                                       : "not shown";
  return result;
}

std::vector<StudyResult> results_of_part(const StudiedPart& part, const std::vector<FinishedDay>& days) {
  const Question question{.reference = reference_variant, .at = "idle_km", .bound = bound_variant};
  std::vector<StudyResult> results;
  for (const Compared& row : compare(days, question)) {
    if (row.whole) {
      results.push_back(with_interval(
          {.part = part.name, .faults = row.faults, .verdict = {}, .days = row.days, .way = row.way}, row.difference));
    }
  }
  return results;
}

/// A number as it stands in a line: the last digits of a sum over days are of no interest, and those of a machine.
Json shown_number(double value) {
  return std::isfinite(value) ? Json(std::round(value * 1e4) / 1e4) : Json();
}

Json shown_number(const std::optional<double>& value) {
  return value ? shown_number(*value) : Json();
}

Json results_json(const std::vector<StudyResult>& results) {
  Json list = Json::array();
  for (const StudyResult& result : results) {
    list.push_back({{"part", result.part},
                    {"faults", result.faults},
                    {"verdict", result.verdict},
                    {"days", result.days},
                    {"difference", shown_number(result.difference)},
                    {"low", shown_number(result.low)},
                    {"high", shown_number(result.high)},
                    {"way", shown_number(result.way)}});
  }
  return {{"verdict", verdict_of(results)}, {"way", shown_number(way_of(results))}, {"comparisons", list}};
}

Json part_json(const StudiedPart& part) {
  Json json = {{"name", part.name},     {"settings", part.settings}, {"idle_km", Json::array()},
               {"lost", Json::array()}, {"digests", Json::array()},  {"bounds", Json::array()}};
  for (const StudiedDay& day : part.days) {
    json["idle_km"].push_back(day.idle_km);
    json["lost"].push_back(day.lost);
    json["digests"].push_back(day.digest);
  }
  for (const StudiedBound& bound : part.bounds) {
    Json corners = {
        {"day", bound.day}, {"seed", std::to_string(bound.seed)}, {"km", Json::array()}, {"lost", Json::array()}};
    for (const Driving& corner : bound.corners) {
      corners["km"].push_back(corner.km);
      corners["lost"].push_back(corner.lost);
    }
    json["bounds"].push_back(corners);
  }
  return json;
}

StudiedBound read_bound_of(JsonObject& object) {
  StudiedBound bound{.day = object.text("day"), .seed = 0, .corners = {}};
  const std::string seed = object.text("seed");
  bound.seed = YamlValue::parse_option(seed, "seed").seed();
  const std::vector<double> km = object.numbers("km", 0.0, any_number);
  const std::vector<double> lost = object.numbers("lost", 0.0, any_number);
  if (km.size() != lost.size() || km.empty()) {
    throw object.error("lost", "as many as `km` are expected, and one at least");
  }
  for (std::size_t i = 0; i < km.size(); ++i) {
    bound.corners.push_back({km[i], lost[i]});
  }
  object.finish();
  return bound;
}

StudiedPart read_part_of(JsonObject& object) {
  StudiedPart part{.name = object.text("name"), .settings = object.text("settings"), .days = {}, .bounds = {}};
  const std::vector<double> km = object.numbers("idle_km", 0.0, any_number);
  const std::vector<double> lost = object.numbers("lost", 0.0, any_number);
  const std::vector<std::string> digests = object.texts("digests");
  if (km.size() != lost.size() || km.size() != digests.size()) {
    throw object.error("digests", "as many as `idle_km` and `lost` are expected");
  }
  for (std::size_t i = 0; i < km.size(); ++i) {
    part.days.push_back({km[i], lost[i], digests[i]});
  }
  for (JsonObject& bound : object.objects("bounds")) {
    part.bounds.push_back(read_bound_of(bound));
  }
  object.finish();
  return part;
}

}  // namespace

std::vector<StudyResult> results_of(const StudyLine& line, const std::vector<Sweep>& sweeps) {
  std::vector<StudyResult> results;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const StudiedPart& part = line.parts[i];
    std::vector<FinishedDay> days = days_of(part, sweeps[i]);
    add_bounds(part, sweeps[i], days);
    const std::vector<StudyResult> of_part = results_of_part(part, days);
    results.insert(results.end(), of_part.begin(), of_part.end());
  }
  return results;
}

std::string verdict_of(const std::vector<StudyResult>& results) {
  std::set<std::string> said;
  for (const StudyResult& result : results) {
    said.insert(result.verdict);
  }
  const bool fewer = said.contains("fewer");
  const bool more = said.contains("more");
  return fewer && more ? "mixed" : fewer ? "fewer" : more ? "more" : "not shown";
}

std::optional<double> way_of(const std::vector<StudyResult>& results) {
  double sum = 0.0;
  int count = 0;
  for (const StudyResult& result : results) {
    sum += result.way.value_or(0.0);
    count += result.way ? 1 : 0;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::string results_text(const std::vector<StudyResult>& results) {
  return results_json(results).dump();
}

std::string line_text(const StudyLine& line, const std::vector<StudyResult>& results, double processor_seconds) {
  Json content = {{"format", study_format},           {"file", line.file},
                  {"benchmark", line.benchmark},      {"benchmark_digest", line.benchmark_digest},
                  {"version", line.version},          {"controller", line.controller},
                  {"coordinator", line.coordinator},  {"coordinator_digest", line.coordinator_digest},
                  {"results", results_json(results)}, {"parts", Json::array()}};
  for (const StudiedPart& part : line.parts) {
    content["parts"].push_back(part_json(part));
  }
  const Json whole = {{"content", content},
                      {"digest", text_digest(content.dump())},
                      {"unsigned", {{"processor_seconds", processor_seconds}, {"program", this_program()}}}};
  return whole.dump() + "\n";
}

ClaimedLine read_line(const std::string& text, const std::string& place) {
  Json whole;
  try {
    whole = Json::parse(text);
  } catch (const Json::exception&) {
    throw bad_input(place + ": is no line of `evbal study`");
  }
  if (!whole.is_object() || !whole.contains("content") || !whole.contains("digest")) {
    throw bad_input(place + ": is no line of `evbal study`: `content` and `digest` are expected");
  }
  if (whole["digest"] != text_digest(whole["content"].dump())) {
    throw Error(ExitStatus::expectation_failed, place + ": the digest does not fit: the line was changed");
  }
  const nlohmann::json plain = nlohmann::json::parse(whole["content"].dump());
  JsonObject content(plain, place, "content");
  if (const std::string format = content.text("format"); format != study_format) {
    throw content.error("format", std::string("`") + study_format + "` is expected, not `" + format + "`");
  }
  ClaimedLine claimed{{.file = content.text("file"),
                       .benchmark = content.text("benchmark"),
                       .benchmark_digest = content.text("benchmark_digest"),
                       .version = content.text("version"),
                       .controller = content.text("controller"),
                       .coordinator = content.texts("coordinator"),
                       .coordinator_digest = content.text("coordinator_digest"),
                       .parts = {}},
                      whole["content"].value("results", Json()).dump()};
  for (JsonObject& part : content.objects("parts")) {
    claimed.line.parts.push_back(read_part_of(part));
  }
  return claimed;
}

}  // namespace evbal
