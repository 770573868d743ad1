#include "acquisition/foundation/dof.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>

namespace tapfit {
namespace {

constexpr std::string_view letters = "XYZ";

bool is_sign(char c) { return c == '+' || c == '-'; }

std::string_view trim(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

}  // namespace

std::string node_name(int node) {
  return node < 0 ? fmt::format("P{}", -node) : fmt::format("{}", node);
}

std::string name(const Dof& dof) {
  const bool rotation = dof.component > 3;
  const auto letter = static_cast<std::size_t>((dof.component - 1) % 3);
  return fmt::format("{}{}{}{}",
                     node_name(dof.node),
                     rotation ? "R" : "",
                     letters[letter],
                     dof.sign < 0 ? '-' : '+');
}

std::optional<Dof> parse_direction(int node, std::string_view text) {
  text = trim(text);
  Dof dof{.node = node, .component = 0, .sign = 1};
  if (text.empty()) return std::nullopt;
  const bool sign_first = is_sign(text.front());
  const bool sign_last = is_sign(text.back());
  if (sign_first && sign_last) return std::nullopt;
  if (sign_first || sign_last) {
    dof.sign = (sign_first ? text.front() : text.back()) == '-' ? -1 : 1;
    sign_first ? text.remove_prefix(1) : text.remove_suffix(1);
  }
  int rotation = 0;
  if (text.size() == 2 && (text.front() == 'R' || text.front() == 'r')) {
    rotation = 3;
    text.remove_prefix(1);
  }
  if (text.size() != 1) return std::nullopt;
  const int upper = std::toupper(static_cast<unsigned char>(text.front()));
  const std::size_t axis = letters.find(static_cast<char>(upper));
  if (axis == std::string_view::npos) return std::nullopt;
  dof.component = static_cast<int>(axis) + 1 + rotation;
  return dof;
}

std::optional<Dof> parse_dof(std::string_view text) {
  text = trim(text);
  const bool own =
      !text.empty() && (text.front() == 'P' || text.front() == 'p');
  if (own) text.remove_prefix(1);
  int node = 0;
  const char* end = text.data() + text.size();
  const auto [rest, fault] = std::from_chars(text.data(), end, node);
  if (fault != std::errc{} || node <= 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  if (!text.empty() && text.front() == ':') text.remove_prefix(1);
  return parse_direction(own ? -node : node, text);
}

}  // namespace tapfit
