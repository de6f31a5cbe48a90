#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/world/city.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// What is wrong with a move.
struct MoveComplaint {
  const char* field;  ///< of the move
  std::string words;  ///< what would be right
};

/// Checks moves of somebody else's controller against the reports, one after another: no region sends more cars than it
/// reported.
class MoveCheck {
 public:
  /// Regions that are `rejected` stand in the plan as the controller estimates them, and may send any number.
  MoveCheck(const std::vector<Report>& reports, const std::vector<Rejection>& rejected, const City& city);

  /// Takes the cars of a move, or says what is wrong with it.
  std::optional<MoveComplaint> take(const Move& move);

 private:
  struct Left {
    int vacant = 0;
    int low_battery = 0;
    int chargeable = 0;
  };

  std::optional<MoveComplaint> take(const Move& move, Left& left) const;

  int regions_;
  bool top_up_;
  std::map<int, Left> left_;  ///< none where no report came
};

/// Sorts moves by (errand, from, to). Gives a sentence on one that is given twice, or an empty text.
std::string sort_moves(std::vector<Move>& moves);

}  // namespace evbal
