#include "modal/mode_set/synthesis.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;

std::optional<Eigen::Index> row_of(const ModeSet& modes, const Dof& dof) {
  for (std::size_t k = 0; k < modes.dofs.size(); ++k) {
    if (modes.dofs[k].node == dof.node &&
        modes.dofs[k].component == dof.component) {
      return static_cast<Eigen::Index>(k);
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Eigen::VectorXcd> synthesise(const ModeSet& modes,
                                           const Dof& response,
                                           const Dof& reference,
                                           const Eigen::VectorXcd& s) {
  const std::optional<Eigen::Index> a = row_of(modes, response);
  const std::optional<Eigen::Index> b = row_of(modes, reference);
  if (!modes.scaled || !a || !b) return std::nullopt;
  const double sign = response.sign * reference.sign;
  Eigen::VectorXcd H = Eigen::VectorXcd::Zero(s.size());
  for (const Mode& mode : modes.modes) {
    const Complex residue = sign * mode.shape(*a) * mode.shape(*b) /
                            Complex(0.0, 2.0 * mode.pole.imag());
    for (Eigen::Index k = 0; k < s.size(); ++k) {
      H(k) += s(k) * s(k) *
              (residue / (s(k) - mode.pole) +
               std::conj(residue) / (s(k) - std::conj(mode.pole)));
    }
  }
  return H;
}

signal::FrfSet fitted_set(const signal::FrfSet& frfs, const ModeSet& modes) {
  signal::FrfSet result;
  std::vector<Eigen::Index> lines;
  for (Eigen::Index k = 0; k < frfs.lines(); ++k) {
    const auto fitted = [k](const Eigen::VectorXcd& H) {
      return H.size() > k && std::abs(H(k)) > 0.0;
    };
    if (std::ranges::any_of(modes.fitted, fitted)) lines.push_back(k);
  }
  result.s = frfs.s(lines);
  for (std::size_t f = 0; f < modes.fitted.size(); ++f) {
    if (modes.fitted[f].size() != frfs.lines()) continue;
    if (modes.fitted[f].isZero(0.0)) continue;
    signal::Frf frf = frfs.frfs[f];
    frf.H = Eigen::VectorXcd(modes.fitted[f](lines));
    frf.coherence = Eigen::VectorXd::Ones(result.lines());
    frf.variance = Eigen::VectorXd::Zero(result.lines());
    result.frfs.push_back(std::move(frf));
  }
  return result;
}

}  // namespace tapfit::modal
