#include "modal/checks/modal_constants.hpp"

#include "acquisition/foundation/parallel.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using complex = std::complex<double>;

constexpr double relative_scale = 0.01;
constexpr Index residual_terms = 3;

// Real over imaginary parts.
VectorXd stacked(const VectorXcd& x) {
  VectorXd both(2 * x.size());
  both << x.real(), x.imag();
  return both;
}

// s^2 (q / (s - p)^power + conj) on every line.
VectorXd pole_column(const VectorXcd& s, complex p, complex q, int power) {
  VectorXcd column(s.size());
  for (Index l = 0; l < s.size(); ++l) {
    const complex here = std::pow(s(l) - p, power);
    const complex mirrored = std::pow(s(l) - std::conj(p), power);
    column(l) = s(l) * s(l) * (q / here + std::conj(q) / mirrored);
  }
  return stacked(column);
}

// Columns of z by pairs, of the shifts by pairs, then the residual terms.
MatrixXd columns_of(const VectorXcd& s, const VectorXcd& poles, bool shifts) {
  const Index modes = poles.size();
  const Index pairs = shifts ? 2 * modes : modes;
  const VectorXcd beside = poles_beside(s);
  MatrixXd A(2 * s.size(), 2 * (pairs + beside.size()) + residual_terms);
  for (Index k = 0; k < modes; ++k) {
    const complex unit = 1.0 / complex(0.0, 2.0 * poles(k).imag());
    for (int power = 1; power <= (shifts ? 2 : 1); ++power) {
      const Index first = 2 * (power == 1 ? k : modes + k);
      A.col(first) = pole_column(s, poles(k), unit, power);
      A.col(first + 1) =
          pole_column(s, poles(k), complex(0.0, 1.0) * unit, power);
    }
  }
  for (Index k = 0; k < beside.size(); ++k) {
    const complex unit = 1.0 / complex(0.0, 2.0 * beside(k).imag());
    const Index first = 2 * (pairs + k);
    A.col(first) = pole_column(s, beside(k), unit, 1);
    A.col(first + 1) = pole_column(s, beside(k), complex(0.0, 1.0) * unit, 1);
  }
  const double scale = s.cwiseAbs().maxCoeff();
  VectorXcd term = VectorXcd::Ones(s.size());
  for (Index i = 0; i < residual_terms; ++i) {
    A.col(2 * (pairs + beside.size()) + i) = stacked(term);
    term = term.cwiseProduct(s).cwiseProduct(s) / (scale * scale);
  }
  return A;
}

VectorXd weights_of(const signal::Frf& frf) {
  const double floor =
      0.1 * relative_scale *
      std::sqrt(frf.H.squaredNorm() / static_cast<double>(frf.H.size()));
  VectorXd weight(2 * frf.H.size());
  for (Index l = 0; l < frf.H.size(); ++l) {
    const double variance =
        frf.variance.size() == frf.H.size() ? 0.5 * frf.variance(l) : 0.0;
    const double of_size = relative_scale * std::abs(frf.H(l));
    weight(l) =
        1.0 / std::sqrt(variance + of_size * of_size + floor * floor + 1e-300);
    weight(frf.H.size() + l) = weight(l);
  }
  return weight;
}

double left_share(const signal::Frf& frf, const VectorXd& rest) {
  const double noise =
      frf.variance.size() == frf.H.size() ? frf.variance.sum() : 0.0;
  const double power = frf.H.squaredNorm();
  if (!(power > 0.0)) return 0.0;
  return std::sqrt(std::max(rest.squaredNorm() - noise, 0.0) / power);
}

ModalConstants constants_of(const signal::Frf& frf,
                            const MatrixXd& columns,
                            const VectorXcd& poles,
                            bool shifts) {
  const VectorXd weight = weights_of(frf);
  const VectorXd y = stacked(frf.H);
  MatrixXd A = weight.asDiagonal() * columns;
  const VectorXd scale = A.colwise().norm().transpose().cwiseMax(1e-300);
  A = A * scale.cwiseInverse().asDiagonal();
  MatrixXd normal = A.transpose() * A;
  // Columns of modes that all but coincide share what they explain.
  normal.diagonal().array() += 1e-12;
  const Eigen::LDLT<MatrixXd> factor(normal);
  const VectorXd b = A.transpose() * weight.cwiseProduct(y);
  const VectorXd scaled = factor.solve(b);
  const VectorXd c = scaled.cwiseQuotient(scale);
  const VectorXd rest = y - columns * c;
  const double freedom =
      std::max(static_cast<double>(y.size() - c.size()), 1.0);
  const double scatter =
      std::sqrt(weight.cwiseProduct(rest).squaredNorm() / freedom);
  const VectorXd spread = factor.solve(MatrixXd::Identity(c.size(), c.size()))
                              .diagonal()
                              .cwiseMax(0.0)
                              .cwiseSqrt()
                              .cwiseQuotient(scale) *
                          scatter;
  const Index modes = poles.size();
  ModalConstants found;
  found.z.resize(modes);
  found.sd.resize(modes);
  found.peak.resize(modes);
  if (shifts) {
    found.shift.resize(modes);
    found.shift_sd.resize(modes);
  }
  for (Index k = 0; k < modes; ++k) {
    found.z(k) = {c(2 * k), c(2 * k + 1)};
    found.sd(k) = std::max(spread(2 * k), spread(2 * k + 1));
    const double zeta = -poles(k).real() / std::abs(poles(k));
    found.peak(k) = std::abs(found.z(k)) / (2.0 * std::max(zeta, 1e-6));
    if (!shifts) continue;
    const Index at = 2 * (modes + k);
    const double size = std::max(std::abs(found.z(k)), 1e-300);
    const complex dp = complex(c(at), c(at + 1)) / found.z(k);
    found.shift(k) = dp.imag() / poles(k).imag();
    found.shift_sd(k) =
        std::max(spread(at), spread(at + 1)) / size / poles(k).imag();
  }
  found.left = left_share(frf, rest);
  return found;
}

}  // namespace

VectorXcd poles_beside(const VectorXcd& s) {
  const double low = s.imag().minCoeff();
  const double high = s.imag().maxCoeff();
  const std::array<double, 6> at{
      0.9 * low, 0.98 * low, 1.02 * high, 1.07 * high, 1.2 * high, 1.6 * high};
  VectorXcd poles(static_cast<Index>(at.size()));
  for (std::size_t k = 0; k < at.size(); ++k) {
    poles(static_cast<Index>(k)) = complex(-0.01 * at[k], at[k]);
  }
  return poles;
}

std::vector<ModalConstants> modal_constants(const signal::FrfSet& set,
                                            const VectorXcd& poles,
                                            bool shifts) {
  std::vector<ModalConstants> of(set.frfs.size());
  if (of.empty() || set.lines() == 0) return of;
  const MatrixXd columns = columns_of(set.s, poles, shifts);
  for_each_parallel(of.size(), [&](std::size_t f) {
    of[f] = constants_of(set.frfs[f], columns, poles, shifts);
  });
  return of;
}

}  // namespace tapfit::modal
