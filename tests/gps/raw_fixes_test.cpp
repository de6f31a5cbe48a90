#include "common/error.hpp"
#include "tests/folder.hpp"
#include "tests/packed.hpp"
#include "tools/gps/ingest_gps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace evbal {
namespace {

struct Row {
  long long time = 0;
  double lat = 0.0;
  double lon = 0.0;
  int occupied = 0;
};
using Rows = std::vector<Row>;

constexpr long long kMorning = 1'709'535'660;  // 2024-03-04
constexpr long long kYear = 365LL * 24 * 3600;

Row day_of_a_cab_at(int minute) {
  return {kMorning + 60 * minute, 52.36 + 0.02 * std::sin(minute / 30.0), 9.73 + 0.03 * std::cos(minute / 47.0),
          minute / 12 % 2};
}

/// Ten hours of a cab, a fix a minute: twelve minutes without passengers, twelve with.
Rows day_of_a_cab() {
  Rows rows;
  for (int minute = 0; minute < 600; ++minute) {
    rows.push_back(day_of_a_cab_at(minute));
  }
  return rows;
}

std::string text(const Rows& rows, const std::string& before = "") {
  std::string all;
  for (const Row& row : rows) {
    all += before + std::to_string(row.lat) + " " + std::to_string(row.lon) + " " + std::to_string(row.occupied) + " " +
           std::to_string(row.time) + "\n";
  }
  return all;
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// What GPS records are like as they come: the trips must be those of the clean day.
class RawFixes : public testing::Test {
 protected:
  RawFixes() {
    write_format("vehicle_in_name: \"cab_*.txt\"", "lat: 1, lon: 2, occupied: 3, time: 4", "unix");
    clean_ = trips_of(day_of_a_cab());
    EXPECT_EQ(lines(clean_), 25U);
    clean_km_ = longest_km();
  }

  void write_format(const std::string& vehicle, const std::string& columns, const std::string& time) {
    folder_.write("format.yaml", "separator: space\nheader: false\n" + vehicle + "\ncolumns: {" + columns +
                                     "}\ntime: " + time +
                                     "\noccupied: \"1\"\nfree: \"0\"\nutc_offset_minutes: 60\n"
                                     "clock_changes: [{utc: \"2024-03-04 11:00:00\", utc_offset_minutes: 0}]\n");
  }

  std::string ingest() {
    std::filesystem::remove_all(folder_.path() / "out");
    std::filesystem::create_directory(folder_.path() / "out");
    report_ = ingest_gps({folder_.path() / "gps", folder_.path() / "format.yaml", {}, {}}, folder_.path() / "out",
                         [](const FixProgress&) {});
    return text_of(folder_.path() / "out/trips/trips.csv");
  }

  std::string trips_of(const Rows& rows) {
    folder_.write("gps/cab_7.txt", text(rows));
    return ingest();
  }

  /// Of the vacant moves.
  double longest_km() const {
    std::istringstream in(text_of(folder_.path() / "out/vacant.csv"));
    double longest = 0.0;
    std::string line;
    for (std::getline(in, line); std::getline(in, line);) {
      const std::size_t end = line.rfind(',');
      longest = std::max(longest, std::stod(line.substr(line.rfind(',', end - 1) + 1)));
    }
    return longest;
  }

  /// The trips are those of the clean day, but for `differ` of them, and no vacant move is longer.
  void expect_clean(const std::string& trips, const std::string& line, int differ = 0) {
    EXPECT_EQ(lines(trips), lines(clean_)) << report_;
    std::istringstream in(trips);
    int others = 0;
    for (std::string trip; std::getline(in, trip);) {
      others += clean_.find(trip) == std::string::npos ? 1 : 0;
    }
    EXPECT_LE(others, differ) << trips;
    EXPECT_LE(longest_km(), clean_km_ + 1.0);
    EXPECT_NE(report_.find(line), std::string::npos) << line << " not in\n" << report_;
  }

  std::string refusal() {
    try {
      ingest();
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_input);
      return error.what();
    }
    return "was accepted:\n" + report_;
  }

  void expect_refused(const std::string& reason) {
    const std::string message = refusal();
    EXPECT_NE(message.find(reason), std::string::npos) << reason << " not in\n" << message;
  }

  Folder folder_;
  std::string report_;
  std::string clean_;
  double clean_km_ = 0.0;
};

/// The clean day with rows from `first` on, `count` of them, changed.
Rows changed(std::size_t first, std::size_t count, const std::function<void(Row&)>& change) {
  Rows rows = day_of_a_cab();
  std::for_each(rows.begin() + static_cast<std::ptrdiff_t>(first),
                rows.begin() + static_cast<std::ptrdiff_t>(first + count), change);
  return rows;
}

TEST_F(RawFixes, OfNoPlaceAreLeftOut) {
  const auto no_place = [](Row& row) { row.lat = row.lon = 0.0; };
  for (const std::size_t first : {0U, 100U, 599U}) {
    expect_clean(trips_of(changed(first, 1, no_place)), "at 0,0, which receivers write that know no place: 1 (first: " +
                                                            (folder_.path() / "gps/cab_7.txt").string() + ":" +
                                                            std::to_string(first + 1) + ": `");
  }
  expect_clean(trips_of(changed(2, 5, no_place)), "know no place: 5");
  Rows begins_without = changed(0, 0, no_place);
  begins_without.insert(begins_without.begin(), 150, {kMorning - 100, 0.0, 0.0, 0});
  expect_clean(trips_of(begins_without), "know no place: 150");
}

TEST_F(RawFixes, BeyondWhatACarDrivesAreLeftOut) {
  const auto far = [](Row& row) { row.lat += 1.0; };
  for (const std::size_t first : {0U, 100U, 599U}) {
    expect_clean(trips_of(changed(first, 1, far)), "no car can have driven: 1 (first");
  }
  expect_clean(trips_of(changed(0, 3, far)), "no car can have driven: 3");
  expect_clean(trips_of(changed(302, 9, far)), "no car can have driven: 9");
  expect_clean(trips_of(changed(597, 3, far)), "no car can have driven: 3");
  Rows rows = day_of_a_cab();  // every seventh
  for (std::size_t i = 3; i < rows.size(); i += 7) {
    rows[i].lon = 9.73 + static_cast<double>(i % 5 + 1);
  }
  trips_of(rows);
  EXPECT_LE(longest_km(), clean_km_ + 1.0);
  EXPECT_NE(report_.find("no car can have driven: 86"), std::string::npos) << report_;
}

TEST_F(RawFixes, OfALongStayElsewhereAreAnotherPartOfTheRecords) {
  const std::string trips = trips_of(changed(270, 330, [](Row& row) { row.lat += 30.0; }));
  EXPECT_EQ(lines(trips), 25U);
  EXPECT_LE(longest_km(), clean_km_ + 1.0);
  EXPECT_EQ(report_.find("dropped, where"), std::string::npos) << report_;
}

TEST_F(RawFixes, OfAWrongClockCostNoOthers) {
  for (const long long off : {10 * kYear, -10 * kYear, -kMorning + 1000, 3600LL, -7200LL}) {
    for (const std::size_t row : {20U, 101U, 402U}) {
      const auto late = [off](Row& one) { one.time += off; };
      expect_clean(trips_of(changed(row, 1, late)), ": 1 (first: ");
      expect_clean(trips_of(changed(row, 8, late)), ": 8 (first: ", 1);
    }
  }
  const auto ahead = [](Row& row) { row.time += 10 * kYear; };
  expect_clean(trips_of(changed(599, 1, ahead)), ": 1 (first: ");
  trips_of(changed(241, 95, ahead));  // too many to look back over at once
  EXPECT_NE(report_.find("out of the order of time: 95"), std::string::npos) << report_;
}

TEST_F(RawFixes, FromTheNewestToTheOldestAreReadBackwards) {
  Rows rows = day_of_a_cab();
  std::reverse(rows.begin(), rows.end());
  EXPECT_EQ(trips_of(rows), clean_);
  EXPECT_NE(report_.find("newest to the oldest row, read backwards: 1"), std::string::npos) << report_;
  std::swap(rows[300], rows[301]);
  rows[40].time += kYear;
  expect_clean(trips_of(rows), "out of the order of time: 2", 1);
}

TEST_F(RawFixes, FromTheNewestToTheOldestInLocalTimeAreReadBackwards) {
  write_format("", "vehicle: 1, lat: 2, lon: 3, occupied: 4, time: 5", "local");
  folder_.write("gps/cab_7.txt",  // clocks went back from 12:00 to 11:00
                "7 52.36 9.73 0 2024-03-04T11:40:00\n"
                "7 52.36 9.74 0 2024-03-04T11:10:00\n"
                "7 52.36 9.75 1 2024-03-04T11:50:00\n"
                "7 52.36 9.76 0 2024-03-04T11:30:00\n"
                "7 52.36 9.76 0 2024-03-04T10:30:00\n");
  EXPECT_EQ(lines(ingest()), 2U) << report_;
  EXPECT_EQ(report_.find("dropped, out"), std::string::npos) << report_;
}

TEST_F(RawFixes, MayHaveTimesAsFloatsAndEndingsInCapitals) {
  std::string floats;
  for (const Row& row : day_of_a_cab()) {
    floats += std::to_string(row.lat) + " " + std::to_string(row.lon) + " " + std::to_string(row.occupied) + ".0 " +
              std::to_string(row.time) + ".0\n";
  }
  std::filesystem::remove(folder_.path() / "gps/cab_7.txt");
  folder_.write("gps/cab_7.txt.GZ", packed(floats, "gzip"));
  expect_clean(ingest(), "vehicles: 1");
}

TEST_F(RawFixes, OfSeveralCabsMayBeMixed) {
  write_format("", "vehicle: 1, lat: 2, lon: 3, occupied: 4, time: 5", "unix");
  Rows other = changed(200, 1, [](Row& row) { row.lat = row.lon = 0.0; });
  Rows newest_first = day_of_a_cab();
  std::string mixed;
  std::string reversed;
  for (std::size_t i = 0; i < other.size(); ++i) {
    mixed += text({day_of_a_cab()[i]}, "7 ") + text({other[i]}, "8 ");
    reversed += text({day_of_a_cab()[599 - i]}, "7 ") + text({other[599 - i]}, "8 ");
  }
  for (const std::string& table : {mixed, reversed}) {
    folder_.write("gps/cab_7.txt", table);
    const std::string trips = ingest();
    EXPECT_EQ(lines(trips), 49U);
    EXPECT_EQ(trips.substr(0, clean_.size()), clean_);
  }
}

TEST_F(RawFixes, OfThousandsOfCabsMayBeMixed) {
  write_format("", "vehicle: 1, lat: 2, lon: 3, occupied: 4, time: 5", "unix");
  std::string mixed;
  for (int minute = 0; minute < 70; ++minute) {
    for (int cab = 0; cab < 4200; ++cab) {
      mixed += text({day_of_a_cab_at(minute)}, std::to_string(cab) + " ");
    }
  }
  folder_.write("gps/cab_7.txt", mixed);
  EXPECT_EQ(lines(ingest()), 1U + 2 * 4200);
}

TEST_F(RawFixes, GivenTwiceCountOnce) {
  Rows rows = day_of_a_cab();
  for (std::size_t i = 0; i < rows.size(); i += 11) {
    rows.insert(rows.begin() + static_cast<std::ptrdiff_t>(i), rows[i]);
  }
  EXPECT_EQ(trips_of(rows), clean_);
  EXPECT_NE(report_.find("of the same time as another fix: 60"), std::string::npos) << report_;
  Rows torn = day_of_a_cab();  // the wrong one of two comes first
  torn.insert(torn.begin() + 205, Row{torn[205].time, 53.0, 9.0, 1});
  EXPECT_EQ(trips_of(torn), clean_);
  folder_.write("gps/cab_7.txt.gz", packed(text(day_of_a_cab()), "gzip"));
  expect_refused("cab_7.txt.gz: 599 of its 600 rows are not in the order of time, or older than an earlier file's");
}

TEST_F(RawFixes, AFewOutOfOrderCostNoOthers) {
  Rows rows = day_of_a_cab();
  for (const std::size_t i : {20U, 105U, 400U, 590U}) {
    std::swap(rows[i], rows[i + 1]);
  }
  expect_clean(trips_of(rows), "out of the order of time: 4", 4);
  std::rotate(rows.begin(), rows.begin() + 200, rows.end());
  folder_.write("gps/cab_7.txt", text(rows));
  expect_refused("sort them by time");
}

TEST_F(RawFixes, OfAnotherFormAreRefusedWithTheValue) {
  const auto refused = [&](const Rows& rows, const std::string& reason) {
    folder_.write("gps/cab_7.txt", text(rows));
    expect_refused(reason);
  };
  refused(changed(0, 600, [](Row& row) { row.time *= 1000; }),
          "no unix time in seconds; milliseconds?: 100 (first: " + (folder_.path() / "gps/cab_7.txt").string() +
              ":1: `1709535660000`)");
  refused(changed(0, 600, [](Row& row) { row.lat = row.lon = 0.0; }), "has no fix that counts\n  dropped, at 0,0");
  refused(changed(0, 600, [](Row& row) { row.occupied = 2; }), "neither `1` (occupied) nor `0` (free): 100 (first");
  refused({{kMorning, 152.0, 9.7, 0}}, "no latitude in degrees, -90 to 90: 1 (first: ");
  Rows scattered = day_of_a_cab();
  for (std::size_t i = 0; i < scattered.size(); ++i) {
    scattered[i].lon = static_cast<double>(i * 7919 % 360) - 180.0;
  }
  refused(scattered, "more fixes where or when no car can have driven than others; are the columns");
  folder_.write("gps/cab_7.txt", "52,36 9,73 0 1709535660\n");
  expect_refused("cab_7.txt:1: `52,36`)");
}

TEST_F(RawFixes, ThatBreakOffAreRefusedWithWhatWasDroppedBefore) {
  folder_.write("gps/cab_7.txt", text(changed(10, 4, [](Row& row) { row.lat = row.lon = 0.0; })));
  const std::string whole = packed(text(day_of_a_cab()), "gzip");
  folder_.write("gps/cab_8.txt.gz", whole.substr(0, whole.size() - 20));
  expect_refused("cab_8.txt.gz:");
  expect_refused("know no place: 4 (first: ");
}

}  // namespace
}  // namespace evbal
