// A channel in another unit than the sheet says: kN for N, g for m/s^2, pounds,
// inches, a range switch a decade off, or velocity where acceleration is meant.
// Its FRFs are multiplied by a known factor, or by s to a power. In one run
// only, with those of its placement, where the range was changed there.
#pragma once

#include "updating/set_up/channel_effect.hpp"

#include <optional>

namespace tapfit::effects {

class UnitFactor final : public ChannelEffect {
 public:
  [[nodiscard]] std::string name() const override { return "unit-factor"; }
  [[nodiscard]] std::string physics() const override {
    return "a channel in another unit than written down; a known factor at "
           "every frequency, or once integrated, no frequency moves";
  }
  /// All sensors together and each channel with each factor that it may read
  /// too much by (Where::variant), in all runs, then one channel in the runs of
  /// one placement, which are averaged.
  [[nodiscard]] std::vector<Where> places(
      const Setting& setting) const override;
  [[nodiscard]] bool at_sheet_points() const override { return true; }
  [[nodiscard]] std::vector<std::string> variants() const override;
  [[nodiscard]] std::vector<ParameterSpec> parameters(
      const Where&, const Setting&) const override {
    return {};
  }
  [[nodiscard]] std::vector<Fixed> fixed(const Where& where) const override;
  /// Twice the factor's position; one more for the hammer.
  [[nodiscard]] std::size_t passed_as(const Where& where,
                                      bool hammer) const override;
  [[nodiscard]] std::complex<double> law(std::complex<double> s,
                                         const std::vector<double>& p,
                                         std::size_t group) const override;
  [[nodiscard]] std::complex<double> law_derivative(
      std::complex<double>,
      const std::vector<double>&,
      std::size_t,
      std::size_t) const override {
    return 0.0;
  }
  /// A sensitivity, or what is measured, then in its SI unit; nothing for
  /// single runs, which have the same sensitivity on the sheet as the others.
  void correct(const Where& where,
               const acquisition::TestBundle& written,
               acquisition::TestBundle& sheet) const override;
  [[nodiscard]] std::vector<std::string> bulk_data(
      const Where& where,
      const Setting& setting,
      const std::vector<double>& p) const override;
};

}  // namespace tapfit::effects
