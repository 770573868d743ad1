// Two mistakes at once in one test, of the list of single ones.
#pragma once

#include "tests/updating/support/test_mistakes.hpp"

namespace tapfit::updating::testing {

/// Whether the two can be asked for together. Left out is a pair of which one
/// removes what the other needs:
///
///   - a hammer without signal, whose recordings are refused, beside anything;
///   - hits that mean nothing (a hammer overloaded, exchanged for a sensor,
///     triggered within the noise; times that run backwards or are in ms),
///     beside anything but what the samples alone show;
///   - a channel without a signal (cable off), or one that measures another
///     quantity, beside what its phase, its size or its place is told by;
///   - a cable off beside what is told by comparing sensors: of two sensors
///     none is left to compare with;
///   - two that record the same runs anew: one would undo the other;
///   - two factors on all FRFs, of which only the product shows.
[[nodiscard]] bool go_together(const Mistake& one, const Mistake& other);

/// Makes both: what records runs anew first, the copy of a run last.
void make_both(const Mistake& one,
               const Mistake& other,
               SheetAndRecords& test,
               const PlainOptions& options,
               double size,
               double other_size);

}  // namespace tapfit::updating::testing
