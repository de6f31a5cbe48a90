#pragma once

#include "agents/protocol/bytes.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What the launcher of a run and the keeper of its processes on another host (keeper.hpp) say to each other, through
/// the keeper's standard input and output.
namespace evbal {

/// A file that goes from one host to another.
struct SentFile {
  std::string name;   ///< in the run's folder over there
  std::string bytes;  ///< all of it
};

/// What a keeper is to do.
enum class HostOrderKind : std::uint8_t {
  alive,   ///< nothing: the launcher is there
  start,   ///< a process, with `words` as arguments, once `files` are written
  signal,  ///< `process` gets the signal `number`; after SIGKILL it has ended
  ports,   ///< say which UDP port from `number` to `last_port` cannot be had
  end,     ///< end all processes, send what their legs took, and end
};

/// An order of the launcher.
struct HostOrder {
  HostOrderKind kind = HostOrderKind::alive;  ///< what to do
  std::string process{};                      ///< whom it concerns: "agent-3"
  std::vector<std::string> words{};           ///< of HostOrderKind::start
  std::vector<SentFile> files{};              ///< of HostOrderKind::start
  std::int32_t number = 0;                    ///< signal or first port
  std::int32_t last_port = 0;                 ///< of HostOrderKind::ports
};

/// What a keeper tells.
enum class HostNewsKind : std::uint8_t {
  alive,        ///< nothing: the keeper is there
  started,      ///< `process`, with the process id `number`
  not_started,  ///< `process`, for the reason `text`
  printed,      ///< `process` has printed `text`
  ended,        ///< `process`, whose id was `number`, with the status that `text` has as a number
  ports,        ///< why a port cannot be had, or nothing
  legs,         ///< `text` is the file of what the legs of `process` took
};

/// News from a keeper.
struct HostNews {
  HostNewsKind kind = HostNewsKind::alive;  ///< what it is about
  std::string process{};                    ///< whom it concerns
  std::int32_t number = 0;                  ///< process id
  std::string text{};                       ///< see HostNewsKind
};

/// The line with which a keeper begins. What a host prints before it, such as the greeting of a shell, is no word of
/// the keeper's.
inline constexpr std::string_view keeper_greeting = "evbal-keeper\n";

/// An order, or news, as it goes through a pipe: its length, a line's end, its bytes, and a line's end again, at which
/// whoever passes lines on passes all of it on.
template <class Message>
std::string frame(const Message& message) {
  const std::string bytes = to_bytes(message);
  return std::to_string(bytes.size()) + "\n" + bytes + "\n";
}

/// Takes frames from bytes that come in pieces.
class FrameReader {
 public:
  /// Adds what has come.
  void add(std::string_view bytes) { bytes_.append(bytes); }

  /// Drops all before the greeting, and the greeting, and says whether it has come. Throws Error{run_failed} with what
  /// came in its place, should that be too long.
  bool greeted();

  /// The next message, if all of it has come. Throws Error{run_failed} if what came is none.
  template <class Message>
  std::optional<Message> next() {
    const auto frame = next_frame();
    return frame ? std::optional(from_bytes<Message>(*frame)) : std::nullopt;
  }

 private:
  std::optional<std::string> next_frame();

  std::string bytes_;
};

/// Writes to a pipe that never waits (O_NONBLOCK) what it takes now, and removes that from `text`; false if nobody
/// reads there any more.
bool write_some(int file, std::string& text);

}  // namespace evbal
