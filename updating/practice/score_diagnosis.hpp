// Judges a diagnosis against what a practice case hides.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <string>

namespace tapfit::updating {

/// How a diagnosis compares with what was hidden.
struct DiagnosisScore {
  /// "none", "a", "a+b"; "strut" and "drift" should be unexplained.
  std::string hidden;
  std::string found;  ///< the diagnosis's verdict
  bool right_kind = false;
  /// What it says is true, though it says less than it might: "unexplained",
  /// or groups of kinds that hold the hidden ones.
  bool honest = false;
  bool right_place = false;  ///< of every hidden effect, within one element
  bool right_size = false;   ///< of every one, within 5 % or its interval
  bool at_floor = false;     ///< error within 1.3 times the floor
  double size_error = 0.0;   ///< largest relative error of a first parameter
  double error = 0.0;        ///< after the diagnosis
  double floor = 0.0;
  /// Of the first parameters of effects found: whether 95 % intervals hold.
  int intervals = 0;
  int intervals_hold = 0;

  /// Right in everything that was asked for.
  [[nodiscard]] bool right() const {
    return right_kind && right_place && right_size && at_floor;
  }
};

/// @param deck the engineer's model that the diagnosis was made with
[[nodiscard]] DiagnosisScore score_diagnosis(const VirtualBundleSpec& hidden,
                                             const Diagnosis& diagnosis,
                                             const structure::Deck& deck);

}  // namespace tapfit::updating
