#include "modal/mass_loading/loaded_frf_model.hpp"

#include "modal/mode_set/synthesis.hpp"
#include "signal/frf_set/set_ups.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

bool same_point(const Dof& a, const Dof& b) {
  return a.node == b.node && a.component == b.component;
}

/// The modes with the poles of one set-up; a mode not found in it keeps the
/// mean's.
ModeSet of_set_up(const ModeSet& modes, std::size_t set_up) {
  ModeSet own;
  own.dofs = modes.dofs;
  own.modes = modes.modes;
  own.scaled = modes.scaled;
  const auto found =
      std::ranges::find(modes.set_ups, set_up, &SetUpPoles::set_up);
  if (found == modes.set_ups.end()) return own;
  for (std::size_t r = 0; r < own.modes.size(); ++r) {
    const Complex pole = found->poles(static_cast<Index>(r));
    if (std::abs(pole) > 0.0) own.modes[r].pole = pole;
  }
  return own;
}

/// What the modes out of the band are, by what was measured.
struct OutOfBand {
  Eigen::VectorXcd driving_mean;
  Eigen::VectorXd driving_variance;  ///< E|T|^2 over driving points
  Eigen::VectorXd variance;          ///< over all FRFs
};

OutOfBand out_of_band(const std::map<std::size_t, ModeSet>& by_set_up,
                      const ModeSet& modes,
                      const signal::FrfSet& frfs,
                      const std::vector<std::size_t>& set_up) {
  OutOfBand out{Eigen::VectorXcd::Zero(frfs.lines()),
                Eigen::VectorXd::Zero(frfs.lines()),
                Eigen::VectorXd::Zero(frfs.lines())};
  double driving = 0.0;
  double count = 0.0;
  for (std::size_t f = 0; f < modes.fitted.size(); ++f) {
    const signal::Frf& frf = frfs.frfs[f];
    const auto H = synthesise(
        by_set_up.at(set_up[f]), frf.response, frf.reference, frfs.s);
    if (!H || modes.fitted[f].isZero(0.0)) continue;
    const double sign = frf.response.sign * frf.reference.sign;
    const Eigen::VectorXcd T = sign * (modes.fitted[f] - *H);
    out.variance += T.cwiseAbs2();
    count += 1.0;
    if (!same_point(frf.response, frf.reference)) continue;
    out.driving_mean += T;
    out.driving_variance += T.cwiseAbs2();
    driving += 1.0;
  }
  out.variance /= std::max(count, 1.0);
  out.driving_mean /= std::max(driving, 1.0);
  out.driving_variance /= std::max(driving, 1.0);
  if (driving == 0.0) out.driving_variance = out.variance;
  return out;
}

/// E|dA|^2 of the modal sum from the shapes' deviations.
Eigen::VectorXd shape_variance(const ModeSet& modes,
                               const Dof& a,
                               const Dof& b,
                               const Eigen::VectorXcd& s) {
  const auto row = [&](const Dof& dof) {
    return std::ranges::find_if(
               modes.dofs,
               [&](const Dof& own) { return same_point(own, dof); }) -
           modes.dofs.begin();
  };
  const Index i = row(a);
  const Index j = row(b);
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(s.size());
  for (const Mode& mode : modes.modes) {
    if (mode.shape_sd.size() == 0) continue;
    const double of_product =
        i == j ? std::norm(2.0 * mode.shape(i)) * std::pow(mode.shape_sd(i), 2)
               : std::norm(mode.shape(j)) * std::pow(mode.shape_sd(i), 2) +
                     std::norm(mode.shape(i)) * std::pow(mode.shape_sd(j), 2);
    for (Index k = 0; k < s.size(); ++k) {
      const Complex H =
          s(k) * s(k) / ((s(k) - mode.pole) * (s(k) - std::conj(mode.pole)));
      variance(k) += std::norm(H) * of_product;
    }
  }
  return variance;
}

}  // namespace

signal::FrfModel loaded_frf_model(const ModeSet& modes,
                                  const signal::FrfSet& frfs) {
  const std::vector<std::size_t> set_up = signal::set_ups(frfs);
  std::map<std::size_t, ModeSet> by_set_up;
  for (const std::size_t k : set_up) {
    if (!by_set_up.contains(k)) by_set_up.emplace(k, of_set_up(modes, k));
  }
  const OutOfBand out = out_of_band(by_set_up, modes, frfs, set_up);
  return [by_set_up, out, s = frfs.s](std::size_t k, const Dof& a, const Dof& b)
             -> std::optional<signal::ModelledFrf> {
    const auto own = by_set_up.find(k);
    if (own == by_set_up.end() || own->second.modes.empty()) {
      return std::nullopt;
    }
    const auto H = synthesise(own->second, a, b, s);
    if (!H) return std::nullopt;
    signal::ModelledFrf result{*H, shape_variance(own->second, a, b, s)};
    if (same_point(a, b)) {
      result.H += out.driving_mean;
      result.variance += out.driving_variance;
    } else {
      result.variance += out.variance;
    }
    return result;
  };
}

}  // namespace tapfit::modal
