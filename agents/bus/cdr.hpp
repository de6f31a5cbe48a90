#pragma once

#include "agents/protocol/reflection.hpp"
#include "agents/protocol/region_range.hpp"
#include "common/error.hpp"
#include "common/plain_text.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Messages as CDR, as evbal.idl gives them: version 1, little-endian, fields in the order of the struct, each number
/// at a multiple of its size, enumerators as 32 bits, lists and texts with their length before them, texts with a zero
/// byte at their end.
namespace evbal {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they stand");

/// What stands before every message: that it is little-endian CDR, and two bytes of options. Positions count from its
/// end.
inline constexpr std::string_view cdr_encapsulation("\0\1\0\0", 4);

/// Writes values one after another, padding between them with zeros.
class CdrWriter {
 public:
  /// `out` has room for all that is written; without one, bytes are only counted.
  explicit CdrWriter(char* out) : out_(out) {}

  /// Writes a number.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  void write(Number value) {
    for (std::size_t padding = (sizeof value - size_ % sizeof value) % sizeof value; padding > 0; --padding) {
      put("", 1);
    }
    put(&value, sizeof value);
  }

  /// Writes an enumerator as 32 bits.
  template <class Enum>
  requires std::is_enum_v<Enum>
  void write(Enum value) { write(static_cast<std::uint32_t>(value)); }

  /// Writes a text.
  void write(const std::string& text) {
    write(static_cast<std::uint32_t>(text.size() + 1));
    put(text.c_str(), text.size() + 1);
  }

  /// Writes a list.
  template <class Item>
  void write(const std::vector<Item>& items) {
    write(static_cast<std::uint32_t>(items.size()));
    for (const auto& item : items) {
      write(item);
    }
  }

  /// Writes a message, field by field.
  template <class Message>
  requires std::is_class_v<Message>
  void write(const Message& message) {
    for_each_field(message, [&](std::string_view /*name*/, const auto& field) { write(field); });
  }

  /// Bytes so far.
  std::size_t size() const { return size_; }

 private:
  void put(const void* data, std::size_t size) {
    if (out_ != nullptr) {
      std::memcpy(out_ + size_, data, size);
    }
    size_ += size;
  }

  char* out_;
  std::size_t size_ = 0;
};

/// Reads what a CdrWriter wrote, from bytes that may be anything: throws Error{run_failed} with the reason where they
/// are no message. A length is believed only as far as there are bytes.
class CdrReader {
 public:
  /// Reads from the first byte on, which follows the encapsulation, and keeps what concerns `regions`.
  CdrReader(std::string_view bytes, const RegionRange& regions) : bytes_(bytes), regions_(regions) {}

  /// Reads a truth value.
  void read(bool& value) {
    std::uint8_t byte = 0;
    read(byte);
    if (byte > 1) {
      throw run_failed("a bool is " + std::to_string(byte));
    }
    value = byte == 1;
  }

  /// Reads a number.
  template <class Number>
  requires std::is_arithmetic_v<Number>
  void read(Number& value) {
    take((sizeof value - at_ % sizeof value) % sizeof value);
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
  }

  /// Reads an enumerator.
  template <class Enum>
  requires std::is_enum_v<Enum>
  void read(Enum& value) {
    std::uint32_t number = 0;
    read(number);
    if (number >= enumerators<Enum>) {
      throw run_failed("an enumerator is " + std::to_string(number) + ", the last one " +
                       std::to_string(enumerators<Enum> - 1));
    }
    value = static_cast<Enum>(number);
  }

  /// Reads a text.
  void read(std::string& text) {
    text = take(length());
    if (text.ends_with('\0')) {
      text.pop_back();
    }
    if (find_invalid_utf8(text) != std::string::npos || text.find('\0') != std::string::npos) {
      throw run_failed("a text is not UTF-8");
    }
  }

  /// Reads a list, of which it keeps what concerns the regions.
  template <class Item>
  void read(std::vector<Item>& items) {
    items.clear();
    for (std::size_t left = length(); left > 0; --left) {
      Item item{};
      read(item);
      if (concerns(regions_, item)) {
        items.push_back(std::move(item));
      }
    }
  }

  /// Reads a message, field by field.
  template <class Message>
  requires std::is_class_v<Message>
  void read(Message& message) {
    for_each_field(message, [&](std::string_view /*name*/, auto& field) { read(field); });
  }

 private:
  /// Of a text or a list, of which each item takes a byte at least.
  std::size_t length() {
    std::uint32_t value = 0;
    read(value);
    if (value > bytes_.size() - at_) {
      throw run_failed("a length is " + std::to_string(value) + ", the bytes left are " +
                       std::to_string(bytes_.size() - at_));
    }
    return value;
  }

  std::string_view take(std::size_t size) {
    if (size > bytes_.size() - at_) {
      throw run_failed("bytes are missing");
    }
    at_ += size;
    return bytes_.substr(at_ - size, size);
  }

  std::string_view bytes_;
  RegionRange regions_;
  std::size_t at_ = 0;
};

/// A message as it goes over the bus: every topic's type begins with the run's id.
template <class Message>
struct Sample {
  std::string run;        ///< id of the run
  Message message{};      ///< as it was written
  std::string wrong{};    ///< why the bytes that came are no message; empty if they are one
  RegionRange regions{};  ///< that its reader asks for: of the lists in it only what concerns these is kept
};

/// Length in bytes, encapsulation included.
template <class Message>
std::size_t cdr_size(const Sample<Message>& sample) {
  CdrWriter counter(nullptr);
  counter.write(sample.run);
  counter.write(sample.message);
  return cdr_encapsulation.size() + counter.size();
}

/// Writes cdr_size(sample) bytes.
template <class Message>
void write_cdr(const Sample<Message>& sample, char* out) {
  CdrWriter writer(std::copy(cdr_encapsulation.begin(), cdr_encapsulation.end(), out));
  writer.write(sample.run);
  writer.write(sample.message);
}

/// Reads any bytes and keeps what concerns `regions`; does not throw.
template <class Message>
Sample<Message> read_cdr(std::string_view bytes, const RegionRange& regions = {}) {
  constexpr std::size_t options = 2;
  Sample<Message> sample;
  sample.regions = regions;
  try {
    if (bytes.size() < cdr_encapsulation.size() || !bytes.starts_with(cdr_encapsulation.substr(0, options))) {
      throw run_failed("it does not begin as little-endian CDR does");
    }
    CdrReader reader(bytes.substr(cdr_encapsulation.size()), regions);
    reader.read(sample.run);
    reader.read(sample.message);
  } catch (const Error& error) {
    sample.wrong = error.what();
  }
  return sample;
}

}  // namespace evbal
