#include "tui/document/svg_heat_map.hpp"

#include "tui/document/svg_canvas.hpp"
#include "tui/screen/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tapfit::tui {
namespace {

constexpr double cell_height = 21.0;
constexpr double head_height = 40.0;
/// At least, so that maps of few and of many columns have letters of one size
/// beside each other.
constexpr double least_width = 420.0;
/// White letters are read on what is darker than this.
constexpr double dark = 0.8;

/// White at 0, the full colour at 1.
std::string shade(double share, bool alarming) {
  constexpr std::array<double, 3> blue{0.0, 90.0, 150.0};
  constexpr std::array<double, 3> orange{196.0, 72.0, 0.0};
  const auto& full = alarming ? orange : blue;
  std::array<int, 3> mixed{};
  for (std::size_t k = 0; k < 3; ++k) {
    mixed[k] = static_cast<int>(std::lround(255.0 + share * (full[k] - 255.0)));
  }
  return fmt::format("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2]);
}

double names_width(const std::vector<std::string>& names,
                   const std::string& title) {
  std::size_t longest = title.size();
  for (const std::string& name : names) {
    longest = std::max(longest, name.size());
  }
  return 7.0 * static_cast<double>(longest) + 12.0;
}

std::string at_or_empty(const std::vector<std::string>& names,
                        Eigen::Index at) {
  const auto k = static_cast<std::size_t>(at);
  return k < names.size() ? names[k] : std::string();
}

}  // namespace

std::string svg_heat_map(const SvgHeatMap& map) {
  const Eigen::Index rows = map.values.rows();
  const Eigen::Index columns = map.values.cols();
  const double left = names_width(map.rows, map.row_title);
  const double cell =
      std::clamp((least_width - left - 6.0) /
                     static_cast<double>(std::max<Eigen::Index>(columns, 1)),
                 34.0,
                 62.0);
  SvgCanvas canvas(
      std::max(left + cell * static_cast<double>(columns) + 6.0, least_width),
      head_height + cell_height * static_cast<double>(rows) + 6.0,
      map.name);
  canvas.text(left + cell * static_cast<double>(columns) / 2.0,
              14.0,
              map.column_title,
              {.anchor = "middle"});
  canvas.text(left - 6.0, 14.0, map.row_title, {.anchor = "end"});
  for (Eigen::Index c = 0; c < columns; ++c) {
    canvas.text(left + cell * (static_cast<double>(c) + 0.5),
                33.0,
                at_or_empty(map.columns, c),
                {.anchor = "middle", .size = 11.5});
  }
  for (Eigen::Index r = 0; r < rows; ++r) {
    const double y = head_height + cell_height * static_cast<double>(r);
    canvas.text(left - 6.0,
                y + 15.0,
                at_or_empty(map.rows, r),
                {.anchor = "end", .size = 11.5});
    for (Eigen::Index c = 0; c < columns; ++c) {
      const double value = map.values(r, c);
      const double x = left + cell * static_cast<double>(c);
      if (!std::isfinite(value)) continue;
      const double share =
          map.full > 0.0 ? std::clamp(value / map.full, 0.0, 1.0) : 0.0;
      canvas.rectangle(
          x, y, cell - 1.0, cell_height - 1.0, shade(share, map.alarming));
      const double written = map.factor * value;
      canvas.text(
          x + cell / 2.0,
          y + 15.0,
          fixed(written, written < 9.95 && map.alarming ? 1 : map.decimals),
          {.anchor = "middle",
           .size = 11.5,
           .colour = share > dark ? "#ffffff" : ink::black});
    }
  }
  return canvas.svg();
}

}  // namespace tapfit::tui
