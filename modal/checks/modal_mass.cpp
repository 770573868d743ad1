#include "modal/checks/modal_mass.hpp"

#include "acquisition/samples/statistics.hpp"
#include "modal/checks/modal_constants.hpp"
#include "modal/checks/run_poles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double far = 20.0;         // of z m from 1: no structure explains it
constexpr double far_apart = 100.0;  // two sensors of one test

struct Known {
  double factor;
  const char* words;
};

constexpr std::array<Known, 7> factors{{
    {4.448, "lbf for N"},
    {9.807, "g for m/s^2, or kgf for N"},
    {25.4, "in for mm"},
    {39.37, "in for m"},
    {386.1, "g for in/s^2"},
    {1000.0, "kN for N, mm for m, or mV for V"},
    {9807.0, "g for mm/s^2"},
}};

std::string hammer_name(const acquisition::TestBundle& bundle) {
  return bundle.channels.at(bundle.runs.front().hammer.channel).name;
}

Finding against_mass(const acquisition::TestBundle& bundle,
                     const std::vector<ChannelSize>& sizes,
                     double factor,
                     double mass_kg) {
  const bool all = sizes.size() > 1;
  const std::string who = all ? std::string("the sensors")
                              : bundle.channels.at(sizes.front().channel).name;
  const std::string unit = unit_factor(factor, 3.0);
  return {Severity::Error,
          {{}, all ? std::string() : who, {}, {}},
          fmt::format("the resonances of {} are those of a mass of {:.2g} kg; "
                      "the structure has {:.3g} kg",
                      who,
                      mass_kg / factor,
                      mass_kg),
          fmt::format("{} against {} reads about {:.2g} times too {}: a unit{}",
                      who,
                      hammer_name(bundle),
                      factor > 1.0 ? factor : 1.0 / factor,
                      factor > 1.0 ? "much" : "little",
                      unit.empty() ? std::string() : " (" + unit + ")"),
          fmt::format("check unit, sensitivity and sensitivity_unit of {} and "
                      "{} in test.json",
                      all ? std::string("all sensors") : who,
                      hammer_name(bundle))};
}

Finding against_others(const acquisition::TestBundle& bundle,
                       const ChannelSize& one,
                       double factor) {
  const std::string& who = bundle.channels.at(one.channel).name;
  const std::string unit = unit_factor(factor, 3.0);
  return {Severity::Warning,
          {{}, who, {}, {}},
          fmt::format("its resonances are {:.2g} times as {} as those of the "
                      "other sensors",
                      factor > 1.0 ? factor : 1.0 / factor,
                      factor > 1.0 ? "high" : "low"),
          fmt::format("a unit{}, or a place where the structure hardly moves",
                      unit.empty() ? std::string() : " (" + unit + ")"),
          fmt::format("check unit, sensitivity and sensitivity_unit of {} in "
                      "test.json",
                      who)};
}

}  // namespace

std::string unit_factor(double factor, double within) {
  const double size = factor > 1.0 ? factor : 1.0 / factor;
  std::string words;
  for (const Known& known : factors) {
    const double off = size / known.factor;
    if (off > within || off < 1.0 / within) continue;
    words += fmt::format(
        "{}{:.4g}: {}", words.empty() ? "" : "; ", known.factor, known.words);
  }
  return words;
}

std::vector<ChannelSize> channel_sizes(const signal::FrfSet& set,
                                       const ModeSet& modes) {
  const std::vector<ModalConstants> of =
      modal_constants(set, poles_of(modes), false);
  const auto count = static_cast<Index>(modes.modes.size());
  std::map<std::size_t, VectorXd> squares;
  std::map<std::size_t, int> frfs;
  for (std::size_t f = 0; f < of.size(); ++f) {
    // Across the blows a structure may hardly move.
    if (set.frfs[f].response.component != set.frfs[f].reference.component) {
      continue;
    }
    const std::size_t channel = set.frfs[f].channel;
    VectorXd& sum = squares[channel];
    if (sum.size() == 0) sum = VectorXd::Zero(count);
    sum += of[f].z.cwiseAbs2();
    ++frfs[channel];
  }
  std::vector<ChannelSize> sizes;
  for (const auto& [channel, sum] : squares) {
    sizes.push_back(
        {channel, acquisition::median((sum / frfs[channel]).cwiseSqrt())});
  }
  return sizes;
}

std::vector<Finding> modal_mass_findings(const acquisition::TestBundle& bundle,
                                         const signal::FrfSet& set,
                                         const ModeSet& modes,
                                         double mass_kg) {
  if (modes.modes.empty() || bundle.runs.empty()) return {};
  const std::vector<ChannelSize> sizes = channel_sizes(set, modes);
  if (sizes.empty()) return {};
  std::vector<Finding> findings;
  std::vector<ChannelSize> off;
  for (const ChannelSize& one : sizes) {
    const double factor = one.z_per_kg * mass_kg;
    if (mass_kg > 0.0 && (factor > far || factor < 1.0 / far)) {
      off.push_back(one);
    }
  }
  if (off.size() == sizes.size()) {
    double log_sum = 0.0;
    for (const ChannelSize& one : off) {
      log_sum += std::log(one.z_per_kg * mass_kg);
    }
    findings.push_back(
        against_mass(bundle,
                     off,
                     std::exp(log_sum / static_cast<double>(off.size())),
                     mass_kg));
    return findings;
  }
  for (const ChannelSize& one : off) {
    // A single one may sit where the structure hardly moves.
    if (one.z_per_kg * mass_kg < 1.0) continue;
    findings.push_back(
        against_mass(bundle, {one}, one.z_per_kg * mass_kg, mass_kg));
  }
  if (!findings.empty() || !off.empty() || sizes.size() < 2) return findings;
  for (const ChannelSize& one : sizes) {
    double log_sum = 0.0;
    for (const ChannelSize& other : sizes) {
      if (other.channel != one.channel) log_sum += std::log(other.z_per_kg);
    }
    const double factor =
        one.z_per_kg /
        std::exp(log_sum / static_cast<double>(sizes.size() - 1));
    // Of two both are named; of more the one that differs.
    if (factor < far_apart && factor > 1.0 / far_apart) continue;
    findings.push_back(against_others(bundle, one, factor));
    if (sizes.size() == 2) break;
  }
  return findings;
}

}  // namespace tapfit::modal
