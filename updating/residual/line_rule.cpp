#include "updating/residual/line_rule.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <string_view>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Of the paper's truss [Hz].
constexpr double truss_first = 75.68;
constexpr double truss_gap = 4.0;
constexpr double truss_before = 10.0;
constexpr double truss_step = 0.5;
constexpr int truss_count = 8;
// Case 1 has 500 lines up to the band's end, Case 2 has 50.
constexpr double even_count = 500.0;
constexpr int random_count = 50;
constexpr std::size_t most_lines = 10000;

[[noreturn]] void refuse(const std::string& what, const std::string& text) {
  throw InputError(what,
                   "--lines " + text,
                   "use damped, rule, even, random, before-peaks, or "
                   "frequencies such as 20,31.5,40:60:0.5");
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(at);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

double positive(std::string_view part, const std::string& text) {
  double value = 0.0;
  const auto [end, fault] =
      std::from_chars(part.data(), part.data() + part.size(), value);
  const bool whole = end == part.data() + part.size();
  if (fault != std::errc() || !whole || !std::isfinite(value) || value <= 0.0) {
    refuse(fmt::format("\"{}\" is no positive number", part), text);
  }
  return value;
}

// LOW:HIGH:STEP, both ends included.
void add_range(const std::vector<std::string_view>& parts,
               const std::string& text,
               std::vector<double>& lines) {
  if (parts.size() != 3) refuse("a range is LOW:HIGH:STEP", text);
  const double low = positive(parts[0], text);
  const double high = positive(parts[1], text);
  const double step = positive(parts[2], text);
  if (high < low) refuse("a range ends below where it begins", text);
  const double count = std::floor((high - low) / step + 1e-9) + 1.0;
  if (count > static_cast<double>(most_lines)) {
    refuse(fmt::format("more than {} lines", most_lines), text);
  }
  for (int k = 0; k < static_cast<int>(count); ++k) {
    lines.push_back(low + step * k);
  }
}

std::vector<double> listed(const std::string& text) {
  std::vector<double> lines;
  for (const std::string_view item : split(text, ',')) {
    const std::vector<std::string_view> parts = split(item, ':');
    if (parts.size() == 1) {
      lines.push_back(positive(item, text));
    } else {
      add_range(parts, text, lines);
    }
    if (lines.size() > most_lines) {
      refuse(fmt::format("more than {} lines", most_lines), text);
    }
  }
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  return lines;
}

double size_or(const LineRule& rule, std::size_t k, double otherwise) {
  return k < rule.sizes.size() ? rule.sizes[k] : otherwise;
}

// How this structure's frequencies stand to the truss's.
double proportion(const LineRule& rule, const VectorXd& resonances_hz) {
  if (resonances_hz.size() == 0) {
    refuse("no resonance was measured that lines could keep off", rule.text);
  }
  return resonances_hz(0) / truss_first;
}

VectorXd before_peaks(const LineRule& rule, const VectorXd& resonances_hz) {
  const double scale = proportion(rule, resonances_hz);
  return lines_before_peaks(resonances_hz,
                            size_or(rule, 0, truss_before * scale),
                            size_or(rule, 1, truss_step * scale),
                            static_cast<int>(size_or(rule, 2, truss_count)));
}

VectorXd all_lines(const LineRule& rule,
                   double high_hz,
                   const VectorXd& resonances_hz) {
  switch (rule.kind) {
    case LineKind::Rule:
      return even_lines(high_hz, high_hz / even_count);
    case LineKind::Even:
      return even_lines(high_hz, size_or(rule, 0, high_hz / even_count));
    case LineKind::Random: {
      acquisition::SeededRandom random(1, "lines");
      return random_lines(
          high_hz, static_cast<int>(size_or(rule, 0, random_count)), random);
    }
    case LineKind::BeforePeaks:
      return before_peaks(rule, resonances_hz);
    default:
      return Eigen::Map<const VectorXd>(rule.sizes.data(),
                                        static_cast<Index>(rule.sizes.size()));
  }
}

}  // namespace

LineRule parse_lines(const std::string& text) {
  struct Word {
    LineKind kind;
    std::size_t sizes;
  };
  static const std::map<std::string_view, Word> words = {
      {"damped", {LineKind::Damped, 0}},
      {"rule", {LineKind::Rule, 1}},
      {"even", {LineKind::Even, 1}},
      {"random", {LineKind::Random, 1}},
      {"before-peaks", {LineKind::BeforePeaks, 3}}};
  const std::vector<std::string_view> parts = split(text, ':');
  const auto word = words.find(parts.front());
  LineRule rule;
  rule.text = text;
  if (word == words.end()) {
    rule.kind = LineKind::List;
    rule.sizes = listed(text);
    return rule;
  }
  if (parts.size() > word->second.sizes + 1) refuse("too many sizes", text);
  rule.kind = word->second.kind;
  for (std::size_t k = 1; k < parts.size(); ++k) {
    rule.sizes.push_back(positive(parts[k], text));
  }
  const bool counts = rule.kind == LineKind::Random && !rule.sizes.empty();
  const double count = counts ? rule.sizes[0] : size_or(rule, 2, 1.0);
  if (count < 1.0 || count > static_cast<double>(most_lines)) {
    refuse("so many lines make no sense", text);
  }
  return rule;
}

VectorXd lines_of(const LineRule& rule,
                  std::array<double, 2> band_hz,
                  const VectorXd& resonances_hz) {
  const bool even = rule.kind == LineKind::Even && !rule.sizes.empty();
  if (even && band_hz[1] / rule.sizes[0] > static_cast<double>(most_lines)) {
    refuse(fmt::format("more than {} lines", most_lines), rule.text);
  }
  std::vector<double> inside;
  for (const double f : all_lines(rule, band_hz[1], resonances_hz)) {
    if (f >= band_hz[0] && f <= band_hz[1]) inside.push_back(f);
  }
  if (inside.empty()) {
    refuse(fmt::format("no line lies in the band from {:g} to {:g} Hz",
                       band_hz[0],
                       band_hz[1]),
           rule.text);
  }
  return Eigen::Map<VectorXd>(inside.data(), static_cast<Index>(inside.size()));
}

void check_lines(const LineRule& rule, std::array<double, 2> band_hz) {
  const bool waits_for_resonances =
      rule.kind == LineKind::Damped || rule.kind == LineKind::BeforePeaks;
  if (waits_for_resonances) return;
  static_cast<void>(lines_of(rule, band_hz, {}));
}

std::optional<PeakRule> gaps_of(const LineRule& rule,
                                const VectorXd& resonances_hz) {
  if (rule.kind != LineKind::Rule) return std::nullopt;
  const double scale = proportion(rule, resonances_hz);
  return PeakRule{size_or(rule, 0, truss_gap * scale), 0.0};
}

}  // namespace tapfit::updating
