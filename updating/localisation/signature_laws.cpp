#include "updating/localisation/signature_laws.hpp"

#include <algorithm>
#include <complex>
#include <numbers>
#include <utility>

namespace tapfit::updating {

Eigen::VectorXd SignatureLaw::shown() const {
  return is_imaginary() ? Eigen::VectorXd(z.imag()) : Eigen::VectorXd(z.real());
}

std::vector<SignatureLaw> signature_laws(const Signature& signature) {
  const Signature& at = signature;
  using namespace std::complex_literals;
  const Eigen::VectorXcd s = 2.0i * std::numbers::pi * at.frequency_hz;
  std::vector<SignatureLaw> laws{
      {"mass",
       "mass_kg",
       at.mass_kg,
       at.mass_unexplained,
       at.mass_kg * s.cwiseProduct(s)},
      {"spring",
       "stiffness_n_per_m",
       at.spring_n_per_m,
       at.spring_unexplained,
       Eigen::VectorXcd::Constant(s.size(), at.spring_n_per_m)},
      {"dashpot",
       "damping_ns_per_m",
       at.dashpot_ns_per_m,
       at.dashpot_unexplained,
       at.dashpot_ns_per_m * s}};
  if (at.absorber.mass_kg > 0.0) {
    laws.push_back({"absorber",
                    "mass_kg",
                    at.absorber.mass_kg,
                    at.absorber.unexplained,
                    absorber_stiffness(at.absorber, s)});
  }
  return laws;
}

SignatureLaw best_law(const Signature& signature, bool resonant) {
  std::vector<SignatureLaw> laws = signature_laws(signature);
  if (laws.back().effect == "absorber") {
    if (resonant) return std::move(laws.back());
    laws.pop_back();
  }
  return *std::ranges::min_element(laws, {}, &SignatureLaw::unexplained);
}

}  // namespace tapfit::updating
