// tapfit hits: the hits found in each run, and what is thought of each.
#pragma once

#include "acquisition/hits/hits.hpp"
#include "tui/options/command.hpp"

#include <nlohmann/json_fwd.hpp>

namespace tapfit::tui {

/// {"runs": [{"file", "hits": [{"time_s", "peak_n", "accepted", "reasons"}]}]}
[[nodiscard]] nlohmann::ordered_json hits_json(
    const acquisition::TestBundle& bundle, const acquisition::HitSet& hits);

/// One line per run, and one per rejected hit with the reason.
[[nodiscard]] std::string hits_text(const acquisition::TestBundle& bundle,
                                    const acquisition::HitSet& hits);

/// @throws InputError, Stopped
[[nodiscard]] std::string hits_command(const CommandOptions& options,
                                       const Progress& progress);

}  // namespace tapfit::tui
