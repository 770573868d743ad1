// A mistake of the set-up as what is to be changed in test.json or the model,
// or, for a test without lines there, of its points (point_edits.hpp).
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/effects/effect.hpp"

#include <string>
#include <vector>

namespace tapfit::effects {

/// What a mistake changes in a sheet on which earlier ones are put right:
/// "runs[3].sensors[0].node: 8 -> 6", places in the file counted from 0; the
/// same edit in several runs as one, "runs[3-5]....", and
/// "channels[1].sensitivity: times 9.807"; of a support "model: release
/// components 456 (basic axes) at nodes 1, 12", or "hold" them. Empty where no
/// number of the sheet is wrong.
///
/// @param written by which it is told what is meant, see Effect::correct()
/// @param before as the earlier mistakes leave it
[[nodiscard]] std::vector<std::string> sheet_edits(
    const Effect& effect,
    const Location& where,
    const acquisition::TestBundle& written,
    const acquisition::TestBundle& before);

}  // namespace tapfit::effects
