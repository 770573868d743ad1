#include "updating/diagnosis/test_diagnosis.hpp"

#include "acquisition/bundle/channel_names.hpp"
#include "modal/mass_loading/sensor_shifts.hpp"
#include "updating/diagnosis/card_swap.hpp"
#include "updating/diagnosis/diagnose.hpp"
#include "updating/diagnosis/set_up_mistakes.hpp"
#include "updating/fit/fit_observer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::updating {

DiagnoseOptions options_of_test(const FitContext& ground,
                                const Comparison& base) {
  DiagnoseOptions options;
  options.floor = std::hypot(base.floor_noise, base.floor_mesh);
  options.floor_noise = base.floor_noise;
  options.contour = base.contour;
  options.properties = ground.properties;
  return options;
}

Diagnosis diagnose_test(const FitContext& ground,
                        const Fit& current,
                        const Comparison& base,
                        const MeasuredTest& test,
                        const std::vector<std::string>& of_model,
                        const Progress& progress) {
  DiagnoseOptions options = options_of_test(ground, base);
  if (const FitObserver* observer = fit_observer(progress)) {
    options.tried = observer->tried;
  }
  Diagnosis d = diagnose(*ground.fitter, current.effects, options, progress);
  if (current.effects.empty()) {
    if (auto slip = card_swap(*ground.fitter, d, options, progress)) {
      d.warnings.push_back(describe(*slip));
      d.set_up.push_back(std::move(*slip));
    }
  }
  // Nothing fitted yet: the base is the deck as it is.
  if (current.result.history.empty()) d.error_base = base.error;
  if (const auto& shifts = test.modes.shifts; modal::is_significant(shifts)) {
    d.warnings.push_back(modal::statement(
        *shifts, acquisition::channel_names(*test.context.bundle)));
  }
  for (const std::string& warning : of_model) {
    if (std::ranges::count(d.warnings, warning) > 0) continue;
    d.warnings.push_back(warning);
  }
  return d;
}

}  // namespace tapfit::updating
