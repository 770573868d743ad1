#include "acquisition/foundation/reuse_memory.hpp"

#include <cstdlib>  // says whether this is glibc

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace tapfit {

void reuse_memory() {
#ifdef __GLIBC__
  // The most that glibc takes; larger arrays are mapped on their own.
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
#endif
}

}  // namespace tapfit
