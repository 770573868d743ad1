// What is offered where no bundle is named, and what is kept of those opened.
#include "tui/app/picker.hpp"

#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/tui/support/play.hpp"
#include "tui/app/recent_bundles.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;

class PickerTest : public ::testing::Test {
 protected:
  PickerTest() {
    for (const char* name : {"beam", "plate", "empty", ".hidden"}) {
      fs::create_directory(folder_.path() / name);
    }
    folder_.write("beam/test.json", "{}");
    folder_.write("plate/test.json", "{}");
    folder_.write("frfs.uff", "    -1\n");
    folder_.write("notes.txt", "");
  }

  [[nodiscard]] Picker picker(std::vector<fs::path> recent = {}) const {
    return {{folder_.path(), std::move(recent), fs::path("/share/demo")},
            {80, 24}};
  }
  /// The screen after the keys, each a character or '\n' for Enter.
  static std::string seen(Picker& picker, const std::string& typed) {
    for (const char c : typed) {
      picker.press(c == '\n' ? Key(keys::enter)
                             : Key(static_cast<char32_t>(c)));
    }
    return picker.draw().to_text();
  }

  ::tapfit::testing::TemporaryFolder folder_;
};

TEST_F(PickerTest, OffersWhatIsThere) {
  Picker one = picker({folder_.path() / "plate"});
  const std::string text = seen(one, "");
  expect_fits(text, 80);
  EXPECT_TRUE(holds(text, "▸recent         plate")) << text;
  EXPECT_TRUE(holds(text, "demonstration  demo")) << text;
  EXPECT_TRUE(holds(text, "bundle         beam")) << text;
  EXPECT_TRUE(holds(text, "bundle         frfs.uff")) << text;
  EXPECT_TRUE(holds(text, "folder         empty/")) << text;
  EXPECT_TRUE(holds(text, "tapfit import")) << text;
  EXPECT_TRUE(holds(text, "next: Enter takes up this work again")) << text;
  EXPECT_FALSE(holds(text, "notes.txt")) << text;
  EXPECT_FALSE(holds(text, ".hidden")) << text;
}

TEST_F(PickerTest, OpensWhatIsChosen) {
  Picker one = picker();
  EXPECT_EQ(one.take_picked(), std::nullopt);
  (void)seen(one, "\n");
  EXPECT_EQ(one.take_picked(), fs::path("/share/demo"));
  EXPECT_EQ(one.take_picked(), std::nullopt);
  (void)seen(one, "j\n");
  EXPECT_EQ(one.take_picked(), folder_.path() / "beam");
  (void)seen(one, "/plat\n\n");
  EXPECT_EQ(one.take_picked(), folder_.path() / "plate");
}

TEST_F(PickerTest, LooksIntoFoldersAndBack) {
  Picker one = picker();
  const std::string empty = seen(one, "/empty\n\n");
  EXPECT_TRUE(holds(empty, "empty")) << empty;
  EXPECT_TRUE(holds(empty, "▸folder  ../")) << empty;
  EXPECT_FALSE(holds(empty, "demonstration")) << empty;
  const std::string back = seen(one, "\n");
  EXPECT_TRUE(holds(back, "demonstration")) << back;
  EXPECT_TRUE(holds(seen(one, "/empty\n\nh"), "demonstration"));
  one.press(Key(keys::escape));
  EXPECT_TRUE(holds(seen(one, ""), "demonstration"));
}

TEST_F(PickerTest, SaysWhyABundleIsRefused) {
  Picker one = picker();
  one.refuse("test.json: is no JSON (see line 1)");
  EXPECT_TRUE(holds(seen(one, ""), "is no JSON"));
  EXPECT_FALSE(holds(seen(one, "j"), "is no JSON"));
}

/// Half a second of a blow and of what rings after it.
std::string hammer_csv() {
  std::string text = "time [s],hammer [N],acc1 [m/s^2]\n";
  for (int n = 0; n < 1024; ++n) {
    const double t = n / 2048.0;
    const double force = n >= 100 && n < 108 ? 50.0 : 0.0;
    const double ring = n < 100 ? 0.0 : std::exp(-20.0 * t) * std::sin(600 * t);
    text += fmt::format("{:.8f},{:.6g},{:.6g}\n", t, force, ring);
  }
  return text;
}

