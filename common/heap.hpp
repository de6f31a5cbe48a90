#pragma once

namespace evbal {

/// Lets the heap grow and shrink by 64 MiB at a time; for programs that plan. A plan allocates tens of megabytes and
/// frees them, and the kernel would take their pages back and clear them anew for every plan. Pages that nobody has
/// touched cost no memory.
void keep_heap_pages();

}  // namespace evbal
