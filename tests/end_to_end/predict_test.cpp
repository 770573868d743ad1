// Predict, then tap: a virtual structure is tested, changed and tested again.
#include "tests/end_to_end/run_program.hpp"
#include "tests/end_to_end/small_bundle.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class PredictThenTap : public testing::Test {
 protected:
  /// By the model with the 50 g that are hidden in both.
  [[nodiscard]] json predicted(const std::string& change) const {
    const ProgramResult result =
        run_tapfit(fmt::format("predict '{}' --effect {} --with added-mass@200 "
                               "--against '{}' --json",
                               before_.string(),
                               change,
                               after_.string()));
    EXPECT_EQ(result.exit_status, 0) << result.err;
    return json::parse(result.out);
  }

  fs::path before_ = copy_of_small_bundle();
  fs::path after_ = fresh_folder() / "after";
};

TEST_F(PredictThenTap, ConfirmsTheMassThatWasPutThereAndNoOther) {
  // As small_bundle.cpp, and 30 g more.
  const ProgramResult made = run_tapfit(
      fmt::format("simulate '{}' --structure ladder --seed 5 --runs 6 --hits 3 "
                  "--effect added-mass@200=0.05 --effect added-mass@100=0.03",
                  after_.string()));
  ASSERT_EQ(made.exit_status, 0) << made.err;
  const json right = predicted("added-mass@100=30g");
  EXPECT_EQ(right.at("against").at("finding"), "confirmed")
      << right.at("against").at("statement");
  EXPECT_GE(right.at("against").at("modes").size(), 6U);
  // Frequencies that the structure was made with.
  const json truth = json::parse(read_file(after_ / "truth.json"));
  for (const json& mode : right.at("modes")) {
    const auto k = mode.at("mode").get<std::size_t>() - 1;
    const double hz = truth.at("natural_frequencies_hz")[k];
    // They are written with four decimals.
    EXPECT_LT(mode.at("predicted_hz").at("lo95"), hz + 1e-4) << k;
    EXPECT_GT(mode.at("predicted_hz").at("hi95"), hz - 1e-4) << k;
  }
  const json wrong = predicted("added-mass@100=20g");
  EXPECT_EQ(wrong.at("against").at("finding"), "refuted")
      << wrong.at("against").at("statement");
}

}  // namespace
}  // namespace tapfit::end_to_end
