#include "tools/console/gatekeeper.hpp"

#include "experiments/run/request_box.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <random>
#include <utility>

namespace evbal {
namespace {

/// What each path is for.
const std::map<std::string, std::string>& methods() {
  static const std::map<std::string, std::string> all = {
      {"/", "GET"}, {"/events", "GET"}, {"/faults.yaml", "GET"}, {"/ask", "POST"}};
  return all;
}

/// Takes as long wherever the two differ.
bool same(const std::string& a, const std::string& b) {
  unsigned differs = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    differs |= static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
  }
  return differs == 0;
}

}  // namespace

Gatekeeper::Gatekeeper(int port, std::string token)
    : names_{"127.0.0.1:" + std::to_string(port), "localhost:" + std::to_string(port)}, token_(std::move(token)) {}

std::string Gatekeeper::new_token() {
  std::random_device device;
  std::string token;
  for (int i = 0; i < 4; ++i) {
    std::array<char, 16> word{};
    std::snprintf(word.data(), word.size(), "%08x", static_cast<unsigned>(device()));
    token += word.data();
  }
  return token;
}

std::optional<Turned> Gatekeeper::turns_away(const Caller& caller) const {
  const auto own = [&](const std::string& name) { return std::ranges::find(names_, name) != names_.end(); };
  const auto own_page = [&](const std::string& origin) {
    return origin.starts_with("http://") && own(origin.substr(std::string("http://").size()));
  };
  if (caller.hosts.size() != 1 || !own(caller.hosts.front())) {
    return Turned{403, "this server has another name; open the link that evbal run has printed"};
  }
  if (caller.origins.size() > 1 || !std::ranges::all_of(caller.origins, own_page)) {
    return Turned{403, "pages of other origins may not ask"};
  }
  if (caller.tokens.size() != 1 || !same(caller.tokens.front(), token_)) {
    return Turned{403, "the token is wrong or missing; open the link that evbal run has printed"};
  }
  const auto known = methods().find(caller.path);
  if (known == methods().end()) {
    return Turned{404, "there is no such page"};
  }
  if (known->second != caller.method) {
    return Turned{405, "is to be asked by " + known->second};
  }
  if (caller.method == "POST" && caller.origins.empty()) {
    return Turned{403, "a request must name its origin"};
  }
  if (caller.method == "POST" && caller.types != std::vector<std::string>{"application/json"}) {
    return Turned{415, "a request must be application/json"};
  }
  if (caller.coded || (caller.method == "POST" && !caller.length)) {
    return Turned{411, "a request must say its length, and come as it is"};
  }
  if (caller.length.value_or(0) > (caller.method == "POST" ? longest_request : 0)) {
    return Turned{413, "a request has at most " + std::to_string(longest_request) + " bytes"};
  }
  return std::nullopt;
}

}  // namespace evbal
