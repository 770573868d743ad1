#include "updating/virtual_test/virtual_support.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/virtual_strip.hpp"
#include "updating/virtual_test/virtual_panel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using support::Strip;

TEST(VirtualSupport, SoftSupportRunsFromClampToHinge) {
  const Strip strip;
  const double clamped = strip.reduced({}).frequency_hz(0);
  const double stiff = strip.reduced({"soft-support=1e9"}).frequency_hz(0);
  const double soft = strip.reduced({"soft-support=300"}).frequency_hz(0);
  // D / (k L) = 1e-6 at the stiffest.
  EXPECT_NEAR(stiff, clamped, 1e-4 * clamped);
  EXPECT_LT(soft, 0.98 * clamped);
  // A rigid strip on a hinge: w^2 = k b / (m b L^2 / 3). The strip bends, so
  // this is approached from below when the hinge is slack.
  const double k = 0.5;
  const double mass_per_area = 2700.0 * 0.002;
  const double rigid =
      std::sqrt(k / (mass_per_area * std::pow(0.30, 3) / 3.0)) / two_pi;
  const double slack = strip.reduced({"soft-support=0.5"}).frequency_hz(0);
  EXPECT_NEAR(slack, rigid, 2e-3 * rigid);
}

TEST(VirtualSupport, AMovingSupportRunsFromClampToFloating) {
  const Strip strip;
  const double clamped = strip.reduced({}).frequency_hz(0);
  EXPECT_NEAR(strip.reduced({"soft-support@translation=1e12"}).frequency_hz(0),
              clamped,
              1e-4 * clamped);
  // A rigid strip that stays level on its springs: w^2 = k b / (m b L).
  const double k = 0.5;
  const double rigid = std::sqrt(k / (2700.0 * 0.002 * 0.30)) / two_pi;
  EXPECT_NEAR(strip.reduced({"soft-support@translation=0.5"}).frequency_hz(0),
              rigid,
              2e-3 * rigid);
}

TEST(VirtualSupport, ASupportThatTurnsAndMovesHasBothSprings) {
  const Strip strip;
  const auto first = [&strip](const std::string& text) {
    return strip.reduced({text}).frequency_hz(0);
  };
  // Either spring as good as rigid leaves the other alone.
  const double turns = first("soft-support=300");
  EXPECT_NEAR(first("soft-support@both=300,1e12"), turns, 1e-4 * turns);
  const double moves = first("soft-support@translation=2e4");
  EXPECT_NEAR(first("soft-support@both=1e9,2e4"), moves, 1e-4 * moves);
  // Compliances in series: the lowest mode is below both.
  EXPECT_LT(first("soft-support@both=300,2e4"), 0.99 * std::min(turns, moves));
  // Forms end as they are written: first the turn.
  EXPECT_LT(first("soft-support@both=3,2e4"),
            first("soft-support@both=300,2e4"));
}

TEST(VirtualSupport, SupportStandsForItsWholeEdge) {
  const SupportEdge edge = support_edge(mesh_panel(support::strip(), 3).deck);
  double length = 0.0;
  for (const auto& [grid, part] : edge.length_of) length += part;
  EXPECT_NEAR(length, 0.04, 1e-12);
  EXPECT_EQ(edge.turns, std::vector{5}) << "rotation about y";
  EXPECT_THROW((void)support_edge(mesh_panel(plate_panel(), 1).deck),
               InputError);
}

}  // namespace
}  // namespace tapfit::updating
