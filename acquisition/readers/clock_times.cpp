#include "acquisition/readers/clock_times.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

namespace tapfit::acquisition {
namespace {

bool is_digit_of_time(char c) { return c >= '0' && c <= '9'; }

// Digits with a decimal point or comma among them.
std::optional<double> time_part(std::string_view text, double below) {
  std::string digits(text);
  std::ranges::replace(digits, ',', '.');
  if (digits.empty() || !is_digit_of_time(digits[0])) return std::nullopt;
  double value = 0.0;
  const char* end = digits.data() + digits.size();
  const auto [rest, fault] =
      std::from_chars(digits.data(), end, value, std::chars_format::fixed);
  if (fault != std::errc{} || rest != end || value >= below) {
    return std::nullopt;
  }
  return value;
}

// "Z", "+01:00" and the like, AM and PM taken off.
struct Ending {
  std::string_view time;
  std::optional<bool> afternoon = {};
};

Ending without_ending(std::string_view text) {
  Ending ending{text};
  for (const std::string_view half : {"AM", "PM", "am", "pm"}) {
    if (!text.ends_with(half)) continue;
    ending.afternoon = half[0] == 'P' || half[0] == 'p';
    ending.time.remove_suffix(half.size());
  }
  if (ending.time.ends_with('Z')) ending.time.remove_suffix(1);
  // A zone stands behind the minutes.
  const std::size_t colon = ending.time.find(':');
  const std::size_t zone = ending.time.find_first_of("+-", colon);
  if (zone != std::string_view::npos) {
    ending.time = ending.time.substr(0, zone);
  }
  while (ending.time.ends_with(' ')) ending.time.remove_suffix(1);
  return ending;
}

std::vector<std::string_view> between_colons(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(':', at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

// What stands behind a date; empty where something else stands there.
std::optional<std::string_view> without_date(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const std::size_t date = text.find_last_of(" T", colon);
  if (date == std::string_view::npos) return text;
  std::string_view before = text.substr(0, date);
  while (before.ends_with(' ')) before.remove_suffix(1);
  if (!before.empty() && !is_date(before)) return std::nullopt;
  return text.substr(date + 1);
}

bool is_count_below(std::string_view part, int end) {
  if (part.empty() || part.size() > 2) return false;
  if (!std::ranges::all_of(part, is_digit_of_time)) return false;
  return std::stoi(std::string(part)) < end;
}

// Hours, minutes and seconds, or minutes and seconds with a fraction: 12:30 is
// no sample's time.
std::optional<double> seconds_of_parts(
    const std::vector<std::string_view>& parts) {
  const bool hours = parts.size() == 3;
  const bool fraction =
      parts.back().find_first_of(".,") != std::string_view::npos;
  if (!hours && (parts.size() != 2 || !fraction)) return std::nullopt;
  // 60 in a second that was put in.
  const std::optional<double> seconds = time_part(parts.back(), 61.0);
  const std::string_view minutes = parts[parts.size() - 2];
  if (!seconds || !is_count_below(minutes, 60)) return std::nullopt;
  double sum = *seconds + 60.0 * std::stoi(std::string(minutes));
  if (!hours) return sum;
  if (!is_count_below(parts[0], 25)) return std::nullopt;
  return sum + 3600.0 * std::stoi(std::string(parts[0]));
}

}  // namespace

bool is_date(std::string_view text) {
  constexpr std::string_view separators = "-./";
  std::size_t numbers = 0;
  bool inside = false;
  for (const char c : text) {
    if (!is_digit_of_time(c) && separators.find(c) == std::string_view::npos) {
      return false;
    }
    if (is_digit_of_time(c) && !inside) ++numbers;
    inside = is_digit_of_time(c);
  }
  return numbers == 3 && inside && is_digit_of_time(text[0]) &&
         text.size() >= 6 && text.size() <= 10;
}

std::optional<double> seconds_of_day(std::string_view text) {
  const auto time = without_date(text);
  if (!time) return std::nullopt;
  const Ending ending = without_ending(*time);
  const std::vector<std::string_view> parts = between_colons(ending.time);
  const bool hours = parts.size() == 3;
  std::optional<double> seconds = seconds_of_parts(parts);
  if (!seconds || !ending.afternoon || !hours) return seconds;
  constexpr double half_day = 43200.0;
  if (*seconds >= half_day) *seconds -= half_day;
  if (*ending.afternoon) *seconds += half_day;
  return seconds;
}

std::optional<double> ClockColumn::next(std::string_view text) {
  const std::optional<double> seconds = seconds_of_day(text);
  if (!seconds) return std::nullopt;
  if (!first_) first_ = last_ = *seconds;
  constexpr double day = 86400.0;
  constexpr double hour = 3600.0;
  const double fall = last_ - *seconds;
  if (fall > 0.5 * day) {
    carry_ += day;
  } else if (fall > 0.5 * hour && last_ < hour) {
    carry_ += hour;
  }
  last_ = *seconds;
  return carry_ + *seconds - *first_;
}

}  // namespace tapfit::acquisition
