#include "modal/mode_set/mac.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>

namespace tapfit::modal {

Eigen::MatrixXd mac(const Eigen::MatrixXcd& U, const Eigen::MatrixXcd& V) {
  const Eigen::MatrixXcd inner = U.adjoint() * V;
  const Eigen::VectorXd uu = U.colwise().squaredNorm().transpose();
  const Eigen::VectorXd vv = V.colwise().squaredNorm().transpose();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(U.cols(), V.cols());
  for (Eigen::Index i = 0; i < U.cols(); ++i) {
    for (Eigen::Index j = 0; j < V.cols(); ++j) {
      if (uu(i) > 0.0 && vv(j) > 0.0) {
        result(i, j) = std::norm(inner(i, j)) / uu(i) / vv(j);
      }
    }
  }
  return result.cwiseMin(1.0);
}

Eigen::MatrixXd auto_mac(const Eigen::MatrixXcd& U) { return mac(U, U); }

Eigen::MatrixXd mass_weighted_mac(const Eigen::MatrixXcd& U,
                                  const Eigen::MatrixXcd& V,
                                  const Eigen::MatrixXd& W) {
  // W = L L': the plain MAC of L' U and L' V. W may lack rank.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(W);
  const Eigen::MatrixXd root =
      eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
      eigen.eigenvectors().transpose();
  return mac(root * U, root * V);
}

Eigen::MatrixXd condensed_mass(const Eigen::MatrixXd& V,
                               const Eigen::VectorXd& omega) {
  const double top = omega.size() > 0 ? omega.maxCoeff() : 0.0;
  double elastic = top;
  for (const double w : omega) {
    if (w > 1e-5 * top) elastic = std::min(elastic, w);
  }
  const Eigen::ArrayXd L = omega.array().max(1e-3 * elastic).square();
  const Eigen::MatrixXd once = V * L.inverse().matrix().asDiagonal();
  const Eigen::MatrixXd inverse = Eigen::MatrixXd(once * V.transpose())
                                      .completeOrthogonalDecomposition()
                                      .pseudoInverse();
  return inverse * (once * once.transpose()) * inverse;
}

Eigen::VectorXd comac(const Eigen::MatrixXcd& U, const Eigen::MatrixXcd& V) {
  // |u conj(v)| takes the phase of each pair out of the sum.
  const Eigen::VectorXd cross =
      (U.array() * V.array().conjugate()).abs().rowwise().sum().matrix();
  const Eigen::VectorXd uu = U.rowwise().squaredNorm();
  const Eigen::VectorXd vv = V.rowwise().squaredNorm();
  Eigen::VectorXd result = Eigen::VectorXd::Zero(U.rows());
  for (Eigen::Index k = 0; k < U.rows(); ++k) {
    if (uu(k) > 0.0 && vv(k) > 0.0) {
      result(k) = cross(k) * cross(k) / uu(k) / vv(k);
    }
  }
  return result.cwiseMin(1.0);
}

Eigen::MatrixXcd in_scale_of(const Eigen::MatrixXcd& U,
                             const Eigen::MatrixXcd& V) {
  Eigen::MatrixXcd scaled = U;
  for (Eigen::Index k = 0; k < U.cols(); ++k) {
    const double size = U.col(k).squaredNorm();
    if (size > 0.0) scaled.col(k) *= U.col(k).dot(V.col(k)) / size;
  }
  return scaled;
}

namespace {

/// Inner products of each pair, from which leaving out a row subtracts.
struct Products {
  Eigen::ArrayXcd uv;
  Eigen::ArrayXd uu;
  Eigen::ArrayXd vv;

  [[nodiscard]] double mean_mac() const {
    double sum = 0.0;
    for (Eigen::Index k = 0; k < uv.size(); ++k) {
      if (uu(k) > 0.0 && vv(k) > 0.0) sum += std::norm(uv(k)) / uu(k) / vv(k);
    }
    return sum / static_cast<double>(std::max<Eigen::Index>(1, uv.size()));
  }
};

Products products(const Eigen::MatrixXcd& U,
                  const Eigen::MatrixXcd& V,
                  const std::vector<Eigen::Index>& rows) {
  const Eigen::MatrixXcd u = U(rows, Eigen::all);
  const Eigen::MatrixXcd v = V(rows, Eigen::all);
  return {u.conjugate().cwiseProduct(v).colwise().sum().transpose().array(),
          u.colwise().squaredNorm().transpose().array(),
          v.colwise().squaredNorm().transpose().array()};
}

}  // namespace

std::vector<LeftOut> macco(const Eigen::MatrixXcd& U,
                           const Eigen::MatrixXcd& V,
                           Eigen::Index most) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index k = 0; k < U.rows(); ++k) rows.push_back(k);
  std::vector<LeftOut> steps;
  while (rows.size() > 1 && static_cast<Eigen::Index>(steps.size()) < most) {
    LeftOut best{-1, -1.0};
    for (const Eigen::Index row : rows) {
      std::vector<Eigen::Index> others = rows;
      std::erase(others, row);
      const double mean = products(U, V, others).mean_mac();
      if (mean > best.mean_mac) best = {row, mean};
    }
    std::erase(rows, best.dof);
    steps.push_back(best);
  }
  return steps;
}

MacEstimate mac_with_uncertainty(const Eigen::VectorXcd& u,
                                 const Eigen::VectorXd& sd,
                                 const Eigen::VectorXcd& v) {
  MacEstimate result;
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  if (!(uu > 0.0) || !(vv > 0.0)) return result;
  // With w = v / |v|, the part of u along it c and the rest r: MAC = |c|^2 /
  // (|c|^2 + |r|^2). Noise adds E|w^H e|^2 to |c|^2 and the rest to |r|^2.
  const Eigen::VectorXcd w = v / std::sqrt(vv);
  const std::complex<double> c = w.dot(u);
  const Eigen::VectorXd power = sd.cwiseAbs2();
  const double along = w.cwiseAbs2().dot(power);
  const double across = std::max(0.0, power.sum() - along);
  const double measured = std::norm(c);
  const double left = std::max(0.0, uu - measured);
  const double true_c = std::max(0.0, measured - along);
  const double true_r = std::max(0.0, left - across);
  const double sum = true_c + true_r;
  result.value = sum > 0.0 ? true_c / sum : 0.0;
  // dMAC/du* = (c w - MAC u) / |u|^2, half of whose noise is in phase with it.
  const double mac_now = measured / uu;
  const Eigen::VectorXcd gradient = (c * w - mac_now * u) / uu;
  // |r|^2 scatters by its own noise too; the gradient has that noise in it.
  const double second = power.cwiseAbs2().sum() / (uu * uu);
  const double first =
      std::max(0.0, 2.0 * gradient.cwiseAbs2().dot(power) - 2.0 * second);
  result.sd = std::sqrt(first + second);
  result.lo95 = std::clamp(result.value - 1.96 * result.sd, 0.0, 1.0);
  result.hi95 = std::clamp(result.value + 1.96 * result.sd, 0.0, 1.0);
  return result;
}

}  // namespace tapfit::modal
