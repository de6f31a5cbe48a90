#include "common/yaml.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace evbal {
namespace {

YamlMap map_of(const std::string& text) {
  return YamlMap(YamlValue::parse(text, "a.yaml"));
}

void expect_refused(const std::function<void()>& reads, const std::string& place, const std::string& word) {
  try {
    reads();
    FAIL() << "was accepted, expected a refusal at " << place;
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_input);
    EXPECT_TRUE(std::string(error.what()).starts_with(place + ": ")) << error.what();
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(Yaml, ReadsWhatItIsGiven) {
  auto map = map_of("a: 1.5\nb: 12\nc: true\nd: 90min\ne: \"17:30\"\nf: [x, y]\ng: 18446744073709551615\n");
  EXPECT_EQ(map.require("a").number(), 1.5);
  EXPECT_EQ(map.require("b").integer(0, 20), 12);
  EXPECT_TRUE(map.require("c").boolean());
  EXPECT_EQ(map.require("d").whole_minutes(), 90);
  EXPECT_EQ(map.require("e").time_of_day(), 17 * 60 + 30);
  EXPECT_EQ(map.require("f").items().at(1).text(), "y");
  EXPECT_EQ(map.require("g").seed(), 18446744073709551615ULL);
  EXPECT_NO_THROW(map.finish());
}

TEST(Yaml, RefusesWhatYamlWouldGuess) {
  expect_refused([] { map_of("a: 1\na: 2\n"); }, "a.yaml:2", "twice");
  expect_refused([] { map_of("a: 010\n").require("a").integer(); }, "a.yaml:1", "whole number");
  expect_refused([] { map_of("a: yes\n").require("a").boolean(); }, "a.yaml:1", "neither");
  expect_refused([] { map_of("\na: 0x10\n").require("a").number(); }, "a.yaml:2", "decimal");
  expect_refused([] { map_of("a: .inf\n").require("a").number(); }, "a.yaml:1", "decimal");
  expect_refused([] { map_of("a: 30\n").require("a").duration(); }, "a.yaml:1", "30min");
  expect_refused([] { map_of("a: 1.5min\n").require("a").whole_minutes(); }, "a.yaml:1", "whole minutes");
  expect_refused([] { map_of("a: 30 minutes\n").require("a").duration(); }, "a.yaml:1", "30min");
  expect_refused([] { map_of("a: \"24:30\"\n").require("a").time_of_day(); }, "a.yaml:1", "17:30");
  expect_refused([] { map_of("a: -1\n").require("a").integer(0, 5); }, "a.yaml:1", "from 0 to 5");
}

TEST(Yaml, RefusesUnknownAndMissingKeys) {
  expect_refused(
      [] {
        auto map = map_of("tick: 5min\nstpe: 30min\n");
        map.find("tick");
        map.find("step");
        map.finish();
      },
      "a.yaml:2", "did you mean `step`");
  expect_refused([] { map_of("a: 1\n").require("b"); }, "a.yaml:1", "`b` is missing");
}

TEST(Yaml, SetsKeysByPath) {
  const auto settings = YamlValue::parse("tau: 3\nnew: 12min\n", "b.yaml");
  YamlMap given(settings);
  const auto base = YamlValue::parse("x: 1\nbalancing: {tau: 2, m1: 10}\n", "a.yaml");
  YamlMap map(base.with("balancing.tau", given.require("tau")).with("clock.tick", given.require("new")));
  YamlMap balancing(map.require("balancing"));
  EXPECT_EQ(balancing.require("tau").integer(), 3);
  EXPECT_EQ(balancing.require("m1").integer(), 10);
  YamlMap clock(map.require("clock"));
  EXPECT_EQ(clock.require("tick").whole_minutes(), 12);
  EXPECT_EQ(map.keys(), (std::vector<std::string>{"x", "balancing", "clock"}));
  YamlMap as_before(base);
  EXPECT_FALSE(as_before.find("clock"));
}

TEST(Yaml, PutsTheBlameForASettingWhereItStands) {
  const auto settings = YamlValue::parse("a: 1\ntau: x\n", "b.yaml");
  YamlMap given(settings);
  const auto base = YamlValue::parse("x: 1\n", "a.yaml");
  const auto finish = [](YamlMap map) {
    map.find("x");
    map.finish();
  };
  const auto with = [&](const std::string& path) { return base.with(path, given.require("tau")); };
  expect_refused([&] { YamlMap(YamlMap(with("balancing.tau")).require("balancing")).require("tau").integer(); },
                 "b.yaml:2", "`x` is no whole number");
  expect_refused([&] { finish(YamlMap(with("xx"))); }, "b.yaml:2", "unknown key `xx`");
  expect_refused([&] { YamlMap(with("clock.tick")).require("clock").text(); }, "b.yaml:2", "expected a text");
  expect_refused([&] { YamlMap(with("x.y")); }, "b.yaml:2", "`x` holds no keys");
}

TEST(Yaml, PutsTheBlameForAnOptionOnTheOption) {
  const auto base = YamlValue::parse("seed: 1\nbalancing: {m1: 10}\n", "a.yaml");
  const auto balancing = [&](const std::string& text) {
    const YamlValue set = base.with("balancing.tau", YamlValue::parse_option(text, "--set balancing.tau"));
    return YamlMap(YamlMap(set).require("balancing"));
  };
  EXPECT_EQ(balancing("3").require("tau").integer(), 3);
  EXPECT_EQ(balancing("3").require("tau").line(), 0);
  EXPECT_EQ(balancing("3").require("m1").line(), 2);
  expect_refused([&] { balancing("x").require("tau").integer(); }, "--set balancing.tau", "`x` is no whole number");
  expect_refused([&] { balancing("3").finish(); }, "a.yaml:2", "unknown key `m1`");
  expect_refused([&] { balancing(""); }, "--set balancing.tau", "is empty");
  expect_refused([&] { balancing("[1"); }, "--set balancing.tau", "not valid YAML");
  expect_refused([&] { balancing("[1, x]").require("tau").items().at(1).integer(); }, "--set balancing.tau", "`x`");
}

TEST(Yaml, RefusesASecondDocument) {
  expect_refused([] { YamlValue::parse("a: 1\n---\nb: 2\n", "a.yaml"); }, "a.yaml:3", "second document");
  expect_refused([] { YamlValue::parse("a: 1\n...\nb: 2\n", "a.yaml"); }, "a.yaml:3", "second document");
  expect_refused([] { YamlValue::parse("a: 1\n---\n", "a.yaml"); }, "a.yaml:2", "second document");
  expect_refused([] { YamlValue::parse("{a: 1},\n{b: 2}\n", "a.yaml"); }, "a.yaml:2", "second document");
  expect_refused([] { YamlValue::parse("{a: 1} b", "a.yaml"); }, "a.yaml:1", "second document");
  EXPECT_EQ(YamlMap(YamlValue::parse("# one\n---\na: 1\n...\n", "a.yaml")).require("a").integer(), 1);
}

TEST(Yaml, TakesDurationsAsTheyAreWritten) {
  const std::vector<std::pair<std::string, int>> durations = {{"4.1h", 246}, {"0.1h", 6},      {"1.1h", 66},
                                                              {"2.3h", 138}, {"17.85h", 1071}, {"120s", 2},
                                                              {"4140s", 69}, {"60000ms", 1},   {"4140000ms", 69}};
  for (const auto& [text, minutes] : durations) {
    EXPECT_EQ(map_of("a: " + text + "\n").require("a").whole_minutes(), minutes) << text;
  }
  EXPECT_EQ(map_of("a: 0.5min\n").require("a").duration(), 0.5);
  for (const std::string text : {"30s", "1.0001h", "4.100001h", "90001ms"}) {
    expect_refused([&] { map_of("a: " + text + "\n").require("a").whole_minutes(); }, "a.yaml:1", "whole minutes");
  }
}

TEST(Yaml, RefusesTextThatIsNotUtf8) {
  for (const std::string bytes : {"\xff", "\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80", "M\xfcnchen"}) {
    expect_refused([&] { YamlValue::parse("a: 1\nb: " + bytes + "\n", "a.yaml"); }, "a.yaml:2", "UTF-8");
  }
  EXPECT_EQ(map_of("a: M\u00fcnchen \u6df1\u5733 \U0001f696\n").require("a").text(),
            "M\u00fcnchen \u6df1\u5733 \U0001f696");
}

TEST(Yaml, RefusesControlCharacters) {
  expect_refused([] { YamlValue::parse("a: 1\n\x04\nb: 2\n", "a.yaml"); }, "a.yaml:2", "control character");
  expect_refused([] { YamlValue::parse(std::string("a: 1\nb: x\0y\n", 12), "a.yaml"); }, "a.yaml:2",
                 "control character");
  expect_refused([] { map_of("a: \"x\\ty\"\n").require("a").text(); }, "a.yaml:1", "control character");
  expect_refused([] { map_of("\na: \"x\\ny\"\n").require("a").text(); }, "a.yaml:2", "line break");
  expect_refused([] { map_of("\"x\\ny\": 1\n"); }, "a.yaml:1", "line break");
}

TEST(Yaml, RefusesBrokenFiles) {
  expect_refused([] { YamlValue::parse("a: [1, 2\n", "a.yaml"); }, "a.yaml:2", "YAML");
  expect_refused([] { YamlValue::parse("", "a.yaml"); }, "a.yaml:1", "empty");
  expect_refused([] { YamlValue::load("/no/such/file.yaml"); }, "/no/such/file.yaml", "cannot be read");
}

}  // namespace
}  // namespace evbal
