// Draws practice cases: a structure, what is hidden in it and how large, all
// from one seed. Sizes are scaled by the structure, so that what is hidden is
// felt but not gross.
#pragma once

#include "updating/diagnosis.hpp"
#include "updating/structure/deck.hpp"
#include "updating/virtual_bundle.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tapfit::updating {

/// What a case may hide: the catalogue's effects, "none", pairs joined with
/// "+", and "strut", which is no effect of the catalogue.
[[nodiscard]] const std::vector<std::string>& hidden_kinds();

/// @param kind one of hidden_kinds()
[[nodiscard]] VirtualBundleSpec draw_hidden_case(const std::string& kind,
                                                 std::uint64_t seed);

/// How a diagnosis compares with what was hidden.
struct Verdict {
  std::string hidden;  ///< "none", "a", "a+b"; "strut" should be unexplained
  std::string found;   ///< the diagnosis's verdict
  bool right_kind = false;
  bool right_place = false;  ///< of every hidden effect, within one element
  double size_error = 0.0;   ///< largest relative error of a first parameter
  double error = 0.0;        ///< after the diagnosis
  double floor = 0.0;
  /// Of the first parameters of effects found: whether 95 % intervals hold.
  int intervals = 0;
  int intervals_hold = 0;
};

/// @param deck the engineer's model that the diagnosis was made with
[[nodiscard]] Verdict judge(const VirtualBundleSpec& hidden,
                            const Diagnosis& diagnosis,
                            const structure::Deck& deck);

}  // namespace tapfit::updating
