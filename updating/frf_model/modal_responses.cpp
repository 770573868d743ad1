// What FrfModel answers where modes were measured: the parts of its interface
// that FRFs have in frf_responses.cpp, with a measured mode in the place of a
// line and its frequency and shape (modal_data.hpp) in that of the FRFs.
//
// Of a mode of unit mass, a change of the dynamic stiffness b' z b makes
//
//   d lambda = z (b phi)^2 / (1 + z own),  own = sum_j (b phi_j)^2 /
//                                                (lambda_j - lambda)
//   d phi = sum_j phi_j (b phi_j) (b phi) z / ((lambda - lambda_j)(1 + z own))
//
// over all other modes j, to first order in what the mode itself moves: the
// same products of rows and the same denominator as an FRF's, so that places
// are scanned for both in the same way.
#include "updating/frf_model/frf_model.hpp"
#include "updating/frf_model/run_lines.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

namespace {

// 1 / (lambda_m - lambda_j) of the other modes. Of modes closer than this, as a
// share of lambda, the first order says too much.
VectorXd inverse_gaps(const VectorXd& omega, Index m) {
  constexpr double close = 0.02;
  const VectorXd lambda = omega.cwiseAbs2();
  const VectorXd gap = (lambda(m) - lambda.array()).matrix();
  const double least = close * std::max(lambda(m), 1e-300);
  VectorXd inverse = gap.array() / (gap.array().square() + least * least);
  inverse(m) = 0.0;
  return inverse;
}

}  // namespace

// Pairs by hand name modes of the deck: followed by what they move alike.
std::vector<PairedMode> FrfModel::paired(const BaseModes& modes,
                                         const MatrixXd& at_points) const {
  std::vector<std::pair<Index, Index>> fixed = modes_->fixed;
  for (auto& [measured, model] : fixed) {
    if (reference_phi_.size() == 0) continue;
    const VectorXd overlap =
        (modes.phi.transpose() * reference_phi_.col(model)).cwiseAbs();
    overlap.maxCoeff(&model);
  }
  return paired_modes(*modes_, modes.omega, at_points, fixed);
}

std::pair<VectorXd, MatrixXd> FrfModel::modes_at_points() const {
  return {base_.K.diagonal().cwiseMax(0.0).cwiseSqrt(), points_.transpose()};
}

ModelResponse FrfModel::respond_modes(ModalState& shared,
                                      bool derivatives) const {
  const ModalData& data = *modes_;
  const VectorXd& omega = shared.modes.omega;
  const MatrixXd at = points_.transpose() * shared.modes.phi;
  const std::vector<PairedMode> pairs = paired(shared.modes, at);
  ModelResponse out;
  out.H = MatrixXcd::Zero(data.modes(), 1 + data.points());
  for (Index r = 0; r < data.modes(); ++r) {
    const PairedMode& pair = pairs[static_cast<std::size_t>(r)];
    const double hz = std::max(omega(pair.model), 1e-6) / (2.0 * M_PI);
    out.H(r, 0) = data.frequency_weight(r) * std::log(hz);
    out.H.row(r).tail(data.points()) =
        (pair.factor * data.shape_weight.col(r).cwiseProduct(pair.u))
            .transpose()
            .cast<std::complex<double>>();
  }
  if (!derivatives) return out;
  find_turning(shared, omega.maxCoeff());
  out.dH.assign(static_cast<std::size_t>(shared.state->parameters()),
                MatrixXcd::Zero(out.H.rows(), out.H.cols()));
  for (const TurningParameter& p : shared.turning) {
    const MatrixXd turned = p.scale * p.turn.turned(at.transpose());
    MatrixXcd& d = out.dH[p.column];
    for (Index r = 0; r < data.modes(); ++r) {
      const PairedMode& pair = pairs[static_cast<std::size_t>(r)];
      const Index m = pair.model;
      const double lambda = std::max(std::pow(omega(m), 2), 1e-12);
      d(r, 0) = data.frequency_weight(r) * p.scale * p.turn.stiffness()(m) /
                (2.0 * lambda);
      const VectorXd q = data.shape_weight.col(r);
      const VectorXd change =
          pair.fitted_change(data.shape.col(r), q, turned.row(m).transpose());
      d.row(r).tail(data.points()) =
          q.cwiseProduct(change).transpose().cast<std::complex<double>>();
    }
  }
  return out;
}

