// How often the check of a test names a mistake, and how often it finds one
// where there is none.
//
//   check_study SEED COUNT
//
// COUNT plates drawn from the seed, free and held in turn, 2 to 4 sensors: each
// clean and with every mistake of test_mistakes.hpp, from just visible to
// gross.
#include "tests/updating/support/check_score.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <map>
#include <random>

namespace tapfit::updating::testing {
namespace {

struct Tally {
  int made = 0;
  int named = 0;
  std::string missed;
};

PlainOptions drawn(unsigned seed) {
  PlainOptions options;
  options.seed = seed;
  options.held = seed % 2 == 0;
  options.sensors = 2 + static_cast<int>(seed % 3);
  options.noise = seed % 5 == 0 ? 3.0 : 1.0;
  return options;
}

int study(unsigned seed, unsigned count, const std::string& only) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  int false_tests = 0;
  std::map<std::string, Tally> tallies;
  for (unsigned k = 0; k < count; ++k) {
    const PlainOptions options = drawn(seed + k);
    const SheetAndRecords clean = plain_test(options);
    const std::string said = serious(check_of(clean).findings);
    if (!said.empty()) {
      ++false_tests;
      fmt::print("clean {}: {}", options.seed, said);
    }
    for (const Mistake& mistake : mistakes()) {
      const double size = anywhere(engine);
      if (!only.empty() && mistake.name.find(only) == std::string::npos) {
        continue;
      }
      SheetAndRecords test = clean;
      mistake.make(test, options, size);
      const TestCheck found = check_of(test);
      Tally& tally = tallies[mistake.name];
      ++tally.made;
      if (is_named(mistake, found.findings)) {
        ++tally.named;
      } else {
        tally.missed += fmt::format("    {} at {:.2f}{}: {}\n",
                                    options.seed,
                                    size,
                                    options.held ? " held" : "",
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
  fmt::print("named {} of {} ({:.1f} %); false in {} of {} clean tests\n",
             named,
             made,
             100.0 * named / std::max(made, 1),
             false_tests,
             count);
  return 0;
}

}  // namespace
}  // namespace tapfit::updating::testing

int main(int argc, char** argv) {
  const auto number = [&](int at, unsigned otherwise) {
    return argc > at ? static_cast<unsigned>(std::atoi(argv[at])) : otherwise;
  };
  return tapfit::updating::testing::study(
      number(1, 4711), number(2, 20), argc > 3 ? argv[3] : "");
}
