#include "updating/virtual_test/virtual_channels.hpp"

#include "acquisition/simulator/virtual_test.hpp"

#include <cmath>

namespace tapfit::updating {
namespace {

constexpr double full_scale_volts = 5.0;

// An ordinary hit stays below full scale by this factor, with its scatter
// already in it.
constexpr double headroom = 1.25;

acquisition::Channel make_channel(const VirtualBundleSpec& spec,
                                  const std::string& name,
                                  double largest) {
  acquisition::Channel channel;
  channel.name = name;
  const bool force = name == "hammer";
  channel.quantity = force ? acquisition::Quantity::Force
                           : acquisition::Quantity::Acceleration;
  channel.unit = force ? "N" : "m/s^2";
  channel.full_scale_volts = full_scale_volts;
  channel.sensitivity =
      acquisition::choose_sensitivity(largest, full_scale_volts, headroom);
  if (!force) channel.mass_kg = spec.stated_mass_kg;
  return channel;
}

}  // namespace

std::vector<std::string> channel_names(const VirtualSetup& setup) {
  std::vector<std::string> names{"hammer"};
  names.insert(
      names.end(), setup.sensor_channels.begin(), setup.sensor_channels.end());
  return names;
}

double channel_effect(const VirtualBundleSpec& spec,
                      const std::string& name,
                      const std::string& channel,
                      double otherwise) {
  for (const VirtualEffect& effect : spec.effects) {
    if (effect.name == name && effect.places.front() == channel) {
      return effect.values.empty() ? -otherwise : effect.values[0];
    }
  }
  return otherwise;
}

double gain_of(const VirtualBundleSpec& spec, const std::string& channel) {
  return std::abs(channel_effect(spec, "channel-gain", channel, 1.0));
}

std::vector<acquisition::Channel> make_channels(
    const VirtualBundleSpec& spec,
    const VirtualSetup& setup,
    const std::vector<Eigen::MatrixXd>& responses) {
  const std::vector<std::string> names = channel_names(setup);
  Eigen::RowVectorXd largest =
      Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(names.size()));
  for (const Eigen::MatrixXd& response : responses) {
    largest = largest.cwiseMax(response.cwiseAbs().colwise().maxCoeff());
  }
  for (std::size_t c = 0; c < names.size(); ++c) {
    largest(static_cast<Eigen::Index>(c)) *= gain_of(spec, names[c]);
  }
  // One kind of accelerometer: all have the sensitivity that the hardest
  // pressed of them needs, so that it does not tell whose gain is off.
  const double acceleration = largest.tail(largest.size() - 1).maxCoeff();
  std::vector<acquisition::Channel> channels;
  for (std::size_t c = 0; c < names.size(); ++c) {
    channels.push_back(
        make_channel(spec, names[c], c == 0 ? largest(0) : acceleration));
  }
  return channels;
}

std::vector<acquisition::AnalogueChannel> make_chains(
    const VirtualBundleSpec& spec,
    const VirtualSetup& setup,
    const std::vector<acquisition::Channel>& channels) {
  // Noise grows with the square root of the bandwidth.
  const double root_band = std::sqrt(setup.recorder.rate_hz / 2.0);
  std::vector<acquisition::AnalogueChannel> chains;
  for (const acquisition::Channel& channel : channels) {
    const bool force = channel.quantity == acquisition::Quantity::Force;
    acquisition::AnalogueChannel chain;
    chain.full_scale = channel.full_scale_si();
    chain.gain = channel_effect(spec, "channel-gain", channel.name, 1.0) *
                 channel_effect(spec, "channel-polarity", channel.name, 1.0);
    chain.noise_rms = spec.noise * (force ? 5e-4 : 2e-4) * root_band;
    chain.hum = force ? 0.006 : 0.004;
    chain.offset = 1e-3 * chain.full_scale;
    chain.drift = 0.03;
    chains.push_back(chain);
  }
  return chains;
}

}  // namespace tapfit::updating
