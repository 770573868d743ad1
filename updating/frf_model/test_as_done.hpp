// The test as it was done: the sheet without the mistakes that are among a
// state's effects. Where a point was written down wrongly, the model is to be
// asked about the one that was hit or measured, and what moves with a sensor
// (its mass, its cable) acts there.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/effects/effect.hpp"
#include "updating/effects/effect_instance.hpp"
#include "updating/frf_model/model_response.hpp"

#include <memory>
#include <vector>

namespace tapfit::updating {

struct TestAsDone {
  effects::TestContext
      context;  ///< with the corrected sheet, where there is one
  /// What `setting` then points to; empty: the sheet is right.
  std::unique_ptr<const acquisition::TestBundle> sheet = {};
};

/// @param context of the sheet as it was written
[[nodiscard]] TestAsDone test_as_done(
    const effects::TestContext& context,
    const std::vector<EffectInstance>& effects);

/// What a pair was measured between; as written where the sheet does not hold
/// it.
[[nodiscard]] PairEnds ends_as_done(const MeasuredPair& pair,
                                    const acquisition::TestBundle& written,
                                    const acquisition::TestBundle& done);

}  // namespace tapfit::updating
