#include "tui/app/keep_work.hpp"

namespace tapfit::tui {

std::string keep_work(Workbench& bench,
                      Snapshot& known,
                      const Progress& progress,
                      const std::string& done) {
  const std::string failure = bench.save(known.hit_acts, progress);
  known.unsaved = !failure.empty();
  if (failure.empty()) return done;
  return done.empty() ? failure : done + "; " + failure;
}

}  // namespace tapfit::tui
