#pragma once

#include "agents/protocol/messages.hpp"

#include <utility>

namespace evbal {

/// CPU seconds of this thread so far.
double thread_cpu_seconds();

/// This process, with the CPU seconds that this thread has spent since it showed `started`.
Origin origin_since(double started);

/// The message that `make` gives, with its origin filled in.
template <class Make>
auto with_origin(Make&& make) {
  const double started = thread_cpu_seconds();
  auto message = std::forward<Make>(make)();
  message.origin = origin_since(started);
  return message;
}

}  // namespace evbal
