// The channels of a virtual test: their sensitivities, and what is wrong with
// them or their chains.
#pragma once

#include "acquisition/bundle/channel.hpp"
#include "acquisition/simulator/analogue_chain.hpp"
#include "updating/virtual_test/virtual_setup.hpp"
#include "updating/virtual_test/virtual_spec.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::updating {

/// Hammer first.
[[nodiscard]] std::vector<std::string> channel_names(const VirtualSetup& setup);

/// The value of an effect on a channel; without one `otherwise`, of one without
/// values -otherwise.
[[nodiscard]] double channel_effect(const VirtualBundleSpec& spec,
                                    const std::string& name,
                                    const std::string& channel,
                                    double otherwise);

/// What a channel's readings are off by, its polarity aside.
[[nodiscard]] double gain_of(const VirtualBundleSpec& spec,
                             const std::string& channel);

/// With sensitivities at which no response goes over full scale.
/// @param responses of each run, n_samples x channels [N, m/s^2]
[[nodiscard]] std::vector<acquisition::Channel> make_channels(
    const VirtualBundleSpec& spec,
    const VirtualSetup& setup,
    const std::vector<Eigen::MatrixXd>& responses);

/// Gain, noise, hum and drift of each channel.
[[nodiscard]] std::vector<acquisition::AnalogueChannel> make_chains(
    const VirtualBundleSpec& spec,
    const VirtualSetup& setup,
    const std::vector<acquisition::Channel>& channels);

}  // namespace tapfit::updating
