#include "coordinator/convex/start.hpp"

#include <algorithm>
#include <functional>
#include <string_view>

namespace evbal {
namespace {

// FNV-1a over one more byte.
constexpr std::uint64_t mixed(std::uint64_t key, unsigned char byte) {
  return (key ^ byte) * 0x100000001b3;
}

}  // namespace

std::uint64_t key_of(const Name& name) {
  std::uint64_t key = 0xcbf29ce484222325;
  for (const char letter : name.what) {
    key = mixed(key, static_cast<unsigned char>(letter));
  }
  for (const int number : {name.step, name.i, name.j}) {
    for (int shift = 0; shift < 32; shift += 8) {
      key = mixed(key, static_cast<unsigned char>(static_cast<unsigned>(number) >> shift));
    }
  }
  return key;
}

const CurveStart* Start::of_curve(std::uint64_t above) const {
  const auto known = std::ranges::lower_bound(curves, above, {}, &CurveStart::above);
  return known != curves.end() && known->above == above ? &*known : nullptr;
}

}  // namespace evbal
