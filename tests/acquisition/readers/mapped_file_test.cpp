// Files that become shorter while they are read: a copy that is still going on,
// a recorder that begins anew.
#include "acquisition/readers/mapped_file.hpp"

#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/support/matchers.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t count_letters(const MappedFile& file) {
  return file.reading([&file] {
    return std::count(file.text().begin(), file.text().end(), 'a');
  });
}

std::string said_of(const MappedFile& file) {
  return refusal_of([&] {
    // Or the compiler sees that nothing comes of it and reads nothing.
    [[maybe_unused]] const volatile std::ptrdiff_t seen = count_letters(file);
  });
}

// Some pages, and the end of the last one.
TEST(MappedFile, ThatBecomesShorterIsRefused) {
  constexpr std::size_t size = 100'001;
  for (const std::size_t left : {std::size_t{0}, size / 2, size - 1}) {
    const testing::TemporaryFolder folder;
    const fs::path path = folder.write("a.uff", std::string(size, 'a'));
    const MappedFile file(path);
    EXPECT_EQ(count_letters(file), std::ptrdiff_t{size});
    fs::resize_file(path, left);
    EXPECT_THAT(said_of(file), HasSubstr("became shorter")) << left;
  }
}

TEST(MappedFile, ThatWasShorterForAWhileIsRefused) {
  const testing::TemporaryFolder folder;
  const fs::path path = folder.write("a.uff", std::string(100'000, 'a'));
  const MappedFile file(path);
  fs::resize_file(path, 0);
  EXPECT_NE(said_of(file), "");
  fs::resize_file(path, 100'000);
  EXPECT_THAT(said_of(file), HasSubstr("became shorter"));
}

TEST(MappedFile, ThatGrowsIsReadAsItWas) {
  const testing::TemporaryFolder folder;
  const fs::path path = folder.write("a.uff", std::string(100'000, 'a'));
  const MappedFile file(path);
  fs::resize_file(path, 200'000);
  EXPECT_EQ(count_letters(file), 100'000);
}

// What is made of the zeros is not what is told.
TEST(MappedFile, ThatBecomesShorterIsToldBeforeWhatIsWrongInIt) {
  const testing::TemporaryFolder folder;
  const fs::path path = folder.write("a.uff", std::string(100'000, 'a'));
  const MappedFile file(path);
  fs::resize_file(path, 10);
  EXPECT_THAT(
      [&] {
        (void)file.reading([&]() -> int {
          throw InputError("a broken record", path.string(), "mend it");
        });
      },
      Refuses("became shorter"));
}

TEST(MappedFile, ThatBecomesShorterIsToldWhateverWasThrown) {
  const testing::TemporaryFolder folder;
  const fs::path path = folder.write("a.uff", std::string(100'000, 'a'));
  const MappedFile file(path);
  const auto outside = [&file] {
    return file.reading([] { return std::vector<int>().at(1); });
  };
  EXPECT_THROW((void)outside(), std::out_of_range);
  fs::resize_file(path, 10);
  EXPECT_THROW((void)outside(), InputError);
}

}  // namespace
}  // namespace tapfit::acquisition
