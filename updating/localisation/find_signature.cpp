#include "updating/localisation/find_signature.hpp"

#include "updating/catalogue/catalogue.hpp"
#include "updating/localisation/absorber_law.hpp"
#include "updating/localisation/first_order_sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;
using std::complex;

Signature signature_at(Fit current,
                       const Fitter& fitter,
                       int node,
                       const Progress& progress) {
  // The base gains the static response at the grid looked at: without it the
  // grid's own flexibility would be taken for something missing.
  std::vector<EffectInstance> with_node = current.effects;
  with_node.push_back({&effects::find("added-mass"), {}, {1.0}});
  with_node.back().where.node = node;
  current.model = fitter.model_for(with_node);
  const Target& target = fitter.target();
  const FirstOrderSensitivity patterns = first_order_sensitivity(
      current,
      target,
      {current.model->row(node, current.model->context().component)},
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
  // Of one datum a line any place explains all.
  const bool tells = all > 0.0 && target.H.cols() > 1;
  result.explained = tells ? 1.0 - left / all : 0.0;
  const VectorXcd& s = target.s;
  const LawFit mass = fit_law(result.z, weight, s.cwiseProduct(s));
  const LawFit spring = fit_law(result.z, weight, VectorXcd::Ones(lines));
  const LawFit dashpot = fit_law(result.z, weight, s);
  result.mass_kg = mass.size;
  result.mass_unexplained = mass.unexplained;
  result.spring_n_per_m = spring.size;
  result.spring_unexplained = spring.unexplained;
  result.dashpot_ns_per_m = dashpot.size;
  result.dashpot_unexplained = dashpot.unexplained;
  result.absorber = fit_absorber(result.z, weight, s);
  return result;
}

}  // namespace tapfit::updating
