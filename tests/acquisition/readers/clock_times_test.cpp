// Times of day in the columns of recorders.
#include "acquisition/readers/clock_times.hpp"

#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

TEST(ClockTimes, SecondsSinceMidnight) {
  EXPECT_EQ(seconds_of_day("12:00:01.5"), 43201.5);
  EXPECT_EQ(seconds_of_day("2024-01-31T01:02:03Z"), 3723.0);
  EXPECT_EQ(seconds_of_day("2024-01-31 01:02:03,25+05:30"), 3723.25);
  EXPECT_EQ(seconds_of_day("31.01.2024 01:02:03"), 3723.0);
  EXPECT_EQ(seconds_of_day("1/31/24 01:02:03 PM"), 46923.0);
  EXPECT_EQ(seconds_of_day("12:00:00 AM"), 0.0);
  EXPECT_EQ(seconds_of_day("12:00:00 PM"), 43200.0);
  EXPECT_EQ(seconds_of_day("01:02.5"), 62.5);
}

TEST(ClockTimes, OtherTextsAreNone) {
  for (const char* text : {"",
                           ":",
                           "::",
                           "12",
                           "12:30",
                           "12:60:00",
                           "wing:12:+Z",
                           "12:00:00.1.2",
                           "a 12:00:00",
                           "123:00:00",
                           "12:-1:00",
                           "12:00:nan"}) {
    EXPECT_FALSE(seconds_of_day(text)) << text;
  }
  EXPECT_TRUE(is_date("2024-01-31"));
  EXPECT_TRUE(is_date("1/31/24"));
  for (const char* text :
       {"", "20240131", "1.5", "2024-01", "-1-2-3", "1.2.3"}) {
    EXPECT_FALSE(is_date(text)) << text;
  }
}

TEST(ClockTimes, GoOnAfterMidnightAndTheFullHour) {
  ClockColumn days;
  EXPECT_EQ(days.next("23:59:59.5"), 0.0);
  EXPECT_EQ(days.next("00:00:00.5"), 1.0);
  EXPECT_EQ(days.next("00:00:01.5"), 2.0);
  EXPECT_FALSE(days.next("1.5"));
  ClockColumn hours;
  EXPECT_EQ(hours.next("59:59.5"), 0.0);
  EXPECT_EQ(hours.next("00:00.5"), 1.0);
}

}  // namespace
}  // namespace tapfit::acquisition
