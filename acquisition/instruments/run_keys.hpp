// Runs in the names of arrays: "run1" of "run1/force".
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tapfit::acquisition {

struct RunKey {
  std::string key;      ///< what may be a run: "run1", "{1}"
  std::string channel;  ///< what is left of the name: "force"
};

/// Empty for a name without such a key.
using KeyOf = std::optional<RunKey> (*)(const std::string& name);

/// All ways in which names hold keys, the surest first; the last takes each
/// array for a run whose columns are channels.
[[nodiscard]] const std::vector<KeyOf>& run_keys();

/// Whether the keys are one word with numbers and the word means a run, as in
/// "run1", "Messung 02".
[[nodiscard]] bool sound_like_runs(const std::vector<std::string>& keys);

[[nodiscard]] bool sounds_like_hammer(const std::string& channel);

/// In the order of their numbers, where they differ by nothing else; else as
/// they are.
void sort_by_number(std::vector<std::string>& keys);

}  // namespace tapfit::acquisition
