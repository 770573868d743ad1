// A run of another structure among those of a test.
#include "tests/acquisition/support/temporary_folder.hpp"
#include "updating/session/session.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

VirtualBundleSpec ladder() {
  VirtualBundleSpec spec;
  spec.structure = "ladder";
  spec.points = 6;
  spec.hits = 2;
  spec.seed = 5;
  spec.faulty_hits = false;
  spec.modulus_percent = 1.0;
  return spec;
}

bool warns(const std::vector<std::string>& warnings) {
  return std::ranges::any_of(warnings, [](const std::string& warning) {
    return warning.starts_with("run-outlier at run 4: correct runs[3].file");
  });
}

// The other ladder is 40 % stiffer: its poles lie 18 % higher, many bandwidths.
TEST(ForeignRun, IsLeftOutAndNamed) {
  const tapfit::testing::TemporaryFolder folder;
  const fs::path own = folder.path() / "own";
  const fs::path other = folder.path() / "other";
  (void)make_virtual_bundle(ladder(), own);
  VirtualBundleSpec stiffer = ladder();
  stiffer.modulus_percent = 40.0;
  (void)make_virtual_bundle(stiffer, other);

  Session clean(own);
  const double usual = clean.comparison().error;
  EXPECT_TRUE(clean.run_outliers().empty());
  EXPECT_FALSE(warns(clean.model_warnings()));

  const fs::path file = clean.bundle().runs[3].file.filename();
  for (const auto& entry : fs::recursive_directory_iterator(own)) {
    if (entry.path().filename() != file) continue;
    fs::copy_file(other / fs::relative(entry.path(), own),
                  entry.path(),
                  fs::copy_options::overwrite_existing);
  }
  Session session(own);
  const auto found = session.run_outliers();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].mistake, "run-outlier");
  EXPECT_EQ(found[0].where.runs, std::vector<int>{4});
  EXPECT_GT(found[0].probability, 0.999);
  EXPECT_TRUE(warns(session.model_warnings()));
  // Of the five runs that are left: as of all six, but for which points they
  // are. With the fourth in use it is several times that.
  EXPECT_LT(session.comparison().error, 1.5 * usual);
}

}  // namespace
}  // namespace tapfit::updating
