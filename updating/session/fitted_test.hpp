// A test with its current fit, as fits of several tests together need it.
#pragma once

#include "updating/fit/estimates.hpp"
#include "updating/fit/fitter.hpp"

#include <vector>

namespace tapfit::updating {

/// Valid as long as nothing changes in its session.
struct FittedTest {
  const Fitter& fitter;
  const Fit& deck;  ///< nothing fitted
  const Fit& fit;   ///< the current one
  const std::vector<PropertyName>& properties;
  effects::TestContext context;
};

}  // namespace tapfit::updating
