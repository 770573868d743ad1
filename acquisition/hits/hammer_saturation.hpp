// A level that no blow of a hammer's channel exceeds, since what is ahead of
// the recorder (the conditioner of an IEPE hammer, a charge amplifier) can give
// no more.
//
// A flat top alone proves nothing, tips have them. But a tip's shape is the
// same at every level or changes slowly with it, and the hand scatters levels.
// At a ceiling levels are equal to 1 %, and the shape jumps there.
#pragma once

#include "acquisition/hits/pulse_top.hpp"

#include <optional>
#include <vector>

namespace tapfit::acquisition {

enum class Evidence {
  Suspicion,  ///< one blow only, or no blow below to compare with
  Flatness,   ///< only conditioners and places of their own make such tops
  Corners     ///< only conditioners do
};

struct HammerSaturation {
  double level_n = 0.0;         ///< of the highest top
  double least_flatness = 0.0;  ///< from here on a top at it is cut off
  Evidence evidence = Evidence::Suspicion;
};

/// Looks for a ceiling among the blows of one channel. At it are those whose
/// level is within 1 % of the highest; flatter than those below, where there
/// are any, by 0.05 than all of them (but one in 20). Evidence are
///
///   corners (PulseTop::corners of 2 or more) of two or more at it, where none
///   below has any (but one in 20), else
///   flatness, where three or more at it are flatter than those below;
///
/// suspected it is where all blows, four or more, are at it with a flatness of
/// 0.47 or more that differs by 0.03, or where one has corners, is flatter than
/// those below and these are two or more.
///
/// Tops of less than 5 samples' width are left out: behind a filter they have
/// no shape of their own.
[[nodiscard]] std::optional<HammerSaturation> find_saturation(
    const std::vector<PulseTop>& tops);

/// Whether a blow is cut off at the ceiling.
[[nodiscard]] bool is_cut(const HammerSaturation& ceiling, const PulseTop& top);

}  // namespace tapfit::acquisition
