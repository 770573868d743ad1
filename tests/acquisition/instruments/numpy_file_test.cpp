// Files of numpy byte by byte (npy_text.hpp).
#include "acquisition/instruments/numpy_file.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/instruments/instrument_file.hpp"
#include "tests/acquisition/support/npy_text.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;
using testing::bytes_of_numbers;
using testing::npy;

class Numpy : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;

  NamedArray read(const std::string& bytes) {
    return read_npy_arrays(folder_.write("a.npy", bytes)).at(0);
  }
  std::string refusal(const std::string& name, const std::string& bytes) {
    try {
      (void)read_instrument_file(folder_.write(name, bytes));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
};

TEST_F(Numpy, RowsOrColumnsFirstAreTheSameColumns) {
  const std::string rows =
      npy("<f8", "(3, 2)", bytes_of_numbers<double>({1, 2, 3, 4, 5, 6}));
  const std::string columns =
      npy("<f8", "(3, 2)", bytes_of_numbers<double>({1, 3, 5, 2, 4, 6}), true);
  for (const std::string& bytes : {rows, columns}) {
    const NamedArray array = read(bytes);
    EXPECT_EQ(array.name, "a");
    ASSERT_EQ(array.samples(), 3);
    EXPECT_EQ(array.column(0), Eigen::Vector3d(1, 3, 5));
    EXPECT_EQ(array.column(1), Eigen::Vector3d(2, 4, 6));
  }
}

// No values in all, and a side that no index holds.
TEST_F(Numpy, SidesBeyondAnyMemoryHaveNoContent) {
  for (const char* shape :
       {"(0, 18446744073709551615)", "(18446744073709551615, 0)"}) {
    EXPECT_EQ(read(npy("<f8", shape, "")).kind, NamedArray::Kind::Other);
  }
}

TEST_F(Numpy, AllVersionsAndTypes) {
  const Eigen::Vector2d expected(1, 3);
  for (const int version : {1, 2, 3}) {
    EXPECT_EQ(
        read(
            npy("<f4", "(2,)", bytes_of_numbers<float>({1, 3}), false, version))
            .column(0),
        expected);
  }
  EXPECT_EQ(read(npy("|i1", "(2,)", "\x01\x03")).column(0), expected);
  EXPECT_EQ(read(npy("|b1", "(2,)", std::string("\x01\x00", 2))).column(0),
            Eigen::Vector2d(1, 0));
  EXPECT_EQ(
      read(npy(">i2", "(2,)", std::string("\xff\xfe\x00\x03", 4))).column(0),
      Eigen::Vector2d(-2, 3));
  EXPECT_EQ(
      read(npy(">f8",
               "(1, 2, 1)",
               std::string("\x3f\xf0\0\0\0\0\0\0\x40\x08\0\0\0\0\0\0", 16)))
          .column(0),
      expected);
  EXPECT_EQ(read(npy("<u8", "(2,)", bytes_of_numbers<std::uint64_t>({1, 3})))
                .column(0),
            expected);
}

TEST_F(Numpy, WhatIsNoNumbersHasNoContent) {
  for (const char* type : {"<c16", "|O", "<M8[s]", "<f2"}) {
    EXPECT_EQ(read(npy(type, "(2,)", std::string(32, 'x'))).kind,
              NamedArray::Kind::Other)
        << type;
  }
  EXPECT_EQ(read(npy("<f8", "(2, 2, 2)", std::string(64, 'x'))).kind,
            NamedArray::Kind::Other);
}

// An archive as people save it: keys are channels, fs the rate.
TEST_F(Numpy, KeysOfAnArchiveAreChannels) {
  const std::string texts =
      npy("<U3",
          "(2,)",
          bytes_of_numbers<std::uint32_t>({'N', 0, 0, 'm', '/', 0xb2}));
  for (const bool deflated : {false, true}) {
    const fs::path file = folder_.write(
        "run.npz",
        testing::zip(
            {{"hammer.npy", npy({0, 7, -1, 2})},
             {"acc.npy", npy({1, 5, 2, 4})},
             {"units.npy", texts},
             {"fs.npy",
              npy("<i8", "()", bytes_of_numbers<std::int64_t>({1000}))},
             {"readme.txt", "left aside"}},
            deflated));
    const InstrumentFile read = read_instrument_file(file);
    ASSERT_EQ(read.records.size(), 2U);
    EXPECT_EQ(read.records[0].name, "hammer");
    EXPECT_EQ(read.records[0].unit, "N");
    EXPECT_EQ(read.records[0].rate_hz, 1000.0);
    EXPECT_EQ(read.records[1].unit, "m/\u00b2");
    EXPECT_EQ(read.records[1].values, Eigen::Vector4d(1, 5, 2, 4));
  }
}

TEST_F(Numpy, ATimeArrayOrColumnGivesTheRate) {
  const fs::path archive =
      folder_.write("run.npz",
                    testing::zip({{"t.npy", npy({0.5, 0.625, 0.75, 0.875})},
                                  {"acc.npy", npy({1, 5, 2, 4})}},
                                 false));
  EXPECT_EQ(read_instrument_file(archive).records.at(0).rate_hz, 8.0);
  const fs::path table =
      folder_.write("table.npy",
                    npy("<f8",
                        "(4, 3)",
                        bytes_of_numbers<double>(
                            {0, 9, 1, 0.25, 8, 5, 0.5, 9, 2, 0.75, 7, 4})));
  const InstrumentFile read = read_instrument_file(table);
  ASSERT_EQ(read.records.size(), 2U) << "the first column is time";
  EXPECT_EQ(read.records[0].column, "table:2");
  EXPECT_EQ(read.records[0].rate_hz, 4.0);
  EXPECT_EQ(read.records[1].values, Eigen::Vector4d(1, 5, 2, 4));
}

TEST_F(Numpy, DamagedArchivesAreRefused) {
  const std::string good = testing::zip({{"a.npy", npy({1, 2, 3, 5})}}, true);
  std::string changed = good;
  changed[60] = static_cast<char>(changed[60] ^ 0x55);
  EXPECT_NE(refusal("a.npz", changed).find("does not unpack"),
            std::string::npos)
      << refusal("a.npz", changed);
  EXPECT_NE(refusal("a.npz", good.substr(0, good.size() - 22))
                .find("is no whole zip archive"),
            std::string::npos);
  std::string vast = good;  // 16 MB in some 100 bytes
  const std::size_t size = vast.rfind("PK\x01\x02") + 24;
  vast.replace(size, 4, std::string("\0\0\0\x01", 4));
  EXPECT_NE(refusal("a.npz", vast).find("does not unpack"), std::string::npos);
}

TEST_F(Numpy, AnArrayLongerThanItsFileIsRefused) {
  EXPECT_NE(refusal("a.npy", npy("<f8", "(5,)", std::string(32, '\0')))
                .find("40 bytes are announced, 32 are there"),
            std::string::npos);
  EXPECT_NE(refusal("a.npy", npy("<f8", "(1152921504606846976, 9)", ""))
                .find("more than memory holds"),
            std::string::npos);
  EXPECT_NE(
      refusal("a.npy", "\x93NUMPY" + std::string(8, '\x01')).find("a.npy"),
      std::string::npos);
}

}  // namespace
}  // namespace tapfit::acquisition
