// What libFuzzer calls: any bytes as what comes over a connection to the console, from the first line to the fault that
// is asked for. TOKEN and PORT in them stand for this server's own. Everything but an answer is found.

#include "common/error.hpp"
#include "experiments/run/day_request.hpp"
#include "faults/schedule/by_hand.hpp"
#include "tools/console/web_server.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace evbal {
namespace {

/// A connection over which these bytes come and no more.
class Bytes : public httplib::Stream {
 public:
  explicit Bytes(std::string_view bytes) : left_(bytes) {}

  bool is_readable() const override { return !left_.empty(); }
  bool is_writable() const override { return true; }
  ssize_t read(char* to, std::size_t size) override {
    const std::size_t count = std::min(size, left_.size());
    std::memcpy(to, left_.data(), count);
    left_.remove_prefix(count);
    return count == 0 ? -1 : static_cast<ssize_t>(count);
  }
  ssize_t write(const char*, std::size_t size) override { return static_cast<ssize_t>(size); }
  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  socket_t socket() const override { return INVALID_SOCKET; }

 private:
  std::string_view left_;
};

/// Answers a request as a day of a small city does.
std::string answer(const std::string& text) {
  const DayRequest request = read_day_request(text);
  if (!request.fault) {
    return "done";
  }
  const FaultContext context{DayClock{}, {0, 4, 0, 12, 20}};
  const Schedule before{.seed = 1,
                        .guard = {.max_active = 2, .min_working_points = 1},
                        .faults = {{.name = "slow",
                                    .type = EffectType::travel_slow,
                                    .regions = {3},
                                    .magnitudes = {2.0},
                                    .start = 0,
                                    .duration = 60}}};
  return with_fault_by_hand(before, *request.fault, context, 3).faults.back().name;
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
}

/// What has been told of a day that is over.
Feed& feed() {
  static Feed told;
  static const bool over = [] {
    told.begin_day("{}");
    told.close();
    return true;
  }();
  static_cast<void>(over);
  return told;
}

void hear(std::string bytes) {
  static WebServer server(0, {.page = "page", .ask = answer}, feed());
  static const std::string link = server.link();
  const auto colon = link.rfind(':');
  replace_all(bytes, "TOKEN", link.substr(link.find('=') + 1));
  replace_all(bytes, "PORT", link.substr(colon + 1, link.find('/', colon) - colon - 1));
  Bytes stream(bytes);
  server.serve(stream);
}

}  // namespace
}  // namespace evbal

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  evbal::hear({reinterpret_cast<const char*>(data), size});
  return 0;
}
