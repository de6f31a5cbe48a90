#include "tools/fit/transition_table.hpp"

#include "agents/world/pack_table.hpp"
#include "common/decimal.hpp"
#include "common/files.hpp"
#include "common/table_text.hpp"

#include <array>
#include <cmath>
#include <map>
#include <sstream>

namespace evbal {
namespace {

const std::string kHeader = "from,region,state,cars,becomes,in_region,share";

/// A block of a period's transitions, by the words of the table.
struct Block {
  const char* state;
  const char* becomes;
  Eigen::MatrixXd Transitions::*shares;
};
constexpr std::array<Block, 5> kBlocks{{{"vacant", "vacant", &Transitions::vacant_to_vacant},
                                        {"vacant", "occupied", &Transitions::vacant_to_occupied},
                                        {"vacant", "low_battery", &Transitions::vacant_to_low_battery},
                                        {"occupied", "vacant", &Transitions::occupied_to_vacant},
                                        {"occupied", "occupied", &Transitions::occupied_to_occupied}}};

std::string time_of_day(int minute) {
  const auto two = [](int number) { return (number < 10 ? "0" : "") + std::to_string(number); };
  return two(minute / 60) + ":" + two(minute % 60);
}

class TransitionReader {
 public:
  TransitionReader(const std::filesystem::path& file, const std::vector<Region>& regions)
      : file_(file), table_(file, kHeader), n_(static_cast<Eigen::Index>(regions.size())) {
    for (std::size_t r = 0; r < regions.size(); ++r) {
      region_of_[regions[r].name] = static_cast<Eigen::Index>(r);
    }
    for (const int start : transition_periods()) {
      const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(n_, n_);
      period_of_[time_of_day(start)] = periods_.size();
      periods_.push_back({start, {none, none, none, none, none}});
    }
  }

  std::vector<Period> read() {
    while (table_.next()) {
      const auto period = period_of_.find(table_.text(0));
      if (period == period_of_.end()) {
        throw table_.error("no period begins at `" + std::string(table_.text(0)) + "`");
      }
      shares(periods_[period->second].transitions)(region(1), region(5)) = table_.number(6, 0.0, 1.0);
    }
    for (const Period& period : periods_) {
      check(period);
    }
    return periods_;
  }

 private:
  Eigen::Index region(std::size_t column) const {
    const auto found = region_of_.find(table_.text(column));
    if (found == region_of_.end()) {
      throw table_.error("the city has no region `" + std::string(table_.text(column)) +
                         "`; make the table with its regions.geojson");
    }
    return found->second;
  }

  Eigen::MatrixXd& shares(Transitions& transitions) const {
    for (const Block& block : kBlocks) {
      if (table_.text(2) == block.state && table_.text(4) == block.becomes) {
        return transitions.*block.shares;
      }
    }
    throw table_.error("`" + std::string(table_.text(2)) + "` becomes `" + std::string(table_.text(4)) +
                       "`; expected vacant or occupied, which becomes vacant, occupied or, if vacant, low_battery");
  }

  void check(const Period& period) const {
    for (const auto& [name, row] : region_of_) {
      std::map<std::string, double> sums;
      for (const Block& block : kBlocks) {
        sums[block.state] += (period.transitions.*block.shares).row(row).sum();
      }
      for (const auto& [state, sum] : sums) {
        if (std::abs(sum - 1.0) > 1e-6) {
          std::ostringstream what;
          what << "from " << time_of_day(period.start) << ", shares of region `" << name << "`, " << state
               << ", sum to " << decimal(sum) << " where 1 is expected";
          throw bad_input(file_.string(), 0, what.str());
        }
      }
    }
  }

  std::filesystem::path file_;
  PackTable table_;
  Eigen::Index n_;
  std::map<std::string, Eigen::Index, std::less<>> region_of_;
  std::map<std::string, std::size_t, std::less<>> period_of_;
  std::vector<Period> periods_;
};

}  // namespace

std::string write_transitions(const std::vector<TransitionCounts>& counts, const std::vector<Region>& regions,
                              const std::filesystem::path& file) {
  const std::vector<Period> periods = periods_of(counts);
  std::string text = kHeader + "\n";
  double seen = 0.0;
  int rows = 0;
  int thin = 0;
  for (std::size_t p = 0; p < periods.size(); ++p) {
    for (std::size_t from = 0; from < regions.size(); ++from) {
      const auto row = static_cast<Eigen::Index>(from);
      const double vacant = counts[p].vacant.row(row).sum();
      const double occupied = counts[p].occupied.row(row).sum();
      seen += vacant + occupied;
      rows += 2;
      thin += (vacant < transition_prior ? 1 : 0) + (occupied < transition_prior ? 1 : 0);
      for (const Block& block : kBlocks) {
        const std::string cars = decimal(std::llround(block.state == kBlocks[0].state ? vacant : occupied));
        for (std::size_t to = 0; to < regions.size(); ++to) {
          const double share = (periods[p].transitions.*block.shares)(row, static_cast<Eigen::Index>(to));
          if (share > 0.0) {
            text += csv_row({time_of_day(periods[p].start), regions[from].name, block.state, cars, block.becomes,
                             regions[to].name, decimal(share)});
          }
        }
      }
    }
  }
  write_file(file, text);
  std::ostringstream report;
  report << "transitions counted: " << std::llround(seen) << "\n"
         << "  rows of fewer than " << transition_prior << " cars, drawn towards the day's mean: " << thin << " of "
         << rows << "\n";
  return report.str();
}

std::vector<Period> read_transitions(const std::filesystem::path& file, const std::vector<Region>& regions) {
  return TransitionReader(file, regions).read();
}

}  // namespace evbal
