#include "common/error.hpp"
#include "experiments/study/statistics/page_markdown.hpp"

#include <gtest/gtest.h>

namespace evbal {
namespace {

const std::vector<std::string> variants = {"ref", "new"};

Page read(const std::string& sections) {
  return read_page(YamlValue::parse("title: Who wins\ntext: On small data.\nsections:\n" + sections, "sweep.yaml"),
                   variants);
}

FinishedDay day_of(const std::string& variant, const std::string& price, const std::string& day, double km,
                   double lost) {
  FinishedDay finished{.scenario = "toy", .variant = variant, .controller = "ratio", .faults = "calm", .day = day};
  finished.seed = 1;
  finished.settings = {{"price", price}};
  finished.totals = {{"idle_km", km}, {"lost", lost}, {"served", 100.0 - lost}};
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
  return page_markdown(read(sections), three_days(), "evbal sweep a.yaml");
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

TEST(Page, ComparesAndSaysWhatIsShown) {
  const std::string text = page(
      "- title: One\n"
      "  compare: {variants: [new], against: [ref], metrics: [lost, served], at: idle_km, aims: {lost: -49}}\n");
  expect_in("| scenario | faults | variant | against | metric | idle_km | value |", text);
  expect_in("| toy | calm | new | ref | lost | 15.0 | 50.0 | 100 | -50.0 % | -52.5 .. -47.5 |", text);
  // With two rows p of the first, 0.00013, counts twice. Served: 0, as the mean of -20 and 20, is no reference.
  expect_in("| 0.0001 | 0.0003 | 3 | 0 |", text);
  expect_in("| served | 15.0 | 50.0 | 0.000 | +50.0 | +47.5 .. +52.5 |  |", text);
  expect_in("rows in all: 2. Lower: `new` against `ref`, lost, toy calm. Higher: `new` against `ref`, served", text);
  expect_in(
      "- Aim -49 %, `new` against `ref`, lost, toy calm: reached in the mean, not with the whole interval "
      "(-50.0 %, -52.5 .. -47.5).\n",
      text);
}

TEST(Page, ComparesFronts) {
  std::vector<FinishedDay> days = three_days();
  for (const auto& [day, lost] : {std::pair("d1", 50.0), std::pair("d2", 51.0), std::pair("d3", 49.0)}) {
    days.push_back(day_of("new", "2", day, 25, lost - 20.0));
  }
  const std::string text = page_markdown(read("- {title: One, fronts: {variants: [new], against: [ref]}}\n"), days, "");
  expect_in("| scenario | faults | variant | against | metric | value | reference | of totals | difference |", text);
  expect_in("| toy | calm | new | ref | lost | 135 | 270 | -50.0 % | -49.7 % |",
            text);  // 45.5 of 90.5, from 15 to 20 km
  expect_in("| 3 | 0 | 50 % |", text);
  expect_in("| toy | calm | new | ref | lost |  |  |  |  |  |  | 0 | 3 | 0 % |",
            page("- {title: One, fronts: {variants: [new], against: [ref], metrics: [lost], at: idle_km}}\n"));
}

TEST(Page, SaysWhenNothingIsShown) {
  std::vector<FinishedDay> days = three_days();
  days.back().totals["lost"] = 400.0;
  const Page asked = read(
      "- {title: One, compare: {variants: [new], against: [ref], metrics: [lost], at: idle_km,"
      " aims: {lost: -49}}}\n");
  const std::string text = page_markdown(asked, days, "");
  expect_in("rows in all: 1. Lower: none. Higher: none. Rows in which no difference is shown: 1.\n", text);
  expect_in("missed (+67.0 %,", text);
}

TEST(Page, ShowsMeansRanksAndSettings) {
  const std::string text = page(
      "- {title: A, means: {variants: [new], metrics: [lost]}}\n"
      "- {title: B, correlate: {variants: [ref, new], metrics: [idle_km], with: lost}}\n"
      "- {title: C, settings: {variants: [ref]}}\n");
  expect_in("| toy | calm | new | 50.0 ± 2.48 |", text);
  expect_in("| toy | calm | -0.50 (-0.50 .. -0.50) |", text);
  expect_in("| toy | ref | ratio | `price` 1 |", text);
}

TEST(Page, PricesDays) {
  const Page asked = read_page(YamlValue::parse("title: A\nobjective: {idle_km: 1, lost: 2}\nsections:\n"
                                                "- {title: B, means: {variants: [new], metrics: [objective]}}\n",
                                                "sweep.yaml"),
                               variants);
  expect_in("| toy | calm | new | 115 ± 4.97 |", page_markdown(asked, three_days(), ""));
  EXPECT_THROW(read("- {title: B, means: {variants: [new], metrics: [objective]}}\n"), Error);
}

TEST(Page, KeepsItsTablesWhateverScenariosAndFaultsAreCalled) {
  std::vector<FinishedDay> days = three_days();
  for (auto& day : days) {
    day.scenario = "rush|hour";
    day.faults = "a|b";
    day.settings["price"] = "[1|2]";
  }
  const std::string text = page_markdown(
      read("- {title: A, means: {variants: [new], metrics: [lost]}}\n- {title: B, settings: {variants: [ref]}}\n"
           "- {title: C, compare: {variants: [new], against: [ref], metrics: [lost], at: idle_km}}\n"),
      days, "");
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
}

}  // namespace
}  // namespace evbal
