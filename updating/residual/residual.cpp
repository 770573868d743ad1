#include "updating/residual/residual.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace tapfit::updating {

using Eigen::Index;

double Target::count() const {
  return std::accumulate(use.begin(), use.end(), 0.0) *
         static_cast<double>(s.size());
}

Target make_target(const signal::FrfSet& measured) {
  Target target;
  target.s = measured.s;
  const auto n = static_cast<Index>(measured.frfs.size());
  target.H.resize(measured.lines(), n);
  target.variance.resize(measured.lines(), n);
  for (Index k = 0; k < n; ++k) {
    const signal::Frf& frf = measured.frfs[static_cast<std::size_t>(k)];
    target.H.col(k) = frf.H;
    target.variance.col(k) = frf.variance;
    target.run.push_back(frf.run);
    target.use.push_back(1.0);
  }
  target.weight =
      target.H.cwiseAbs2().rowwise().mean().cwiseSqrt().cwiseMax(1e-300);
  return target;
}

Target make_target(const ModalData& measured) {
  const Index p = measured.modes();
  const Index n = measured.points();
  Target target;
  target.s = std::complex<double>(0.0, 2.0 * std::numbers::pi) *
             measured.frequency_hz.cast<std::complex<double>>();
  target.H = measured.response().cast<std::complex<double>>();
  target.weight = Eigen::VectorXd::Ones(p);
  target.run.assign(static_cast<std::size_t>(1 + n), 0);
  target.use.assign(static_cast<std::size_t>(1 + n), 1.0);
  target.modal_sd = measured.sd;
  // A shape's factor is fitted and takes one of its values.
  const double of_shapes =
      n > 0 ? static_cast<double>(n - 1) / static_cast<double>(n) : 0.0;
  target.variance.setConstant(p, 1 + n, of_shapes);
  target.variance.col(0).setOnes();
  target.variance *= measured.sd * measured.sd;
  return target;
}

void leave_out(const std::vector<std::size_t>& runs, Target& target) {
  for (std::size_t f = 0; f < target.run.size(); ++f) {
    if (std::ranges::count(runs, target.run[f]) > 0) target.use[f] = 0.0;
  }
}

double block_error(const Target& target,
                   const Eigen::MatrixXcd& H,
                   Index first_line,
                   Index lines,
                   Index first_frf,
                   Index frfs) {
  double sum = 0.0;
  double count = 0.0;
  for (Index f = first_frf; f < first_frf + frfs; ++f) {
    const double use = target.use[static_cast<std::size_t>(f)];
    for (Index l = first_line; l < first_line + lines; ++l) {
      sum += use * std::norm((H(l, f) - target.H(l, f)) / target.weight(l));
      count += use;
    }
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

double relative_error(const Target& target, const Eigen::MatrixXcd& H) {
  return block_error(target, H, 0, target.s.size(), 0, target.H.cols());
}

double frf_error(const Target& target, const Eigen::MatrixXcd& H, Index frf) {
  return block_error(target, H, 0, target.s.size(), frf, 1);
}

double noise_error(const Target& target) {
  double sum = 0.0;
  for (Index f = 0; f < target.H.cols(); ++f) {
    const double use = target.use[static_cast<std::size_t>(f)];
    for (Index l = 0; l < target.s.size(); ++l) {
      sum += use * target.variance(l, f) / std::pow(target.weight(l), 2);
    }
  }
  const double count = target.count();
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

Eigen::VectorXd stack(const Target& target,
                      const Eigen::MatrixXcd& difference) {
  const Index lines = target.s.size();
  const Index frfs = target.H.cols();
  const double scale = 1.0 / std::sqrt(std::max(target.count(), 1.0));
  Eigen::VectorXd r =
      Eigen::VectorXd::Zero(2 * lines * frfs + (target.is_modal() ? 1 : 0));
  const Eigen::ArrayXd share = scale / target.weight.array();
  for (Index f = 0; f < frfs; ++f) {
    const double use = target.use[static_cast<std::size_t>(f)];
    const Eigen::ArrayXcd d = (use * share) * difference.col(f).array();
    r.segment(2 * lines * f, lines) = d.real();
    r.segment(2 * lines * f + lines, lines) = d.imag();
  }
  return r;
}

Eigen::VectorXd residual(const Target& target, const Eigen::MatrixXcd& H) {
  Eigen::VectorXd r = stack(target, H - target.H);
  if (target.is_modal()) {
    r(r.size() - 1) =
        target.modal_sd * std::sqrt(known_scatter / target.count());
  }
  return r;
}

double error_of(const Target& target, const Eigen::VectorXd& residual) {
  return residual.head(2 * target.H.size()).norm();
}

}  // namespace tapfit::updating
