#include "acquisition/force_ceiling.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

constexpr double equal = 0.01;        // levels at a ceiling, relative
constexpr double flatter = 0.05;      // a loss of 1 % of the impulse
constexpr double with_corners = 2.0;  // smooth tops have 1 at most, dented 3
constexpr double least_width = 5.0;   // samples
constexpr double odd_ones = 20.0;     // one of so many below may be as flat
constexpr double all_flat = 0.47;     // more than a half sine's 0.43 in noise
constexpr double flat_unlike = 0.03;  // scatters less where nothing is cut
constexpr std::ptrdiff_t enough = 3;  // tops that are merely flat
constexpr std::size_t enough_of_all = 4;

bool has_corners(const PulseTop& top) { return top.corners >= with_corners; }

// The flatness that none below reaches, but the odd ones; 0 of none.
double flattest(const std::vector<PulseTop>& below) {
  std::vector<double> all;
  for (const PulseTop& top : below) all.push_back(top.flatness);
  if (all.empty()) return 0.0;
  std::ranges::sort(all, std::greater<>());
  const double odd = static_cast<double>(all.size()) / odd_ones;
  return all[static_cast<std::size_t>(odd)];
}

std::optional<Evidence> evidence_of_all(const std::vector<PulseTop>& at) {
  const auto [least, most] = std::ranges::minmax(at, {}, &PulseTop::flatness);
  if (at.size() < enough_of_all || least.flatness < all_flat ||
      most.flatness - least.flatness < flat_unlike) {
    return std::nullopt;
  }
  return Evidence::Suspicion;
}

// @param cut those of the highest that are flatter than all below
std::optional<Evidence> evidence_of(const std::vector<PulseTop>& cut,
                                    const std::vector<PulseTop>& below) {
  const auto corners = std::ranges::count_if(cut, has_corners);
  const auto odd = std::ranges::count_if(below, has_corners);
  const bool only_there =
      static_cast<double>(odd) <= static_cast<double>(below.size()) / odd_ones;
  if (corners >= 2 && only_there) return Evidence::Corners;
  if (std::ssize(cut) >= enough) return Evidence::Flatness;
  if (cut.size() == 1 && corners == 1 && odd == 0 && below.size() >= 2) {
    return Evidence::Suspicion;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ForceCeiling> find_ceiling(const std::vector<PulseTop>& tops) {
  ForceCeiling ceiling;
  for (const PulseTop& top : tops) {
    if (top.width < least_width) continue;
    ceiling.level_n = std::max(ceiling.level_n, top.level);
  }
  std::vector<PulseTop> at;
  std::vector<PulseTop> below;
  for (const PulseTop& top : tops) {
    if (top.width < least_width) continue;
    const bool highest = top.level >= (1.0 - equal) * ceiling.level_n;
    (highest ? at : below).push_back(top);
  }
  if (at.size() + below.size() < 2) return std::nullopt;
  std::optional<Evidence> evidence;
  if (below.empty()) {
    evidence = evidence_of_all(at);
  } else {
    ceiling.least_flatness = flattest(below) + flatter;
    std::erase_if(at,
                  [&](const PulseTop& top) { return !is_cut(ceiling, top); });
    evidence = evidence_of(at, below);
  }
  if (!evidence) return std::nullopt;
  ceiling.evidence = *evidence;
  return ceiling;
}

bool is_cut(const ForceCeiling& ceiling, const PulseTop& top) {
  return top.width >= least_width &&
         std::abs(top.level - ceiling.level_n) <= equal * ceiling.level_n &&
         top.flatness >= ceiling.least_flatness;
}

}  // namespace tapfit::acquisition
