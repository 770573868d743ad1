// How often the check of a test names a mistake, and how often it finds one
// where there is none.
//
//   check_study SEED COUNT [CLEAN [ONLY]]
//
// COUNT tests drawn from the seed, of five structures in turn, 2 to 4 sensors,
// 4 to 12 points and three levels of noise, with every mistake of
// test_mistakes.hpp (or those whose name holds ONLY), from just visible to
// gross; and CLEAN of them as they are (else COUNT).
#include "tests/updating/support/check_score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <random>
#include <string>

namespace tapfit::updating::testing {
namespace {

struct Tally {
  int made = 0;
  int named = 0;
  std::string missed;
};

// Numbers without a common factor: each goes with each.
PlainOptions drawn(unsigned seed) {
  PlainOptions options;
  options.seed = seed;
  options.structure = static_cast<Structure>(seed % 5);
  options.sensors = 2 + static_cast<int>(seed % 3);
  options.runs = 4 + static_cast<int>(seed % 7) * 8 / 6;
  options.noise = std::array{1.0, 3.0, 0.3, 1.0}.at(seed / 2 % 4);
  return options;
}

constexpr std::array<const char*, 5> structures{
    "free plate", "held plate", "free beam", "clamped beam", "storeys"};

std::string described(const PlainOptions& options) {
  return fmt::format("{} ({}, {} sensors, {} points, noise {})",
                     options.seed,
                     structures.at(static_cast<std::size_t>(options.structure)),
                     options.sensors,
                     options.runs,
                     options.noise);
}

void study_clean(unsigned seed, unsigned count) {
  int false_tests = 0;
  for (unsigned k = 0; k < count; ++k) {
    const PlainOptions options = drawn(seed + k);
    const std::string said = serious(check_of(plain_test(options)).findings);
    if (said.empty()) continue;
    ++false_tests;
    fmt::print("clean {}: {}", described(options), said);
  }
  fmt::print("false in {} of {} clean tests\n", false_tests, count);
}

void study_mistakes(unsigned seed, unsigned count, const std::string& only) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  std::map<std::string, Tally> tallies;
  for (unsigned k = 0; k < count; ++k) {
    PlainOptions options = drawn(seed + k);
    options.runs =
        std::max(options.runs, 8);  // some mistakes are made in late ones
    const SheetAndRecords clean = plain_test(options);
    for (const Mistake& mistake : mistakes()) {
      const double size = anywhere(engine);
      if (mistake.name.find(only) == std::string::npos) continue;
      SheetAndRecords test = clean;
      mistake.make(test, options, size);
      const TestCheck found = check_of(test);
      Tally& tally = tallies[mistake.name];
      ++tally.made;
      if (is_named(mistake, found.findings)) {
        ++tally.named;
      } else {
        tally.missed += fmt::format("    {} at {:.2f}: {}\n",
                                    described(options),
                                    size,
                                    serious(found.findings));
      }
    }
  }
  int made = 0;
  int named = 0;
  for (const auto& [name, tally] : tallies) {
    fmt::print("{:<40} {:>3} of {:>3}\n", name, tally.named, tally.made);
    fmt::print("{}", tally.missed);
    made += tally.made;
    named += tally.named;
  }
  fmt::print("named {} of {} ({:.1f} %)\n",
             named,
             made,
             100.0 * named / std::max(made, 1));
}

}  // namespace
}  // namespace tapfit::updating::testing

int main(int argc, char** argv) {
  const auto number = [&](int at, unsigned otherwise) {
    return argc > at ? static_cast<unsigned>(std::atoi(argv[at])) : otherwise;
  };
  using namespace tapfit::updating::testing;
  const unsigned seed = number(1, 4711);
  const unsigned count = number(2, 20);
  study_clean(seed, number(3, count));
  study_mistakes(seed, count, argc > 4 ? argv[4] : "");
}
