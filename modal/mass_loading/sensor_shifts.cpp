#include "modal/mass_loading/sensor_shifts.hpp"

#include "modal/fit/shape_uncertainty.hpp"
#include "modal/mass_loading/explain_shifts.hpp"

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
std::vector<std::vector<std::size_t>> group_channels(
    const signal::FrfSet& frfs, const WeightedFrfs& curves) {
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
    const WeightedFrfs& curves,
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

/// Modes whose mean frequency lies in the band; those beside it are known too
/// poorly to tell of shifts.
std::vector<Index> modes_in_band(const WeightedFrfs& curves,
                                 const MultiSetupModes& runs) {
  std::vector<Index> kept;
  for (Index r = 0; r < runs.poles.size(); ++r) {
    const double omega = std::abs(runs.poles(r));
    if (omega >= curves.s(0).imag() &&
        omega <= curves.s(curves.lines() - 1).imag()) {
      kept.push_back(r);
    }
  }
  return kept;
}

void fill_poles(const MultiSetupModes& runs,
                const std::vector<Index>& kept,
                ShiftData& data) {
  const auto set_ups = static_cast<Index>(runs.set_ups.size());
  const auto modes = static_cast<Index>(kept.size());
  data.log_omega = Eigen::MatrixXd::Zero(set_ups, modes);
  data.log_sd = Eigen::MatrixXd::Zero(set_ups, modes);
  const Eigen::VectorXcd poles = runs.poles(kept);
  data.damping = -poles.real().cwiseQuotient(poles.cwiseAbs());
  for (Index k = 0; k < set_ups; ++k) {
    const SetUpPoles& own = runs.set_ups[static_cast<std::size_t>(k)];
    for (Index r = 0; r < modes; ++r) {
      const double size =
          std::abs(own.poles(kept[static_cast<std::size_t>(r)]));
      if (!(size > 0.0)) continue;
      data.log_omega(k, r) = std::log(size);
      data.log_sd(k, r) = own.log_sd(kept[static_cast<std::size_t>(r)]);
    }
  }
}

/// The set-up with a driving point, and the shapes at the hammer's point in all
/// set-ups that were hit there and nowhere else.
void fill_hammer(const WeightedFrfs& curves,
                 const MultiSetupModes& runs,
                 const std::vector<Dof>& dofs,
                 const Eigen::MatrixXcd& shapes,
                 ShiftData& data) {
  std::map<std::size_t, std::set<Dof>> hit;
  std::map<std::size_t, std::set<Dof>> driving;
  for (std::size_t f = 0; f < curves.source.size(); ++f) {
    hit[curves.set_up[f]].insert(curves.reference[f]);
    if (curves.response[f] == curves.reference[f]) {
      driving[curves.set_up[f]].insert(curves.reference[f]);
    }
  }
  data.hammer.assign(runs.set_ups.size(), Eigen::MatrixXd(0, shapes.cols()));
  if (driving.size() != 1 || driving.begin()->second.size() != 1) return;
  const Dof point = *driving.begin()->second.begin();
  const auto own = std::ranges::find(dofs, point);
  if (own == dofs.end()) return;
  for (std::size_t k = 0; k < runs.set_ups.size(); ++k) {
    const std::size_t set_up = runs.set_ups[k].set_up;
    if (hit[set_up] != std::set<Dof>{point}) continue;
    data.hammer[k] = shapes.row(own - dofs.begin()).real();
    if (set_up == driving.begin()->first) data.driving = k;
  }
}

/// Splits the deviations of the shapes into what is common to a whole shape,
/// no more than its best known value is uncertain by, and the rest.
void split_deviations(const Eigen::MatrixXcd& shapes,
                      Eigen::MatrixXd& sd,
                      ShiftData& data) {
  data.scale_sd = Eigen::VectorXd::Zero(shapes.cols());
  for (Index r = 0; r < shapes.cols(); ++r) {
    const Eigen::ArrayXd size = shapes.col(r).cwiseAbs().array();
    if (!(size.maxCoeff() > 0.0)) continue;
    const double common =
        (sd.col(r).array() / size.max(1e-3 * size.maxCoeff())).minCoeff();
    data.scale_sd(r) = common;
    sd.col(r) =
        (sd.col(r).array().square() - (common * size).square()).max(0.0).sqrt();
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
  if (shifts.masses.empty() && shifts.explained < 0.8) {
    return start + fmt::format(
                       ", though that explains {:.0f} % of the shifts only: "
                       "the sensors load the structure, but modes mix too "
                       "much, or something else moves, for the mass to be told",
                       100.0 * shifts.explained);
  }
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
                                        const WeightedFrfs& curves,
                                        const ShapeGraph& graph,
                                        const MultiSetupModes& runs) {
  ShiftData data;
  data.scaled = graph.scaled;
  const std::vector<Index> kept = modes_in_band(curves, runs);
  if (kept.empty()) return std::nullopt;
  fill_poles(runs, kept, data);
  const Eigen::VectorXcd poles = runs.poles(kept);
  const Eigen::MatrixXcd residues = runs.residues(Eigen::all, kept);
  const Eigen::MatrixXd variance = runs.residue_variance(Eigen::all, kept);
  const Eigen::MatrixXcd shapes =
      mode_shapes(graph, residues, poles, runs.frf_weight);
  // Half of E|dphi|^2 is in the real part.
  Eigen::MatrixXd sd =
      std::numbers::sqrt2 / 2.0 *
      shape_deviations(graph, residues, variance, poles, shapes);
  fill_hammer(curves, runs, graph.dofs, shapes, data);
  split_deviations(shapes, sd, data);
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

bool is_significant(const std::optional<PoleShifts>& shifts) {
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
      "frequencies move by up to {:.2g} % between set-ups, not clearly in "
      "proportion to the squared shape: something else changed, or the sensors "
      "are so heavy, or the set-ups so few, that this does not tell",
      100.0 * shifts.largest);
}

}  // namespace tapfit::modal
