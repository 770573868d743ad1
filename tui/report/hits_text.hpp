// Hits as JSON and as text.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/hits/hits.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tapfit::tui {

/// {"runs": [{"file", "hits": [{"time_s", "peak_n", "accepted", "reasons"}]}]}
[[nodiscard]] nlohmann::ordered_json hits_json(
    const acquisition::TestBundle& bundle, const acquisition::HitSet& hits);

/// One line per run, and one per rejected hit with the reason.
[[nodiscard]] std::string hits_text(const acquisition::TestBundle& bundle,
                                    const acquisition::HitSet& hits);

}  // namespace tapfit::tui
