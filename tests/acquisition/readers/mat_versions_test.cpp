// MATLAB files of every version: 4 (byte by byte, mat_text.hpp), 5 plain and
// compressed, 7.3 (HDF5), written by matio itself.
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/readers/mat_file.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <matio.h>

#include <fstream>
#include <iterator>

namespace tapfit::acquisition {
namespace {

// A matrix of doubles, single precision and 16-bit counts in a structure.
void write_mat(const std::filesystem::path& file,
               mat_ft version,
               matio_compression compression) {
  mat_t* handle = Mat_CreateVer(file.c_str(), nullptr, version);
  ASSERT_NE(handle, nullptr);
  double force[] = {0.0, 7.5, -1.0, 0.25};
  std::size_t column[] = {4, 1};
  matvar_t* one =
      Mat_VarCreate("force", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, column, force, 0);
  EXPECT_EQ(Mat_VarWrite(handle, one, compression), 0);
  Mat_VarFree(one);
  float single[] = {1.F, 2.F, 3.F, 4.F, 5.F, 6.F, 7.F, 8.F};
  std::size_t matrix[] = {4, 2};
  std::int16_t counts[] = {-5, 6, -7, 8};
  const char* names[] = {"acc", "raw"};
  std::size_t scalar[] = {1, 1};
  matvar_t* run = Mat_VarCreateStruct("run", 2, scalar, names, 2);
  Mat_VarSetStructFieldByName(
      run,
      "acc",
      0,
      Mat_VarCreate("acc", MAT_C_SINGLE, MAT_T_SINGLE, 2, matrix, single, 0));
  Mat_VarSetStructFieldByName(
      run,
      "raw",
      0,
      Mat_VarCreate("raw", MAT_C_INT16, MAT_T_INT16, 2, column, counts, 0));
  EXPECT_EQ(Mat_VarWrite(handle, run, compression), 0);
  Mat_VarFree(run);
  Mat_Close(handle);
}

class MatVersions
    : public ::testing::TestWithParam<std::pair<mat_ft, matio_compression>> {
 protected:
  testing::TemporaryFolder folder_;
};

TEST_P(MatVersions, MatricesAndFieldsComeBack) {
  const auto file = folder_.path() / "test.mat";
  write_mat(file, GetParam().first, GetParam().second);
  Eigen::MatrixXd expected(4, 3);
  expected << 0.0, 5, -5, 7.5, 6, 6, -1.0, 7, -7, 0.25, 8, 8;
  EXPECT_EQ(read_mat_columns(file, {"force", "run.acc:2", "run.raw"}),
            expected);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    MatVersions,
    ::testing::Values(std::pair{MAT_FT_MAT5, MAT_COMPRESSION_NONE},
                      std::pair{MAT_FT_MAT5, MAT_COMPRESSION_ZLIB},
                      std::pair{MAT_FT_MAT73, MAT_COMPRESSION_NONE},
                      std::pair{MAT_FT_MAT73, MAT_COMPRESSION_ZLIB}));

// Behind the 512 bytes that precede HDF5, whatever looks like the beginning of
// packed numbers (a multiple of 31 that begins with 0x78) goes on wrongly.
TEST(MatDamage, PackedNumbersOfHdf5AreRefusedByName) {
  const testing::TemporaryFolder folder;
  const auto file = folder.path() / "test.mat";
  write_mat(file, MAT_FT_MAT73, MAT_COMPRESSION_ZLIB);
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  for (std::size_t i = 512; i + 6 < text.size(); ++i) {
    const int next = static_cast<unsigned char>(text[i + 1]);
    if (text[i] == 0x78 && (0x7800 + next) % 31 == 0) {
      text.replace(i + 2, 4, "\xff\xff\xff\xff");
    }
  }
  try {
    (void)read_mat_columns(folder.write("bad.mat", text), {"force"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("\"force\" cannot be read"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace tapfit::acquisition
