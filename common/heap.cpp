#include "common/heap.hpp"

#include <malloc.h>

namespace evbal {

void keep_heap_pages() {
  constexpr int bytes = 64 << 20;
  mallopt(M_TOP_PAD, bytes);
}

}  // namespace evbal
