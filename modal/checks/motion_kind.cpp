#include "modal/checks/motion_kind.hpp"

#include "modal/checks/modal_constants.hpp"
#include "modal/checks/run_poles.hpp"

#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <set>

namespace tapfit::modal {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using complex = std::complex<double>;

// Share that the right kind may leave, each line relative to its own size, and
// of what accelerance of either sign leaves.
constexpr double most_left = 0.2;
constexpr double most_of_other = 0.5;

MatrixXcd accelerance_terms(const VectorXcd& s, const VectorXcd& poles) {
  MatrixXcd terms(s.size(), poles.size() + 2);
  for (Index l = 0; l < s.size(); ++l) {
    const complex s2 = s(l) * s(l);
    for (Index k = 0; k < poles.size(); ++k) {
      terms(l, k) = s2 / ((s(l) - poles(k)) * (s(l) - std::conj(poles(k))));
    }
    terms(l, poles.size()) = 1.0;
    terms(l, poles.size() + 1) = s2;
  }
  return terms;
}

// What non-negative terms leave of H, each line relative to its size.
double left_of(const VectorXcd& H, const MatrixXcd& terms) {
  const double floor =
      0.1 * std::sqrt(H.squaredNorm() / static_cast<double>(H.size()));
  const VectorXd weight = (H.cwiseAbs().array() + floor).inverse();
  MatrixXd A(2 * H.size(), terms.cols());
  VectorXd b(2 * H.size());
  A << weight.asDiagonal() * terms.real(), weight.asDiagonal() * terms.imag();
  b << weight.cwiseProduct(H.real()), weight.cwiseProduct(H.imag());
  return (b - A * nonnegative_fit(A, b)).norm() / b.norm();
}

Finding displacement_finding(const signal::Frf& frf,
                             const std::string& channel,
                             double left,
                             double otherwise) {
  return {Severity::Error,
          {{frf.run}, channel, {}, name(frf)},
          fmt::format("its driving point is a receptance (positive modes leave "
                      "{:.2g} % of it), no accelerance ({:.2g} %)",
                      100.0 * left,
                      100.0 * otherwise),
          "the channel measures displacement, not acceleration",
          fmt::format("give {} \"quantity\": \"displacement\" and its unit in "
                      "test.json",
                      channel)};
}

}  // namespace

VectorXd nonnegative_fit(const MatrixXd& A, const VectorXd& b) {
  const VectorXd scale = A.colwise().norm().transpose().cwiseMax(1e-300);
  const MatrixXd unit = A * scale.cwiseInverse().asDiagonal();
  VectorXd x = VectorXd::Zero(A.cols());
  std::vector<Index> free;
  const double tiny = 1e-10 * b.norm();
  for (Index step = 0; step < 3 * A.cols() + 3; ++step) {
    const VectorXd gain = unit.transpose() * (b - unit * x);
    Index most = -1;
    for (Index k = 0; k < gain.size(); ++k) {
      if (std::ranges::count(free, k) > 0 || gain(k) <= tiny) continue;
      if (most < 0 || gain(k) > gain(most)) most = k;
    }
    if (most < 0) break;
    free.push_back(most);
    while (!free.empty()) {
      const VectorXd inner =
          MatrixXd(unit(Eigen::all, free)).householderQr().solve(b);
      double share = 1.0;
      for (std::size_t i = 0; i < free.size(); ++i) {
        const double now = x(free[i]);
        const double then = inner(static_cast<Index>(i));
        if (then <= 0.0) share = std::min(share, now / (now - then + 1e-300));
      }
      for (std::size_t i = 0; i < free.size(); ++i) {
        x(free[i]) += share * (inner(static_cast<Index>(i)) - x(free[i]));
      }
      if (share >= 1.0) break;
      std::erase_if(free, [&x](Index k) {
        const bool at_zero = x(k) <= 1e-14;
        if (at_zero) x(k) = 0.0;
        return at_zero;
      });
    }
  }
  return x.cwiseQuotient(scale);
}

std::vector<Finding> motion_kind_findings(const acquisition::TestBundle& bundle,
                                          const signal::FrfSet& set,
                                          const ModeSet& modes) {
  const VectorXcd poles = poles_of(modes);
  if (poles.size() == 0 || bundle.runs.empty()) return {};
  const VectorXcd beside = poles_beside(set.s);
  VectorXcd all(poles.size() + beside.size());
  all << poles, beside;
  const MatrixXcd terms = accelerance_terms(set.s, all);
  std::vector<Finding> findings;
  std::set<std::size_t> told;
  for (const signal::Frf& frf : set.frfs) {
    if (frf.response.node != frf.reference.node ||
        frf.response.component != frf.reference.component ||
        told.contains(frf.channel)) {
      continue;
    }
    const double sign = frf.response.sign * frf.reference.sign;
    const VectorXcd H = sign * frf.H;
    const VectorXcd as_displacement = H.cwiseProduct(set.s).cwiseProduct(set.s);
    const double accelerance = std::min(left_of(H, terms), left_of(-H, terms));
    const double receptance = std::min(left_of(as_displacement, terms),
                                       left_of(-as_displacement, terms));
    if (receptance > most_left || receptance > most_of_other * accelerance) {
      continue;
    }
    told.insert(frf.channel);
    findings.push_back(displacement_finding(
        frf, bundle.channels.at(frf.channel).name, receptance, accelerance));
  }
  return findings;
}

}  // namespace tapfit::modal
