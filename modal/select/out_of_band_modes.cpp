#include "modal/select/out_of_band_modes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

bool ran_away(const WeightedFrfs& curves, const Complex& pole) {
  constexpr double far = 4.0;
  const double omega = std::abs(pole);
  return far * omega < curves.s(0).imag() ||
         omega > far * curves.s(curves.lines() - 1).imag();
}

/// Tries one more pole outside the band, started at omega; keeps it when the
/// misfit falls clearly and the pole stays outside.
bool add_outside(const WeightedFrfs& curves, double omega, ModalFit& fit) {
  Eigen::VectorXcd poles(fit.poles.size() + 1);
  poles << fit.poles, Complex(-0.01 * omega, omega);
  ModalFit trial = refine_poles(curves, poles, 15);
  const Complex last = trial.poles(trial.poles.size() - 1);
  if (in_band(curves, last) || std::abs(last) > 10.0 * omega) return false;
  const Index before = fit.poles.size();
  for (Index r = 0; r < before; ++r) {
    if (in_band(curves, fit.poles(r)) != in_band(curves, trial.poles(r))) {
      return false;
    }
  }
  // Two parameters per FRF on 2 n_lines values fall by 1 / n_lines by chance.
  const double chance = 1.0 / static_cast<double>(curves.lines());
  const double least = 1.0 - 0.01 - 4.0 * chance;
  if (trial.misfit > least * fit.misfit) return false;
  fit = std::move(trial);
  return true;
}

}  // namespace

bool in_band(const WeightedFrfs& curves, const Complex& pole) {
  const double omega = std::abs(pole);
  return omega >= curves.s(0).imag() &&
         omega <= curves.s(curves.lines() - 1).imag();
}

bool far_outside(const WeightedFrfs& curves, const Complex& pole) {
  const double low = curves.s(0).imag();
  const double high = curves.s(curves.lines() - 1).imag();
  const double margin = 0.05 * (high - low);
  const double omega = std::abs(pole);
  return omega < low - margin || omega > high + margin;
}

std::pair<Index, Index> lines_within(const WeightedFrfs& curves,
                                     const Complex& pole,
                                     double reach) {
  const Eigen::ArrayXd off = (curves.s.imag().array() - pole.imag()).abs();
  const Index count = (off <= reach).count();
  Index nearest = 0;
  if (count == 0) return {0, 0};
  off.minCoeff(&nearest);
  Index begin = nearest;
  while (begin > 0 && off(begin - 1) <= reach) --begin;
  return {begin, count};
}

Eigen::VectorXcd without(const Eigen::VectorXcd& poles, Index leave_out) {
  Eigen::VectorXcd result(poles.size() - 1);
  result << poles.head(leave_out), poles.tail(poles.size() - leave_out - 1);
  return result;
}

ModalFit by_frequency(const WeightedFrfs& curves, const ModalFit& fit) {
  Eigen::VectorXcd poles = fit.poles;
  std::ranges::sort(poles, {}, [](const Complex& p) { return std::abs(p); });
  return fit_residues(curves, poles);
}

ModalFit refine_in_reach(const WeightedFrfs& curves,
                         Eigen::VectorXcd poles,
                         int iterations) {
  for (;;) {
    ModalFit fit = refine_poles(curves, poles, iterations);
    Index away = 0;
    while (away < poles.size() && !ran_away(curves, fit.poles(away))) ++away;
    if (away == poles.size()) return fit;
    poles = without(poles, away);
  }
}

void add_out_of_band_modes(const WeightedFrfs& curves, ModalFit& fit) {
  const double low = curves.s(0).imag();
  const double high = curves.s(curves.lines() - 1).imag();
  if (curves.lines() < 60) return;
  // The nearest disturbs most and is found only from close by.
  constexpr double close = 1.02;
  constexpr double apart = 1.15;
  (void)add_outside(curves, close * high, fit);
  if (add_outside(curves, apart * high, fit)) {
    (void)add_outside(curves, 1.5 * high, fit);
  }
  if (low < 0.1 * high) return;
  (void)add_outside(curves, low / close, fit);
  (void)add_outside(curves, low / apart, fit);
}

}  // namespace tapfit::modal
