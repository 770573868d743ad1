#include "acquisition/instruments/run_keys.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace tapfit::acquisition {
namespace {

bool is_digit_of_key(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::string lower_case(const std::string& text) {
  std::string lower = text;
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  return lower;
}

bool holds_word(const std::string& text, const auto& words) {
  const std::string lower = lower_case(text);
  return std::ranges::any_of(words, [&](std::string_view word) {
    return lower.find(word) != std::string::npos;
  });
}

bool means_run(const std::string& key) {
  constexpr auto words = std::to_array<std::string_view>({"run",
                                                          "test",
                                                          "meas",
                                                          "mess",
                                                          "hit",
                                                          "tap",
                                                          "blow",
                                                          "schlag",
                                                          "rec",
                                                          "shot",
                                                          "trial",
                                                          "take",
                                                          "versuch"});
  return holds_word(key, words) && std::ranges::any_of(key, is_digit_of_key);
}

// Parts of a path up to the given depth; blanks and points are parts of names
// where there are slashes.
template <int depth>
std::optional<RunKey> by_path(const std::string& name) {
  const char separator = name.find('/') != std::string::npos ? '/' : '.';
  std::size_t at = std::string::npos;
  for (int k = 0; k < depth; ++k) {
    at = name.find(separator, at == std::string::npos ? 0 : at + 1);
    if (at == std::string::npos || at + 1 == name.size()) return std::nullopt;
  }
  return RunKey{name.substr(0, at), name.substr(at + 1)};
}

// "force{2}", "force(2)".
std::optional<RunKey> by_index(const std::string& name) {
  const std::size_t at = name.find_last_of("{(");
  if (at == std::string::npos || at == 0 || at + 2 >= name.size() ||
      (name.back() != '}' && name.back() != ')')) {
    return std::nullopt;
  }
  const std::string inside = name.substr(at + 1, name.size() - at - 2);
  if (!std::ranges::all_of(inside, is_digit_of_key)) return std::nullopt;
  return RunKey{name.substr(at), name.substr(0, at)};
}

std::optional<RunKey> by_first_word(const std::string& name) {
  const std::size_t at = name.find('_');
  if (at == std::string::npos || at + 1 == name.size()) return std::nullopt;
  const std::string key = name.substr(0, at);
  if (!means_run(key)) return std::nullopt;
  return RunKey{key, name.substr(at + 1)};
}

std::optional<RunKey> by_last_word(const std::string& name) {
  const std::size_t at = name.rfind('_');
  if (at == std::string::npos || at == 0) return std::nullopt;
  const std::string key = name.substr(at + 1);
  if (!means_run(key)) return std::nullopt;
  return RunKey{key, name.substr(0, at)};
}

std::optional<RunKey> by_array(const std::string& name) {
  return RunKey{name, ""};
}

std::string without_digits(const std::string& key) {
  std::string rest = key;
  std::erase_if(rest, is_digit_of_key);
  return rest;
}

bool differ_by_number(const std::vector<std::string>& keys) {
  return std::ranges::all_of(keys, [&](const std::string& key) {
    return without_digits(key) == without_digits(keys[0]);
  });
}

// Digits alone, without zeros in front: the longer is the larger.
std::string number_of_key(const std::string& key) {
  std::string digits;
  for (const char c : key) {
    if (is_digit_of_key(c) && (c != '0' || !digits.empty())) digits += c;
  }
  return digits;
}

}  // namespace

const std::vector<KeyOf>& run_keys() {
  static const std::vector<KeyOf> ways{&by_path<1>,
                                       &by_path<2>,
                                       &by_path<3>,
                                       &by_index,
                                       &by_first_word,
                                       &by_last_word,
                                       &by_array};
  return ways;
}

bool sound_like_runs(const std::vector<std::string>& keys) {
  return differ_by_number(keys) && std::ranges::all_of(keys, means_run);
}

bool sounds_like_hammer(const std::string& channel) {
  constexpr auto words = std::to_array<std::string_view>(
      {"force", "hammer", "kraft", "impact", "impuls"});
  return holds_word(channel, words);
}

void sort_by_number(std::vector<std::string>& keys) {
  if (!differ_by_number(keys)) return;
  std::ranges::stable_sort(keys, [](const auto& one, const auto& other) {
    const std::string a = number_of_key(one);
    const std::string b = number_of_key(other);
    return a.size() != b.size() ? a.size() < b.size() : a < b;
  });
}

}  // namespace tapfit::acquisition
