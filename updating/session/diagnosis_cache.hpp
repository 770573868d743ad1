// What a diagnosis came to, kept on disk from one run of the program to the
// next: it takes a minute or more, and whoever opens the test again wants it.
//
// It is of one build of the program and of all that it follows from: the
// bundle, the model, the FRFs and modes, the effects in the model.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"
#include "updating/cache/matrix_cache.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/measurement/mode_choices.hpp"
#include "updating/session/effect_stack.hpp"
#include "updating/structure/deck/deck.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace tapfit::updating {

/// What a diagnosis follows from, the effects in the model aside.
struct DiagnosisContent {
  const acquisition::TestBundle& bundle;
  const structure::Deck& deck;
  const signal::FrfSet& frfs;
  const modal::ModeSet& modes;
  const std::vector<PairByHand>& pairs;  ///< which modes as data are fitted to
};

/// The place of one diagnosis on disk.
class DiagnosisCache {
 public:
  /// @param cache empty: nothing is found and nothing kept
  /// @param history of the model's effects
  /// @param effects how many of those that are on, from the first
  DiagnosisCache(std::optional<MatrixCache> cache,
                 const DiagnosisContent& content,
                 const EffectHistory& history,
                 std::size_t effects);

  /// @return none where none was kept, or what was is damaged
  [[nodiscard]] std::optional<Diagnosis> load() const;
  /// Keeps it where that is possible, in place of what was kept.
  void keep(const Diagnosis& diagnosis) const;
  /// What is kept, or what is made now and kept then where that is possible.
  [[nodiscard]] Diagnosis kept_or_made(
      const std::function<Diagnosis()>& make) const;

 private:
  std::optional<MatrixCache> cache_;
  Digest key_{};
};

}  // namespace tapfit::updating
