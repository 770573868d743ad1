#include "updating/session/shared_session.hpp"

#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

SavedSession with_effect(const std::string& effect) {
  SavedSession session;
  session.effects = {{{effect, {}}, true}};
  return session;
}

// Two windows: neither writes over what it has not seen.
TEST(SharedSession, WritesOverNothingUnseen) {
  const ::tapfit::testing::TemporaryFolder folder;
  const auto file = folder.path() / "session.json";
  SharedSession one(file);
  SharedSession other(file);
  EXPECT_FALSE(one.news());
  EXPECT_TRUE(one.write(with_effect("soft-support")));
  EXPECT_FALSE(one.news()) << "its own is no news";
  EXPECT_FALSE(other.write(with_effect("sensor-mass")));
  const auto news = other.news();
  ASSERT_TRUE(news);
  ASSERT_EQ(news->effects.size(), 1U);
  EXPECT_EQ(news->effects[0].ref.effect, "soft-support");
  EXPECT_FALSE(other.news());
  EXPECT_TRUE(other.write(with_effect("sensor-mass")));
  EXPECT_TRUE(one.news());
}

TEST(SharedSession, TakesAnEmptyOneAway) {
  const ::tapfit::testing::TemporaryFolder folder;
  const auto file = folder.path() / "session.json";
  SharedSession one(file);
  SharedSession other(file);
  ASSERT_TRUE(one.write(with_effect("soft-support")));
  ASSERT_TRUE(one.write({}));
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_FALSE(other.news());
  EXPECT_TRUE(other.write(with_effect("sensor-mass")));
}

}  // namespace
}  // namespace tapfit::updating
