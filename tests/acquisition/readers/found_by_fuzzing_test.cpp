// Inputs that brought a reader down or made it wait, as libFuzzer found them.
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "acquisition/readers/mat_file.hpp"
#include "acquisition/uff/uff_geometry.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/support/matchers.hpp"

namespace tapfit::acquisition {
namespace {

std::string bytes(const std::string& hex) {
  std::string result;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    result += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return result;
}

// 65 thousand million samples of four channels in 230 bytes.
constexpr const char* tall_tale =
    "664c6143000000dea97bd4169487e0d93d4dd46d66ff1f1010329a68efc003da5f81e4"
    "6b3422ed124ab028a07a0f7cd9a274225fa55a9c432a5138db6e65a640ddca18a8658a"
    "47f3b57dc58951cb1cf8b57d5d3757eb3a715ccf3d6358974715e692827629c472fd21"
    "4ea31ca2a0a6cd2b05577e79c56ff089de514d4a8caf2a63679e8096b7ea0a96424926"
    "bd18c5b041214b685dff765667a2095c0eef0f1b6d4426253e34a0d79044521bebeaec"
    "98c1cb47d1f8fbb005293818ed3d45ca868d13138e95cf655235f890fae87980cd2749"
    "3cbd06aab29cd40228b466399434beff5146594c";

// A compressed variable of 85 bytes, of which 43 are there; matio took 1.6 GB
// for it. Behind the 124 characters of text that such a file begins with.
constexpr const char* half_a_variable =
    "0001494d0f00000055000000789ce36360604800623620e680d220c00ae5b300312314"
    "f3ff71496a71497c5a516a61696a5e722523004d";

// A matrix of 56 bytes whose name is 3.2 GB long; matio took that much for it.
constexpr const char* long_name =
    "0001494d0e0000003800000006000000080000000600000000000000050000000800"
    "0000c800000002000000010000000900e7bf6163630009000000080000000000000000"
    "000000";

// A packed variable of two numbers, one byte of the second changed: only the
// checksum at its end shows that.
constexpr const char* changed_byte =
    "0001494d0f0000005b0000007801015000afff0e000000480000000600000008000000"
    "0600000000000000050000000800000002000000010000000100000003000000616363"
    "00000000000900000010000000000000000000f03f000000000000004f54de032e";

// The endless name, packed, and its checksum right.
constexpr const char* packed_long_name =
    "0001494d0f0000005b0000007801015000afff0e000000480000000600000008000000"
    "060000000000000005000000080000000200000001000000010000000900e7bf616363"
    "00000000000900000010000000000000000000f03f00000000000000408d0304da";

// Eight numbers that call themselves 6291457 rows of 2816; matio asked for 141
// GB.
constexpr const char* vast_matrix =
    "0001494d0e0000007800000006000000080000000600000000000000050000000800"
    "000001006000000b0000010000000300000061636300000000000900000040000000"
    "00000000000000000000000000000000000000000000000000000000000000000000"
    "000000000000000000000000000000000000000000000000000000000000";

TEST(FoundByFuzzing, MatlabMatrixLargerThanItsFileCanHold) {
  const testing::TemporaryFolder folder;
  const std::string text = std::string(124, ' ') + bytes(vast_matrix);
  EXPECT_THAT([&] { (void)read_mat_arrays(folder.write("vast.mat", text)); },
              Throws<InputError>(AllOf(
                  Property(&InputError::what, HasSubstr("\"acc\"")),
                  Property(&InputError::remedy, HasSubstr("copy it again")))));
}

TEST(FoundByFuzzing, SoundFileThatAnnouncesMoreThanItCanHold) {
  const testing::TemporaryFolder folder;
  EXPECT_THAT(
      [&] { (void)read_audio(folder.write("tall.flac", bytes(tall_tale))); },
      Refuses("in 230 bytes"));
}

TEST(FoundByFuzzing, MatlabVariableThatEndsEarly) {
  const testing::TemporaryFolder folder;
  const std::string text = std::string(124, ' ') + bytes(half_a_variable);
  EXPECT_THAT(
      [&] { (void)read_mat_arrays(folder.write("half.mat", text)); },
      Throws<InputError>(AllOf(
          Property(&InputError::what, HasSubstr("85 bytes are announced, 43")),
          Property(&InputError::where, HasSubstr("byte 128")))));
}

TEST(FoundByFuzzing, MatlabVariableWithAnEndlessName) {
  const testing::TemporaryFolder folder;
  const std::string text = std::string(124, ' ') + bytes(long_name);
  try {
    (void)read_mat_arrays(folder.write("name.mat", text));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("3219587081 bytes are announced"));
    // Behind 128 of the header, 8 of the matrix, twice 16 of flags and size.
    EXPECT_THAT(error.where(), HasSubstr("byte 168"));
  }
}

// matio took the changed number for a good one.
TEST(FoundByFuzzing, MatlabVariablesThatDoNotUnpack) {
  const testing::TemporaryFolder folder;
  for (const char* variable : {changed_byte, packed_long_name}) {
    const std::string text = std::string(124, ' ') + bytes(variable);
    EXPECT_THAT(
        [&] { (void)read_mat_arrays(folder.write("packed.mat", text)); },
        Throws<InputError>(
            AllOf(Property(&InputError::what, HasSubstr("does not unpack")),
                  Property(&InputError::where, HasSubstr("byte 128")))))
        << variable;
  }
}

// No node has a number of a hundred digits; it was cast to an int.
TEST(FoundByFuzzing, NodeNumberOfAHundredDigits) {
  const std::string line = std::string(100, '3') + " 1 0 1 1.0 2.0 3.0";
  UffDataset dataset;
  dataset.type = 15;
  dataset.lines = {line};
  UffGeometry geometry;
  add_geometry(dataset, geometry);
  ASSERT_EQ(geometry.nodes.size(), 1U);
  EXPECT_EQ(geometry.nodes.begin()->first, 0);
}

}  // namespace
}  // namespace tapfit::acquisition
