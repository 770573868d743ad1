// What the screen that compares is drawn from.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"
#include "tui/widgets/wireframe.hpp"
#include "updating/comparison/comparison.hpp"

namespace tapfit::tui {

struct CompareInput {
  const updating::Comparison& comparison;
  const signal::FrfSet& frfs;
  const Wireframe* wire = nullptr;
  /// For those without a partner, once they are at hand.
  const modal::ModeSet* modes = nullptr;
};

}  // namespace tapfit::tui
