#include "acquisition/hits/hammer_saturation.hpp"

#include "acquisition/hits/saturated_tops.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

constexpr double with_corners = 2.0;  // smooth tops have 1 at most, dented 3
constexpr double all_flat = 0.47;     // more than a half sine's 0.43 in noise
constexpr double flat_unlike = 0.03;  // scatters less where nothing is cut
constexpr std::ptrdiff_t enough = 3;  // tops that are merely flat
constexpr std::size_t enough_of_all = 4;

bool has_corners(const PulseTop& top) { return top.corners >= with_corners; }

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

std::optional<HammerSaturation> find_saturation(
    const std::vector<PulseTop>& tops) {
  HammerSaturation ceiling;
  ceiling.level_n = highest_level(tops);
  auto [at, below] = tops_by_level(tops, ceiling.level_n);
  if (at.size() + below.size() < 2) return std::nullopt;
  std::optional<Evidence> evidence;
  if (below.empty()) {
    evidence = evidence_of_all(at);
  } else {
    ceiling.least_flatness = cut_flatness(below);
    std::erase_if(at,
                  [&](const PulseTop& top) { return !is_cut(ceiling, top); });
    evidence = evidence_of(at, below);
  }
  if (!evidence) return std::nullopt;
  ceiling.evidence = *evidence;
  return ceiling;
}

bool is_cut(const HammerSaturation& ceiling, const PulseTop& top) {
  return top.width >= least_width &&
         std::abs(top.level - ceiling.level_n) <=
             equal_levels * ceiling.level_n &&
         top.flatness >= ceiling.least_flatness;
}

}  // namespace tapfit::acquisition
