// What the program tells the shell when it ends (docs/commands.md).
#pragma once

namespace tapfit::tui {

enum ExitStatus {
  Done = 0,
  InputAtFault = 1,
  CommandLineAtFault = 2,
  StoppedByUser = 3,  ///< or by a signal that asks to end
  OwnFault = 70,
};

}  // namespace tapfit::tui
