// What fuzzers found worth keeping is read again: inputs that brought a reader
// down, and a few from which they start.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using Fuzzer = int(const std::uint8_t* data, std::size_t size);
// The fuzzers' entries, named apart from each other where they are compiled.
extern "C" {
Fuzzer fuzz_audio, fuzz_bundle, fuzz_deck, fuzz_instrument, fuzz_mat,
    fuzz_matrices, fuzz_modes, fuzz_session, fuzz_table, fuzz_uff;
}

namespace tapfit::fuzz {
namespace {

namespace fs = std::filesystem;

struct Reader {
  std::string name;
  Fuzzer* read;
};

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Corpus : public ::testing::TestWithParam<Reader> {};

// A reader that falls ends the program; what it must not throw is a failure.
TEST_P(Corpus, IsReadOrRefused) {
  const auto& [name, read] = GetParam();
  const fs::path folder = fs::path(TAPFIT_SOURCE_DIR) / "tests/fuzz/corpus";
  std::vector<fs::path> samples;
  for (const auto& entry : fs::directory_iterator(folder / name)) {
    samples.push_back(entry.path());
  }
  std::ranges::sort(samples);
  ASSERT_FALSE(samples.empty());
  for (const fs::path& sample : samples) {
    SCOPED_TRACE(sample.filename());
    const std::string bytes = bytes_of(sample);
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
    EXPECT_NO_THROW(EXPECT_EQ(read(data, bytes.size()), 0));
  }
}

INSTANTIATE_TEST_SUITE_P(Readers,
                         Corpus,
                         ::testing::Values(Reader{"audio", &fuzz_audio},
                                           Reader{"bundle", &fuzz_bundle},
                                           Reader{"deck", &fuzz_deck},
                                           Reader{"instrument",
                                                  &fuzz_instrument},
                                           Reader{"mat", &fuzz_mat},
                                           Reader{"matrices", &fuzz_matrices},
                                           Reader{"modes", &fuzz_modes},
                                           Reader{"session", &fuzz_session},
                                           Reader{"table", &fuzz_table},
                                           Reader{"uff", &fuzz_uff}),
                         [](const auto& reader) { return reader.param.name; });

}  // namespace
}  // namespace tapfit::fuzz
