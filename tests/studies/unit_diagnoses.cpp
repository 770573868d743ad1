#include "tests/studies/unit_diagnoses.hpp"

#include "acquisition/bundle/write_test_bundle.hpp"
#include "acquisition/foundation/output_file.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "updating/session/session.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace tapfit::updating::testing {
namespace {

constexpr std::array<const char*, 3> structures{"frame", "portal", "ladder"};
constexpr std::array<double, 3> factors{4.448, 9.80665, 25.4};

// What the sheet says is too much: what is read is too little.
void declare(const std::filesystem::path& folder, double factor) {
  acquisition::TestBundle bundle = Session(folder).bundle();
  for (acquisition::Channel& channel : bundle.channels) {
    if (channel.quantity == acquisition::Quantity::Force) continue;
    channel.sensitivity *= factor;
  }
  acquisition::write_file(folder / "test.json",
                          acquisition::test_bundle_text(bundle, folder),
                          {{}, true});
}

}  // namespace

UnitDiagnosis diagnose_unit(unsigned seed) {
  const tapfit::testing::TemporaryFolder parent;
  const std::filesystem::path folder = parent.path() / "test";
  VirtualBundleSpec spec;
  spec.structure = structures.at(seed % structures.size());
  spec.seed = seed;
  spec.points = 8;
  spec.hits = 3;
  spec.faulty_hits = false;
  const double factor = factors.at(seed / structures.size() % factors.size());
  (void)make_virtual_bundle(spec, folder);
  declare(folder, factor);
  Session session(folder);
  const Diagnosis& diagnosis = session.diagnosis();
  UnitDiagnosis result;
  result.named =
      diagnosis.verdict.find("unit-factor") != std::string::npos ||
      std::ranges::any_of(diagnosis.set_up, [](const SetUpMistake& mistake) {
        return mistake.mistake == "unit-factor";
      });
  result.told = fmt::format(
      "{} ({}), 1/{}: {}", seed, spec.structure, factor, diagnosis.verdict);
  for (const SetUpMistake& mistake : diagnosis.set_up) {
    result.told += "; " + mistake.edit;
  }
  return result;
}

}  // namespace tapfit::updating::testing
