#include "modal/mass_loading/multi_setup_identification.hpp"

#include "modal/fit/fit_residual.hpp"
#include "modal/mass_loading/mode_groups.hpp"
#include "modal/select/unrefined_fit.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Standard deviation of ln|lambda| of mode r.
double log_deviation(const SetUpFit& fit, Index r) {
  const Complex pole = fit.fit.poles(r);
  const Eigen::Vector2d direction(pole.real(), pole.imag());
  const double variance =
      direction.dot(fit.pole_covariance.block<2, 2>(2 * r, 2 * r) * direction);
  return std::sqrt(std::max(0.0, variance)) / std::norm(pole);
}

void take_over(const SetUpFit& from,
               Index mode,
               Index column,
               SetUpPoles& poles,
               MultiSetupModes& result) {
  poles.poles(column) = from.fit.poles(mode);
  poles.log_sd(column) = log_deviation(from, mode);
  for (std::size_t k = 0; k < from.frfs.size(); ++k) {
    const auto row = static_cast<Index>(k);
    result.residues(from.frfs[k], column) = from.fit.residues(row, mode);
    result.residue_variance(from.frfs[k], column) =
        from.residue_variance(row, mode);
  }
}

void summarise(const std::vector<SetUpFit>& fits,
               const ModeGroup& group,
               Index column,
               MultiSetupModes& result) {
  const Complex mean = mean_pole(fits, group);
  double low = std::abs(mean);
  double high = low;
  const auto n = static_cast<double>(group.members.size());
  for (const GroupMember& member : group.members) {
    const SetUpFit& own = fits[member.fit];
    const Complex pole = own.fit.poles(member.mode);
    low = std::min(low, std::abs(pole));
    high = std::max(high, std::abs(pole));
    take_over(own, member.mode, column, result.set_ups[member.fit], result);
  }
  double re = 0.0;
  double im = 0.0;
  for (const GroupMember& member : group.members) {
    const Complex off = fits[member.fit].fit.poles(member.mode) - mean;
    re += off.real() * off.real() / (n - 1.0);
    im += off.imag() * off.imag() / (n - 1.0);
  }
  if (const GroupMember& only = group.members.front(); n == 1.0) {
    const Eigen::MatrixXd& covariance = fits[only.fit].pole_covariance;
    re = covariance(2 * only.mode, 2 * only.mode);
    im = covariance(2 * only.mode + 1, 2 * only.mode + 1);
  }
  result.poles(column) = mean;
  result.scatter(column) = {std::sqrt(re), std::sqrt(im)};
  result.frequency_range(column) = (high - low) / std::abs(mean);
}

/// Room for so many modes, none of them found in any set-up yet.
MultiSetupModes empty_modes(const WeightedFrfs& curves,
                            const std::vector<SetUpFit>& fits,
                            Index count) {
  MultiSetupModes result;
  result.poles.resize(count);
  result.scatter.resize(count);
  result.frequency_range.resize(count);
  result.residues = Eigen::MatrixXcd::Zero(curves.count(), count);
  result.residue_variance = Eigen::MatrixXd::Zero(curves.count(), count);
  result.H.resize(curves.lines(), curves.count());
  result.unrefined_H.resize(curves.lines(), curves.count());
  result.frf_weight.resize(curves.count());
  for (const SetUpFit& fit : fits) {
    result.frf_weight(fit.frfs) = fit.fit.frf_weight;
    result.H(Eigen::all, fit.frfs) = fitted_accelerance(fit.curves, fit.fit);
    result.unrefined_H(Eigen::all, fit.frfs) =
        unrefined_fit(fit.curves, fit.tracks, fit.fit.poles);
    result.set_ups.push_back({fit.set_up,
                              Eigen::VectorXcd::Zero(count),
                              Eigen::VectorXd::Zero(count)});
  }
  return result;
}

/// All of the set-ups as one.
MultiSetupModes joined(const WeightedFrfs& curves, SetUpFits parts) {
  for (SetUpFit& own : parts.fits) estimate_uncertainty(own);
  const auto count = static_cast<Index>(parts.groups.size());
  MultiSetupModes result = empty_modes(curves, parts.fits, count);
  for (Index c = 0; c < count; ++c) {
    summarise(parts.fits, parts.groups[static_cast<std::size_t>(c)], c, result);
  }
  result.made_of = std::make_shared<const SetUpFits>(std::move(parts));
  return result;
}

}  // namespace

bool sensors_rove(const WeightedFrfs& curves) {
  const std::set<std::size_t> all(curves.set_up.begin(), curves.set_up.end());
  std::map<Dof, std::set<std::size_t>> seen;
  for (std::size_t f = 0; f < curves.set_up.size(); ++f) {
    seen[curves.response[f]].insert(curves.set_up[f]);
  }
  return all.size() > 1 && std::ranges::all_of(seen, [&](const auto& entry) {
           return 2 * entry.second.size() <= all.size();
         });
}

std::optional<MultiSetupModes> identify_per_set_up(
    const WeightedFrfs& curves,
    const IdentifyOptions& options,
    const Progress& progress) {
  if (std::ranges::all_of(curves.set_up,
                          [](std::size_t k) { return k == 0; })) {
    return std::nullopt;
  }
  std::vector<SetUpFit> fits = fit_set_ups(curves, options, progress);
  for (const SetUpFit& own : fits) {
    if (own.fit.poles.size() == 0) return std::nullopt;
  }
  std::vector<ModeGroup> found = group_modes(fits);
  find_missing(options, fits, found);
  std::vector<ModeGroup> groups = common_modes(fits, std::move(found));
  if (groups.empty()) return std::nullopt;
  return joined(curves, {std::move(fits), std::move(groups)});
}

MultiSetupModes edited(const WeightedFrfs& curves,
                       const std::vector<PoleEdit>& edits,
                       const MultiSetupModes& modes) {
  if (edits.empty()) return modes;
  SetUpFits parts = *modes.made_of;
  for (const PoleEdit& edit : edits) {
    if (edit.what == PoleEdit::What::Drop) {
      drop_group(edit.hz, parts);
    } else {
      add_group(edit.hz, parts);
    }
  }
  return joined(curves, std::move(parts));
}

}  // namespace tapfit::modal
