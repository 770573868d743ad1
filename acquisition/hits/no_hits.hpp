// Runs in which no hit was found, as an error that says which they are.
#pragma once

#include "acquisition/foundation/input_error.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace tapfit::acquisition {

struct HitlessRun {
  std::size_t run = 0;  ///< counted from 0
  InputError why;
};

/// Reads as what is wrong with the first of them.
class NoHits : public InputError {
 public:
  /// @param runs at least one
  explicit NoHits(std::vector<HitlessRun> runs)
      : InputError(runs.front().why), runs_(std::move(runs)) {}

  [[nodiscard]] const std::vector<HitlessRun>& runs() const { return runs_; }

 private:
  std::vector<HitlessRun> runs_;
};

}  // namespace tapfit::acquisition
