#include "tools/gps/drivable.hpp"

#include "tools/gps/rides.hpp"

#include <algorithm>
#include <deque>

namespace evbal {
namespace {

constexpr long long kLongestGap = 7 * 24 * 3600;  // s between fixes that belong together
constexpr double kFastest = 50.0;                 // m/s
constexpr double kNoise = 500.0;                  // m that GPS errs by, at both fixes
constexpr int kFewest = 10;                       // fixes that make a part of their own
constexpr int kWindow = 60;                       // fixes back that one may follow on
constexpr std::size_t kRejoins = 16;              // older fixes that it may, where records broke off
constexpr int kNone = -1;

/// The longest chain that ends at each fix, by dynamic programming.
class Chains {
 public:
  Chains(std::span<const Fix> fixes, const std::optional<Fix>& last) : fixes_(fixes), last_(last) {
    score_.reserve(fixes.size());
    before_.reserve(fixes.size());
    for (int i = 0; i < static_cast<int>(fixes.size()); ++i) {
      extend(i);
    }
  }

  std::vector<std::size_t> longest() const {
    std::vector<std::size_t> chain;
    for (int i = best_; i != kNone; i = before_[i]) {
      chain.push_back(static_cast<std::size_t>(i));
    }
    std::reverse(chain.begin(), chain.end());
    return chain;
  }

 private:
  /// Makes `score` and `before` those of a chain through `j`, if it is longer and a car can drive from there to `i`;
  /// of chains as long the one whose fix was recorded first.
  void try_follow(int j, int i, int& score, int& before) const {
    if (score_[j] + 1 >= score && can_drive(fixes_[j], fixes_[i])) {
      score = score_[j] + 1;
      before = j;
    }
  }

  void extend(int i) {
    const bool joined = i > 0 && can_drive(fixes_[i - 1], fixes_[i]);
    int score = start(i);
    int before = kNone;
    if (joined && best_ == i - 1) {  // no other chain is as long
      score = score_[i - 1] + 1;
      before = i - 1;
    } else {
      search(i, score, before);
    }
    if (!joined && i > 0) {
      rejoins_.push_back(i - 1);
      if (rejoins_.size() > kRejoins) {
        rejoins_.pop_front();
      }
    }
    score_.push_back(score);
    before_.push_back(before);
    if (score > (best_ == kNone ? 0 : score_[best_])) {
      best_ = i;
    }
  }

  void search(int i, int& score, int& before) const {
    for (int j = i - 1; j >= std::max(0, i - kWindow); --j) {
      try_follow(j, i, score, before);
    }
    for (const int j : rejoins_) {
      try_follow(j, i, score, before);
    }
    if (best_ != kNone && fixes_[best_].time < fixes_[i].time && score_[best_] + 1 - kFewest > score) {
      score = score_[best_] + 1 - kFewest;
      before = best_;
    }
  }

  /// Score of a chain that begins with fix `i`; a chain of none has 0.
  int start(int i) const {
    if (!last_) {
      return 1;
    }
    const bool later = fixes_[i].time > last_->time;
    return can_drive(*last_, fixes_[i]) ? 1 : later ? 1 - kFewest : kNever;
  }

  static constexpr int kNever = -1'000'000'000;

  std::span<const Fix> fixes_;
  const std::optional<Fix>& last_;
  std::vector<int> score_;   ///< fixes of the longest chain that ends at each, less kFewest for each break
  std::vector<int> before_;  ///< the fix before it in that chain, or kNone
  std::deque<int> rejoins_;  ///< fixes that the next one did not follow on
  int best_ = kNone;         ///< end of the longest chain so far
};

}  // namespace

bool can_drive(const Fix& before, const Fix& after) {
  const long long seconds = after.time - before.time;
  return seconds > 0 && seconds <= kLongestGap &&
         metres_between(before, after) <= kNoise + kFastest * static_cast<double>(seconds);
}

std::vector<std::size_t> longest_drive(std::span<const Fix> fixes, const std::optional<Fix>& last) {
  return Chains(fixes, last).longest();
}

}  // namespace evbal
