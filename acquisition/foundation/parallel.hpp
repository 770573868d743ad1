// Independent pieces of work on all cores.
#pragma once

#include <cstddef>
#include <functional>

namespace tapfit {

/// Calls work(0) ... work(count - 1), each once, on as many threads as the
/// machine has cores (as the process may use); returns when all are done.
/// Called from within such a piece, it does its work on that one thread.
///
/// The exception of the lowest index is thrown on after the rest have finished,
/// so that it is the same one every time; pieces not yet begun are then left
/// out.
///
/// @param work must be safe to call at once for different indices
void for_each_parallel(std::size_t count,
                       const std::function<void(std::size_t)>& work);

/// The same, but on this thread alone where all pieces together are less work
/// than starting another.
///
/// @param operations about how many, of all pieces
void for_each_parallel(std::size_t count,
                       double operations,
                       const std::function<void(std::size_t)>& work);

}  // namespace tapfit
