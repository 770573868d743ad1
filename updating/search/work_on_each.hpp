// The same work on each of many hypotheses, on all cores.
#pragma once

#include "acquisition/foundation/parallel.hpp"
#include "acquisition/foundation/progress.hpp"

#include <atomic>
#include <cstddef>
#include <thread>

namespace tapfit::updating {

/// @param work on the n-th, of a Progress that only listens for the stop; the
///   calling thread alone reports
template <typename Work>
void work_on_each(std::size_t count,
                  const Progress& progress,
                  const Work& work) {
  const auto caller = std::this_thread::get_id();
  std::atomic<std::size_t> done = 0;
  for_each_parallel(count, [&](std::size_t n) {
    work(n, Progress{{}, progress.stop});
    ++done;
    if (std::this_thread::get_id() != caller) return;
    progress("fitting effects",
             static_cast<double>(done) / static_cast<double>(count));
  });
}

}  // namespace tapfit::updating
