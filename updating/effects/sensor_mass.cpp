#include "updating/effects/sensor_mass.hpp"

#include "updating/effects/deck_cards.hpp"
#include "updating/effects/point_effect.hpp"

#include <algorithm>
#include <set>

namespace tapfit::effects {
namespace {

// Index of the mass of a channel: its own, or the shared one.
std::size_t group_of(const Where& where, std::size_t position) {
  return where.variant == "each" ? position : 0;
}

// Sensor channels in the order of the channel table.
std::vector<std::string> sensor_channels(const acquisition::TestBundle& b) {
  std::set<std::size_t> used;
  for (const acquisition::Run& run : b.runs) {
    for (const acquisition::Placement& p : run.sensors) used.insert(p.channel);
  }
  std::vector<std::string> names;
  for (const std::size_t channel : used) {
    names.push_back(b.channels[channel].name);
  }
  return names;
}

}  // namespace

std::vector<Where> SensorMass::places(const Setting& setting) const {
  const std::vector<std::string> channels = sensor_channels(*setting.bundle);
  std::vector<Where> result;
  if (channels.empty()) return result;
  Where all;
  all.channels = channels;
  result.push_back(all);
  if (channels.size() == 1) return result;
  for (const std::string& channel : channels) {
    Where one;
    one.channels = {channel};
    result.push_back(one);
  }
  return result;
}

std::vector<ParameterSpec> SensorMass::parameters(
    const Where& where, const Setting& setting) const {
  const double start = std::min(0.02, 0.02 * setting.mass_kg);
  const double lower = 1e-5 * setting.mass_kg;
  const double upper = 0.5 * setting.mass_kg;
  if (where.variant != "each") return {{"mass_kg", start, lower, upper}};
  std::vector<ParameterSpec> specs;
  for (const std::string& channel : where.channels) {
    specs.push_back({"mass_kg." + channel, start, lower, upper});
  }
  return specs;
}

std::vector<ActedDof> SensorMass::acts_on(const Where& where,
                                          const Setting& setting,
                                          std::size_t run) const {
  std::vector<ActedDof> result;
  const acquisition::TestBundle& bundle = *setting.bundle;
  for (const acquisition::Placement& p : bundle.runs.at(run).sensors) {
    const auto it = std::find(where.channels.begin(),
                              where.channels.end(),
                              bundle.channels[p.channel].name);
    if (it == where.channels.end()) continue;
    const auto position = static_cast<std::size_t>(it - where.channels.begin());
    for (ActedDof dof : translations(p.dof.node)) {
      dof.group = group_of(where, position);
      result.push_back(dof);
    }
  }
  return result;
}

std::complex<double> SensorMass::law(std::complex<double> s,
                                     const std::vector<double>& p,
                                     std::size_t group) const {
  return s * s * p[group];
}

std::complex<double> SensorMass::law_derivative(std::complex<double> s,
                                                const std::vector<double>&,
                                                std::size_t group,
                                                std::size_t k) const {
  return group == k ? s * s : 0.0;
}

std::vector<std::string> SensorMass::bulk_data(
    const Where& where,
    const Setting& setting,
    const std::vector<double>& p) const {
  std::vector<std::string> cards = {
      "$ The sensors' mass, where they sat in the first run"};
  int offset = 0;
  std::set<int> done;
  for (const ActedDof& dof : acts_on(where, setting, 0)) {
    if (!done.insert(dof.node).second) continue;
    cards.push_back(
        point_mass_card(*setting.deck, offset++, dof.node, p[dof.group]));
  }
  return cards;
}

}  // namespace tapfit::effects