std::vector<FrfModel::Walk> FrfModel::walk_modes(
    const ModelState& state,
    const VectorXcd& s,
    const MatrixXd& candidates) const {
  const ModalData& data = *modes_;
  const ModalState shared = modal_state(state, base_modes(state));
  const auto& [omega, phi] = shared.modes;
  const MatrixXd at = points_.transpose() * phi;
  const MatrixXd squares = (phi.transpose() * candidates).cwiseAbs2();
  Walk walk;
  for (Index k = 0; k <= data.points(); ++k) walk.pairs.push_back({k, k, 0});
  walk.recorded = MatrixXcd::Ones(data.modes(), 1 + data.points());
  walk.own.resize(data.modes(), candidates.cols());
  const std::vector<PairedMode> pairs = paired(shared.modes, at);
  for (Index r = 0; r < data.modes(); ++r) {
    const PairedMode& pair = pairs[static_cast<std::size_t>(r)];
    const VectorXd own = phi.col(pair.model);
    const VectorXd inverse = inverse_gaps(omega, pair.model);
    const double lambda = std::max(std::pow(omega(pair.model), 2), 1e-12);
    const double line = std::norm(s(r));  // the scan multiplies by it
    walk.own.row(r) = (-squares.transpose() * inverse)
                          .transpose()
                          .cast<std::complex<double>>();
    MatrixXd Xo(phi.rows(), 1 + data.points());
    Xo.col(0) = data.frequency_weight(r) / (2.0 * lambda * line) * own;
    const VectorXd q = data.shape_weight.col(r);
    const MatrixXd moved = at * inverse.asDiagonal() * phi.transpose();
    Xo.rightCols(data.points()) =
        (q.asDiagonal() * pair.fitted_change(data.shape.col(r), q, moved))
            .transpose() /
        line;
    walk.Xo.push_back(Xo.cast<std::complex<double>>());
    walk.Xi.push_back(own.cast<std::complex<double>>());
  }
  return {std::move(walk)};
}

std::vector<MatrixXcd> FrfModel::form_patterns_of_modes(
    const ModelState& state) const {
  constexpr Index neighbours = 2;
  const ModalData& data = *modes_;
  const ModalState shared = modal_state(state, base_modes(state));
  const auto& [omega, phi] = shared.modes;
  const MatrixXd at = points_.transpose() * phi;
  const double top = 2.0 * M_PI * setting_.high_hz;
  const MatrixXcd none = MatrixXcd::Zero(data.modes(), 1 + data.points());
  MatrixXcd even = none;
  MatrixXcd linear = none;
  std::vector<MatrixXcd> patterns;
  const std::vector<PairedMode> pairs = paired(shared.modes, at);
  for (Index r = 0; r < data.modes(); ++r) {
    const PairedMode& pair = pairs[static_cast<std::size_t>(r)];
    const Index m = pair.model;
    const double unit = 0.5 * data.frequency_weight(r);
    even(r, 0) = unit;
    linear(r, 0) = unit * omega(m) / top;
    patterns.push_back(none);
    patterns.back()(r, 0) = unit;
    if (data.points() == 0) continue;
    const VectorXd inverse = inverse_gaps(omega, m);
    const VectorXd q = data.shape_weight.col(r);
    const Index first = std::max<Index>(m - neighbours, 0);
    const Index last = std::min<Index>(m + neighbours, omega.size() - 1);
    for (Index j = first; j <= last; ++j) {
      if (j == m) continue;
      const VectorXd mixed =
          omega(m) * omega(j) * M_SQRT1_2 * inverse(j) * at.col(j);
      patterns.push_back(none);
      patterns.back().row(r).tail(data.points()) =
          q.cwiseProduct(
               VectorXd(pair.fitted_change(data.shape.col(r), q, mixed)))
              .transpose()
              .cast<std::complex<double>>();
    }
  }
  patterns.push_back(std::move(even));
  patterns.push_back(std::move(linear));
  return patterns;
}

}  // namespace tapfit::updating
