#include "common/heap.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <vector>

namespace evbal {
namespace {

// Pages that the kernel gave for 16 MiB in blocks too small to be mapped on their own, all freed again.
long pages_for_some_blocks() {
  rusage before{};
  getrusage(RUSAGE_SELF, &before);
  { const std::vector<std::vector<char>> blocks(256, std::vector<char>(64 << 10, 'x')); }
  rusage after{};
  getrusage(RUSAGE_SELF, &after);
  return after.ru_minflt - before.ru_minflt;
}

TEST(Heap, KeepsItsPages) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer has a heap of its own";
#endif
  keep_heap_pages();
  pages_for_some_blocks();
  EXPECT_LT(pages_for_some_blocks(), 100);
}

}  // namespace
}  // namespace evbal
