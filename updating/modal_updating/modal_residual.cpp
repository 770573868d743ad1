#include "updating/modal_updating/modal_residual.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/modal_updating/mode_sensitivity.hpp"
#include "updating/modal_updating/shape_fit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Index points(const MeasuredModes& measured) {
  return static_cast<Index>(measured.dofs.size());
}

MatrixXd at_points(const MeasuredModes& measured, const MatrixXd& phi) {
  MatrixXd result(points(measured), phi.cols());
  for (Index i = 0; i < result.rows(); ++i) {
    result.row(i) = phi.row(measured.dofs[static_cast<std::size_t>(i)]);
  }
  return result;
}

// The frequencies as far off as pairing allows; the shapes are to follow.
ModalResidual without_partners(const MeasuredModes& measured,
                               double most_ratio,
                               double independent) {
  const Index p = measured.frequency_hz.size();
  const Index m = points(measured);
  ModalResidual result;
  result.frequency_hz = VectorXd::Zero(p);
  result.mac = VectorXd::Zero(p);
  result.factor = VectorXd::Zero(p);
  result.excess = VectorXd::Zero(p);
  result.r = VectorXd::Zero(p * (1 + m));
  result.r.head(p) = (most_ratio - 1.0) *
                     measured.frequency_hz.cwiseQuotient(measured.frequency_sd);
  result.weight = VectorXd::Ones(p * (1 + m));
  if (m > 0) {
    result.weight.tail(p * m).setConstant(independent / static_cast<double>(m));
  }
  return result;
}

// The shapes of these modes against the model's, their factors and excess.
void take_shapes(const MeasuredModes& measured,
                 const std::vector<Index>& which,
                 const MatrixXd& phi,
                 ModalResidual& result) {
  const Index p = measured.frequency_hz.size();
  const Index m = points(measured);
  const ShapeFit fit = fit_shapes(measured.shape(Eigen::all, which),
                                  phi,
                                  measured.shape_sd(Eigen::all, which));
  for (std::size_t k = 0; k < which.size(); ++k) {
    const auto from = static_cast<Index>(k);
    result.factor(which[k]) = fit.factor(from);
    result.excess(which[k]) = fit.excess(from);
    result.r.segment(p + which[k] * m, m) = fit.r.col(from);
  }
  result.misfit += result.weight(p) * fit.misfit;
}

std::vector<modal::Pair> pair(const MeasuredModes& measured,
                              const structure::Eigenmodes& modes,
                              const modal::PairingOptions& options) {
  // One row of ones: every MAC is 1.
  const Index p = measured.frequency_hz.size();
  const Index q = modes.frequency_hz.size();
  const bool shapes = points(measured) > 0;
  const MatrixXd U = shapes ? measured.shape : MatrixXd::Ones(1, p);
  const MatrixXd V =
      shapes ? at_points(measured, modes.phi) : MatrixXd::Ones(1, q);
  return modal::pair_modes(
      U, measured.frequency_hz, V, modes.frequency_hz, options);
}

void require(bool good, const std::string& what, const std::string& where) {
  if (good) return;
  throw InputError(what, where, "Look at how the measured modes were read.");
}

void check_shapes(const MeasuredModes& measured, Index n) {
  const Index m = points(measured);
  const Index p = measured.frequency_hz.size();
  require(measured.shape.rows() == m && measured.shape.cols() == p &&
              measured.shape_sd.rows() == m && measured.shape_sd.cols() == p,
          fmt::format("shapes of {} modes at {} degrees of freedom come as {} "
                      "x {}, their standard deviations as {} x {}",
                      p,
                      m,
                      measured.shape.rows(),
                      measured.shape.cols(),
                      measured.shape_sd.rows(),
                      measured.shape_sd.cols()),
          "measured modes");
  require(measured.shape.allFinite() && measured.shape_sd.allFinite() &&
              measured.shape_sd.minCoeff() > 0.0,
          "a shape or its standard deviation is not a number, or the latter "
          "is not above 0",
          "measured modes");
  for (Index i = 0; i < p; ++i) {
    require(measured.shape.col(i).cwiseAbs().maxCoeff() > 0.0,
            "the shape is zero at every point",
            fmt::format("measured mode {}", i + 1));
  }
  for (const int dof : measured.dofs) {
    require(dof >= 0 && dof < n,
            fmt::format("row {} is not one of the model's {}", dof, n),
            "measured degrees of freedom");
  }
}

}  // namespace

