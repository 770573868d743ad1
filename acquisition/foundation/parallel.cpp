#include "acquisition/foundation/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tapfit {
namespace {

// Whether this thread is at work on a piece, which gets no further threads.
thread_local bool within_piece = false;

// The failure of the lowest index. Pieces are begun in order, so that those
// below it have been begun and come to their own end.
class Failure {
 public:
  void keep(std::size_t index) {
    const std::lock_guard lock(guard_);
    if (exception_ && index > index_) return;
    exception_ = std::current_exception();
    index_ = index;
  }
  void throw_on() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::mutex guard_;
  std::exception_ptr exception_;
  std::size_t index_ = 0;
};

}  // namespace

void for_each_parallel(std::size_t count,
                       const std::function<void(std::size_t)>& work) {
  if (within_piece || count == 1) {
    for (std::size_t k = 0; k < count; ++k) work(k);
    return;
  }
  std::atomic<std::size_t> next = 0;
  Failure failure;
  const auto run = [&] {
    within_piece = true;
    for (std::size_t k = next++; k < count; k = next++) {
      try {
        work(k);
      } catch (...) {
        failure.keep(k);
        next = count;
      }
    }
    within_piece = false;
  };
  const std::size_t threads = std::min<std::size_t>(
      count, std::max(1U, std::thread::hardware_concurrency()));
  {
    std::vector<std::jthread> others;
    for (std::size_t k = 1; k < threads; ++k) others.emplace_back(run);
    run();
  }
  failure.throw_on();
}

void for_each_parallel(std::size_t count,
                       double operations,
                       const std::function<void(std::size_t)>& work) {
  constexpr double a_thread = 1e6;  // a few hundred microseconds
  if (operations > a_thread) {
    for_each_parallel(count, work);
  } else {
    for (std::size_t k = 0; k < count; ++k) work(k);
  }
}

}  // namespace tapfit
