// Independent pieces of work on all cores.
#pragma once

#include <cstddef>
#include <functional>

namespace tapfit::updating {

/// Calls work(0) ... work(count - 1), each once, on as many threads as the
/// machine has cores; returns when all are done. The first exception is thrown
/// on after the rest have finished; pieces not yet begun are then left out.
///
/// @param work must be safe to call at once for different indices
void for_each_parallel(std::size_t count,
                       const std::function<void(std::size_t)>& work);

}  // namespace tapfit::updating
