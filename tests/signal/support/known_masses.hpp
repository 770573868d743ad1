// A test whose sensors have masses that count.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "signal/frf_set/frf_set.hpp"

namespace tapfit::signal {

/// acc1 of 20 g, acc2 of a mass that nobody states.
inline acquisition::TestBundle bundle_with_masses() {
  acquisition::TestBundle bundle;
  bundle.channels.resize(3);
  bundle.channels[0].name = "hammer";
  bundle.channels[0].quantity = acquisition::Quantity::Force;
  bundle.channels[1].name = "acc1";
  bundle.channels[1].mass_kg = 0.02;
  bundle.channels[2].name = "acc2";
  return bundle;
}

/// One FRF of acc1 at its own hit point.
inline FrfSet frfs_with_masses() {
  Frf frf;
  frf.response = {.node = 12, .component = 3, .sign = 1};
  frf.reference = frf.response;
  frf.channel = 1;
  frf.H = Eigen::VectorXcd::Constant(2, {10.0, 0.0});
  frf.variance = Eigen::VectorXd::Constant(2, 0.01);
  frf.coherence = Eigen::VectorXd::Ones(2);
  FrfSet set;
  set.s = Eigen::VectorXcd::Constant(2, {0.0, 6.0});
  set.frfs = {frf};
  return set;
}

}  // namespace tapfit::signal
