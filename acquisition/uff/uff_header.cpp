#include "acquisition/uff/uff_header.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <array>
#include <ctime>
#include <ostream>

namespace tapfit::acquisition {

TimeStamp time_stamp() {
  constexpr std::array<std::string_view, 12> months{"Jan",
                                                    "Feb",
                                                    "Mar",
                                                    "Apr",
                                                    "May",
                                                    "Jun",
                                                    "Jul",
                                                    "Aug",
                                                    "Sep",
                                                    "Oct",
                                                    "Nov",
                                                    "Dec"};
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  return {
      fmt::format("{:02}-{}-{:02}",
                  utc.tm_mday,
                  months[static_cast<std::size_t>(utc.tm_mon)],
                  utc.tm_year % 100),
      fmt::format("{:02}:{:02}:{:02}", utc.tm_hour, utc.tm_min, utc.tm_sec)};
}

std::string uff_line(std::string text) {
  text = text.substr(0, 80);
  for (char& c : text) {
    if (c == '\t' || c == '\r' || c == '\n') c = ' ';
    // Old readers know nothing but ASCII.
    if (c < ' ' || c > '~') c = '?';
  }
  return text.empty() ? "NONE" : text;
}

void write_uff_header(const std::string& title,
                      std::string_view what,
                      std::ostream& out) {
  const auto [date, clock] = time_stamp();
  fmt::print(
      out, "{}   151\n{}\n{}\ntapfit\n", uff_fence, uff_line(title), what);
  fmt::print(out, "{:<10}{:<10}{:10}{:10}{:10}\n", date, clock, 0, 0, 0);
  fmt::print(out,
             "{:<10}{:<10}\ntapfit\n{:<10}{:<10}\n{}",
             date,
             clock,
             date,
             clock,
             uff_fence);
  fmt::print(out, "{}   164\n{:10}{:<20}{:10}\n", uff_fence, 1, "SI: m, N", 2);
  fmt::print(out,
             "  1.00000000000000000D+00  1.00000000000000000D+00"
             "  1.00000000000000000D+00\n"
             "  2.73149999999999977D+02\n{}",
             uff_fence);
}

void write_uff_axis(int type,
                    std::string_view name,
                    std::string_view unit,
                    std::ostream& out) {
  fmt::print(
      out, "{:10}{:5}{:5}{:5} {:<20} {:<20}\n", type, 0, 0, 0, name, unit);
}

}  // namespace tapfit::acquisition
