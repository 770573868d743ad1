// Times of day, as recorders write them into a column: 12:00:00.001000,
// 2024-01-31T12:00:00.001Z, 31.01.2024 12:00:00,001, 12:00:00.001 PM, 59:59.9.
#pragma once

#include <optional>
#include <string_view>

namespace tapfit::acquisition {

/// Seconds since midnight, or since the full hour where no hour is written.
/// @return empty for what is no time of day
[[nodiscard]] std::optional<double> seconds_of_day(std::string_view text);

/// Whether a text is a date alone: 2024-01-31, 31.01.2024, 1/31/24.
[[nodiscard]] bool is_date(std::string_view text);

/// Makes times of day seconds from the first of them on. What falls by more
/// than half of a day (an hour) is of the next one.
class ClockColumn {
 public:
  /// @return empty for what is no time of day
  [[nodiscard]] std::optional<double> next(std::string_view text);

 private:
  std::optional<double> first_;
  double last_ = 0.0;
  double carry_ = 0.0;
};

}  // namespace tapfit::acquisition
