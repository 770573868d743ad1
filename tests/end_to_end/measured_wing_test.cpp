// A real test that was published as modes: a flying wing, hung free, with its
// makers' deck, which has one mode far from where it was measured.
#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <filesystem>

namespace tapfit::end_to_end {
namespace {

using nlohmann::json;

const std::filesystem::path wing = TAPFIT_SOURCE_DIR "/recordings/maewing1";

json of_wing(const std::string& command, const std::filesystem::path& input) {
  const auto result =
      run_tapfit(fmt::format("{} '{}' --json", command, input.string()));
  EXPECT_EQ(result.exit_status, 0) << result.err;
  return result.exit_status == 0 ? json::parse(result.out) : json();
}

TEST(MeasuredWing, ItsDeckHasTheModesThatItsMakersNastranPrinted) {
  const json hz = of_wing("model", wing / "model.bdf").at("frequencies_hz");
  // Seven digits are printed.
  const std::array<double, 4> printed{7.949976, 12.54754, 15.91975, 18.67089};
  ASSERT_GE(hz.size(), 10U);
  EXPECT_LT(hz[5].get<double>(), 0.01) << "six modes of a rigid body";
  for (std::size_t k = 0; k < printed.size(); ++k) {
    EXPECT_NEAR(hz[6 + k].get<double>(), printed.at(k), 1e-5 * printed.at(k));
  }
}

// Five frequencies say that the body gives, as docs/real-test.md tells; joints
// that the screening puts first say nothing there, so that all must be tried.
TEST(MeasuredWing, GivesInTheBodyAndIsNotTiedToTheWallByASpring) {
  const json found = of_wing("diagnose", wing);
  EXPECT_EQ(found.at("verdict"), "joint");
  EXPECT_LT(found.at("error").at("best").get<double>(), 0.01);
  EXPECT_NE(found.at("warnings").dump().find("suspension_hz"),
            std::string::npos);
  // The stiffest moves the whole wing: 6.25 kg, a fifth of 8.04 Hz.
  const double most = 6.25 * std::pow(2.0 * M_PI * 0.2 * 8.04, 2) * 1.01;
  for (const json& candidate : found.at("candidates")) {
    if (candidate.at("effect") != "ground-spring") continue;
    const json& size = candidate.at("parameters").at("stiffness_n_per_m");
    EXPECT_LE(size.at("value").get<double>(), most) << candidate.dump();
  }
}

}  // namespace
}  // namespace tapfit::end_to_end
