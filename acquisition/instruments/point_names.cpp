#include "acquisition/instruments/point_names.hpp"

#include <cctype>

namespace tapfit::acquisition {
namespace {

constexpr std::string_view between = " _:-./[](),";

bool is_sign(char c) { return c == '+' || c == '-'; }

}  // namespace

std::optional<Dof> point_in_name(std::string_view name) {
  for (std::size_t at = 0; at < name.size();) {
    const auto dof = parse_dof(name.substr(at));
    if (dof && dof->node > 0 && dof->component <= 3) return dof;
    const std::size_t next = name.find_first_of(between, at);
    if (next == std::string_view::npos) break;
    at = next + 1;
  }
  return std::nullopt;
}

std::optional<AxisName> axis_in_name(std::string_view name) {
  AxisName axis;
  const auto take_sign = [&] {
    if (name.empty() || !is_sign(name.back())) return;
    axis.sign = name.back() == '-' ? -1 : 1;
    name.remove_suffix(1);
  };
  take_sign();
  if (name.empty()) return std::nullopt;
  const int letter = std::toupper(static_cast<unsigned char>(name.back()));
  if (letter < 'X' || letter > 'Z') return std::nullopt;
  axis.component = letter - 'X' + 1;
  name.remove_suffix(1);
  take_sign();
  while (!name.empty() && between.find(name.back()) != std::string_view::npos) {
    name.remove_suffix(1);
  }
  axis.sensor = name;
  return axis;
}

}  // namespace tapfit::acquisition
