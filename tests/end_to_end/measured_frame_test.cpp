// A real hammer test, measured by others: a three-storey steel frame, recorded
// as CSV. Their folder lies beside the project and is not part of it.
#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path data = TAPFIT_SOURCE_DIR "/../shared/data/three-storey-frame";

TEST(MeasuredFrame, ItsResonancesComeOutOfTheImportedRecord) {
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not there";
  const fs::path bundle = fresh_folder() / "frame";
  const auto imported = run_tapfit(
      fmt::format("import '{}' -o '{}' --hammer CH8@3:+X,volts_per_unit=1 "
                  "--sensor CH2@1:+X,unit=cm/s^2 --sensor CH3@2:-X,unit=cm/s^2 "
                  "--sensor CH5@3:+X,unit=cm/s^2 --band 1 20",
                  (data / "imp_ham_set1_nomass.CSV").string(),
                  bundle.string()));
  ASSERT_EQ(imported.exit_status, 0) << imported.err;
  const auto result =
      run_tapfit(fmt::format("modes '{}' --json", bundle.string()));
  ASSERT_EQ(result.exit_status, 0) << result.err;
  const json modes = json::parse(result.out).at("modes");
  ASSERT_EQ(modes.size(), 3U);
  // Its makers' values; 0.5 % is what two ways of reading a peak differ by on
  // a frame whose frequencies move with the amplitude.
  const double makers[] = {2.17, 6.89, 13.263};
  for (std::size_t k = 0; k < 3; ++k) {
    const double f = modes[k].at("frequency_hz").at("value");
    EXPECT_NEAR(f, makers[k], 0.005 * makers[k]);
  }
}

}  // namespace
}  // namespace tapfit::end_to_end
