// `tapfit import FILE` with nothing but a file.
#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string netcdf =
    TAPFIT_SOURCE_DIR "/tests/acquisition/instruments/files/rattlesnake.nc";

TEST(Import, AFileAloneBecomesABundleThatSaysWhatWasAssumed) {
  const fs::path bundle = fresh_folder() / "bundle";
  const ProgramResult imported =
      run_tapfit(fmt::format("import '{}' -o '{}'", netcdf, bundle.string()));
  ASSERT_EQ(imported.exit_status, 0) << imported.err;
  EXPECT_TRUE(holds(imported.out, "hammer  \"Force 3 Z+\" at 3Z+, force in N"))
      << imported.out;
  EXPECT_TRUE(holds(imported.out, "sampled at 2048 Hz")) << imported.out;
  EXPECT_TRUE(holds(imported.out, "assumed: \"Voltage\" in V is left out"))
      << imported.out;
  const ProgramResult hits =
      run_tapfit(fmt::format("hits '{}' --json", bundle.string()));
  ASSERT_EQ(hits.exit_status, 0) << hits.err;
  const json found = json::parse(hits.out);
  ASSERT_EQ(found["runs"].size(), 1U);
  // Samples of 10, 40 and 30 N: it stood between the last two.
  const auto peak = found["runs"][0]["hits"].at(0)["peak_n"].get<double>();
  EXPECT_GT(peak, 40.0);
  EXPECT_LT(peak, 45.0);
}

TEST(Import, JsonListsWhatWasAssumedWithItsRemedy) {
  const fs::path folder = fresh_folder();
  std::string table = "a,b\n";
  for (int k = 0; k < 400; ++k) {
    const bool hit = k % 100 == 20;
    table += fmt::format("{},{}\n", hit ? 50 : 0, (k % 7) - 3);
  }
  write_file(folder / "mute.csv", table);
  const ProgramResult imported =
      run_tapfit(fmt::format("import '{}' -o '{}' --rate 1000 --json",
                             (folder / "mute.csv").string(),
                             (folder / "bundle").string()));
  ASSERT_EQ(imported.exit_status, 0) << imported.err;
  const json said = json::parse(imported.out);
  ASSERT_EQ(said["assumed"].size(), 4U) << imported.out;
  EXPECT_TRUE(holds(said["assumed"][0]["what"], "the hammer is \"a\""));
  EXPECT_EQ(said["assumed"][2]["field"], "channels[1].unit");
  EXPECT_EQ(said["assumed"][2]["option"], "--sensor COLUMN@POINT,unit=UNIT");
}

TEST(Import, TakesNoSensitivityThatIsNoNumber) {
  const fs::path folder = fresh_folder();
  write_file(folder / "mute.csv", "a,b\n1,2\n5,1\n0,3\n");
  for (const char* wrong : {"volts_per_unit=nan", "mass_kg=inf"}) {
    const ProgramResult imported = run_tapfit(
        fmt::format("import '{}' -o '{}' --rate 1000 --hammer a@1Z+,{} "
                    "--sensor b@2Z+",
                    (folder / "mute.csv").string(),
                    (folder / "bundle").string(),
                    wrong));
    EXPECT_EQ(imported.exit_status, 1);
    EXPECT_TRUE(holds(imported.err, "is no number")) << imported.err;
  }
}

// Beside what is there already, and without a rate.
TEST(Import, WritesNothingThatItCannotFinish) {
  const fs::path folder = fresh_folder();
  write_file(folder / "mute.csv", "a,b\n1,2\n5,1\n0,3\n");
  const ProgramResult imported =
      run_tapfit(fmt::format("import '{}' -o '{}'",
                             (folder / "mute.csv").string(),
                             (folder / "bundle").string()));
  EXPECT_EQ(imported.exit_status, 1);
  EXPECT_TRUE(holds(imported.err, "sampling rate")) << imported.err;
  EXPECT_FALSE(fs::exists(folder / "bundle"));
}

}  // namespace
}  // namespace tapfit::end_to_end
