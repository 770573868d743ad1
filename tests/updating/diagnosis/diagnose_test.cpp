#include "updating/diagnosis/diagnose.hpp"

#include "tests/updating/support/hidden_in_plate.hpp"
#include "updating/catalogue/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

class DiagnoseHidden : public support::HiddenInPlate {
 protected:
  static EffectInstance at(const std::string& kind, int grid, double p) {
    Location where;
    where.node = grid;
    return {&effects::find(kind), where, {p}};
  }
};

// With an effect in the model its fit is settled first, which is no part of the
// search; half of it is to come when the first effects are fitted.
TEST_F(DiagnoseHidden, SaysHowFarTheWholeIs) {
  hide({at("ground-spring", 31, 3000.0)});
  std::vector<std::pair<std::string, double>> reports;
  std::mutex one_at_a_time;
  Progress progress;
  progress.report = [&](std::string_view stage, double far) {
    const std::lock_guard lock(one_at_a_time);
    reports.emplace_back(stage, far);
  };
  DiagnoseOptions options;
  options.floor = options.floor_noise = 1e-4;
  std::size_t tried = 0;
  std::size_t tried_before = 0;
  options.tried = [&](const Candidate&) {
    const std::lock_guard lock(one_at_a_time);
    ++tried;
    // Those that are fitted to the end come after six tenths of the fits.
    if (reports.empty() || reports.back().second < 0.2) ++tried_before;
  };
  const Diagnosis d =
      diagnose(*fitter_, {at("added-mass", 14, 0.001)}, options, progress);
  EXPECT_FALSE(d.candidates.empty());
  const auto fitting =
      std::ranges::find(reports, "fitting effects", [](const auto& report) {
        return std::string_view(report.first);
      });
  ASSERT_NE(fitting, reports.end());
  EXPECT_LT(fitting->second, 0.5);
  EXPECT_TRUE(std::ranges::is_sorted(
      reports, {}, &std::pair<std::string, double>::second));
  EXPECT_GT(tried, 0U);
  EXPECT_GT(tried_before, 0U);
}

// A candidate's error is what the model is left with once it is added.
TEST_F(DiagnoseHidden, TellsErrorsOfFitsThatHaveSettled) {
  hide({at("ground-spring", 31, 3000.0), at("added-mass", 14, 0.003)});
  DiagnoseOptions options;
  options.floor = options.floor_noise = 1e-4;
  options.max_rungs = 1;
  const Diagnosis d = diagnose(*fitter_, {}, options, {});
  ASSERT_FALSE(d.candidates.empty());
  // Fits of others may end in another minimum.
  int compared = 0;
  for (const Candidate& c : d.candidates) {
    if (c.where.node == 0 || !c.where.channels.empty()) continue;
    ++compared;
    const EffectInstance own{&effects::find(c.effect), c.where, c.sizes};
    const Fit again =
        fitter_->settled(fitter_->fit({own}, fitter_->model_for({own})), {});
    EXPECT_NEAR(c.error / again.result.error, 1.0, 2e-3)
        << effect_text(c.effect, c.where);
  }
  EXPECT_GT(compared, 3);
}

}  // namespace
}  // namespace tapfit::updating
