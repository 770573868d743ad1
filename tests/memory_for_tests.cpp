// Part of every test program and the benchmarks: they keep memory as the
// program does.
#include "acquisition/foundation/reuse_memory.hpp"

namespace {

[[maybe_unused]] const bool reused = [] {
  tapfit::reuse_memory();
  return true;
}();

}  // namespace
