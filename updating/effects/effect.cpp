#include "updating/effects/effect.hpp"

#include <cmath>

namespace tapfit::effects {
namespace {

// Of a unit parameter.
std::complex<double> unit_law(Law law, std::complex<double> s) {
  switch (law) {
    case Law::Spring:
      return 1.0;
    case Law::Damper:
      return s;
    case Law::Mass:
      return s * s;
    case Law::Own:
      break;
  }
  return 0.0;
}

}  // namespace

ParameterSpec spread(std::string name, double lower, double upper) {
  return {std::move(name), std::sqrt(lower * upper), lower, upper};
}

std::complex<double> Effect::law(std::complex<double> s,
                                 const std::vector<double>& p,
                                 std::size_t group) const {
  if (kind_.law == Law::Own) return 1.0;
  return unit_law(kind_.law, s) * p[group];
}

std::complex<double> Effect::law_derivative(std::complex<double> s,
                                            const std::vector<double>&,
                                            std::size_t group,
                                            std::size_t k) const {
  return group == k ? unit_law(kind_.law, s) : 0.0;
}

}  // namespace tapfit::effects