TEST_F(PickerTest, MakesATestOfARecording) {
  folder_.write("tap.csv", hammer_csv());
  Picker one = picker();
  EXPECT_TRUE(holds(seen(one, ""), "recording      tap.csv"));
  const std::string offered = seen(one, "/tap\n\n");
  expect_fits(offered, 80);
  EXPECT_TRUE(holds(offered, "becomes the test tap/")) << offered;
  EXPECT_TRUE(holds(offered, "hammer: \"hammer\" at 2Z+, force")) << offered;
  EXPECT_TRUE(holds(offered, "assumed:")) << offered;
  one.press(Key(keys::escape));
  EXPECT_FALSE(fs::exists(folder_.path() / "tap"));
  EXPECT_EQ(one.take_picked(), std::nullopt);
  (void)seen(one, "\n\n");
  EXPECT_EQ(one.take_picked(), folder_.path() / "tap");
  EXPECT_TRUE(fs::exists(folder_.path() / "tap" / "test.json"));
  const std::string again = seen(one, "\n");
  EXPECT_TRUE(holds(again, "already, which is never written over")) << again;
}

TEST_F(PickerTest, SaysWhyARecordingIsNoTest) {
  folder_.write("tap.csv", "nothing\n");
  Picker one = picker();
  const std::string text = seen(one, "/tap\n\n");
  EXPECT_FALSE(holds(text, "becomes")) << text;
  EXPECT_TRUE(holds(text, "tap.csv")) << text;
  EXPECT_FALSE(fs::exists(folder_.path() / "tap"));
}

TEST_F(PickerTest, ExplainsItself) {
  Picker one = picker();
  const std::string text = seen(one, "?");
  expect_fits(text, 80);
  EXPECT_TRUE(holds(text, "a file of time records")) << text;
  EXPECT_FALSE(holds(seen(one, "j?"), "a file of time records"));
  EXPECT_FALSE(one.quit());
}

TEST_F(PickerTest, LeavesAndFitsWhereverItIsShown) {
  Picker one = picker();
  for (const auto& [width, height] :
       {std::pair{1, 1}, {40, 5}, {80, 24}, {200, 50}}) {
    one.resize(width, height);
    expect_fits(seen(one, ""), width);
  }
  EXPECT_FALSE(one.quit());
  (void)seen(one, "q");
  EXPECT_TRUE(one.quit());
}

/// With a cache of its own.
class RecentBundles : public PickerTest {
 protected:
  void SetUp() override {
    const char* off = std::getenv("TAPFIT_NO_CACHE");
    off_ = off == nullptr ? "" : off;
    ::unsetenv("TAPFIT_NO_CACHE");
    const fs::path cache = folder_.path() / ".cache";
    ::setenv("XDG_CACHE_HOME", cache.c_str(), 1);
  }
  void TearDown() override {
    ::unsetenv("XDG_CACHE_HOME");
    if (!off_.empty()) ::setenv("TAPFIT_NO_CACHE", off_.c_str(), 1);
  }

  std::string off_;
};

TEST_F(RecentBundles, HaveTheLatestFirstAndEachOnce) {
  EXPECT_TRUE(recent_bundles().empty());
  const fs::path root = fs::canonical(folder_.path());
  remember_bundle(folder_.path() / "beam");
  remember_bundle(folder_.path() / "plate");
  remember_bundle(folder_.path() / "empty" / ".." / "beam");
  EXPECT_EQ(recent_bundles(),
            (std::vector<fs::path>{root / "beam", root / "plate"}));
  fs::remove_all(folder_.path() / "plate");
  EXPECT_EQ(recent_bundles(), (std::vector<fs::path>{root / "beam"}));
  for (int i = 0; i < 40; ++i) {
    const auto name = fmt::format("many-{}", i);
    fs::create_directory(folder_.path() / name);
    remember_bundle(folder_.path() / name);
  }
  EXPECT_EQ(recent_bundles().size(), 12U);
  EXPECT_EQ(recent_bundles().front(), root / "many-39");
}

TEST_F(RecentBundles, AreNotKeptWithoutACache) {
  ::setenv("TAPFIT_NO_CACHE", "1", 1);
  remember_bundle(folder_.path() / "beam");
  EXPECT_TRUE(recent_bundles().empty());
  ::unsetenv("TAPFIT_NO_CACHE");
  EXPECT_TRUE(recent_bundles().empty());
}

}  // namespace
}  // namespace tapfit::tui
