// Points, lines, elements and shapes of universal files.
#include "acquisition/uff/uff_shapes.hpp"

#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/uff/uff_geometry.hpp"
#include "tests/support/matchers.hpp"

#include <numbers>

namespace tapfit::acquisition {
namespace {

const std::filesystem::path samples =
    TAPFIT_SOURCE_DIR "/../shared/data/uff-samples";

UffGeometry geometry_of(const std::string& text) {
  UffGeometry geometry;
  for (const UffDataset& dataset : split_uff(text, "x.uff")) {
    add_geometry(dataset, geometry);
  }
  return geometry;
}

TEST(UffGeometry, ReadsPointsLinesAndElements) {
  const UffGeometry g = geometry_of(
      "    -1\n    15\n"
      "         7         1         0         1-5.16190E+01 5.16190E+01 "
      "5.0E+1\n"
      "    -1\n    -1\n  2411\n"
      "         8         0         0        11\n"
      "   1.5000000000000000D+00   0.0000000000000000D+00  -2.5D-01\n"
      "    -1\n    -1\n    82\n"
      "         1         5         8\nfrom 7 to 8, and back\n"
      "         7         8         0         8         7\n"
      "    -1\n    -1\n  2412\n"
      "         1        44         0         0         1         4\n"
      "         3         4         5         6\n"
      "         2        21         0         0         1         2\n"
      "         0         1         1\n"
      "         7         8\n    -1\n");
  ASSERT_EQ(g.nodes.size(), 2U);
  EXPECT_EQ(g.nodes.at(7), Eigen::Vector3d(-51.619, 51.619, 50.0));
  EXPECT_EQ(g.nodes.at(8), Eigen::Vector3d(1.5, 0.0, -0.25));
  EXPECT_EQ(g.trace_lines, (std::vector<std::vector<int>>{{7, 8}, {8, 7}}));
  ASSERT_EQ(g.elements.size(), 2U);
  EXPECT_EQ(g.elements[0].nodes, (std::vector<int>{3, 4, 5, 6}));
  EXPECT_EQ(g.elements[1].nodes, (std::vector<int>{7, 8}));
}

TEST(UffGeometry, RefusesWithTheLine) {
  const auto refusal = [](const std::string& text) {
    return refusal_of([&] { (void)geometry_of(text); });
  };
  EXPECT_THAT(refusal("    -1\n    15\n  1  2  3 not numbers\n    -1\n"),
              HasSubstr("line 1 of dataset 15"));
  EXPECT_THAT(refusal("    -1\n  2411\n         8         0\n    -1\n"),
              HasSubstr("ends within an entry"));
  EXPECT_THAT(refusal("    -1\n    82\n         1  16000000         8\nx\n"
                      "         1\n    -1\n"),
              HasSubstr("ends within an entry"));
}

// A complex mode of the eigenvalue -3 + 4i: |lambda| 5 rad/s, damping 3/5.
TEST(UffShapes, ReadsAComplexMode) {
  const UffShape shape = read_shape(
      split_uff(
          "    -1\n    55\nA\nB\nC\nD\nE\n"
          "         1         3         2         8         5         3\n"
          "         2         6         0         2\n"
          " -3.00000E+00 4.00000E+00 1.00000E+00 0.0E+0 0.0E+0 0.0E+0\n"
          "        11\n"
          "  1.00000E+00-2.00000E+00 0.00000E+00 0.00000E+00 3.00000E+00 4.0E+0"
          "\n    -1\n",
          "x.uff")
          .at(0));
  EXPECT_DOUBLE_EQ(shape.frequency_hz, 5.0 / (2.0 * std::numbers::pi));
  EXPECT_DOUBLE_EQ(shape.damping_ratio, 0.6);
  EXPECT_EQ(shape.mode, 2);
  EXPECT_TRUE(shape.complex);
  ASSERT_EQ(shape.values.size(), 1U);
  EXPECT_EQ(shape.values.at(11)[0], std::complex<double>(1.0, -2.0));
  EXPECT_EQ(shape.values.at(11)[2], std::complex<double>(3.0, 4.0));
}

struct Counts {
  std::size_t nodes = 0;
  std::size_t trace_lines = 0;
  std::size_t elements = 0;
  std::size_t shapes = 0;
};

Counts counts_of(const std::string& name) {
  const UffFile file = open_uff(samples / name);
  UffGeometry geometry;
  Counts counts;
  for (const UffDataset& dataset : file.datasets) {
    add_geometry(dataset, geometry);
    if (dataset.type != 55 && dataset.type != 2414) continue;
    EXPECT_FALSE(read_shape(dataset).values.empty()) << dataset.place;
    ++counts.shapes;
  }
  counts.nodes = geometry.nodes.size();
  counts.trace_lines = geometry.trace_lines.size();
  counts.elements = geometry.elements.size();
  return counts;
}

TEST(UffShapes, OthersFilesAreReadWhole) {
  if (!std::filesystem::is_directory(samples)) {
    GTEST_SKIP() << samples << " is not there";
  }
  // Counted in the files by hand.
  const Counts permas = counts_of("2411 and 2414.uff");
  EXPECT_EQ(permas.nodes, 441U);
  EXPECT_EQ(permas.elements, 400U);
  EXPECT_EQ(permas.shapes, 10U);
  const Counts mixed = counts_of("mesh_test_uff2412_mixed.uff");
  EXPECT_EQ(mixed.nodes, 5U);
  EXPECT_EQ(mixed.elements, 5U);
  EXPECT_GT(counts_of("TestLab 161 164 18 15 82.uff").trace_lines, 3U);
  EXPECT_GT(counts_of("mesh_Oros-modal_uff15_uff2412.uff").elements, 0U);
  EXPECT_EQ(counts_of("uff55_translation.uff").shapes, 3U);
  EXPECT_EQ(counts_of("uff55_translation_rotation.uff").shapes, 1U);
  EXPECT_EQ(counts_of("uff55 sample_test record10.uff").shapes, 1U);
}

TEST(UffShapes, FrequenciesOfOthersFiles) {
  if (!std::filesystem::is_directory(samples)) {
    GTEST_SKIP() << samples << " is not there";
  }
  const UffFile permas = open_uff(samples / "2411 and 2414.uff");
  std::vector<double> frequencies;
  for (const UffDataset& dataset : permas.datasets) {
    if (dataset.type == 2414) {
      frequencies.push_back(read_shape(dataset).frequency_hz);
    }
  }
  EXPECT_DOUBLE_EQ(frequencies.at(0), 0.956363);  // as printed in the file
  const UffFile rotations =
      open_uff(samples / "uff55_translation_rotation.uff");
  EXPECT_DOUBLE_EQ(read_shape(rotations.datasets.at(0)).frequency_hz, 97.013);
}

}  // namespace
}  // namespace tapfit::acquisition
