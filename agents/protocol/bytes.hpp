#pragma once

#include "agents/protocol/messages.hpp"
#include "agents/protocol/reflection.hpp"
#include "common/error.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

/// Messages as bytes: the fields in the order of the struct, numbers little-endian, lists and texts with their length
/// before them. Any plain struct can be written so.
namespace evbal {

static_assert(std::endian::native == std::endian::little, "digests and journals are of little-endian bytes");

/// Whether fields that are no part of a digest are written too.
enum class Detail {
  all,     ///< every field
  digest,  ///< without outside_digests; rare_in_digests only where they differ from their default, with their name
};

/// Calls `then(member)` if `field` of `message` is one of the members that a tuple names; says whether it is.
template <class Members, class Message, class Field, class Then>
bool if_named(const Members& members, const Message& message, const Field& field, Then then) {
  const auto is = [&](auto member) {
    if constexpr (std::is_same_v<decltype(member), Field Message::*>) {
      if (&(message.*member) == &field) {
        then(member);
        return true;
      }
    }
    return false;
  };
  return std::apply([&](auto... member) { return (is(member) || ...); }, members);
}

/// Hands a value's bytes to `sink(pointer, size)`.
template <class Sink>
class ByteWriter {
 public:
  /// Writes to `sink`.
  ByteWriter(Sink sink, Detail detail) : sink_(std::move(sink)), detail_(detail) {}

  /// Writes a number as it stands in memory.
  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void write(Number value) { sink_(&value, sizeof value); }

  /// Writes a text: its length, then its bytes.
  void write(const std::string& text) {
    write(static_cast<std::uint64_t>(text.size()));
    sink_(text.data(), text.size());
  }

  /// Writes a list: its length, then its items.
  template <class Item>
  void write(const std::vector<Item>& items) {
    write(static_cast<std::uint64_t>(items.size()));
    for (const auto& item : items) {
      write(item);
    }
  }

  /// Writes a message, field by field.
  template <class Message>
  requires std::is_class_v<Message>
  void write(const Message& message) {
    for_each_field(message, [&](std::string_view name, const auto& field) {
      if (detail_ == Detail::all || !write_apart(name, message, field)) {
        write(field);
      }
    });
  }

 private:
  /// Whether digests treat a field apart; writes it then as they want it.
  template <class Message, class Field>
  bool write_apart(std::string_view name, const Message& message, const Field& field) {
    const auto write_unless_usual = [&](auto member) {
      static const Message usual{};
      if (field != usual.*member) {
        write(std::string(name));
        write(field);
      }
    };
    return if_named(outside_digests, message, field, [](auto /*member*/) {}) ||
           if_named(rare_in_digests, message, field, write_unless_usual);
  }

  Sink sink_;
  Detail detail_;
};

/// Takes from bytes what a ByteWriter of all fields gave.
class ByteReader {
 public:
  /// Reads from the first byte on.
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  /// Reads a number.
  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void read(Number& value) { std::memcpy(&value, take(sizeof value).data(), sizeof value); }

  /// Reads a text.
  void read(std::string& text) { text = take(size()); }

  /// Reads a list.
  template <class Item>
  void read(std::vector<Item>& items) {
    items.clear();
    for (std::uint64_t left = size(); left > 0; --left) {
      read(items.emplace_back());
    }
  }

  /// Reads a message, field by field.
  template <class Message>
  requires std::is_class_v<Message>
  void read(Message& message) {
    for_each_field(message, [&](std::string_view /*name*/, auto& field) { read(field); });
  }

  /// Whether all bytes were read.
  bool at_end() const { return rest_.empty(); }

 private:
  std::uint64_t size() {
    std::uint64_t size = 0;
    read(size);
    return size;
  }

  std::string_view take(std::uint64_t size) {
    if (size > rest_.size()) {
      throw run_failed("bytes that are no message: too few of them");
    }
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  std::string_view rest_;
};

/// A message as bytes.
template <class Message>
std::string to_bytes(const Message& message) {
  std::string bytes;
  ByteWriter writer([&](const void* data, std::size_t size) { bytes.append(static_cast<const char*>(data), size); },
                    Detail::all);
  writer.write(message);
  return bytes;
}

/// Throws Error{run_failed} if `bytes` are not those of a Message, by their number.
template <class Message>
Message from_bytes(std::string_view bytes) {
  Message message;
  ByteReader reader(bytes);
  reader.read(message);
  if (!reader.at_end()) {
    throw run_failed("bytes that are no message: too many of them");
  }
  return message;
}

}  // namespace evbal
