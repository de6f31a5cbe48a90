#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace evbal {

/// A request over HTTP, as far as it decides who may pass. Of headers and parameters all that were given, in order.
struct Caller {
  std::string method;                   ///< "GET"
  std::string path;                     ///< without the parameters
  std::vector<std::string> hosts{};     ///< headers Host
  std::vector<std::string> origins{};   ///< headers Origin
  std::vector<std::string> tokens{};    ///< parameters token
  std::vector<std::string> types{};     ///< headers Content-Type
  bool coded = false;                   ///< there is a header Transfer-Encoding or Content-Encoding
  std::optional<std::size_t> length{};  ///< header Content-Length, if it is a number
};

/// Why somebody may not pass.
struct Turned {
  int status = 403;  ///< of HTTP
  std::string why;   ///< in a sentence
};

/// Decides who may pass: whoever has the token and speaks to this server by its own name, from its own page. Pages of
/// others that a browser has open are told by their Origin, names that others have pointed to this machine by Host.
class Gatekeeper {
 public:
  /// Of the server on this port of the loopback interface.
  Gatekeeper(int port, std::string token);

  /// 128 random bits in hexadecimal.
  static std::string new_token();

  /// Why the caller may not pass, if so.
  std::optional<Turned> turns_away(const Caller& caller) const;

 private:
  std::vector<std::string> names_;  ///< that the server goes by, with the port
  std::string token_;
};

}  // namespace evbal
