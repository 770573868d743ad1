#include "modal/synthesis.hpp"

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

}  // namespace tapfit::modal
