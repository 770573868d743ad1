#include "updating/localisation/absorber_law.hpp"

#include "acquisition/foundation/constants.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

class Search {
 public:
  Search(const VectorXcd& z, const VectorXd& weight, const VectorXcd& s)
      : z_(z), weight_(weight), s_(s) {}

  /// Takes it over where it leaves less than the best so far. One that does not
  /// resonate on the lines is a mass or a spring there.
  bool look_at(double frequency_hz, double damping_ratio) {
    if (frequency_hz < s_.imag().minCoeff() / two_pi ||
        frequency_hz > s_.imag().maxCoeff() / two_pi || damping_ratio > 1.0) {
      return false;
    }
    AbsorberLaw tried{1.0, frequency_hz, damping_ratio, 1.0};
    const LawFit fit = fit_law(z_, weight_, absorber_stiffness(tried, s_));
    if (!(fit.size > 0.0) || !(fit.unexplained < best_.unexplained)) {
      return false;
    }
    best_ = {fit.size, frequency_hz, damping_ratio, fit.unexplained};
    return true;
  }

  void scan() {
    constexpr std::array<double, 5> ratios{0.003, 0.01, 0.03, 0.1, 0.3};
    for (const std::complex<double>& s : s_) {
      for (const double ratio : ratios) look_at(s.imag() / two_pi, ratio);
    }
  }

  /// Steps along the logarithms of both, shorter where none leads on.
  void refine() {
    double step = 0.5;
    while (step > 1e-4 && best_.mass_kg > 0.0) {
      const AbsorberLaw at = best_;
      const double up = std::exp(step);
      const double damped = std::exp(2.0 * step);
      bool any = look_at(at.frequency_hz * up, at.damping_ratio);
      any |= look_at(at.frequency_hz / up, at.damping_ratio);
      any |= look_at(at.frequency_hz, at.damping_ratio * damped);
      any |= look_at(at.frequency_hz, at.damping_ratio / damped);
      if (!any) step *= 0.5;
    }
  }

  [[nodiscard]] const AbsorberLaw& best() const { return best_; }

 private:
  const VectorXcd& z_;
  const VectorXd& weight_;
  const VectorXcd& s_;
  AbsorberLaw best_;
};

}  // namespace

LawFit fit_law(const VectorXcd& z,
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
  if (denominator <= 0.0 || all <= 0.0) return {};
  const double size = numerator / denominator;
  double left = 0.0;
  for (Index l = 0; l < z.size(); ++l) {
    left += weight(l) * weight(l) * std::norm(z(l) - size * law(l));
  }
  return {size, std::sqrt(left / all)};
}

VectorXcd absorber_stiffness(const AbsorberLaw& absorber, const VectorXcd& s) {
  const double w = two_pi * absorber.frequency_hz;
  const double c = 2.0 * absorber.damping_ratio * w;
  VectorXcd z(s.size());
  for (Index l = 0; l < s.size(); ++l) {
    const std::complex<double> held = c * s(l) + w * w;
    const std::complex<double> s2 = s(l) * s(l);
    z(l) = absorber.mass_kg * s2 * held / (s2 + held);
  }
  return z;
}

AbsorberLaw fit_absorber(const VectorXcd& z,
                         const VectorXd& weight,
                         const VectorXcd& s) {
  Search search(z, weight, s);
  search.scan();
  search.refine();
  return search.best();
}

}  // namespace tapfit::updating
