#include "modal/fit/mode_significance.hpp"

#include "modal/fit/fit_residual.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Lines within a few half bandwidths of a pole: begin, end.
LineRange around(const WeightedFrfs& curves, const Complex& pole) {
  const double half =
      std::max(3.0 * (curves.sigma - pole.real()), 6.0 * curves.spacing);
  const double first = curves.s(0).imag();
  const auto index = [&](double omega) {
    const double k = std::round((omega - first) / curves.spacing);
    return static_cast<Index>(
        std::clamp(k, 0.0, static_cast<double>(curves.lines() - 1)));
  };
  const Index last = curves.lines() - 1;
  Index begin = index(pole.imag() - half);
  Index end = index(pole.imag() + half);
  begin = std::min(begin, std::max<Index>(0, last - 6));
  end = std::max(end, std::min<Index>(last, 6));
  return {begin, end + 1};
}

/// The drop in misfit that the residues of mode r earn.
double earned(const LinearFit& linear,
              const Eigen::MatrixXd& R_inverse,
              Index r) {
  const auto rows = R_inverse.middleRows(2 * r, 2);
  const Eigen::Matrix2d own = (rows * rows.transpose()).inverse();
  const Eigen::MatrixXd c = linear.scale.segment<2>(2 * r).asDiagonal() *
                            linear.coefficients.middleRows(2 * r, 2);
  return c.cwiseProduct(own * c).sum();
}

/// Of all of H at the line in the middle.
double contribution(const WeightedFrfs& curves,
                    const ModalFit& fit,
                    Index r,
                    Index line) {
  const Complex s(curves.sigma, fit.poles(r).imag());
  const Eigen::VectorXd peak = fit.residues.col(r).cwiseAbs() *
                               (std::norm(s) / std::abs(s - fit.poles(r)));
  const Eigen::VectorXd level = curves.H.row(line).cwiseAbs().transpose();
  return peak.cwiseProduct(fit.frf_weight).norm() /
         std::max(level.cwiseProduct(fit.frf_weight).norm(), 1e-300);
}

}  // namespace

void judge_modes(const WeightedFrfs& curves,
                 const LinearFit& linear,
                 ModalFit& fit) {
  const Index modes = fit.poles.size();
  const Index n = linear.scale.size();
  const Eigen::MatrixXd R_inverse =
      linear.R.triangularView<Eigen::Upper>().solve(
          Eigen::MatrixXd::Identity(n, n));
  fit.significance.resize(modes);
  fit.contribution.resize(modes);
  // An exponential window spreads noise over about sigma T lines, in the very
  // form of a resonance.
  const double shared =
      std::max(1.0, 2.0 * std::numbers::pi * curves.sigma / curves.spacing);
  std::vector<LineRange> ranges;
  for (const Complex& pole : fit.poles) ranges.push_back(around(curves, pole));
  const Eigen::VectorXd left = left_per_line(curves, fit, ranges);
  for (Index r = 0; r < modes; ++r) {
    const auto [begin, end] = ranges[static_cast<std::size_t>(r)];
    // Mean squares, of real values.
    const double noise = left.segment(begin, end - begin).sum() /
                         static_cast<double>(end - begin);
    fit.significance(r) =
        earned(linear, R_inverse, r) / std::max(shared * noise, 1e-300);
    const Index line = std::clamp((begin + end - 1) / 2, begin, end - 1);
    fit.contribution(r) = contribution(curves, fit, r, line);
  }
}

}  // namespace tapfit::modal
