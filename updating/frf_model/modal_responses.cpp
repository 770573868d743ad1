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
#include "acquisition/foundation/constants.hpp"
#include "updating/frf_model/form_entries.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/frf_model/run_response.hpp"

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
    const double hz = std::max(omega(pair.model), 1e-6) / two_pi;
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
  const VectorXd& omega = shared.modes.omega;
  const MatrixXd& phi = shared.modes.phi;
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

FormPatterns FrfModel::form_patterns_of_modes(const ModelState& state) const {
  const ModalData& data = *modes_;
  const ModalState shared = modal_state(state, base_modes(state));
  const VectorXd& omega = shared.modes.omega;
  const MatrixXd& phi = shared.modes.phi;
  const MatrixXd at = points_.transpose() * phi;
  const double top = two_pi * context_.high_hz;
  const MatrixXcd none = MatrixXcd::Zero(data.modes(), 1 + data.points());
  const std::vector<PairedMode> pairs = paired(shared.modes, at);
  MatrixXcd even = none;
  MatrixXcd linear = none;
  std::vector<Index> measured(static_cast<std::size_t>(omega.size()), -1);
  Index modes = 0;
  for (Index r = 0; r < data.modes(); ++r) {
    const Index m = pairs[static_cast<std::size_t>(r)].model;
    even(r, 0) = 0.5 * data.frequency_weight(r);
    linear(r, 0) = even(r, 0) * omega(m) / top;
    measured[static_cast<std::size_t>(m)] = r;
    modes = std::max(modes, m + 1);
  }
  // d phi_i = phi_j omega_i omega_j e_ij / (lambda_i - lambda_j)
  const auto mix = [&](Index i, Index j, MatrixXcd& pattern) {
    const Index r = measured[static_cast<std::size_t>(i)];
    if (r < 0) return;
    const VectorXd mixed =
        omega(i) * omega(j) * M_SQRT1_2 * inverse_gaps(omega, i)(j) * at.col(j);
    const VectorXd q = data.shape_weight.col(r);
    const VectorXd change = pairs[static_cast<std::size_t>(r)].fitted_change(
        data.shape.col(r), q, mixed);
    pattern.row(r).tail(data.points()) =
        q.cwiseProduct(change).transpose().cast<std::complex<double>>();
  };
  // Frequencies alone see all modes, whatever moves.
  const MatrixXd seen =
      data.points() > 0 ? at : MatrixXd::Ones(1, omega.size());
  std::vector<MatrixXcd> patterns;
  std::vector<double> left;
  for (const auto [i, j] :
       form_entries(omega,
                    seen,
                    form_below * two_pi * data.frequency_hz.minCoeff(),
                    modes)) {
    MatrixXcd pattern = none;
    if (i != j && data.points() > 0) {
      mix(i, j, pattern);
      mix(j, i, pattern);
    }
    const Index r = measured[static_cast<std::size_t>(i)];
    if (i == j && r >= 0) pattern(r, 0) = even(r, 0);
    if (pattern.isZero(0.0)) continue;
    patterns.push_back(std::move(pattern));
    left.push_back(left_by_mesh(state, shared.modes, {i, j}));
  }
  patterns.push_back(std::move(even));
  patterns.push_back(std::move(linear));
  left.resize(patterns.size(), 0.0);
  return {std::move(patterns),
          Eigen::Map<VectorXd>(left.data(), std::ssize(left))};
}

}  // namespace tapfit::updating
