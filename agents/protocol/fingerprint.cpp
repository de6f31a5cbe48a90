#include "agents/protocol/fingerprint.hpp"

#include "agents/protocol/fields.hpp"

#include <bit>
#include <cstdint>

namespace evbal {
namespace {

static_assert(std::endian::native == std::endian::little, "digests are of little-endian bytes");

class Writer {
 public:
  explicit Writer(Digest& digest) : digest_(digest) {}

  void operator()(const char* /*name*/, const Origin& /*not part of any digest*/) {}

  template <class Field>
  void operator()(const char* /*name*/, const Field& field) {
    write(field);
  }

  template <class Field>
  void rare(const char* name, const Field& field, bool quiet) {
    if (!quiet) {
      write(std::string(name));
      write(field);
    }
  }

 private:
  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void write(Number value) { digest_.update(&value, sizeof value); }

  void write(const std::string& text) {
    write(static_cast<std::uint64_t>(text.size()));
    digest_.update(text.data(), text.size());
  }

  template <class Item>
  void write(const std::vector<Item>& items) {
    write(static_cast<std::uint64_t>(items.size()));
    for (const auto& item : items) {
      write(item);
    }
  }

  template <class Message>
  requires std::is_class_v<Message>
  void write(const Message& message) { fields(*this, message); }

  Digest& digest_;
};

template <class Message>
void add(Digest& digest, const Message& message) {
  Writer writer(digest);
  fields(writer, message);
}

}  // namespace

void fingerprint(Digest& digest, const Faults& message) {
  add(digest, message);
}

void fingerprint(Digest& digest, const Report& message) {
  add(digest, message);
}

void fingerprint(Digest& digest, const Plan& message) {
  add(digest, message);
}

void fingerprint(Digest& digest, const Departures& message) {
  add(digest, message);
}

}  // namespace evbal
