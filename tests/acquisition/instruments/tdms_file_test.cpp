// TDMS files byte by byte (tdms_text.hpp): the expected samples are those that
// were put there.
#include "acquisition/instruments/tdms_file.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/instruments/instrument_file.hpp"
#include "tests/acquisition/support/tdms_text.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

using testing::TdmsBytes;

class Tdms : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;

  std::vector<NamedArray> read(const std::string& bytes) {
    return read_tdms_arrays(folder_.write("a.tdms", bytes));
  }
  std::string refusal(const std::string& bytes) {
    try {
      (void)read(bytes);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  // Samples of a channel, one after the other.
  static std::vector<double> samples(const std::vector<NamedArray>& arrays,
                                     const std::string& name) {
    const Eigen::VectorXd x = samples_of(arrays, name, "a.tdms");
    return {x.begin(), x.end()};
  }
};

using Samples = std::vector<double>;

TEST_F(Tdms, ChannelsComeWithUnitNameAndRateInEitherByteOrder) {
  for (const bool big : {false, true}) {
    const auto file = folder_.write(
        "tap.tdms", testing::tdms_hammer_test({0, 7.5, -1}, {1, 5, 2}, big));
    const InstrumentFile read = read_instrument_file(file);
    ASSERT_EQ(read.records.size(), 2U) << big;
    EXPECT_EQ(read.records[0].column, "Run/Hammer");
    EXPECT_EQ(read.records[0].name, "Hammer");
    EXPECT_EQ(read.records[0].unit, "N");
    EXPECT_EQ(read.records[0].rate_hz, 2048.0);
    EXPECT_EQ(read.records[0].values, Eigen::Vector3d(0, 7.5, -1));
    EXPECT_EQ(read.records[1].unit, "g");
    EXPECT_EQ(read.records[1].dof, (Dof{12, 3, 1})) << "in its name";
    EXPECT_EQ(read.records[1].values, Eigen::Vector3d(1, 5, 2));
  }
}

// A second segment without metadata, one that changes a channel's count alone,
// and one whose last chunk is cut.
TEST_F(Tdms, SegmentsGoOnWithWhatIsNotToldAgain) {
  TdmsBytes first;
  first.add(std::uint32_t{2});
  testing::tdms_object(first, "/'G'/'a'", 2, 2);  // int16
  first.add(std::uint32_t{0});
  testing::tdms_object(first, "/'G'/'b'", 9, 1);  // float
  first.add(std::uint32_t{0});
  const auto chunk = [](TdmsBytes& raw, std::int16_t a, float b) {
    raw.add(a).add(static_cast<std::int16_t>(a + 1)).add(b);
  };
  TdmsBytes raw;
  chunk(raw, 10, 0.5F);
  chunk(raw, 12, 1.5F);  // two chunks in one segment
  TdmsBytes again;
  chunk(again, 14, 2.5F);
  TdmsBytes change;
  change.add(std::uint32_t{2});
  testing::tdms_object(change, "/'G'/'a'", 2, 4);
  change.add(std::uint32_t{0});
  testing::tdms_object_as_before(change, "/'G'/'b'");
  change.add(std::uint32_t{0});
  TdmsBytes cut;  // half a chunk of 4 * 2 + 4 bytes: two values of a, none of b
  cut.add(std::int16_t{16}).add(std::int16_t{17});
  const std::uint32_t values = testing::TdmsRawData;
  const auto arrays = read(
      testing::tdms_segment(
          values | testing::TdmsMetadata | testing::TdmsNewList, first, raw) +
      testing::tdms_segment(values, TdmsBytes(), again) +
      testing::tdms_segment(values | testing::TdmsMetadata, change, cut));
  // 4 of 12 bytes are a third: one value of a.
  EXPECT_EQ(samples(arrays, "G/a"), (Samples{10, 11, 12, 13, 14, 15, 16}));
  EXPECT_EQ(samples(arrays, "G/b"), (Samples{0.5, 1.5, 2.5}));
}

TEST_F(Tdms, InterleavedValuesOfSeveralWidths) {
  TdmsBytes metadata;
  metadata.add(std::uint32_t{3});
  testing::tdms_object(metadata, "/'G'/'a'", 1, 3);  // int8
  metadata.add(std::uint32_t{0});
  testing::tdms_object(metadata, "/'G'/'none'");
  metadata.add(std::uint32_t{0});
  testing::tdms_object(metadata, "/'G'/'b'", 7, 3);  // uint32
  metadata.add(std::uint32_t{0});
  TdmsBytes raw;
  for (int k = 0; k < 3; ++k) {
    raw.add(static_cast<std::int8_t>(-k))
        .add(static_cast<std::uint32_t>(4000000000U + k));
  }
  const auto arrays = read(
      testing::tdms_segment(testing::TdmsMetadata | testing::TdmsNewList |
                                testing::TdmsRawData | testing::TdmsInterleaved,
                            metadata,
                            raw));
  EXPECT_EQ(samples(arrays, "G/a"), (Samples{0, -1, -2}));
  EXPECT_EQ(samples(arrays, "G/b"), (Samples{4e9, 4e9 + 1, 4e9 + 2}));
  EXPECT_EQ(find_array(arrays, "G/none"), nullptr);
}

// LabVIEW leaves the length open when it is stopped hard.
TEST_F(Tdms, ASegmentWithoutAnEndGoesUpToTheFilesEnd) {
  std::string bytes = testing::tdms_hammer_test({0, 7.5, -1}, {1, 5, 2});
  bytes.replace(12, 8, std::string(8, '\xff'));
  EXPECT_EQ(samples(read(bytes), "Run/Hammer"), (Samples{0, 7.5, -1}));
}

TEST_F(Tdms, QuotesInNamesAreDoubled) {
  TdmsBytes metadata;
  metadata.add(std::uint32_t{1});
  testing::tdms_object(metadata, "/'Dr. T''s test'/'a/b'", 10, 1);
  metadata.add(std::uint32_t{1});
  testing::tdms_property(metadata, "NI_ChannelName", "left");
  TdmsBytes raw;
  raw.add(2.5);
  const auto arrays = read(testing::tdms_segment(
      testing::TdmsMetadata | testing::TdmsNewList | testing::TdmsRawData,
      metadata,
      raw));
  EXPECT_EQ(samples(arrays, "Dr. T's test/a/b"), (Samples{2.5}));
}

std::string scaled_counts(const std::string& kind, double first) {
  TdmsBytes metadata;
  metadata.add(std::uint32_t{1});
  testing::tdms_object(metadata, "/'G'/'a'", 2, 2);
  metadata.add(std::uint32_t{9});
  testing::tdms_property(metadata, "NI_Scaling_Status", "unscaled");
  testing::tdms_property(metadata, "NI_Number_Of_Scales", 2.0);
  testing::tdms_property(metadata, "NI_Scale[0]_Scale_Type", kind);
  testing::tdms_property(metadata, "NI_Scale[0]_Linear_Slope", first);
  testing::tdms_property(metadata, "NI_Scale[0]_Linear_Y_Intercept", 1.0);
  testing::tdms_property(metadata, "NI_Scale[1]_Scale_Type", "Polynomial");
  testing::tdms_property(
      metadata, "NI_Scale[1]_Polynomial_Coefficients_Size", 2.0);
  testing::tdms_property(
      metadata, "NI_Scale[1]_Polynomial_Coefficients[1]", 10.0);
  testing::tdms_property(metadata, "NI_Scale[1]_Polynomial_Input_Source", 0.0);
  TdmsBytes raw;
  raw.add(std::int16_t{4}).add(std::int16_t{-2});
  return testing::tdms_segment(
      testing::TdmsMetadata | testing::TdmsNewList | testing::TdmsRawData,
      metadata,
      raw);
}

// 10 (0.5 x + 1), the polynomial's constant missing at first.
TEST_F(Tdms, UnscaledCountsAreScaledOrRefused) {
  std::string bytes = scaled_counts("Linear", 0.5);
  EXPECT_NE(refusal(bytes).find("Coefficients[0] is not there"),
            std::string::npos);
  TdmsBytes constant;
  constant.add(std::uint32_t{1});
  testing::tdms_object_as_before(constant, "/'G'/'a'");
  constant.add(std::uint32_t{1});
  testing::tdms_property(
      constant, "NI_Scale[1]_Polynomial_Coefficients[0]", 0.0);
  bytes += testing::tdms_segment(testing::TdmsMetadata, constant, TdmsBytes());
  EXPECT_EQ(samples(read(bytes), "G/a"), (Samples{30, 0}));
  EXPECT_NE(refusal(scaled_counts("Table", 1.0)).find("of kind Table"),
            std::string::npos)
      << refusal(scaled_counts("Table", 1.0));
}

TEST_F(Tdms, WhatIsNotReadIsRefusedByName) {
  TdmsBytes metadata;
  metadata.add(std::uint32_t{1});
  metadata.add(std::string("/'G'/'a'")).add(std::uint32_t{0x1269});
  const std::string daqmx = refusal(testing::tdms_segment(
      testing::TdmsMetadata | testing::TdmsRawData | testing::TdmsDaqmx,
      metadata,
      TdmsBytes()));
  EXPECT_NE(daqmx.find("DAQmx"), std::string::npos) << daqmx;
  EXPECT_NE(refusal("TDSh" + std::string(24, '\0')).find("is the index"),
            std::string::npos);
  TdmsBytes complex;
  complex.add(std::uint32_t{1});
  testing::tdms_object(complex, "/'G'/'a'", 0x12345, 4);
  EXPECT_NE(refusal(testing::tdms_segment(
                        testing::TdmsMetadata, complex, TdmsBytes()))
                .find("0x12345"),
            std::string::npos);
}

// Announced sizes are held against the file before memory is taken.
TEST_F(Tdms, TallTalesAreRefused) {
  TdmsBytes metadata;
  metadata.add(std::uint32_t{1});
  testing::tdms_object(
      metadata, "/'G'/'a'", 10, std::uint64_t{0x2000000000000001});
  EXPECT_NE(refusal(testing::tdms_segment(
                        testing::TdmsMetadata, metadata, TdmsBytes()))
                .find("more values than the file holds"),
            std::string::npos);
  std::string longer = testing::tdms_hammer_test({0, 1}, {1, 2});
  longer.resize(longer.size() - 1);
  EXPECT_NE(refusal(longer).find("ends early"), std::string::npos);
}

}  // namespace
}  // namespace tapfit::acquisition
