// Universal files that other programs wrote.
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/uff/uff_function.hpp"
#include "signal/files/uff58.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace tapfit::signal {
namespace {

namespace fs = std::filesystem;

using acquisition::read_function;
using acquisition::split_uff;
using acquisition::UffDataset;
using acquisition::UffFunction;

const fs::path samples = TAPFIT_SOURCE_DIR "/../shared/data/uff-samples";

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(UffSamples, AreReadOrRefusedWithAReason) {
  if (!fs::is_directory(samples)) GTEST_SKIP() << samples << " is not there";
  int functions = 0;
  for (const auto& entry : fs::directory_iterator(samples)) {
    if (entry.path().extension() != ".uff") continue;
    const std::string text = text_of(entry.path());
    for (const UffDataset& set : split_uff(text, entry.path().filename())) {
      EXPECT_GT(set.type, 0) << set.place;
      if (set.type != 58) continue;
      const UffFunction function = read_function(set);
      EXPECT_GT(function.y.size(), 0) << set.place;
      EXPECT_TRUE(function.y.allFinite()) << set.place;
      ++functions;
    }
    // None of them holds FRFs.
    EXPECT_THROW((void)read_frfs_uff(entry.path()), InputError) << entry;
  }
  EXPECT_EQ(functions, 9);
}

TEST(UffSamples, OfBinaryAndTextAgree) {
  if (!fs::is_directory(samples)) GTEST_SKIP() << samples << " is not there";
  std::vector<UffFunction> functions;
  for (const char* file : {"Sample_UFF58_ascii.uff", "Sample_UFF58b_bin.uff"}) {
    functions.push_back(
        read_function(split_uff(text_of(samples / file), file).at(0)));
  }
  ASSERT_EQ(functions[0].y.size(), 79292);
  ASSERT_EQ(functions[1].y.size(), 79292);
  // Six digits in the ASCII file.
  EXPECT_LT((functions[0].y - functions[1].y).cwiseAbs().maxCoeff(),
            1e-5 * functions[1].y.cwiseAbs().maxCoeff());
}

}  // namespace
}  // namespace tapfit::signal
