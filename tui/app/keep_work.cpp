#include "tui/app/keep_work.hpp"

#include <utility>

namespace tapfit::tui {
namespace {

bool catch_up(Workbench& bench, Snapshot& known, const Progress& progress) {
  const auto acts = bench.catch_up(progress);
  if (!acts) return false;
  known.hit_acts = *acts;
  known.forget_from_hits();
  known.effects = bench.effects();
  return true;
}

std::string behind(const std::string& first, const std::string& then) {
  if (first.empty() || then.empty()) return first + then;
  return first + "; " + then;
}

}  // namespace

Job kept(const std::string& title, Change change) {
  return {title,
          [change = std::move(change)](
              Workbench& bench, Snapshot& known, const Progress& progress) {
            std::string joined;
            while (true) {
              if (catch_up(bench, known, progress)) {
                joined = "what another window did is taken over";
              }
              const std::string done = change(bench, known, progress);
              const Saving saving = bench.save(known.hit_acts, progress);
              if (saving.overtaken) continue;
              known.unsaved = !saving.failure.empty();
              return behind(behind(joined, done), saving.failure);
            }
          },
          std::nullopt};
}

}  // namespace tapfit::tui
