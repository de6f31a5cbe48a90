#include "agents/bus/roster.hpp"

#include <algorithm>
#include <cstring>

namespace evbal {

std::string text_of(const GuidPrefix& prefix) {
  static constexpr auto digits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : prefix) {
    text += {digits[byte >> 4], digits[byte & 15]};
  }
  return text;
}

Roster::Roster(const BusAddress& address) : participants_(address.participants), secured_(!address.keys.empty()) {
  for (int participant = 0; secured_ && participant < participants_; ++participant) {
    by_subject_[hash_of({.run = address.run, .process = name_of(participant)})] = participant;
  }
}

int Roster::number_of(const GuidPrefix& prefix) const {
  if (secured_) {
    SubjectHash subject{};
    std::copy_n(prefix.begin(), subject.size(), subject.begin());
    const auto found = by_subject_.find(subject);
    return found == by_subject_.end() ? -1 : found->second;
  }
  // Fast DDS keeps it in bytes 8 and 9; in the two that follow, version 3 counts the participants of that number that
  // the process has had before.
  std::uint16_t number = 0;
  std::memcpy(&number, prefix.data() + 8, sizeof number);
  return number < participants_ ? number : -1;
}

}  // namespace evbal
