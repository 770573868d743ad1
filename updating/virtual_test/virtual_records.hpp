// What happens in each run of a virtual test before it is recorded: the hits,
// and the motion that they cause.
#pragma once

#include "acquisition/bundle/channel.hpp"
#include "acquisition/foundation/progress.hpp"
#include "acquisition/simulator/exact_response.hpp"
#include "acquisition/simulator/hammer_pulse.hpp"
#include "updating/virtual_test/virtual_setup.hpp"
#include "updating/virtual_test/virtual_spec.hpp"
#include "updating/virtual_test/virtual_structure.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

struct VirtualRecords {
  std::vector<std::vector<acquisition::HammerPulse>> pulses;
  std::vector<acquisition::SecondOrderSystem> systems;  ///< one per run
  std::vector<Eigen::MatrixXd> responses;  ///< n_samples x channels, per run
  ReducedTruth first;
};

/// All runs, with ordinary hits.
[[nodiscard]] VirtualRecords make_records(const VirtualBundleSpec& spec,
                                          const VirtualSetup& setup,
                                          const VirtualStructure& structure,
                                          const Progress& progress);

/// A hand that hits twice in one run and far too hard in another; of two runs
/// or more.
void spoil_hits(const VirtualBundleSpec& spec,
                const VirtualSetup& setup,
                const std::vector<acquisition::Channel>& channels,
                VirtualRecords& records);

}  // namespace tapfit::updating
