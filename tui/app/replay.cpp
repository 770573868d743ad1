#include "tui/app/replay.hpp"

#include <chrono>
#include <thread>

namespace tapfit::tui {

void wait_until_idle(Program& program) {
  program.tick();
  while (!program.idle() && !program.quit()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    program.tick();
  }
  // A shape swings for ever; a sliding curve takes less than this.
  for (int frame = 0; frame < 48 && program.animate(); ++frame) {
  }
}

std::string replay(Program& program, const std::vector<ScriptStep>& steps) {
  std::string text;
  bool asked = false;
  for (const ScriptStep& step : steps) {
    if (program.quit()) break;
    switch (step.kind) {
      case ScriptStep::Kind::Press:
        program.press(step.key);
        break;
      case ScriptStep::Kind::Wait:
        wait_until_idle(program);
        break;
      case ScriptStep::Kind::Resize:
        program.resize(step.width, step.height);
        break;
      case ScriptStep::Kind::Dump:
        text += program.draw().to_text();
        asked = true;
        break;
    }
    program.tick();
  }
  return asked ? text : program.draw().to_text();
}

}  // namespace tapfit::tui
