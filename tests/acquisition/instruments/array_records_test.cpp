// Which arrays are records of channels, and the layouts that are known.
#include "acquisition/instruments/array_records.hpp"

#include "acquisition/instruments/known_layouts.hpp"
#include "acquisition/instruments/point_names.hpp"

#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

using Kind = NamedArray::Kind;
using Arrays = std::vector<NamedArray>;

NamedArray numbers(const std::string& name, const Eigen::MatrixXd& values) {
  return {.name = name, .kind = Kind::Numbers, .values = values};
}
NamedArray number(const std::string& name, double value) {
  return numbers(name, Eigen::MatrixXd::Constant(1, 1, value));
}
NamedArray text(const std::string& name, std::vector<std::string> texts) {
  NamedArray array{.name = name, .kind = Kind::Text};
  array.texts = std::move(texts);
  return array;
}

const Eigen::Vector4d one(0, 7, -1, 2);
const Eigen::Vector4d two(1, 5, 2, 4);

Eigen::MatrixXd both() {
  Eigen::MatrixXd values(4, 2);
  values << one, two;
  return values;
}

// As a TDMS file's own property "name", or an attribute of an HDF5 file.
TEST(ArrayRecords, NameOfTheFileNamesNoChannel) {
  const Arrays arrays{text("name", {"run 1"}),
                      text("Group@name", {"first blow"}),
                      numbers("Group/hammer 1Z+", one),
                      numbers("Group/acc 3X", two),
                      text("Group/acc 3X@unit_string", {"g"})};
  const auto records = records_of_arrays(arrays);
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].name, "hammer 1Z+");
  EXPECT_EQ(records[1].name, "acc 3X");
  EXPECT_EQ(records[1].unit, "g");
  // Of a file with one array it is the array's.
  const auto alone =
      records_of_arrays({text("name", {"acc 3X"}), numbers("x", one)});
  ASSERT_EQ(alone.size(), 1U);
  EXPECT_EQ(alone[0].name, "acc 3X");
}

TEST(ArrayRecords, TestlabsStructures) {
  const Arrays arrays{
      number("Signal.x_values.start_value", 0.0),
      number("Signal.x_values.increment", 1.0 / 25600),
      number("Signal.x_values.number_of_values", 4),
      text("Signal.x_values.quantity.label", {"s"}),
      numbers("Signal.y_values.values", both()),
      text("Signal.y_values.quantity.label", {"g"}),
      text("Signal.function_record.name", {"hammer:3:+Z", "wing:12:-X"}),
      number("Signal_1.x_values.increment", 1.0 / 25600),
      numbers("Signal_1.y_values.values", one),
      text("Signal_1.y_values.quantity.label", {"N"}),
      number("FRF.x_values.increment", 0.5),
      text("FRF.x_values.quantity.label", {"Hz"}),
      numbers("FRF.y_values.values", one)};
  const auto records = records_of_arrays(arrays);
  ASSERT_EQ(records.size(), 3U) << "the FRF is no record of time";
  EXPECT_EQ(records[0].name, "hammer:3:+Z");
  EXPECT_EQ(records[0].column, "Signal.y_values.values:1");
  EXPECT_EQ(records[1].dof, (Dof{12, 1, -1}));
  EXPECT_EQ(records[1].unit, "g");
  EXPECT_EQ(records[1].values, two);
  EXPECT_DOUBLE_EQ(*records[1].rate_hz, 25600.0);
  EXPECT_EQ(records[2].name, "Signal_1");
  EXPECT_EQ(records[2].unit, "N");
}

TEST(ArrayRecords, DewesoftsVariables) {
  const Eigen::Vector4d times(0.0, 0.0002, 0.0004, 0.0006);
  const Arrays arrays{number("Sample_rate", 5000),
                      text("File_name", {"C:/a.dxd"}),
                      numbers("Data1_time_AI_1", times),
                      numbers("Data1_AI_1", one),
                      numbers("Data1_AI_2", two),
                      numbers("Data1_slow", Eigen::Vector2d(1, 2))};
  const auto records = records_of_arrays(arrays);
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].name, "AI_1");
  EXPECT_EQ(records[0].column, "Data1_AI_1");
  EXPECT_EQ(records[1].rate_hz, 5000.0);
  EXPECT_EQ(records[1].unit, "");
}

TEST(ArrayRecords, FramesOfAModalTestAreTold) {
  Arrays arrays{numbers("time_data", both()),
                text("channels/unit", {"N", "g"}),
                number("Modal@samples_per_frame", 2),
                number("sample_rate", 64)};
  EXPECT_TRUE(is_rattlesnake(arrays));
  EXPECT_EQ(rattlesnake_frame(arrays), 0) << "a stream";
  arrays.push_back(numbers("Modal/frf_data_real", one));
  EXPECT_EQ(rattlesnake_frame(arrays), 2);
}

// The nearest rate counts, and nobody's own is another's.
TEST(ArrayRecords, RatesBelongToWhatTheyStandBeside) {
  const Arrays arrays{numbers("slow/a", one),
                      number("slow/fs", 10),
                      numbers("fast/b", two),
                      number("fast/fs", 1000),
                      numbers("c", one),
                      number("c@dt", 0.5),
                      numbers("cd", two)};
  const auto records = records_of_arrays(arrays);
  ASSERT_EQ(records.size(), 4U);
  EXPECT_EQ(records[0].rate_hz, 10.0);
  EXPECT_EQ(records[1].rate_hz, 1000.0);
  EXPECT_EQ(records[2].rate_hz, 2.0);
  EXPECT_NE(records[3].rate_hz, 2.0);
}

TEST(ArrayRecords, NumbersOfSamplesAreNoTimes) {
  const auto records = records_of_arrays(
      {numbers("n", Eigen::Vector4d(0, 1, 2, 3)), numbers("a", one)});
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].rate_hz, std::nullopt);
}

TEST(ArrayRecords, UnevenTimesTellNoRate) {
  const auto records = records_of_arrays(
      {numbers("t", Eigen::Vector4d(0, 1, 2, 9)), numbers("a", one)});
  ASSERT_EQ(records.size(), 1U);
  EXPECT_EQ(records[0].rate_hz, std::nullopt);
}

TEST(ArrayRecords, NamesDiffer) {
  const auto records =
      records_of_arrays({numbers("run1/acc", one), numbers("run2/acc", two)});
  ASSERT_EQ(records.size(), 2U);
  EXPECT_EQ(records[0].name, "acc");
  EXPECT_EQ(records[1].name, "acc 2");
  EXPECT_EQ(records[1].column, "run2/acc");
}

TEST(PointNames, PointsEndANameAfterASeparator) {
  EXPECT_EQ(point_in_name("12Z+"), (Dof{12, 3, 1}));
  EXPECT_EQ(point_in_name("wing:12:-X"), (Dof{12, 1, -1}));
  EXPECT_EQ(point_in_name("acc 7Y"), (Dof{7, 2, 1}));
  EXPECT_EQ(point_in_name("acc12Z+"), std::nullopt);
  EXPECT_EQ(point_in_name("hammer"), std::nullopt);
  EXPECT_EQ(point_in_name(""), std::nullopt);
}

TEST(PointNames, AxesEndAName) {
  const auto axis = axis_in_name("seat -y");
  ASSERT_TRUE(axis);
  EXPECT_EQ(axis->sensor, "seat");
  EXPECT_EQ(axis->component, 2);
  EXPECT_EQ(axis->sign, -1);
  EXPECT_FALSE(axis_in_name("acc1"));
  EXPECT_FALSE(axis_in_name("+"));
}

}  // namespace
}  // namespace tapfit::acquisition
