// What mistakes of the sheet share: points, directions or channels in test.json
// that were not those of the test. They are put right in the sheet, see
// Effect::correct(); the FRFs themselves are left as they are, and nothing
// acts on the structure.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

#include <fmt/format.h>

namespace tapfit::effects {

class SheetMistake : public Effect {
 public:
  [[nodiscard]] Entry entry() const final { return Entry::Measurement; }
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where&, const Setting&) const final {
    return {};
  }
  [[nodiscard]] std::vector<ActedDof> acts_on(const Where&,
                                              const Setting&,
                                              std::size_t) const final {
    return {};
  }
  [[nodiscard]] std::complex<double> law(std::complex<double>,
                                         const std::vector<double>&,
                                         std::size_t) const final {
    return 1.0;
  }
  [[nodiscard]] std::complex<double> law_derivative(std::complex<double>,
                                                    const std::vector<double>&,
                                                    std::size_t,
                                                    std::size_t) const final {
    return 0.0;
  }
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Where& where,
      const Setting&,
      const std::vector<double>&) const final {
    return {fmt::format("$ The sheet is at fault, not the model: {}, {}",
                        name(),
                        describe(where))};
  }
};

}  // namespace tapfit::effects
