#include "modal/sensor_shifts.hpp"

#include "modal/shape_uncertainty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace tapfit::modal {
namespace {

using Eigen::Index;

/// Channels that share a grid in some set-up, joined.
std::vector<std::vector<std::size_t>> group_channels(const signal::FrfSet& frfs,
                                                     const Curves& curves) {
  std::map<std::pair<std::size_t, int>, std::set<std::size_t>> at_grid;
  for (std::size_t f = 0; f < curves.source.size(); ++f) {
    at_grid[{curves.set_up[f], curves.response[f].node}].insert(
        frfs.frfs[curves.source[f]].channel);
  }
  std::vector<std::set<std::size_t>> groups;
  for (const auto& [place, channels] : at_grid) {
    std::set<std::size_t> joined = channels;
    std::erase_if(groups, [&joined](const std::set<std::size_t>& group) {
      const bool shares = std::ranges::any_of(
          group, [&](std::size_t c) { return joined.contains(c); });
      if (shares) joined.insert(group.begin(), group.end());
      return shares;
    });
    groups.push_back(joined);
  }
  std::ranges::sort(groups);
  std::vector<std::vector<std::size_t>> result;
  for (const auto& group : groups) {
    result.emplace_back(group.begin(), group.end());
  }
  return result;
}

/// Rows of the shapes where a sensor sits in a set-up; empty when a point is
/// not in the shapes.
std::optional<std::vector<Index>> rows_of_sensor(
    const signal::FrfSet& frfs,
    const Curves& curves,
    const std::vector<Dof>& dofs,
    const std::vector<std::size_t>& channels,
    std::size_t set_up) {
  std::set<Index> rows;
  for (std::size_t f = 0; f < curves.source.size(); ++f) {
    const std::size_t channel = frfs.frfs[curves.source[f]].channel;
    if (curves.set_up[f] != set_up ||
        std::ranges::find(channels, channel) == channels.end()) {
      continue;
    }
    const auto own = std::ranges::find(dofs, curves.response[f]);
    if (own == dofs.end()) return std::nullopt;
    rows.insert(own - dofs.begin());
  }
  return std::vector<Index>(rows.begin(), rows.end());
}

void fill_poles(const RunModes& runs, ShiftData& data) {
  const auto set_ups = static_cast<Index>(runs.set_ups.size());
  const Index modes = runs.poles.size();
  data.log_omega = Eigen::MatrixXd::Zero(set_ups, modes);
  data.log_sd = Eigen::MatrixXd::Zero(set_ups, modes);
  data.damping.resize(modes);
  for (Index r = 0; r < modes; ++r) {
    data.damping(r) = -runs.poles(r).real() / std::abs(runs.poles(r));
    for (Index k = 0; k < set_ups; ++k) {
      const SetUpPoles& own = runs.set_ups[static_cast<std::size_t>(k)];
      const double size = std::abs(own.poles(r));
      if (!(size > 0.0)) continue;
      data.log_omega(k, r) = std::log(size);
      data.log_sd(k, r) = own.log_sd(r);
    }
  }
}

std::string grams(double kg) { return fmt::format("{:.3g}", 1e3 * kg); }

std::string masses_text(const PoleShifts& shifts,
                        const std::vector<std::string>& channels) {
  std::string text;
  for (std::size_t m = 0; m < shifts.masses.size(); ++m) {
    const MassEstimate& mass = shifts.masses[m];
    text += fmt::format("{}{} g (95 %: {} to {} g)",
                        m == 0 ? "" : ", ",
                        grams(mass.kg),
                        grams(mass.lo95_kg),
                        grams(mass.hi95_kg));
    if (shifts.masses.size() < 2) {
      if (shifts.sensors.size() > 1) text += " each";
      continue;
    }
    const std::size_t channel = shifts.sensors[m].front();
    text += " of " + (channel < channels.size()
                          ? channels[channel]
                          : fmt::format("channel {}", channel + 1));
  }
  return text;
}

std::string mass_statement(const PoleShifts& shifts,
                           const std::vector<std::string>& channels) {
  const std::string start = fmt::format(
      "frequencies move by up to {:.2g} % with the sensors in proportion to "
      "the squared shape (p = {:.1g})",
      100.0 * shifts.largest,
      shifts.p_mass);
  if (shifts.masses.empty()) {
    return start +
           ": the sensors' mass loads the structure; how large it is cannot be "
           "told from shapes without a scale, for which a hit next to a sensor "
           "is needed";
  }
  std::string text =
      start + ": the sensors' mass, " + masses_text(shifts, channels);
  if (shifts.same_fraction > 0.0) {
    text += fmt::format(
        "; besides, all modes move by the same {:.2g} % (rms), as with "
        "temperature",
        100.0 * shifts.same_fraction);
  }
  return text;
}

}  // namespace

std::optional<PoleShifts> sensor_shifts(const signal::FrfSet& frfs,
                                        const Curves& curves,
                                        const ShapeGraph& graph,
                                        const RunModes& runs) {
  ShiftData data;
  data.scaled = graph.scaled;
  fill_poles(runs, data);
  const Eigen::MatrixXcd shapes =
      mode_shapes(graph, runs.residues, runs.poles, runs.frf_weight);
  // Half of E|dphi|^2 is in the real part.
  const Eigen::MatrixXd sd =
      std::numbers::sqrt2 / 2.0 *
      shape_deviations(
          graph, runs.residues, runs.residue_variance, runs.poles, shapes);
  const auto sensors = group_channels(frfs, curves);
  for (const auto& channels : sensors) {
    data.phi.emplace_back();
    data.phi_sd.emplace_back();
    for (const SetUpPoles& own : runs.set_ups) {
      const auto rows =
          rows_of_sensor(frfs, curves, graph.dofs, channels, own.set_up);
      if (!rows) return std::nullopt;
      data.phi.back().push_back(shapes(*rows, Eigen::all).real());
      data.phi_sd.back().push_back(sd(*rows, Eigen::all));
    }
  }
  std::optional<PoleShifts> shifts = explain_shifts(data);
  if (shifts) shifts->sensors = sensors;
  return shifts;
}

bool is_telling(const std::optional<PoleShifts>& shifts) {
  return shifts && shifts->cause != ShiftCause::Noise;
}

std::string statement(const PoleShifts& shifts,
                      const std::vector<std::string>& channels) {
  switch (shifts.cause) {
    case ShiftCause::Noise:
      return {};
    case ShiftCause::SensorMass:
      return mass_statement(shifts, channels);
    case ShiftCause::SameFraction:
      return fmt::format(
          "frequencies move by up to {:.2g} % between set-ups, all modes by "
          "the same fraction: not like a sensor's mass, but as with "
          "temperature or tension",
          100.0 * shifts.largest);
    case ShiftCause::Unknown:
      break;
  }
  return fmt::format(
      "frequencies move by up to {:.2g} % between set-ups, not in proportion "
      "to the squared shape: not like a sensor's mass",
      100.0 * shifts.largest);
}

}  // namespace tapfit::modal
