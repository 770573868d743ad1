// Fixed practice cases, judged as `tapfit score` judges: effect, place within
// one element, size within 5 % or its interval, error within 1.3 times the
// floor. Truth and engineer's model differ as in a laboratory: the truth has a
// finer mesh, its own integration in time, damping that scatters from mode to
// mode, another modulus, noise, hum, drift and faulty hits.
//
// Case k has seed 9000 + k. Structures and kinds were written down before any
// of them was diagnosed, and nothing in the program is set on them. Numbers
// that are missing hid the same as another case, on another structure: the
// whole is to run in five minutes.
#include "updating/hidden_case.hpp"
#include "updating/hidden_verdict.hpp"
#include "updating/session.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace tapfit::hidden_effects {
namespace {

namespace fs = std::filesystem;
using namespace updating;

/// What a case must come to at least.
enum class AtLeast {
  Right,  ///< in everything
  Size,   ///< effect, place and size; the error is above the floor
  Place   ///< effect and place; the size is outside of its interval
};

struct FixedCase {
  int number = 0;  ///< the seed is 9000 more
  std::string structure;
  std::string kind;
  AtLeast at_least = AtLeast::Right;
  std::string why = {};  ///< it is no better
  bool roving_sensor = false;
};

void PrintTo(const FixedCase& fixed, std::ostream* out) {
  *out << fixed.structure << ' ' << fixed.kind << ' ' << fixed.why;
}

std::string told(const Verdict& v) {
  return fmt::format(
      "hidden {}, found {}; kind {}, honest {}, place {}, size {} ({:.1f} % "
      "off), error {:.4f} over floor {:.4f} = {:.2f}",
      v.hidden,
      v.found,
      v.right_kind,
      v.honest,
      v.right_place,
      v.right_size,
      100.0 * v.size_error,
      v.error,
      v.floor,
      v.error / v.floor);
}

Verdict diagnosed(const FixedCase& fixed) {
  VirtualBundleSpec spec =
      draw_hidden_case(fixed.kind,
                       9000 + static_cast<std::uint64_t>(fixed.number),
                       fixed.structure);
  // A short test: one that CI has the time for.
  spec.points = 12;
  spec.hits = 3;
  spec.roving_sensor = fixed.roving_sensor;
  const fs::path folder = fs::path(testing::TempDir()) /
                          fmt::format("tapfit-hidden-{}", fixed.number);
  fs::remove_all(folder);
  (void)make_virtual_bundle(spec, folder);
  Session session(folder);
  const Verdict verdict = judge(spec, session.diagnosis(), session.deck());
  fs::remove_all(folder);
  return verdict;
}

class HiddenEffects : public testing::TestWithParam<FixedCase> {};

TEST_P(HiddenEffects, IsToldFromTheRecordings) {
  const FixedCase& fixed = GetParam();
  const Verdict v = diagnosed(fixed);
  fmt::print("{}\n", told(v));
  EXPECT_TRUE(v.right_kind) << told(v);
  EXPECT_TRUE(v.right_place) << told(v);
  if (fixed.at_least == AtLeast::Place) return;
  EXPECT_TRUE(v.right_size) << told(v);
  if (fixed.at_least == AtLeast::Size) return;
  EXPECT_TRUE(v.at_floor) << told(v);
}

// Known weaknesses.
//
// The mesh's error is corrected in the clamped modes, whatever the clamp does
// afterwards. Here that drives the support 8 % up and the modulus 0.7 % down,
// beyond their intervals; with the engineer's mesh twice as fine the support is
// 0.2 % off.
constexpr const char* mesh_of_clamp = "mesh error of a clamp that turns";
// Damping is told mode by mode in the structure without the effect. The truth's
// is that of the loaded modes, which a heavy mass mixes: 1.32 times the floor,
// 1.4 with twice the damping, 2.0 with three times.
constexpr const char* damping_of_loaded = "damping of the loaded modes";

std::string name_of(const testing::TestParamInfo<FixedCase>& fixed) {
  std::string name =
      fmt::format("{}_{}", fixed.param.structure, fixed.param.kind);
  for (char& c : name) c = std::isalnum(c) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(
    Fixed,
    HiddenEffects,
    testing::Values(
        FixedCase{0, "frame", "none"},
        FixedCase{1, "ladder", "none"},
        FixedCase{2, "plate", "none"},
        FixedCase{3, "portal", "none"},
        FixedCase{4, "frame", "sensor-mass"},
        FixedCase{5, "portal", "soft-support"},
        FixedCase{6, "ladder", "added-mass"},
        FixedCase{7, "plate", "ground-spring"},
        FixedCase{8, "frame", "dashpot"},
        FixedCase{9, "portal", "sensor-cable"},
        FixedCase{10, "ladder", "stiffness-loss"},
        FixedCase{11, "plate", "joint"},
        FixedCase{12, "portal", "absorber"},
        FixedCase{13, "frame", "channel-gain"},
        FixedCase{14, "ladder", "channel-delay"},
        FixedCase{15, "plate", "channel-polarity"},
        FixedCase{16, "portal", "channel-swap"},
        FixedCase{17, "frame", "added-mass+soft-support"},
        FixedCase{18, "plate", "added-mass+channel-gain"},
        FixedCase{19,
                  "ladder",
                  "sensor-mass+soft-support",
                  AtLeast::Place,
                  mesh_of_clamp},
        FixedCase{20, "frame", "strut"},
        FixedCase{23, "ladder", "drift"},
        FixedCase{24, "portal", "added-mass", AtLeast::Size, damping_of_loaded},
        FixedCase{25, "portal", "joint"},
        FixedCase{26, "portal", "stiffness-loss"},
        FixedCase{27, "frame", "soft-support"},
        FixedCase{28, "plate", "sensor-mass", AtLeast::Right, {}, true},
        FixedCase{29, "ladder", "absorber"},
        FixedCase{30, "frame", "wrong-grid"},
        FixedCase{31, "portal", "wrong-grid"},
        FixedCase{33, "frame", "nonlinearity"},
        FixedCase{34, "frame", "drift"},
        FixedCase{35, "frame", "uneven-soft-support"},
        FixedCase{36, "ladder", "moving-soft-support"},
        FixedCase{37, "frame", "turning-and-moving-soft-support"},
        FixedCase{38, "plate", "unequal-sensor-mass"},
        FixedCase{39, "portal", "turning-and-moving-soft-support"}),
    name_of);

}  // namespace
}  // namespace tapfit::hidden_effects
