// What effects that change the base's stiffness matrix share: parameters that
// scale the parts of the change, and no degrees of freedom of their own.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

namespace tapfit::effects {

class StiffnessEffect : public Effect {
 public:
  [[nodiscard]] Entry entry() const final { return Entry::Stiffness; }
  [[nodiscard]] std::vector<ActedDof> acts_on(const Where&,
                                              const Setting&,
                                              std::size_t) const final {
    return {};
  }
  [[nodiscard]] std::complex<double> law(std::complex<double>,
                                         const std::vector<double>& p,
                                         std::size_t group) const final {
    return p[group];
  }
  [[nodiscard]] std::complex<double> law_derivative(std::complex<double>,
                                                    const std::vector<double>&,
                                                    std::size_t group,
                                                    std::size_t k) const final {
    return group == k ? 1.0 : 0.0;
  }
};

}  // namespace tapfit::effects
