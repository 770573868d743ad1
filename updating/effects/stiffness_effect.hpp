// What effects that change the base's stiffness matrix share: one parameter,
// which scales the change, and no degrees of freedom of their own.
#pragma once

#include "updating/effects/effect.hpp"

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
                                         std::size_t) const final {
    return p[0];
  }
  [[nodiscard]] std::complex<double> law_derivative(std::complex<double>,
                                                    const std::vector<double>&,
                                                    std::size_t,
                                                    std::size_t) const final {
    return 1.0;
  }
};

}  // namespace tapfit::effects
