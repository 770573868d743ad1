// MATLAB files of every version: 4 (byte by byte, mat_text.hpp), 5 plain and
// compressed, 7.3 (HDF5), written by matio itself.
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/readers/mat_file.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/support/matchers.hpp"

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
  EXPECT_EQ(columns_of(
                read_mat_arrays(file), {"force", "run.acc:2", "run.raw"}, file),
            expected);
}

matvar_t* mat_number(const char* name, double value) {
  std::size_t scalar[] = {1, 1};
  return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, scalar, &value, 0);
}

matvar_t* mat_text(const char* name, std::string text) {
  std::size_t dims[] = {1, text.size()};
  return Mat_VarCreate(name, MAT_C_CHAR, MAT_T_UTF8, 2, dims, text.data(), 0);
}

matvar_t* mat_struct(const char* name, const std::vector<matvar_t*>& fields) {
  std::vector<const char*> names;
  for (const matvar_t* field : fields) names.push_back(field->name);
  std::size_t scalar[] = {1, 1};
  matvar_t* made = Mat_VarCreateStruct(
      name, 2, scalar, names.data(), static_cast<unsigned>(names.size()));
  for (matvar_t* field : fields) {
    Mat_VarSetStructFieldByName(made, field->name, 0, field);
  }
  return made;
}

// A structure as Testlab exports it: structures, texts and a cell of texts.
TEST_P(MatVersions, StructuresAndCellsAreTakenApart) {
  const auto file = folder_.path() / "testlab.mat";
  mat_t* handle = Mat_CreateVer(file.c_str(), nullptr, GetParam().first);
  ASSERT_NE(handle, nullptr);
  double samples[] = {0, 7, -1, 3, 1, 5, 2, 4};
  std::size_t dims[] = {4, 2};
  matvar_t* names[] = {mat_text(nullptr, "hammer"), mat_text(nullptr, "12Z+")};
  std::size_t two[] = {1, 2};
  matvar_t* signal = mat_struct(
      "Signal",
      {mat_struct("x_values", {mat_number("increment", 0.001)}),
       mat_struct(
           "y_values",
           {Mat_VarCreate(
                "values", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, samples, 0),
            mat_struct("quantity", {mat_text("label", "m/s^2")})}),
       mat_struct(
           "function_record",
           {Mat_VarCreate("name", MAT_C_CELL, MAT_T_CELL, 2, two, names, 0)})});
  EXPECT_EQ(Mat_VarWrite(handle, signal, GetParam().second), 0);
  Mat_VarFree(signal);
  Mat_Close(handle);
  const auto arrays = read_mat_arrays(file);
  EXPECT_EQ(number_of(arrays, "Signal.x_values.increment", file), 0.001);
  EXPECT_EQ(samples_of(arrays, "Signal.y_values.values:2", file),
            Eigen::Vector4d(1, 5, 2, 4));
  const NamedArray* label =
      find_array(arrays, "Signal.y_values.quantity.label");
  ASSERT_NE(label, nullptr);
  EXPECT_EQ(label->texts, std::vector<std::string>{"m/s^2"});
  const NamedArray* list = find_array(arrays, "Signal.function_record.name");
  ASSERT_NE(list, nullptr);
  EXPECT_EQ(list->texts, (std::vector<std::string>{"hammer", "12Z+"}));
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
  EXPECT_THAT(
      [&] {
        const auto bad = folder.write("bad.mat", text);
        (void)samples_of(read_mat_arrays(bad), "force", bad);
      },
      Refuses("\"force\" cannot be read"));
}

// Three variables, each 0.4 of what all together may take. The file has
// holes where the numbers are and takes no room on disk.
TEST(MatFile, ItsVariablesAreHeldByMemoryTogether) {
  testing::TemporaryFolder folder;
  const auto file = folder.path() / "vast.mat";
  const auto columns =
      static_cast<std::uint32_t>(0.4 * most_matrix_bytes() / 24 / 65536);
  std::ofstream out(file, std::ios::binary);
  for (const char name : {'a', 'b', 'c'}) {
    for (const std::uint32_t number : {0U, 65536U, columns, 0U, 2U}) {
      out.write(reinterpret_cast<const char*>(&number), 4);
    }
    out << name << '\0';
    out.seekp(std::streamoff{65536} * columns * 8, std::ios::cur);
  }
  out.seekp(-1, std::ios::cur);
  out << '\0';
  out.close();
  EXPECT_THAT([&] { (void)read_mat_arrays(file); },
              Refuses("more than memory holds"));
}

// A disk that was full, or a copy that was not finished, leaves holes: a
// terabyte of them would be walked through for hours.
TEST(MatFile, ThatIsZerosIsRefusedAtOnce) {
  testing::TemporaryFolder folder;
  const auto file = folder.path() / "zeros.mat";
  const auto refused = [&] { (void)read_mat_arrays(file); };
  std::ofstream(file, std::ios::binary).close();
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40U);
  EXPECT_THAT(refused, Refuses("cannot be read as a MATLAB file"));
  std::string header(124, ' ');  // of version 5
  header += std::string("\0\1IM", 4);
  std::ofstream(file, std::ios::binary) << header;
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40U);
  EXPECT_THAT(refused, Refuses("nothing is stored there"));
}

TEST(NamedArrays, ShareTheRoomOfTheirFile) {
  const double half = 0.6 * most_matrix_bytes() / 24;  // of numbers in 3 places
  ArrayRoom room("run.mat");
  room.take("a", half);
  EXPECT_THAT([&] { room.take("b", half); }, Refuses("\"b\" has"));
}

}  // namespace
}  // namespace tapfit::acquisition
