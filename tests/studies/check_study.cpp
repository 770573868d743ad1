// How often the check of a test names what is wrong with it, and how often it
// finds something where nothing is.
//
//   check_study PART SEED COUNT [ONLY]
//
// COUNT tests drawn from the seed, of five structures in turn, 2 to 4 sensors,
// 4 to 12 points and three levels of noise. PART is
//
//   clean     as they are
//   hidden    with an effect in the structure (hidden_effect.hpp) and no
//   mistake single    with every mistake of test_mistakes.hpp, from just
//   visible to
//             gross
//   two       with every mistake and another one of the list, drawn from those
//             that go together (mistake_pairs.hpp)
//   beside    with every mistake, and an effect in the structure
//   unlisted  with mistakes that the list does not hold (unlisted_mistakes.hpp)
//   units     of structures that are held, all sensors off by a unit: what a
//             diagnosis with the model says, since no measurement of a held
//             structure tells it (unit_diagnoses.hpp)
//
// ONLY: mistakes whose name holds it.
#include "tests/studies/unit_diagnoses.hpp"
#include "tests/updating/support/check_score.hpp"
#include "tests/updating/support/mistake_pairs.hpp"
#include "tests/updating/support/unlisted_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace tapfit::updating::testing {
namespace {

struct Study {
  unsigned seed = 4711;
  unsigned count = 20;
  std::string only;  ///< part of a mistake's name
};

/// How often each mistake was named, and at least pointed at.
struct Tally {
  int made = 0;
  int named = 0;
  int pointed = 0;
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

// Some mistakes are made in late runs.
PlainOptions drawn_long(unsigned seed) {
  PlainOptions options = drawn(seed);
  options.runs = std::max(options.runs, 8);
  return options;
}

constexpr std::array kinds{Hidden::PointMass,
                           Hidden::SensorMasses,
                           Hidden::GroundSpring,
                           Hidden::Softened};
constexpr std::array<const char*, 5> effects{
    "nothing", "point mass", "sensor masses", "ground spring", "softened"};

// Every kind in every structure within twenty seeds.
HiddenEffect drawn_effect(unsigned seed) {
  std::mt19937 engine(seed + 77);
  return {kinds.at(seed / 5 % kinds.size()),
          std::uniform_real_distribution<double>(0.0, 1.0)(engine),
          seed % 12};
}

std::string described(const PlainOptions& options) {
  constexpr std::array<const char*, 5> structures{
      "free plate", "held plate", "free beam", "clamped beam", "storeys"};
  return fmt::format("{} ({}, {} sensors, {} points, noise {}, {} {:.2f})",
                     options.seed,
                     structures.at(static_cast<std::size_t>(options.structure)),
                     options.sensors,
                     options.runs,
                     options.noise,
                     effects.at(static_cast<std::size_t>(options.hidden.kind)),
                     options.hidden.size);
}

void study_faultless(const Study& study, bool hidden) {
  int faulted = 0;
  for (unsigned k = 0; k < study.count; ++k) {
    PlainOptions options = drawn(study.seed + k);
    if (hidden) options.hidden = drawn_effect(study.seed + k);
    const std::string said = serious(check_of(plain_test(options)).findings);
    if (said.empty()) continue;
    ++faulted;
    fmt::print("  {}: {}", described(options), said);
  }
  fmt::print(
      "fault found with {} of {} tests without any\n", faulted, study.count);
}

void print(const std::map<std::string, Tally>& tallies, bool pointed) {
  Tally all;
  const auto line = [&](const std::string& name, const Tally& tally) {
    fmt::print("{:<40} named {:>3} of {:>3}", name, tally.named, tally.made);
    if (pointed) fmt::print(", pointed at {:>3}", tally.pointed);
    fmt::print("\n{}", tally.missed);
  };
  for (const auto& [name, tally] : tallies) {
    line(name, tally);
    all.made += tally.made;
    all.named += tally.named;
    all.pointed += tally.pointed;
  }
  line("all", all);
}

void study_single(const Study& study, bool hidden) {
  std::mt19937 engine(study.seed);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  std::map<std::string, Tally> tallies;
  for (unsigned k = 0; k < study.count; ++k) {
    PlainOptions options = drawn_long(study.seed + k);
    if (hidden) options.hidden = drawn_effect(study.seed + k);
    const SheetAndRecords clean = plain_test(options);
    for (const Mistake& mistake : mistakes()) {
      const double size = anywhere(engine);
      if (mistake.name.find(study.only) == std::string::npos) continue;
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
  print(tallies, false);
}

void study_two(const Study& study) {
  std::mt19937 engine(study.seed);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  std::array<int, 3> counts{};  // by how many of the two are named
  std::map<std::string, Tally> tallies;
  for (unsigned k = 0; k < study.count; ++k) {
    const PlainOptions options = drawn_long(study.seed + k);
    const SheetAndRecords clean = plain_test(options);
    for (const Mistake& one : mistakes()) {
      std::vector<const Mistake*> partners;
      for (const Mistake& other : mistakes()) {
        if (go_together(one, other)) partners.push_back(&other);
      }
      if (partners.empty()) continue;
      const Mistake& other = *partners.at(engine() % partners.size());
      const double size = anywhere(engine);
      const double other_size = anywhere(engine);
      if (one.name.find(study.only) == std::string::npos) continue;
      SheetAndRecords test = clean;
      make_both(one, other, test, options, size, other_size);
      const TestCheck found = check_of(test);
      int named = 0;
      for (const Mistake* mistake : {&one, &other}) {
        Tally& tally = tallies[mistake->name];
        ++tally.made;
        if (is_named(*mistake, found.findings)) {
          ++tally.named;
          ++named;
        } else {
          tally.missed +=
              fmt::format("    {}, {:.2f} and {:.2f} of {} + {}: {}\n",
                          described(options),
                          size,
                          other_size,
                          one.name,
                          other.name,
                          serious(found.findings));
        }
      }
      ++counts.at(static_cast<std::size_t>(named));
    }
  }
  print(tallies, false);
  fmt::print("both named in {}, one in {}, none in {} of {} pairs\n",
             counts[2],
             counts[1],
             counts[0],
             counts[0] + counts[1] + counts[2]);
}

void study_unlisted(const Study& study) {
  std::mt19937 engine(study.seed);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  std::map<std::string, Tally> tallies;
  for (unsigned k = 0; k < study.count; ++k) {
    const PlainOptions options = drawn_long(study.seed + k);
    const SheetAndRecords clean = plain_test(options);
    for (const UnlistedMistake& one : unlisted_mistakes()) {
      const double size = anywhere(engine);
      if (one.mistake.name.find(study.only) == std::string::npos) continue;
      SheetAndRecords test = clean;
      one.mistake.make(test, options, size);
      const TestCheck found = check_of(test);
      const bool named = is_named(one.mistake, found.findings);
      const bool pointed = is_pointed_at(one, found.findings);
      Tally& tally = tallies[one.mistake.name];
      ++tally.made;
      tally.named += named ? 1 : 0;
      tally.pointed += pointed ? 1 : 0;
      if (named && pointed) continue;
      tally.missed += fmt::format("    {} at {:.2f}: {}\n",
                                  described(options),
                                  size,
                                  serious(found.findings));
    }
  }
  print(tallies, true);
}

void study_units(const Study& study) {
  int named = 0;
  for (unsigned k = 0; k < study.count; ++k) {
    const UnitDiagnosis one = diagnose_unit(study.seed + k);
    named += one.named ? 1 : 0;
    fmt::print("{} {}\n", one.named ? "  named" : "  missed", one.told);
  }
  fmt::print("named {} of {}\n", named, study.count);
}

const std::map<std::string, std::function<void(const Study&)>>& parts() {
  static const std::map<std::string, std::function<void(const Study&)>> all{
      {"clean", [](const Study& s) { study_faultless(s, false); }},
      {"hidden", [](const Study& s) { study_faultless(s, true); }},
      {"single", [](const Study& s) { study_single(s, false); }},
      {"two", study_two},
      {"beside", [](const Study& s) { study_single(s, true); }},
      {"unlisted", study_unlisted},
      {"units", study_units}};
  return all;
}

int run(int argc, char** argv) {
  const auto part = argc > 1 ? parts().find(argv[1]) : parts().end();
  if (part == parts().end()) {
    fmt::print(stderr, "check_study PART SEED COUNT [ONLY], PART one of");
    for (const auto& [name, study] : parts()) fmt::print(stderr, " {}", name);
    fmt::print(stderr, "\n");
    return 1;
  }
  Study study;
  if (argc > 2) study.seed = static_cast<unsigned>(std::atoi(argv[2]));
  if (argc > 3) study.count = static_cast<unsigned>(std::atoi(argv[3]));
  if (argc > 4) study.only = argv[4];
  part->second(study);
  return 0;
}

}  // namespace
}  // namespace tapfit::updating::testing

int main(int argc, char** argv) {
  return tapfit::updating::testing::run(argc, argv);
}
