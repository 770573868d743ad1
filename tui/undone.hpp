// What was undone and can be done again, kept in the saved session so that it
// outlives the program. Other readers of the file pass over it.
#pragma once

#include "updating/diagnosis.hpp"
#include "updating/saved_session.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

/// One change of the effects: one was added, or one that was there switched.
struct EffectChange {
  updating::EffectRef added;              ///< where nothing was switched
  std::optional<std::size_t> switched{};  ///< counted from 0

  bool operator==(const EffectChange&) const = default;
};

/// What leads from `before` to `after`; empty where it is no single change.
[[nodiscard]] std::optional<EffectChange> change_between(
    const std::vector<updating::AddedEffect>& before,
    const std::vector<updating::AddedEffect>& after);

/// The session's text with what was undone, the last one last, in "undone".
[[nodiscard]] std::string with_undone(const std::string& session_text,
                                      const std::vector<EffectChange>& undone);

/// What with_undone() put there; nothing where there is none or it cannot be
/// read.
[[nodiscard]] std::vector<EffectChange> undone_in(
    const std::string& session_text);

}  // namespace tapfit::tui
