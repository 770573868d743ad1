#include "updating/signature.hpp"

#include "updating/place_patterns.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

// Weighted least squares of z = size * law; returns the size and the share of
// z (in the same weights) that is left.
std::pair<double, double> fit_law(const VectorXcd& z,
                                  const VectorXd& weight,
                                  const VectorXcd& law) {
  double numerator = 0.0;
  double denominator = 0.0;
  double all = 0.0;
  for (Index l = 0; l < z.size(); ++l) {
    const double w = weight(l) * weight(l);
    numerator += w * (std::conj(law(l)) * z(l)).real();
    denominator += w * std::norm(law(l));
    all += w * std::norm(z(l));
  }
  if (denominator <= 0.0 || all <= 0.0) return {0.0, 1.0};
  const double size = numerator / denominator;
  double left = 0.0;
  for (Index l = 0; l < z.size(); ++l) {
    left += weight(l) * weight(l) * std::norm(z(l) - size * law(l));
  }
  return {size, std::sqrt(left / all)};
}

}  // namespace

Signature signature_at(const Fit& current,
                       const Target& target,
                       int node,
                       const Progress& progress) {
  const PlacePatterns patterns = place_patterns(
      current,
      target,
      {current.model->row(node, current.model->setting().component)},
      progress);
  const Eigen::MatrixXcd model =
      current.model->respond(current.result.state, target.s, false).H;
  const Index lines = target.s.size();
  Signature result;
  result.node = node;
  result.frequency_hz = target.s.imag() / (2.0 * std::numbers::pi);
  result.z.resize(lines);
  result.z_sd.resize(lines);
  double all = 0.0;
  double left = 0.0;
  // A law is fitted where the effect shows: an error of z counts by what it
  // does to the FRFs.
  VectorXd weight(lines);
  for (Index l = 0; l < lines; ++l) {
    const complex<double> s2 = target.s(l) * target.s(l);
    const VectorXcd pattern = s2 * patterns.pattern[0].row(l).transpose();
    const VectorXcd missing = (model.row(l) - target.H.row(l)).transpose();
    const double power = std::max(pattern.squaredNorm(), 1e-300);
    const complex<double> w = pattern.dot(missing) / power;
    const double misfit = (missing - w * pattern).squaredNorm();
    const double freedom =
        std::max<double>(1.0, static_cast<double>(pattern.size() - 1));
    const double w_sd = std::sqrt(misfit / freedom / power);
    const complex<double> own = patterns.own[0].row(l).mean();
    const complex<double> turn = 1.0 - own * w;
    const double safe = std::max(std::abs(turn), 1e-9);
    result.z(l) = w * std::conj(turn) / (safe * safe);
    result.z_sd(l) = w_sd / (safe * safe);
    weight(l) = std::sqrt(power) * safe * safe / target.weight(l);
    const double scale = std::pow(target.weight(l), -2);
    all += scale * missing.squaredNorm();
    left += scale * misfit;
  }
  result.explained = all > 0.0 ? 1.0 - left / all : 0.0;
  const VectorXcd& s = target.s;
  std::tie(result.mass_kg, result.mass_unexplained) =
      fit_law(result.z, weight, s.cwiseProduct(s));
  std::tie(result.spring_n_per_m, result.spring_unexplained) =
      fit_law(result.z, weight, VectorXcd::Ones(lines));
  std::tie(result.dashpot_ns_per_m, result.dashpot_unexplained) =
      fit_law(result.z, weight, s);
  return result;
}

}  // namespace tapfit::updating
