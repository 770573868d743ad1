#include "updating/damping_statement.hpp"

#include "updating/effects/catalogue.hpp"
#include "updating/estimates.hpp"
#include "updating/evidence.hpp"

#include <fmt/format.h>

namespace tapfit::updating {

std::optional<std::string> damping_statement(const Fit& fit,
                                             const Fitter& fitter,
                                             double data,
                                             const Progress& progress) {
  const effects::Effect& effect = effects::find("damping-law");
  const effects::Setting& setting = fitter.setting().setting;
  PlacedEffect law{&effect, {}, {}};
  const std::vector<effects::ParameterSpec> specs =
      effect.parameters({}, setting);
  for (const effects::ParameterSpec& spec : specs) law.p.push_back(spec.start);
  const auto ratios = static_cast<double>(fit.result.state.zeta.size());
  const auto size = static_cast<double>(law.p.size());
  if (ratios <= size) return std::nullopt;
  std::vector<PlacedEffect> effects = fit.effects;
  effects.push_back(law);
  const Fit with = fitter.fit(effects, fitter.model_for(effects), progress);
  if (log_evidence(with.result.error, size, 1.0, data) <=
      log_evidence(fit.result.error, ratios, 1.0, data)) {
    return std::nullopt;
  }
  std::string sizes;
  std::size_t k = 0;
  for (const Estimate& e :
       effect_estimates(with, with.effects.size() - 1, setting)) {
    // What the data do not ask for lies at its lower bound.
    if (e.value < 2.0 * specs[k++].lower) continue;
    sizes += fmt::format("{}{} {:.3g} (95 % {:.2g} to {:.2g})",
                         sizes.empty() ? "" : ", ",
                         e.name,
                         e.value,
                         e.lo95,
                         e.hi95);
  }
  return fmt::format(
      "the damping of the modes follows one law (damping-law): {}; error "
      "{:.3g} with it, {:.3g} with a ratio for each mode",
      sizes,
      with.result.error,
      fit.result.error);
}

}  // namespace tapfit::updating
