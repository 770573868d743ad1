#include "modal/checks/modal_mass.hpp"

#include "acquisition/foundation/unit_slips.hpp"
#include "acquisition/samples/statistics.hpp"
#include "modal/checks/modal_constants.hpp"
#include "modal/checks/run_poles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double far = 20.0;         // of z m from 1: no structure explains it
constexpr double far_apart = 100.0;  // two sensors of one test

// Of z m, which is 16 at the corners of plates and less near supports: the
// units that leave a factor within it, in brackets; empty for none.
std::string units_behind(double factor) {
  constexpr double most_of_structure = 16.0;
  constexpr double least_of_structure = 1.0 / 3.0;
  const std::string units = acquisition::units_between(
      factor / most_of_structure, factor / least_of_structure);
  return units.empty() ? units : " (" + units + ")";
}

// Between two sensors either may be the one that moves more.
std::string units_between_sensors(double factor) {
  constexpr double either = 3.0;
  const std::string units =
      acquisition::units_between(factor / either, factor * either);
  return units.empty() ? units : " (" + units + ")";
}

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
  return {Severity::Error,
          {{}, all ? std::string() : who, {}, {}},
          fmt::format("the resonances of {} are those of a mass of {} kg; "
                      "the structure has {:.3g} kg",
                      who,
                      in_digits(mass_kg / factor, 2),
                      mass_kg),
          fmt::format("{} against {} reads about {} times too {}: a unit{}",
                      who,
                      hammer_name(bundle),
                      in_digits(factor > 1.0 ? factor : 1.0 / factor, 2),
                      factor > 1.0 ? "much" : "little",
                      units_behind(factor)),
          fmt::format("check unit, sensitivity and sensitivity_unit of {} and "
                      "{} in test.json",
                      all ? std::string("all sensors") : who,
                      hammer_name(bundle))};
}

Finding against_others(const acquisition::TestBundle& bundle,
                       const ChannelSize& one,
                       double factor) {
  const std::string& who = bundle.channels.at(one.channel).name;
  return {Severity::Warning,
          {{}, who, {}, {}},
          fmt::format("its resonances are {} times as {} as those of the "
                      "other sensors",
                      in_digits(factor > 1.0 ? factor : 1.0 / factor, 2),
                      factor > 1.0 ? "high" : "low"),
          fmt::format("a unit{}, or a place where the structure hardly moves",
                      units_between_sensors(factor)),
          fmt::format("check unit, sensitivity and sensitivity_unit of {} in "
                      "test.json",
                      who)};
}

// Geometric mean of z m.
double mean_factor(const std::vector<ChannelSize>& sizes, double mass_kg) {
  double log_sum = 0.0;
  for (const ChannelSize& one : sizes) log_sum += std::log(one.z_per_kg);
  return mass_kg * std::exp(log_sum / static_cast<double>(sizes.size()));
}

}  // namespace

bool have_mass(const std::vector<ChannelSize>& sizes, double mass_kg) {
  if (sizes.empty()) return true;
  const double factor = mean_factor(sizes, mass_kg);
  return factor <= far && factor >= 1.0 / far;
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
    findings.push_back(
        against_mass(bundle, off, mean_factor(off, mass_kg), mass_kg));
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
    std::vector<ChannelSize> others = sizes;
    std::erase_if(others, [&one](const ChannelSize& other) {
      return other.channel == one.channel;
    });
    const double factor = one.z_per_kg / mean_factor(others, 1.0);
    // Of two both are named; of more the one that differs.
    if (factor < far_apart && factor > 1.0 / far_apart) continue;
    findings.push_back(against_others(bundle, one, factor));
    if (sizes.size() == 2) break;
  }
  return findings;
}

}  // namespace tapfit::modal