void check(const MeasuredModes& measured, Index n) {
  const Index p = measured.frequency_hz.size();
  require(p > 0, "there is no mode", "measured modes");
  require(measured.frequency_sd.size() == p,
          fmt::format("there are {} standard deviations for {} frequencies",
                      measured.frequency_sd.size(),
                      p),
          "measured modes");
  for (Index i = 0; i < p; ++i) {
    const double f = measured.frequency_hz(i);
    const double sd = measured.frequency_sd(i);
    require(std::isfinite(f) && f > 0.0 && std::isfinite(sd) && sd > 0.0,
            fmt::format("{} Hz with a standard deviation of {} Hz", f, sd),
            fmt::format("measured mode {}", i + 1));
  }
  if (points(measured) > 0) check_shapes(measured, n);
}

ModalResidual modal_residual(const MeasuredModes& measured,
                             const structure::Eigenmodes& modes,
                             const modal::PairingOptions& pairing,
                             double independent) {
  const Index p = measured.frequency_hz.size();
  const Index m = points(measured);
  ModalResidual result =
      without_partners(measured, pairing.most_frequency_ratio, independent);
  result.pairs = pair(measured, modes, pairing);
  std::vector<Index> paired;
  std::vector<Index> partner;
  std::vector<bool> alone(static_cast<std::size_t>(p), true);
  for (const modal::Pair& found : result.pairs) {
    const Index i = found.measured;
    const double f = modes.frequency_hz(found.model);
    result.frequency_hz(i) = f;
    result.r(i) = (f - measured.frequency_hz(i)) / measured.frequency_sd(i);
    if (m > 0) result.mac(i) = found.mac;
    paired.push_back(i);
    partner.push_back(found.model);
    alone[static_cast<std::size_t>(i)] = false;
  }
  result.misfit = result.r.head(p).squaredNorm();
  if (m == 0) return result;
  // A mode without a partner says nothing of how well the others fit.
  for (Index i = 0; i < p; ++i) {
    if (!alone[static_cast<std::size_t>(i)]) continue;
    take_shapes(measured, {i}, VectorXd::Zero(m), result);
  }
  if (!paired.empty()) {
    const MatrixXd phi = modes.phi(Eigen::all, partner);
    take_shapes(measured, paired, at_points(measured, phi), result);
  }
  return result;
}

// With phi and r over sqrt(sd^2 + v): a = phi'u / phi'phi, so
//   dr = -a dphi - da phi,   da = (dphi'r - a phi'dphi) / phi'phi.
MatrixXd modal_jacobian(const ScaledModel& model,
                        const VectorXd& theta,
                        const MeasuredModes& measured,
                        const structure::Eigenmodes& modes,
                        const ModalResidual& residual) {
  const Index p = measured.frequency_hz.size();
  const Index m = points(measured);
  MatrixXd J = MatrixXd::Zero(residual.r.size(), theta.size());
  if (residual.pairs.empty()) return J;
  const ModeSensitivity sensitivity(model, theta, modes);
  for (const modal::Pair& paired : residual.pairs) {
    const Index i = paired.measured;
    const ModeDerivative d = sensitivity.of(paired.model);
    const double df =
        1.0 / (8.0 * std::pow(std::numbers::pi, 2) * residual.frequency_hz(i));
    J.row(i) = df / measured.frequency_sd(i) * d.lambda;
    if (m == 0) continue;
    const VectorXd precise = (measured.shape_sd.col(i).array().square() +
                              std::pow(residual.excess(i), 2))
                                 .sqrt()
                                 .inverse();
    const VectorXd phi =
        precise.cwiseProduct(at_points(measured, modes.phi.col(paired.model)));
    const double square = phi.squaredNorm();
    if (square == 0.0) continue;
    const MatrixXd dphi = precise.asDiagonal() * at_points(measured, d.phi);
    const auto r = residual.r.segment(p + i * m, m);
    const double a = residual.factor(i);
    const Eigen::RowVectorXd da =
        (r.transpose() * dphi - a * (phi.transpose() * dphi)) / square;
    J.middleRows(p + i * m, m) = -a * dphi - phi * da;
  }
  return J;
}

}  // namespace tapfit::updating
