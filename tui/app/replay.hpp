// Replays a key script on the program, without a terminal.
#pragma once

#include "tui/app/key_script.hpp"
#include "tui/app/program.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// @return the screens that the script asks for, one after the other; if it
///   asks for none, the one it ends with
[[nodiscard]] std::string replay(Program& program,
                                 const std::vector<ScriptStep>& steps);

/// Ticks until all work is done and animations that end have ended.
void wait_until_idle(Program& program);

}  // namespace tapfit::tui
