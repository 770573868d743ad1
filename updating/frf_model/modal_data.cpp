#include "updating/frf_model/modal_data.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "modal/mode_set/complexity.hpp"
#include "modal/mode_set/mac.hpp"
#include "modal/mode_set/pairing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

using Fixed = std::vector<std::pair<Index, Index>>;

// Above any sum of real costs.
constexpr double beyond_reach = 1e3;
// Far below any mode: a rigid one's logarithm is finite.
constexpr double slowest = 1e-6;

VectorXd hertz(const VectorXd& omega) {
  return omega.cwiseMax(slowest) / two_pi;
}

MatrixXd likeness(const ModalData& data, const MatrixXd& at_points) {
  if (data.points() == 0) {
    return MatrixXd::Ones(data.modes(), at_points.cols());
  }
  MatrixXd alike = modal::mac(data.shape.cast<std::complex<double>>(),
                              at_points.cast<std::complex<double>>());
  // Where no point moves, the frequency counts alone.
  for (Index r = 0; r < data.modes(); ++r) {
    if (data.shape.col(r).isZero(0.0)) alike.row(r).setOnes();
  }
  return alike;
}

// |ln ratio| of every measured frequency and every one of the model's.
MatrixXd apart(const ModalData& data, const VectorXd& omega) {
  const VectorXd measured = data.frequency_hz.array().log();
  const VectorXd model = hertz(omega).array().log();
  return (measured.replicate(1, model.size()) -
          model.transpose().replicate(measured.size(), 1))
      .cwiseAbs();
}

}  // namespace

MatrixXd ModalData::response() const {
  MatrixXd all(modes(), 1 + points());
  all.col(0) = frequency_weight.array() * frequency_hz.array().log();
  all.rightCols(points()) = shape_weight.cwiseProduct(shape).transpose();
  return all;
}

ModalData ModalData::only(const std::vector<Index>& kept) const {
  ModalData part;
  part.sd = sd;
  part.dofs = dofs;
  part.frequency_hz = frequency_hz(kept);
  part.frequency_weight = frequency_weight(kept);
  part.shape = shape(Eigen::all, kept);
  part.shape_weight = shape_weight(Eigen::all, kept);
  for (const auto& [measured, model] : fixed) {
    const auto at = std::ranges::find(kept, measured);
    if (at != kept.end()) part.fixed.emplace_back(at - kept.begin(), model);
  }
  return part;
}

ModalData modal_data(const modal::ModeSet& measured) {
  const auto p = static_cast<Index>(measured.modes.size());
  ModalData data;
  data.frequency_hz.resize(p);
  VectorXd relative(p);
  for (Index r = 0; r < p; ++r) {
    const modal::Mode& mode = measured.modes[static_cast<std::size_t>(r)];
    data.frequency_hz(r) = mode.frequency_hz;
    relative(r) = mode.frequency_sd_hz / mode.frequency_hz;
  }
  data.sd = relative.norm() / std::sqrt(static_cast<double>(p));
  data.frequency_weight = data.sd * relative.cwiseInverse();
  const bool shapes = measured.dofs.size() > 1;
  if (shapes) data.dofs = measured.dofs;
  const auto n = static_cast<Index>(data.dofs.size());
  data.shape.resize(n, p);
  data.shape_weight.resize(n, p);
  for (Index r = 0; shapes && r < p; ++r) {
    const modal::Mode& mode = measured.modes[static_cast<std::size_t>(r)];
    if (mode.shape.isZero(0.0)) {
      data.shape.col(r).setZero();
      data.shape_weight.col(r).setZero();
      continue;
    }
    const VectorXd real = modal::real_shape(mode.shape);
    data.shape.col(r) = real / real.norm();
    data.shape_weight.col(r) =
        data.sd * real.norm() * mode.shape_sd.cwiseInverse();
  }
  return data;
}

MatrixXd PairedMode::fitted_change(const VectorXd& e,
                                   const VectorXd& q,
                                   const MatrixXd& du) const {
  // a = e' Q u / u' Q u,  Q = diag(q^2)
  const VectorXd Q = q.cwiseAbs2();
  const double power = u.dot(Q.cwiseProduct(u));
  if (power <= 0.0) return MatrixXd::Zero(du.rows(), du.cols());
  const VectorXd slope = Q.cwiseProduct(e - 2.0 * factor * u) / power;
  return factor * du + u * (slope.transpose() * du);
}

std::vector<PairedMode> paired_modes(const ModalData& data,
                                     const VectorXd& omega,
                                     const MatrixXd& at_points,
                                     const Fixed& fixed) {
  const MatrixXd like = likeness(data, at_points);
  MatrixXd cost =
      MatrixXd::Ones(like.rows(), like.cols()) - like + apart(data, omega);
  for (const auto& [measured, model] : fixed) {
    cost.row(measured).array() += beyond_reach;
    cost.col(model).array() += beyond_reach;
    cost(measured, model) = 0.0;
  }
  const std::vector<Index> model = modal::assign(cost);
  std::vector<PairedMode> pairs;
  for (Index r = 0; r < data.modes(); ++r) {
    PairedMode pair;
    pair.model = model[static_cast<std::size_t>(r)];
    if (pair.model < 0) {
      throw InputError(
          fmt::format("the model has {} modes for {} measured ones",
                      omega.size(),
                      data.modes()),
          "the model",
          "leave those out that the model cannot have, by band_hz");
    }
    pair.u = at_points.col(pair.model);
    const VectorXd Q = data.shape_weight.col(r).cwiseAbs2();
    const double power = pair.u.dot(Q.cwiseProduct(pair.u));
    const double along = pair.u.dot(Q.cwiseProduct(data.shape.col(r)));
    pair.factor = power > 0.0 ? along / power : 0.0;
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

std::vector<Index> foreign_modes(const ModalData& data,
                                 const VectorXd& omega,
                                 const MatrixXd& at_points) {
  constexpr double reach = 3.0;  // of the frequency
  const double least = modal::PairingOptions{}.least_mac;
  const MatrixXd like = likeness(data, at_points);
  const MatrixXd off = apart(data, omega);
  std::vector<Index> foreign;
  for (Index r = 0; r < data.modes(); ++r) {
    const bool known = ((like.row(r).array() >= least) &&
                        (off.row(r).array() <= std::log(reach)))
                           .any();
    const bool by_hand = std::ranges::any_of(
        data.fixed, [r](const auto& pair) { return pair.first == r; });
    if (!known && !by_hand && data.points() > 0) foreign.push_back(r);
  }
  return foreign;
}

}  // namespace tapfit::updating
