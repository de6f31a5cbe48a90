#include "common/error.hpp"
#include "experiments/study/statistics/primaries.hpp"
#include "tests/study/whole_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace evbal {
namespace {

const PageNames names = {{"ref", "new"}, {"toy", "city"}, {"calm"}};

Page read(const std::string& sections) {
  return read_page(YamlValue::parse("title: Who wins\ntext: On small data.\nsections:\n" + sections, "sweep.yaml"),
                   names);
}

FinishedDay day_of(const std::string& variant, const std::string& price, const std::string& day, double km,
                   double lost) {
  FinishedDay finished{.scenario = "toy", .variant = variant, .controller = "ratio", .faults = "calm", .day = day};
  finished.seed = 1;
  finished.settings = {{"price", price}};
  finished.totals = {{"idle_km", km}, {"lost", lost}, {"served", 500.0 - lost}};
  return finished;
}

/// Three days; the other loses a half at the same km, and a bit less or more than that.
std::vector<FinishedDay> three_days() {
  std::vector<FinishedDay> days;
  for (const auto& [day, lost] : {std::pair("d1", 50.0), std::pair("d2", 51.0), std::pair("d3", 49.0)}) {
    days.push_back(day_of("ref", "1", day, 10, 120));
    days.push_back(day_of("ref", "2", day, 20, 80));
    days.push_back(day_of("new", "1", day, 15, lost));
  }
  return days;
}

std::string page(const std::string& sections) {
  return whole_page(read(sections), {three_days()}, "evbal sweep a.yaml");
}

void expect_in(const std::string& part, const std::string& text) {
  EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
}

TEST(Page, SaysWhatWasRunAndHowToRunItAgain) {
  const std::string text = page("- {title: One, text: Words.}\n");
  EXPECT_TRUE(text.starts_with("# Who wins\n\nOn small data.\n\nMade by\n\n    evbal sweep a.yaml\n"));
  expect_in("from 9 simulated days. Scenarios: toy. Days: d1, d2, d3. Seeds: 1. Faults: calm.\n", text);
  expect_in("\n## One\n\nWords.\n", text);
}

TEST(Page, ComparesAndSaysWhetherAimsAreReached) {
  const std::string text = page(
      "- title: One\n"
      "  compare: {variants: [new], against: [ref], metrics: [lost, idle_km], at: idle_km, aims: {lost: -49}}\n");
  expect_in(
      "| scenario | faults | variant | against | metric | idle_km | value | reference | of totals | difference | 95 % "
      "by "
      "t | days | apart | inside | covered |",
      text);
  expect_in(
      "| toy | calm | new | ref | lost | 15.0 | 150 | 300 | -50.0 % | -49.8 % | -52.2 .. -47.2 | 3 | 0 | 3 of 3 |  |",
      text);
  expect_in(
      "- Aim -49 %, `new` against `ref`, lost, toy calm: reached in the mean, not with the whole interval "
      "(-49.8 %, -52.2 .. -47.2).\n",
      text);
}

/// The second section asks of metrics and aims of its own, and names its row.
const std::string with_primaries =
    "- {title: One, compare: {variants: [new], against: [ref], metrics: [lost], at: idle_km, primary: {scenario: "
    "toy}}}\n"
    "- title: Two\n"
    "  compare: {variants: [new], against: [ref], metrics: [served, lost, idle_km], at: idle_km,\n"
    "            primary: {scenario: toy, metric: served}}\n"
    "- title: Three\n"
    "  compare: {variants: [new], against: [ref], metrics: [lost, served], at: idle_km}\n";

TEST(Page, AdjustsForItsPrimaryEndpointsAndForNothingElse) {
  const std::string text = page(with_primaries);
  expect_in(
      "| section | scenario | faults | variant | against | metric | difference | 95 % by t | p | p, Holm | days |",
      text);
  // Two endpoints and six rows: the smaller p, of `served`, counts twice, this one once.
  expect_in("| One | toy | calm | new | ref | lost | -49.8 % | -52.2 .. -47.2 | 0.0003 | 0.0003 | 3 |", text);
  expect_in(
      "Lower, with p below 0.05 after Holm's adjustment: `new` against `ref`, lost, toy calm. Higher: `new` against "
      "`ref`, served, toy calm. No difference is shown: none.\n",
      text);
  expect_in("| 3 | 0 | 3 of 3 |  | primary |\n", text);
  expect_in("Every other row of a comparison is exploratory", text);
  const std::string after = text.substr(text.find("\n## One"));
  EXPECT_EQ(after.find("Holm"), std::string::npos) << after;
}

TEST(Page, GivesOneQuestionOnePValueWhereverItIsShown) {
  const Page asked = read(with_primaries);
  const auto answers = primary_answers(asked, with_objective(asked, three_days()));
  ASSERT_EQ(answers.size(), 2U);
  const auto [smaller, larger] =
      std::minmax(answers[0], answers[1], [](const auto& a, const auto& b) { return a.row.p < b.row.p; });
  EXPECT_DOUBLE_EQ(smaller.p_holm, 2.0 * smaller.row.p);
  EXPECT_DOUBLE_EQ(larger.p_holm, std::max(smaller.p_holm, larger.row.p));
  const Question question{.metric = "lost", .reference = "ref", .at = "idle_km"};
  const auto rows = compare(three_days(), question);
  EXPECT_TRUE(answers[0].is(question, rows.at(0)));
  EXPECT_FALSE(answers[1].is(question, rows.at(0)));
  EXPECT_FALSE(answers[0].is({.metric = "lost", .reference = "ref", .at = "lost"}, rows.at(0)));
}

TEST(Page, CountsAPrimaryEndpointWithoutAnAnswerInItsFamily) {
  const std::string text = page(
      "- {title: A, compare: {variants: [new], against: [ref], metrics: [lost], at: idle_km, primary: {scenario: "
      "toy}}}\n"
      "- {title: B, compare: {variants: [new], against: [ref], metrics: [lost], at: idle_km, primary: {scenario: "
      "city}}}\n");
  expect_in("| 0.0003 | 0.0006 | 3 |", text);
  expect_in("| B | city | calm | new | ref | lost |  |  |  |  | 0 |", text);
}

TEST(Page, SaysThatWithoutPrimaryEndpointsAllIsExploratory) {
  expect_in("The file names no primary endpoint. Every row of a comparison is exploratory",
            page("- {title: One, compare: {variants: [new], against: [ref], metrics: [lost], at: idle_km}}\n"));
  EXPECT_EQ(page("- {title: A, means: {variants: [new], metrics: [lost]}}\n").find("exploratory"), std::string::npos);
}

TEST(Page, ComparesFronts) {
  std::vector<FinishedDay> days = three_days();
  for (const auto& [day, lost] : {std::pair("d1", 50.0), std::pair("d2", 51.0), std::pair("d3", 49.0)}) {
    days.push_back(day_of("new", "2", day, 25, lost - 20.0));
  }
  const std::string text = whole_page(read("- {title: One, fronts: {variants: [new], against: [ref]}}\n"), {days}, "");
  expect_in("| toy | calm | new | ref | lost | 15.0 .. 20.0 | 135 | 270 | -50.0 % | -49.7 % |",
            text);  // 45.5 of 90.5, from 15 to 20 km
  expect_in("| 3 | 0 | 3 of 6 | 50 % |", text);
}

TEST(Page, SaysWhenAnAimIsMissed) {
  std::vector<FinishedDay> days = three_days();
  days.back().totals["lost"] = 400.0;
  const Page asked = read(
      "- {title: One, compare: {variants: [new], against: [ref], metrics: [lost], at: idle_km,"
      " aims: {lost: -49}, primary: {scenario: toy}}}\n");
  const std::string text = whole_page(asked, {days}, "");
  expect_in("Higher: none. No difference is shown: `new` against `ref`, lost, toy calm.\n", text);
  expect_in("missed (", text);
}

TEST(Page, ShowsMeansRanksAndSettings) {
  const std::string text = page(
      "- {title: A, means: {variants: [new], metrics: [lost]}}\n"
      "- {title: B, correlate: {variants: [ref, new], metrics: [idle_km], with: lost}}\n"
      "- {title: C, settings: {variants: [ref]}}\n");
  expect_in("| toy | calm | new | 50.0 ± 2.48 |", text);
  expect_in("| toy | calm | -0.50 (not known) |", text);  // the same on all days
  expect_in("| toy | ref | ratio | `price` 1 |", text);
}

TEST(Page, PricesDays) {
  const Page asked = read_page(YamlValue::parse("title: A\nobjective: {idle_km: 1, lost: 2}\nsections:\n"
                                                "- {title: B, means: {variants: [new], metrics: [objective]}}\n",
                                                "sweep.yaml"),
                               names);
  expect_in("| toy | calm | new | 115 ± 4.97 |", whole_page(asked, {with_objective(asked, three_days())}, ""));
  EXPECT_THROW(read("- {title: B, means: {variants: [new], metrics: [objective]}}\n"), Error);
  EXPECT_THROW(
      read_page(YamlValue::parse("title: A\nobjective: {served: -1}\nsections: [{title: B}]\n", "sweep.yaml"), names),
      Error);
}

TEST(Page, KeepsItsTablesWhateverScenariosAndFaultsAreCalled) {
  std::vector<FinishedDay> days = three_days();
  for (auto& day : days) {
    day.scenario = "rush|hour";
    day.faults = "a|b";
    day.settings["price"] = "[1|2]";
  }
  const std::string text = whole_page(
      read("- {title: A, means: {variants: [new], metrics: [lost]}}\n- {title: B, settings: {variants: [ref]}}\n"
           "- {title: C, compare: {variants: [new], against: [ref], metrics: [lost], at: idle_km}}\n"),
      {days}, "");
  expect_in("| rush\\|hour | a\\|b | new | 50.0 ± 2.48 |", text);
  expect_in("| rush\\|hour | ref | ratio | `price` \\[1\\|2\\] |", text);
  expect_in("| rush\\|hour | a\\|b | new | ref | lost |", text);
}

TEST(Page, RefusesWhatItDoesNotKnow) {
  const auto refuse = [](const std::string& section, const std::string& word) {
    try {
      read(section);
      FAIL() << word;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("sweep.yaml:4: "), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refuse("- {title: A, means: {variants: [nwe], metrics: [lost]}}\n", "`nwe` is no variant (did you mean `new`?)");
  refuse("- {title: A, means: {variants: [new], metrics: [lots]}}\n", "no metric");
  refuse("- {title: A, means: {variants: [new], metrics: [lost], at: idle_km}}\n", "unknown key `at`");
  refuse("- {title: A, compare: {variants: [new], against: [ref], metrics: [lost], aims: {served: 1}}}\n",
         "not compared here");
  refuse("- {title: A, fronts: {variants: [new], against: [ref], at: served}}\n", "nothing to compare at");
  refuse("- {title: A, fronts: {variants: [new], against: [ref], primary: {}}}\n", "say which scenario");
  refuse("- {title: A, fronts: {variants: [new], against: [ref], primary: {scenario: tyo}}}\n", "did you mean `toy`");
}

}  // namespace
}  // namespace evbal
