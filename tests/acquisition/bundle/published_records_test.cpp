// Every universal file with time records that others published, against a
// reading of its bytes by hand. Their folder lies beside the project and is not
// part of it. None holds a hammer: as bundles they are refused with the reason.
#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/import/read_time_table.hpp"
#include "acquisition/uff/uff_values.hpp"
#include "tests/acquisition/support/mutation.hpp"
#include "tests/support/matchers.hpp"

#include <bit>
#include <cstdint>
#include <sstream>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

const fs::path samples = TAPFIT_SOURCE_DIR "/../shared/data/uff-samples";

struct Known {
  const char* file;
  std::size_t records;
  Eigen::Index count;
  double rate_hz;
  const char* unit;
  const char* refusal;
};

class PublishedRecords : public ::testing::TestWithParam<Known> {
 protected:
  void SetUp() override {
    if (!fs::exists(samples)) GTEST_SKIP() << samples << " is not there";
  }
};

// The numbers of a record's data, found by counting 11 lines behind the header.
std::vector<float> by_hand(const std::string& text, std::size_t record) {
  std::size_t at = 0;
  for (std::size_t k = 0;; ++k) {
    at = text.find("\n    58", at == 0 ? 0 : at + 1) + 1;
    if (k == record) break;
  }
  const std::string header = text.substr(at, text.find('\n', at) - at);
  for (int line = 0; line < 12; ++line) at = text.find('\n', at) + 1;
  std::vector<float> values;
  if (header.find('b') == std::string::npos) {
    std::istringstream in(text.substr(at, text.find("    -1", at) - at));
    for (float value = 0; in >> value;) values.push_back(value);
    return values;
  }
  const std::size_t size = std::stoul(header.substr(31, 12));
  for (std::size_t i = at; i < at + size; i += 4) {
    std::uint32_t bits = 0;
    for (std::size_t b = 4; b-- > 0;) {
      bits = bits << 8U | static_cast<unsigned char>(text[i + b]);
    }
    values.push_back(std::bit_cast<float>(bits));
  }
  return values;
}

TEST_P(PublishedRecords, AreReadToTheLastValue) {
  const Known& known = GetParam();
  const fs::path path = samples / known.file;
  std::vector<std::string> columns;
  for (std::size_t k = 1; k <= known.records; ++k) {
    columns.push_back(std::to_string(k));
  }
  const TimeTable table = read_time_table(path, columns, {});
  ASSERT_EQ(table.values.rows(), known.count);
  EXPECT_EQ(table.rate_hz, known.rate_hz);
  EXPECT_EQ(table.units[0], known.unit);
  const std::string text = testing::bytes_of(path);
  const UffFile file = open_uff(path);
  ASSERT_EQ(file.datasets.size(), known.records);
  for (std::size_t k = 0; k < known.records; ++k) {
    const std::vector<float> expected = by_hand(text, k);
    ASSERT_EQ(static_cast<Eigen::Index>(expected.size()), known.count);
    // Streamed in pieces that end anywhere in a line.
    UffValues values(file.datasets[k], read_header(file.datasets[k]));
    Eigen::VectorXd piece(997);
    for (Eigen::Index i = 0; i < known.count;) {
      const Eigen::Index got = values.read(piece);
      ASSERT_GT(got, 0);
      for (Eigen::Index j = 0; j < got; ++j, ++i) {
        const double is = table.values(i, static_cast<Eigen::Index>(k));
        ASSERT_EQ(piece[j], is);
        ASSERT_EQ(static_cast<float>(is),
                  expected[static_cast<std::size_t>(i)]);
      }
    }
    EXPECT_EQ(values.read(piece), 0);
  }
}

TEST_P(PublishedRecords, AreRefusedAsABundleWithTheReason) {
  const Known& known = GetParam();
  try {
    (void)read_test_bundle(samples / known.file);
    FAIL() << "taken for a hammer test";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_THAT(what, HasSubstr(known.refusal));
    EXPECT_THAT(what, HasSubstr("function type 1"));
  }
}

// Rates are 1 / step of record 7; 1.52588E-05 s are six digits of 1 / 65536.
INSTANTIATE_TEST_SUITE_P(
    Files,
    PublishedRecords,
    ::testing::Values(
        // Four accelerometers on a structure that is shaken by the wind.
        Known{"MPSTD#Set001_2024_10_08_10_27_07.uff",
              4,
              222400,
              3200.0,
              "m/s2",
              "a run needs one force"},
        Known{"Sample_UFF58_ascii.uff", 1, 79292, 65536.0, "Pa", "no force"},
        Known{"Sample_UFF58b_bin.uff", 1, 79292, 65536.0, "Pa", "no force"},
        // Its last line holds one number of six.
        Known{"time-history-not-all-columns-filled.uff",
              1,
              13,
              20000.0,
              "m/s\xc2\xb2",
              "no direction"}));

}  // namespace
}  // namespace tapfit::acquisition
