// Several tests fitted together: one structure with and without a known mass,
// held in two ways, before and after a change; several structures on one rig.
// What they share is one number, what each has for itself its own.
#pragma once

#include "updating/effects/effect_ref.hpp"
#include "updating/fit/estimate.hpp"
#include "updating/fit/joint_fit.hpp"
#include "updating/session/session.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::updating {

/// What is fitted, beside what each test.json calls uncertain.
struct TogetherChoice {
  std::vector<EffectRef> shared = {};  ///< one size in all tests
  std::vector<EffectRef> each = {};    ///< in all tests, each with its own size
  /// In one test, counted from 0.
  std::vector<std::pair<std::size_t, EffectRef>> single = {};
  /// Uncertain properties of that name are each test's own.
  std::vector<std::string> own = {};
  /// Tests of several structures: they share effects alone, neither properties
  /// nor what their decks are wrong by in form.
  bool structures = false;
};

struct SharedEstimate {
  Estimate together;
  std::vector<std::optional<Estimate>> alone;  ///< of the tests that have it
  Agreement agreement;                         ///< of these
};

struct TestTogether {
  double deck_error = 0.0;   ///< nothing fitted
  double alone_error = 0.0;  ///< fitted by itself
  double error = 0.0;        ///< fitted with the others
  double floor = 0.0;
  std::vector<Estimate> own;  ///< of what it does not share

  /// Whether what is shared fits this test, too: it leaves no more than it does
  /// by itself and noise, mesh and form may add to that.
  [[nodiscard]] bool agrees() const;
};

struct TestsTogether {
  std::vector<SharedEstimate> shared;
  std::vector<TestTogether> tests;
  bool converged = false;
  std::string message;  ///< why the fit stopped

  [[nodiscard]] bool agree() const;
};

/// Fits each test by itself, then all together.
///
/// @param sessions two or more, in which nothing was added yet; afterwards they
///   have the effects, as fitted by themselves
/// @param names of the tests, for messages
/// @throws InputError where they share nothing, or an effect has no such place
///   or another number of sizes in one of them
[[nodiscard]] TestsTogether fit_tests_together(
    std::vector<Session>& sessions,
    const std::vector<std::string>& names,
    const TogetherChoice& choice,
    const Progress& progress = {});

}  // namespace tapfit::updating
