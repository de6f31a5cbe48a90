#pragma once

#include "agents/protocol/fields.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace evbal {

static_assert(std::endian::native == std::endian::little, "the walk below reads numbers as they stand");

/// Walks over the bytes of a message as CDR has it (little-endian, as Fast DDS writes it here), taking nothing: does
/// the message end where its bytes do? A list's length is believed only as far as there are bytes for its items.
class CdrWalk {
 public:
  explicit CdrWalk(std::string_view bytes) : bytes_(bytes) {}

  template <class Field>
  void operator()(const char* /*name*/, const Field& field) {
    walk(field);
  }

  void walk(const std::string& /*like*/) {
    const std::uint32_t size = length();  // with the zero byte at its end
    skip(1, size);
  }

  void walk(bool /*like*/) {
    skip(1, 1);
    sound_ = sound_ && static_cast<unsigned char>(bytes_[at_ - 1]) <= 1;
  }

  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void walk(Number /*like*/) {
    constexpr std::size_t size = std::is_enum_v<Number> ? sizeof(std::uint32_t) : sizeof(Number);
    skip(size, size);
  }

  template <class Item>
  void walk(const std::vector<Item>& /*like*/) {
    static const Item item{};
    for (std::uint32_t left = length(); left > 0 && sound_; --left) {
      walk(item);
    }
  }

  template <class Message>
  requires std::is_class_v<Message>
  void walk(const Message& like) { fields(*this, like); }

  bool sound() const { return sound_; }

 private:
  void skip(std::size_t alignment, std::size_t size) {
    const std::size_t begin = (at_ + alignment - 1) / alignment * alignment;
    sound_ = sound_ && begin <= bytes_.size() && size <= bytes_.size() - begin;
    at_ = sound_ ? begin + size : at_;
  }

  std::uint32_t length() {
    std::uint32_t value = 0;
    skip(sizeof value, sizeof value);
    if (sound_) {
      std::memcpy(&value, bytes_.data() + at_ - sizeof value, sizeof value);
    }
    return value;
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  bool sound_ = true;
};

/// Whether these are the bytes of a run's id and a Message, with their encapsulation before them, and none is missing.
template <class Message>
bool is_whole(std::string_view bytes) {
  constexpr std::string_view little_endian("\0\1", 2);
  constexpr std::size_t encapsulation = 4;
  if (bytes.size() < encapsulation || !bytes.starts_with(little_endian)) {
    return false;
  }
  CdrWalk walk(bytes.substr(encapsulation));
  walk.walk(std::string());
  walk.walk(Message());
  return walk.sound();
}

}  // namespace evbal
