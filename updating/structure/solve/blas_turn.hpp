// CHOLMOD's dense kernels come from whatever BLAS the system has chosen.
//
// OpenBLAS built without threads hands out its buffers without a lock: two
// callers at once get each other's numbers, without a word (its README,
// "Multi-threaded usage"). Built with threads it is safe, and works on as many
// cores as it finds; they are given out where the work is divided, so that it
// gets one. The reference BLAS has no state.
#pragma once

#include <mutex>

namespace tapfit::structure {

/// To be held while a BLAS is called: a lock where it is not safe for several
/// threads, else none.
[[nodiscard]] std::unique_lock<std::mutex> blas_turn();

}  // namespace tapfit::structure
